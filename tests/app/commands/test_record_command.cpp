// `dapple record`, and other programs that play what it writes.

#include <doctest/doctest.h>

#include "io/files/picture.h"
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
    // 50.8 mm are 2 inches. The dots have settled.
    const Outcome drawn =
        run_dapple("render " + scene("cat.png") + " -o " + scene("a.png") + " --dpi 100" + options);
    CAPTURE(drawn.err);
    REQUIRE(drawn.status == 0);
    const Picture last = read_picture(scene("new/frame-0003.png")), whole = read_picture(scene("a.png"));
    CHECK(last.light.width == 200);
    CHECK(last.light.values == whole.light.values);
    CHECK(read_picture(scene("new/frame-0001.png")).light.values != whole.light.values);
}

TEST_CASE("a film of growth adds dots that stay, lets them settle, and ends on what render draws") {
    const Scene scene;
    // The page's shape; with --relax 0 it would end on other dots.
    const std::string options = " --dots 300 --width 50.8 --dot-radius 0.3";
    const auto film = [&](const std::string& folder, const std::string& more) {
        const Outcome made = run_dapple("record " + scene("cat.png") + " -o " + scene(folder) +
                                        " --seconds 4 --fps 10 --size 200" + options + more);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
    };
    const auto picture = [&](const std::string& name) { return read_picture(scene(name)).light.values; };
    const auto drawn = [&](const std::string& name, const std::string& more) {
        const Outcome outcome =
            run_dapple("render " + scene("cat.png") + " -o " + scene(name) + " --dpi 100" + options + more);
        REQUIRE(outcome.status == 0);
        return picture(name);
    };
    film("film/", "");
    film("placed/", " --relax 0");
    CHECK(picture("film/frame-0040.png") == drawn("a.png", ""));
    CHECK(picture("placed/frame-0040.png") == drawn("b.png", " --relax 0"));
    CHECK(picture("film/frame-0040.png") != picture("placed/frame-0040.png"));
    // The 36th of 40 pictures is the last before all dots are there: no dot of one is missing in the next.
    for (const char* const pair : {"0010 0020", "0020 0030", "0030 0036"}) {
        const std::vector<float> before = picture(std::string("film/frame-") + std::string(pair, 4) + ".png"),
                                 after = picture(std::string("film/frame-") + (pair + 5) + ".png");
        std::size_t paler = 0;
        for (std::size_t i = 0; i < before.size(); ++i) paler += after[i] > before[i] + 0.1f;
        CHECK(paler == 0);
    }
}

TEST_CASE(
    "the line for ffmpeg that help prints makes what players take: even sides, the film's rate, 4:2:0") {
    const std::string help = run_dapple("record --help").out;
    const std::size_t at = help.find("ffmpeg ");
    REQUIRE(at != std::string::npos);
    const std::string line = help.substr(at, help.find('\n', at) - at);
    CHECK(line.find(" -framerate 25 -i ") != std::string::npos);  // before what it is of
    CHECK(line.find(" -pix_fmt yuv420p ") != std::string::npos);
    CHECK(line.find("crop=trunc(iw/2)*2:trunc(ih/2)*2") != std::string::npos);
    CHECK(help.find("25") < at);
}

TEST_CASE("a film is drawn with masks, presets and another drawing's settings, as render draws") {
    const Scene scene;
    write_picture(scene("mask.png"), {.width = 2, .height = 1, .values = {0.0f, 1.0f}});
    const std::string cat = " " + scene("cat.png") + " --relax 0 --width 50.8";
    REQUIRE(run_dapple("render" + cat + " --dots 300 --ink '#205080' --region 5,6,7x8 -o " + scene("r.svg"))
                .status == 0);
    for (const std::string& options :
         {" --dots 300 --mask " + scene("mask.png"), " --dots 300 --finer " + scene("mask.png"),
          std::string(" --preset night --dots 300"), " --region all --settings-from " + scene("r.svg")}) {
        CAPTURE(options);
        const Outcome drawn = run_dapple("render" + cat + options + " --dpi 100 -o " + scene("a.png"));
        CAPTURE(drawn.err);
        REQUIRE(drawn.status == 0);
        const bool region = options.starts_with(" --region all");
        const Outcome made = run_dapple("record" + cat + (region ? options.substr(13) : options) +
                                        " --seconds 0.2 --fps 10 --size 200 -o " + scene("film/"));
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        CHECK(read_picture(scene("film/frame-0002.png")).light.values ==
              read_picture(scene("a.png")).light.values);
        CHECK((made.err.find("the film shows the whole page, not just 5,6,7x8") != std::string::npos) ==
              region);
    }
    const std::string film = "record " + scene("cat.png") + " -o " + scene("a.webp");
    scene.must_fail(film + " --preset none", "there is no preset \"none\"");
    scene.must_fail(film + " --show zoom --finer " + scene("mask.png"),
                    "--finer: applies to the films of growth");
    scene.must_fail(film + " --show plot --style line --finer " + scene("mask.png"), "--finer: makes dots");
    scene.must_fail(film + " --mask " + scene("none.png"), "--mask: " + scene("none.png"));
}

TEST_CASE("what cannot be filmed is said in a sentence, and nothing is written") {
    const Scene scene;
    const std::string cat = "record " + scene("cat.png") + " -o ";
    scene.must_fail(cat + scene("old.svg"), "a film's name ends in .webp");
    scene.must_fail(cat + scene("none/a.webp"), "none");
    scene.must_fail(cat + scene("a.webp") + " --depth 5", "--depth: applies to a zoom only");
    scene.must_fail(cat + scene("a.webp") + " --style line", "--style: applies to the film of a plot only");
    scene.must_fail(cat + scene("a.webp") + " --show zoom --relax 3",
                    "--relax: applies to the films of growth");
    scene.must_fail(cat + scene("a.webp") + " --seconds 0", "--seconds");
    scene.must_fail(cat + scene("a.webp") + " --size 5000", "--size");
    scene.must_fail("record " + scene("none.png") + " -o " + scene("a.webp"), "none.png");
    write_picture(scene("white.png"), {.width = 4, .height = 4, .values = std::vector<float>(16, 1.0f)});
    scene.must_fail("record " + scene("white.png") + " --tone true -o " + scene("b.webp") + "; rm -f " +
                        scene("white.png"),
                    "nothing to film");
}

}  // namespace dapple
