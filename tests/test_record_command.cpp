// `dapple record`, and other programs that play what it writes.

#include <doctest/doctest.h>

#include "app/files/picture.h"
#include "tests/render_scene.h"

namespace dapple {

TEST_CASE("a film is an animated WebP with a picture for each moment, and its last is the whole drawing") {
    const Scene scene;
    const std::string film = scene("cat.webp");
    const Outcome made = run_dapple("record " + scene("cat.png") + " -o " + film +
                                    " --seconds 0.8 --fps 10 --size 200 --dots 900");
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    const Outcome frames = run_in_shell("identify -format '%Wx%H %T\\n' " + film);
    CHECK(frames.status == 0);
    std::size_t lines = 0;
    for (std::size_t at = frames.out.find("200x133"); at != std::string::npos;
         at = frames.out.find("200x133", at + 1))
        ++lines;
    CAPTURE(frames.out);
    CHECK(lines >= 7);                                            // the last ones are alike, and may be one
    CHECK(frames.out.find("200x133 10\n") != std::string::npos);  // hundredths of a second
}

TEST_CASE("a film into a folder is numbered pictures; the last one is what render draws, to the pixel") {
    const Scene scene;
    const std::string options = " --dots 900 --tone true --gamma 1.3 --ink '#205080' --width 50.8";
    for (const std::string folder : {"new/", "new"}) {  // which is there then
        const Outcome made = run_dapple("record " + scene("cat.png") + " -o " + scene(folder) +
                                        " --seconds 0.5 --fps 6 --size 200" + options);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(scene("new"))) ++count;
        CHECK(count == 3);
    }
    // 50.8 mm are 2 inches.
    const Outcome drawn =
        run_dapple("render " + scene("cat.png") + " -o " + scene("a.png") + " --dpi 100 --relax 0" + options);
    CAPTURE(drawn.err);
    REQUIRE(drawn.status == 0);
    const Picture last = read_picture(scene("new/frame-0003.png")), whole = read_picture(scene("a.png"));
    CHECK(last.light.width == 200);
    CHECK(last.light.values == whole.light.values);
    CHECK(read_picture(scene("new/frame-0001.png")).light.values != whole.light.values);
}

TEST_CASE("what cannot be filmed is said in a sentence, and nothing is written") {
    const Scene scene;
    const std::string cat = "record " + scene("cat.png") + " -o ";
    scene.must_fail(cat + scene("old.svg"), "a film's name ends in .webp");
    scene.must_fail(cat + scene("none/a.webp"), "none");
    scene.must_fail(cat + scene("a.webp") + " --depth 5", "--depth: is of a zoom");
    scene.must_fail(cat + scene("a.webp") + " --style line", "--style: shows in the film of a plot only");
    scene.must_fail(cat + scene("a.webp") + " --seconds 0", "--seconds");
    scene.must_fail(cat + scene("a.webp") + " --size 5000", "--size");
    scene.must_fail("record " + scene("none.png") + " -o " + scene("a.webp"), "none.png");
    write_picture(scene("white.png"), {.width = 4, .height = 4, .values = std::vector<float>(16, 1.0f)});
    scene.must_fail("record " + scene("white.png") + " --tone true -o " + scene("b.webp") + "; rm -f " +
                        scene("white.png"),
                    "nothing to film");
}

}  // namespace dapple
