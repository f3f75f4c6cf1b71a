// No command writes over a file that it reads, or one of its files over another.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

// The arguments, with each @name as that of a file of the scene.
std::string in_scene(const Scene& scene, std::string arguments) {
    for (std::size_t at = arguments.find('@'); at != arguments.npos; at = arguments.find('@', at + 1)) {
        const std::size_t end = std::min(arguments.find(' ', at), arguments.size());
        const std::string file = scene(arguments.substr(at + 1, end - at - 1));
        arguments.replace(at, end - at, file);
        at += file.size() - 1;
    }
    return arguments;
}

}  // namespace

TEST_CASE("no command writes over what it reads, whatever it reads it for, nor twice into one file") {
    const Scene scene;
    const std::string laser = "start G21\nmove G1 X{x} Y{y}\ndot M3 S{power}\nend M5\n";
    put_text(scene("t.gcode"), laser);
    put_text(scene("k.svg"), "Black:#000:0.3\nRed:#f00:0.3\nBlue:#00f:0.3\n");
    put_text(scene("mine.tile"), "a tile");
    std::filesystem::create_directory(scene("r"));
    std::filesystem::create_directory(scene("out"));
    for (const char* const copy : {"m-plan.svg", "m-B1.svg", "cat-2-cyan.svg", "r/frame-0002.png",
                                   "out/dog.svg", "numbers.json", "index.html"})
        std::filesystem::copy_file(scene("cat.png"), scene(copy));
    const std::vector<std::pair<std::string, std::string>> refused{
        {"render - -o @cat.png <@cat.png", "over the picture"},
        {"render - -o @m-B1.svg --stats @cat.png <@cat.png", "over the picture"},
        {"render @cat.png -o @t.gcode --gcode @t.gcode", "over what --gcode reads"},
        {"render @cat.png -o @k.svg --pens @k.svg", "over what --pens reads"},
        {"render @cat.png -o @k.svg --pens auto:2:@k.svg", "over what --pens reads"},
        {"render @cat.png -o @cat.png --mask @cat.png", "over the "},
        {"render @cat.png -o @x.png --mask @numbers.json --stats @numbers.json", "over the mask"},
        {"render @cat.png -o @x.png --finer @numbers.json --stats @numbers.json", "over the mask"},
        {"render @m-plan.svg -o @m.svg --sheets 2x2", "over the picture"},
        {"render @m-B1.svg -o @m.svg --sheets 2x2", "over the picture"},
        {"render @cat-2-cyan.svg -o @cat.svg --pens cmyk --pen-files", "over the picture"},
        {"render @cat.png -o @m.svg --sheets 2x2 --stats @m-A2.svg", "over a part of the drawing"},
        {"render @cat.png -o @c.png --pens cmyk --separations --stats @c-1-yellow.png",
         "over a part of the drawing"},
        {"render @cat.png @out/dog.svg -o @out/ --format svg", "over the picture"},
        {"render @cat.png @old.svg -o @out/ --stats @out/old.svg", "over the drawing"},
        {"record @r/frame-0002.png -o @r/", "over the picture"},
        {"record @cat.png -o @mine.webp --tile @mine.webp", "mine.webp"},
        {"analyse @numbers.json -o @numbers.json", "over "},
        {"lights @numbers.json -o @numbers.json", "over the map"},
        {"compare @index.html --page @index.html", "over "},
        {"compare --page @new.html --json @new.html", "new.html"},
        {"reproduce -o @. --environment @index.html", "over what --environment reads"},
        {"tile show @k.svg -o @k.svg", "over the tile"},
        {"tile rank @mine.tile -o @mine.tile", "over the tile"},
        {"testsheet --pens @k.svg -o @k.svg", "over what --pens reads"},
    };
    for (const auto& [arguments, words] : refused) scene.must_fail(in_scene(scene, arguments), words);
    CHECK(text_of(scene("t.gcode")) == laser);
    // A drawing may be drawn again by the settings in it.
    REQUIRE(run_dapple(in_scene(scene, "render @cat.png -o @new.svg --dots 50")).status == 0);
    CHECK(run_dapple(in_scene(scene, "render @cat.png -o @new.svg --settings-from @new.svg --dots 60"))
              .status == 0);
    // And what only looks like a file's name elsewhere is in nobody's way.
    CHECK(run_dapple(in_scene(scene, "render @cat.png -o @svg.svg --dots 50 --format svg")).status == 0);
}

TEST_CASE("pens that are chosen from the picture do not get its file for theirs") {
    const Scene scene;
    REQUIRE(
        run_dapple(in_scene(scene, "render @cat.png -o @a.svg --pens auto:2 --pen-files --dots 60")).status ==
        0);
    std::filesystem::path of_a_pen;
    for (const auto& entry : std::filesystem::directory_iterator(scene.folder / ""))
        if (entry.path().filename().string().starts_with("a-1")) of_a_pen = entry.path();
    REQUIRE(!of_a_pen.empty());
    std::filesystem::copy_file(scene("cat.png"), of_a_pen, std::filesystem::copy_options::overwrite_existing);
    scene.must_fail(
        in_scene(scene, "render " + of_a_pen.string() + " -o @a.svg --pens auto:2 --pen-files --dots 60"),
        "over the picture");
}
