// The real program in a real window, on a display of its own, driven with a real mouse and keyboard.
//
// Everything waits until what it did is seen in what the program logs.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/window/running_viewer.h"
#include "tests/window/screen.h"

namespace dapple {
namespace {

/// An environment map in Radiance's format, its columns as light as paper times 2^(exponent - 0x81) in turn.
void write_map(const fs::path& file, char even_exponent, char odd_exponent) {
    std::ofstream out(file, std::ios::binary);
    out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int pixel = 0; pixel < 8 * 16; ++pixel)
        out << "\x80\x80\x80" << (pixel % 2 ? odd_exponent : even_exponent);
}

void write_even_map(const fs::path& file) {
    write_map(file, '\x81', '\x81');
}

/// How many of an SVG's circles lie in each of 4 x 4 parts of a page of that many px.
std::array<int, 16> circles_by_part(const std::string& svg, double page) {
    std::array<int, 16> counts{};
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);) {
        double x = 0, y = 0;
        if (std::sscanf(line.c_str(), "<circle cx=\"%lf\" cy=\"%lf\"", &x, &y) != 2) continue;
        const auto part = [&](double at) { return std::clamp(static_cast<int>(4 * at / page), 0, 3); };
        ++counts[static_cast<std::size_t>(4 * part(y) + part(x))];
    }
    return counts;
}

void open_the_method(RunningViewer& viewer) {
    viewer.key("m");
    REQUIRE(viewer.shows([&] { return viewer.has("ramp"); }));
}

/// An even grey in the photograph's place.
void choose_grey(RunningViewer& viewer) {
    const double before = viewer.status()["scale"];
    viewer.click("grey");
    // As many dots as before, which a grey has at another scale.
    REQUIRE(viewer.shows([&] { return viewer.status()["scale"] != before; }));
}

/// Writes a project of the sample whose dots stay where they are placed, for tests that place it again and
/// again; its name.
std::string write_unrelaxed(const TemporaryFolder& folder) {
    put_text(folder / "placed.dapple", R"({"dapple": 1, "drawing": {"relax": 0}})");
    return "placed.dapple";
}

}  // namespace

TEST_CASE("dragging the scale slider with the mouse changes the number of dots, and undo brings it back") {
    Display display;
    RunningViewer viewer;
    CHECK(viewer.dots() == 40'000);
    REQUIRE(viewer.is_relaxed());
    const int placings = viewer.status()["placings"];
    viewer.click("from tone");
    REQUIRE(
        viewer.shows([&] { return viewer.has("Dots in black") && viewer.status()["placings"] > placings; }));
    REQUIRE(viewer.is_relaxed());
    const double scale = viewer.status()["scale"];
    // A scale draws the dots above it, with detail for about as many.
    const std::uint64_t dots = viewer.dots();
    CHECK(dots == doctest::Approx(40'000).epsilon(0.0001));

    viewer.point_at("Dots in black", 0.5);
    viewer.press();
    viewer.point_at("Dots in black", 0.4);
    viewer.point_at("Dots in black", 0.3);
    // The dots follow while the button is still down.
    CHECK(viewer.shows([&] { return viewer.dots() < 10'000; }));
    viewer.release();
    CHECK(viewer.status()["scale"] < scale / 4);

    viewer.move(300, 300);
    viewer.key("ctrl+z");
    CHECK(viewer.shows([&] { return viewer.status()["scale"] == scale && viewer.dots() == dots; }));

    CHECK(viewer.quit() == 0);
}

TEST_CASE("a project opens in the window and is saved again from there, with what the window does not know") {
    const TemporaryFolder folder;
    put_text(folder / "small.dapple",
             R"({"dapple": 1, "drawing": {"count": 500, "relax": 0}, "mine": "kept"})");
    Display display;
    RunningViewer viewer(folder.path(), {"small.dapple"});
    CHECK(viewer.dots() == 500);
    run({"xdotool", "search", "--name", "^small.dapple - Dapple$"});
    viewer.click("from tone");
    REQUIRE(viewer.shows([&] { return viewer.has("Dots in black"); }));
    viewer.key("ctrl+shift+s");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    CHECK(
        viewer.shows([&] { return text_of(folder / "small.dapple").find("\"view\"") != std::string::npos; }));
    const json saved = json::parse(text_of(folder / "small.dapple"));
    CHECK(saved["mine"] == "kept");
    CHECK(saved["drawing"]["count"].is_null());
    CHECK(saved["picture"].is_null());
    CHECK(viewer.quit() == 0);
}

TEST_CASE("the wheel zooms, F fits again, and neither places a dot anew") {
    Display display;
    RunningViewer viewer;
    REQUIRE(viewer.is_relaxed());
    const double zoom = viewer.status()["zoom"];
    viewer.move(300, 300);
    viewer.wheel_up();
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] > zoom * 1.1; }));
    const int placings = viewer.status()["placings"];
    viewer.key("f");
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] == zoom; }));
    CHECK(viewer.status()["placings"] == placings);
}

TEST_CASE("zooming in with more dots keeps them as dense, and F brings the drawing back") {
    Display display;
    RunningViewer viewer;
    open_the_method(viewer);
    REQUIRE(viewer.shows([&] { return viewer.status()["all_steps"] == 0; }));  // where nothing is relaxed
    const double scale = viewer.status()["scale"], zoom = viewer.status()["zoom"];
    viewer.click("more dots");
    viewer.move(380, 320);
    for (int i = 0; i < 12; ++i) viewer.wheel_up();
    CHECK(viewer.shows([&] {
        const double enlarged = viewer.status()["zoom"].get<double>() / zoom;
        const double denser = viewer.status()["scale"].get<double>() / scale;
        return enlarged > 8 && std::abs(denser / (1.07 * enlarged * enlarged) - 1) < 0.01;
    }));
    CHECK(viewer.dots() == 40'000);  // which the rows say too
    viewer.key("f");
    viewer.click("larger dots");
    CHECK(viewer.shows([&] { return viewer.status()["scale"] == scale; }));
    CHECK(viewer.dots() == 40'000);
}

TEST_CASE("what the window exports is what the command writes, to the byte") {
    TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path());
    viewer.move(300, 300);
    viewer.key("ctrl+e");
    viewer.click("Accept");
    REQUIRE(viewer.shows([&] { return fs::exists(folder / "Still life.svg"); }));
    run({dapple_program(), "render", "-o", (folder / "command.svg").string()});
    CHECK(text_of(folder / "Still life.svg") == text_of(folder / "command.svg"));
}

TEST_CASE(
    "a tile from a file is drawn with, whether it is chosen in the window or named on the command line") {
    TemporaryFolder folder;
    const std::string tile = (folder / "mine.tile").string(), command = (folder / "command.svg").string();
    run({lab_program(), "tile", "rank", "aperiodic16", "--ranking", "farthest", "-o", tile});
    run({dapple_program(), "render", "-o", command, "--tile", tile, "--relax", "0"});
    const auto exports_the_same = [&](RunningViewer& viewer) {
        viewer.move(300, 300);
        viewer.key("ctrl+e");
        viewer.click("Accept");
        REQUIRE(viewer.shows([&] { return fs::exists(folder / "Still life.svg"); }));
        CHECK(text_of(folder / "Still life.svg") == text_of(command));
        fs::remove(folder / "Still life.svg");
        CHECK(viewer.quit() == 0);
    };
    Display display;
    {
        RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
        open_the_method(viewer);
        viewer.click("Tile");
        viewer.click("From a file...");
        REQUIRE(viewer.shows([&] { return viewer.has("mine.tile"); }));
        const int placings = viewer.status()["placings"];
        viewer.click("mine.tile");
        REQUIRE(viewer.shows([&] { return !viewer.has("Path") && viewer.status()["placings"] > placings; }));
        exports_the_same(viewer);
    }
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder), "--tile", "mine.tile"});
    exports_the_same(viewer);
}

TEST_CASE(
    "the split view shows why one tile repeats, its divider can be dragged, and undo takes it all back") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    const double scale_of_photograph = viewer.status()["scale"];
    open_the_method(viewer);
    choose_grey(viewer);
    viewer.move(300, 300);
    viewer.key("shift+c");
    REQUIRE(viewer.shows([&] {
        const json right = viewer.status()["right"];
        return right.is_object() && right["repetition"].is_number() && right["left_repetition"].is_number();
    }));
    json right = viewer.status()["right"];
    // The same tile everywhere on an even grey against one that never repeats.
    CHECK(right["repetition"] > 0.9);
    CHECK(right["left_repetition"] < 0.3);
    const double scale = viewer.status()["scale"];
    CHECK(right["scale"].get<double>() == doctest::Approx(scale).epsilon(1e-6));

    const auto divider = [&] { return viewer.status()["right"]["divider"].get<double>(); };
    CHECK(divider() == 0.5);
    viewer.point_at("Divider");
    viewer.press();
    viewer.move(200, 300);
    viewer.move(150, 300);
    CHECK(viewer.shows([&] { return std::abs(divider() - 150.0 / 940) < 0.01; }));
    // Not out of the canvas.
    viewer.move(2, 300);
    CHECK(viewer.shows([&] { return divider() < 150.0 / 940 - 0.05; }));
    CHECK(divider() > 0);
    viewer.release();
    CHECK(viewer.dots() == 40'000);

    viewer.move(300, 300);
    viewer.key("ctrl+z");
    CHECK(viewer.shows([&] { return divider() == 0.5; }));
    viewer.key("ctrl+z");
    CHECK(viewer.shows([&] { return !viewer.status().contains("right"); }));
    viewer.key("ctrl+z");
    CHECK(viewer.shows([&] { return viewer.status()["scale"] == scale_of_photograph; }));
}

TEST_CASE("under the side that is saved, and under no other, it says so") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    viewer.move(300, 300);
    viewer.key("shift+c");
    REQUIRE(viewer.shows([&] { return viewer.status().contains("right"); }));
    // What is said beside the two tiles' names is longer than either; all of it in the strip below the
    // canvas, 940 wide, in letters darker than those of the facts.
    const auto title_width = [](const Grid<glm::u8vec3>& pixels, int from, int to) {
        int first = to, last = from;
        for (int y = 708; y < 768; ++y) {
            for (int x = from; x < to; ++x) {
                if (pixels.at(x, y).g > 80) continue;
                first = std::min(first, x);
                last = std::max(last, x);
            }
        }
        return last - first;
    };
    CHECK(viewer.shows([&] {
        const Grid<glm::u8vec3> pixels = screen();
        const int left = title_width(pixels, 0, 465), right = title_width(pixels, 475, 940);
        return right > 20 && left > 2 * right;
    }));
}

TEST_CASE("Figure 8 on the right comes near the left side's count") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    open_the_method(viewer);
    viewer.click("Split view");
    viewer.click("same count");
    const json before = viewer.status()["widgets"]["Figure 8"];
    viewer.click("Right placer");
    // The list's entry has the name of a choice further up.
    REQUIRE(viewer.shows([&] { return viewer.status()["widgets"]["Figure 8"] != before; }));
    viewer.click("Figure 8");
    CHECK(viewer.shows([&] {
        const json right = viewer.status()["right"];
        if (!right.is_object() || right["duplicates"] == 0) return false;
        const double different = right["dots"].get<double>() - right["duplicates"].get<double>();
        return std::abs(different / 40'000 - 1) < 0.02;
    }));
}

TEST_CASE("the loupe finds the paper's tile on itself everywhere, and a tile that never repeats nowhere") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    open_the_method(viewer);
    choose_grey(viewer);
    viewer.move(300, 300);
    viewer.key("l");
    REQUIRE(viewer.shows([&] { return viewer.status().contains("loupe"); }));
    const auto repetition = [&] { return viewer.status()["loupe"]["repetition"].get<double>(); };
    CHECK(repetition() < 0.1);
    CHECK(viewer.status()["loupe"]["layers"] >= 9);
    // Off the page there is nothing to look at.
    viewer.move(20, 20);
    CHECK(viewer.shows([&] { return !viewer.status().contains("loupe"); }));

    viewer.key("shift+c");
    REQUIRE(viewer.shows([&] { return viewer.status().contains("right"); }));
    viewer.move(700, 300);
    CHECK(viewer.shows([&] { return viewer.status().contains("loupe") && repetition() > 0.9; }));
    viewer.move(250, 300);
    CHECK(viewer.shows([&] { return viewer.status().contains("loupe") && repetition() < 0.1; }));
    viewer.key("l");
    CHECK(viewer.shows([&] { return !viewer.status().contains("loupe"); }));
}

TEST_CASE("a grey is saved as it is shown, and the split view does not change it") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    open_the_method(viewer);
    choose_grey(viewer);
    const auto save = [&](const std::string& name) {
        viewer.move(300, 300);
        viewer.key("ctrl+e");
        viewer.click("Accept");
        REQUIRE(viewer.shows([&] { return fs::exists(folder / "Still life.svg"); }));
        fs::rename(folder / "Still life.svg", folder / name);
    };
    save("alone.svg");
    viewer.move(300, 300);
    viewer.key("shift+c");
    REQUIRE(viewer.shows([&] { return viewer.status().contains("right"); }));
    save("split.svg");
    const std::string alone = text_of(folder / "alone.svg");
    // A sixteenth of the 40,000 dots in every sixteenth of the page, as no photograph has them. Its side is
    // 200 mm at 96 px to the inch.
    for (const int count : circles_by_part(alone, 200 / 25.4 * 96))
        CHECK(count == doctest::Approx(2500).epsilon(0.02));
    CHECK(alone == text_of(folder / "split.svg"));
}

TEST_CASE("the samples of an environment map follow their slider, and exposing it takes none anew") {
    TemporaryFolder folder;
    write_even_map(folder / "even.hdr");
    Display display;
    RunningViewer viewer({}, {"lights", (folder / "even.hdr").string()});
    const auto status = [&] { return viewer.status(); };
    CHECK(status()["samples"] == 1024);
    CHECK(status()["difference"] > 0);
    CHECK(status()["difference"] < 0.2);
    viewer.point_at("Samples", 0.7);
    viewer.press();
    viewer.point_at("Samples", 0.5);
    viewer.release();
    // Halfway between 1 and 16,384 on a logarithmic slider.
    CHECK(viewer.shows([&] { return status()["samples"] < 200 && status()["samples"] > 80; }));
    REQUIRE(viewer.shows([&] { return status()["sampling"] == false; }));

    const json before = status();
    viewer.point_at("Exposure", 0.5);
    viewer.press();
    viewer.point_at("Exposure", 0.6);
    viewer.release();
    // A tenth of its slider's 24 stops above the middle, or thereabouts.
    CHECK(status()["stops"] > 1.5);
    CHECK(status()["stops"] < 3.5);
    REQUIRE(viewer.shows([&] { return status()["sampling"] == false; }));
    CHECK(status()["samplings"] == before["samplings"]);
    CHECK(status()["samples"] == before["samples"]);
    CHECK(viewer.quit() == 0);
}

TEST_CASE("a picture that looks like an environment map is opened as lights by a click") {
    TemporaryFolder folder;
    write_map(folder / "bright.hdr", '\x84', '\x7e');
    Display display;
    RunningViewer viewer(folder.path(), {(folder / "bright.hdr").string()});
    CHECK(viewer.status().contains("dots"));
    viewer.click("Open as lights");
    CHECK(viewer.shows([&] { return viewer.status().contains("samples"); }));
    CHECK(viewer.has("Exposure"));
    viewer.click("Back to the drawing");
    CHECK(viewer.shows([&] { return viewer.status().contains("dots"); }));
    CHECK(viewer.is_titled("^bright.hdr - Dapple$"));
}

TEST_CASE("the wheel zooms into an environment map, F shows all of it again, and the title names it") {
    TemporaryFolder folder;
    write_even_map(folder / "even.hdr");
    Display display;
    RunningViewer viewer({}, {"lights", (folder / "even.hdr").string()});
    const auto zoom = [&] { return viewer.status()["zoom"].get<double>(); };
    CHECK(zoom() == doctest::Approx(1));
    // Finds nothing, and says so by its exit status, if no window has that title.
    CHECK(ChildProcess({"xdotool", "search", "--name", "^even.hdr - Dapple$"}).wait() == 0);
    viewer.point_at("Map", 0.3);
    for (int i = 0; i < 4; ++i) viewer.wheel_up();
    CHECK(viewer.shows([&] { return zoom() > 1.5; }));
    viewer.key("f");
    CHECK(viewer.shows([&] { return zoom() < 1.001; }));
}

TEST_CASE("the samples that the window exports are those of the command, to the byte") {
    TemporaryFolder folder;
    const std::string map = (folder / "even.hdr").string(), command = (folder / "command.json").string();
    write_even_map(map);
    ChildProcess program({dapple_program(), "lights", map, "-n", "300", "-o", command});
    REQUIRE(program.wait() == 0);
    Display display;
    RunningViewer viewer(folder.path(), {"lights", map, "-n", "300"});
    viewer.move(300, 200);
    viewer.key("ctrl+e");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    REQUIRE(viewer.shows([&] { return fs::exists(folder / "even.json"); }));
    CHECK(text_of(folder / "even.json") == text_of(command));
}

TEST_CASE("on the canvas a hidden pen's dots are gone, and of one looked at alone there are no others") {
    const TemporaryFolder folder;
    put_text(folder / "pens.dapple", R"({"dapple": 1, "drawing": {"count": 3000, "pens": "cmyk"}})");
    Display display;
    RunningViewer viewer(folder.path(), {"pens.dapple"});
    REQUIRE(viewer.is_relaxed());
    const auto count = [](const auto& looked_for) {
        const Grid<glm::u8vec3> canvas = cut_out(screen(), {{0, 60}, {930, 700}});
        return std::ranges::count_if(canvas.values, looked_for);
    };
    const auto is_magenta = [](glm::u8vec3 pixel) { return pixel.r > 190 && pixel.g < 60 && pixel.b > 90; };
    const auto is_yellow = [](glm::u8vec3 pixel) { return pixel.r > 220 && pixel.g > 200 && pixel.b < 80; };
    const auto is_black = [](glm::u8vec3 pixel) { return pixel.r < 60 && pixel.g < 60 && pixel.b < 60; };
    viewer.click("More pen settings");
    CHECK(count(is_magenta) > 300);
    viewer.click("Show Magenta");
    viewer.move(300, 750);  // no tip of the row's lies over the canvas
    CHECK(viewer.shows([&] { return count(is_magenta) == 0; }));
    CHECK(count(is_yellow) > 300);
    CHECK(count(is_black) > 300);
    viewer.click("Pens shown");
    viewer.click("1 Yellow alone");
    viewer.move(300, 750);  // no tip of the row's lies over the canvas
    CHECK(viewer.shows([&] { return count(is_black) == 0; }));
    CHECK(count(is_yellow) > 300);
    CHECK(viewer.dots() == 3000);
}

TEST_CASE("a picture is chosen in the list by its name") {
    TemporaryFolder folder;
    std::ofstream(folder / "grey.pgm") << "P2 2 2 255 90 90 90 90\n";
    Display display;
    RunningViewer viewer(folder.path());
    viewer.move(300, 300);
    viewer.key("ctrl+o");
    REQUIRE(viewer.shows([&] { return viewer.has("grey.pgm"); }));
    viewer.click("grey.pgm");
    CHECK(viewer.shows([&] { return !viewer.has("Path"); }));
    CHECK(viewer.shows([&] {
        return ChildProcess({"xdotool", "search", "--name", "^grey.pgm - Dapple$"}).wait() == 0;
    }));
}

TEST_CASE("a key let go quickly counts although a modifier changes meanwhile, and none ends the program") {
    Display display;
    RunningViewer viewer;
    viewer.move(300, 300);
    const double zoom = viewer.status()["zoom"];
    for (int i = 0; i < 5; ++i)
        viewer.xdotool("key --delay 0 ctrl+z keydown shift; sleep 0.1; xdotool keyup shift");
    viewer.xdotool("key --delay 0 plus plus plus");
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] > zoom * 1.9; }));
    CHECK(viewer.quit() == 0);
}

TEST_CASE("a window of any size goes on, whatever is open in it") {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{}, {"lights"}}) {
        Display display;
        RunningViewer viewer({}, arguments);
        viewer.move(300, 300);
        for (const char* keys : {"shift+c", "ctrl+e", "F1"}) {
            viewer.key(keys);
            for (const auto& [width, height] : {std::pair(50, 50), {1, 1}, {1, 700}}) {
                viewer.resize(width, height);
                viewer.xdotool("sleep 0.1");
            }
        }
        viewer.resize(1280, 800);
        viewer.move(310, 310);
        viewer.key("Escape");  // from the help
        CHECK(viewer.quit() == 0);
    }
}

TEST_CASE("a window at rest uses no processor, and a key is still answered") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    viewer.move(300, 300);
    for (int i = 0; i < 2; ++i) {
        const auto rests = [&] {
            const double before = viewer.processor_seconds();
            viewer.xdotool("sleep 2");
            return viewer.processor_seconds() - before < 0.02;
        };
        // It comes to rest, however long what it does first takes on a busy machine, and then stays so.
        CHECK(wait_until(rests));
        CHECK(rests());
        const double zoom = viewer.status()["zoom"];
        viewer.key("plus");
        CHECK(viewer.shows([&] { return viewer.status()["zoom"] > zoom; }));
    }
}

TEST_CASE("a picture or project that is not there opens the window with the sample and a sentence") {
    const TemporaryFolder folder;
    for (const char* const name : {"missing.png", "missing.dapple"}) {
        CAPTURE(name);
        Display display;
        RunningViewer viewer(folder.path(), {name});
        CHECK(viewer.dots() > 0);
        const json widgets = viewer.status()["widgets"];
        CHECK(widgets.contains("Close message"));
        CHECK(std::ranges::any_of(widgets.items(),
                                  [&](const auto& widget) { return widget.key().starts_with(name); }));
    }
}

TEST_CASE(
    "of a picture that is white everywhere there is no drawing to tell of or to save, until it is inverted") {
    TemporaryFolder folder;
    put_text(folder / "white.pgm", "P2 2 2 255 255 255 255 255");
    Display display;
    RunningViewer viewer(folder.path(), {"white.pgm"});
    CHECK(viewer.shows([&] { return viewer.status()["dots"] == 0 && viewer.status()["zoom"] == 0; }));
    viewer.key("ctrl+e");
    CHECK(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.key("Return");
    viewer.key("Escape");
    REQUIRE(viewer.shows([&] { return !viewer.has("Path"); }));
    CHECK_FALSE(fs::exists(folder / "white.svg"));
    viewer.click("More tone settings");
    viewer.click("Invert");
    CHECK(viewer.shows([&] { return viewer.status()["dots"] == 40'000 && viewer.status()["zoom"] > 0; }));
}

TEST_CASE("without a display the program says so and what to do") {
    TemporaryFolder folder;
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    ChildProcess program({dapple_program()}, {.errors = folder / "errors"});
    CHECK(program.wait() == 1);
    CHECK(text_of(folder / "errors").find("dapple render") != std::string::npos);
}

TEST_CASE("nine variations are shown, the one that is clicked is drawn, and one undo takes it back") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    viewer.move(300, 300);
    viewer.key("v");
    REQUIRE(viewer.shows([&] { return viewer.has("Variation fewer dots"); }));
    viewer.click("Variation fewer dots");
    CHECK(viewer.shows([&] { return viewer.dots() == 20'000; }));
    viewer.key("Escape");
    REQUIRE(viewer.shows([&] { return !viewer.has("Variation lighter"); }));
    CHECK(viewer.dots() == 20'000);
    viewer.key("ctrl+z");
    CHECK(viewer.shows([&] { return viewer.dots() == 40'000; }));
}

TEST_CASE("the column is as wide as its edge is dragged to, also in the next window") {
    const TemporaryFolder folder;
    const WindowMemory memory{folder / "home"};
    Display display;
    const auto left_of_column = [](const RunningViewer& viewer) {
        return viewer.status()["widgets"]["Open..."][0].get<double>();
    };
    {
        RunningViewer viewer(folder.path(), {write_unrelaxed(folder)}, memory);
        viewer.point_at("Panels' edge");
        viewer.press();
        viewer.move(800, 400);
        viewer.release();
        CHECK(viewer.shows([&] { return left_of_column(viewer) > 800 && left_of_column(viewer) < 840; }));
        CHECK(viewer.quit() == 0);
    }
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)}, memory);
    CHECK(left_of_column(viewer) > 800);
    CHECK(left_of_column(viewer) < 840);
}

TEST_CASE("the dots on screen are measured once the spectrum's section is opened") {
    const TemporaryFolder folder;
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)});
    open_the_method(viewer);
    CHECK_FALSE(viewer.has("Radial power"));
    viewer.click("Spectrum");
    const bool measured = viewer.shows([&] { return viewer.has("Radial power"); });
    CAPTURE(viewer.status().dump());
    CHECK(measured);
}

TEST_CASE(
    "what was set is there in the next window, where a copied path is opened and a relaxed dot explained") {
    const TemporaryFolder folder;
    const WindowMemory memory{folder / "home"};
    for (const char* name : {"one.pgm", "two.pgm"})
        put_text(folder / name, "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    Display display;
    std::uint64_t dots = 0;
    {
        RunningViewer viewer(folder.path(), {"one.pgm"}, memory);
        dots = viewer.dots();
        CHECK(dots == 40'000);
        viewer.point_at("Dots", 0.3);
        viewer.press();
        viewer.release();
        REQUIRE(viewer.shows([&] { return viewer.dots() < dots; }));
        dots = viewer.dots();
        CHECK(viewer.quit() == 0);
    }
    RunningViewer viewer(folder.path(), {"one.pgm"}, memory);
    CHECK(viewer.dots() == dots);
    viewer.key("ctrl+o");
    REQUIRE(viewer.shows([&] { return viewer.has("Path"); }));
    viewer.xdotool("type '" + (folder / "two.pgm").string() + "'");
    for (const char* keys : {"ctrl+a", "ctrl+c", "Escape"}) viewer.key(keys);
    REQUIRE(viewer.shows([&] { return !viewer.has("Path"); }));
    viewer.key("ctrl+v");
    REQUIRE(viewer.is_titled("two.pgm - Dapple$"));
    viewer.key("i");
    viewer.move(400, 400);
    REQUIRE(viewer.is_relaxed());
    CHECK(viewer.status()["steps"] > 0);
    CHECK(viewer.shows([&] { return viewer.has("Lit tile"); }));
}

TEST_CASE(
    "of a project whose picture is gone a click finds another, and a desktop's dialog that fails is told "
    "of") {
    const TemporaryFolder folder;
    put_text(folder / "moved.dapple", R"({"dapple": 1, "picture": "gone.png", "drawing": {"count": 500}})");
    put_text(folder / "zenity", "#!/bin/sh\nexit 255\n");
    fs::permissions(folder / "zenity", fs::perms::owner_all);
    Display display;
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
    RunningViewer viewer(folder.path(), {"moved.dapple"}, {folder / "memory", false});
    ::setenv("PATH", path.c_str(), 1);
    viewer.click("Find the picture");
    CHECK(viewer.shows([&] {
        return viewer.has("zenity could not show its dialog; choose Dapple's dialog in the preferences");
    }));
    CHECK(viewer.has("Find the picture"));
    CHECK(viewer.quit() == 0);
}

TEST_CASE("what another program copied is opened: a picture, which is kept, and then a file by its path") {
    const TemporaryFolder folder;
    put_text(folder / "red.ppm", "P3\n2 1\n255\n255 0 0 90 0 0\n");
    put_text(folder / "named.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    put_text(folder / "path", (folder / "named.pgm").string() + "\n");
    run({"convert", (folder / "red.ppm").string(), (folder / "red.png").string()});
    Display display;
    RunningViewer viewer(folder.path(), {write_unrelaxed(folder)}, WindowMemory{folder / "home"});
    const int before = viewer.status()["placings"];
    run({"xclip", "-selection", "clipboard", "-t", "image/png", (folder / "red.png").string()});
    viewer.key("ctrl+v");
    REQUIRE(viewer.is_titled("^pasted .*[.]png - Dapple$"));
    const fs::path pasted = folder / "home/dapple/pasted";
    REQUIRE(fs::exists(pasted));
    CHECK((text_of(fs::directory_iterator(pasted)->path()) == text_of(folder / "red.png")));
    CHECK(viewer.shows([&] { return viewer.status()["placings"] > before; }));
    run({"xclip", "-selection", "clipboard", (folder / "path").string()});
    viewer.key("ctrl+v");
    REQUIRE(viewer.is_titled("^named.pgm - Dapple$"));
}

TEST_CASE(
    "a right click on the canvas opens a menu, which fits the page, copies the drawing and exports it") {
    TemporaryFolder folder;
    put_text(folder / "grey.pgm", "P2 4 4 255 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9");
    put_text(folder / "start.dapple",
             R"({"dapple": 1, "picture": "grey.pgm", "drawing": {"count": 300, "relax": 0}})");
    Display display;
    RunningViewer viewer(folder.path(), {"start.dapple"}, WindowMemory{folder / "home"});
    const auto open_menu = [&] {
        viewer.move(300, 300);
        viewer.xdotool("click 3");
        REQUIRE(viewer.shows([&] { return viewer.has("1:1"); }));
    };
    const double zoom = viewer.status()["zoom"];
    open_menu();
    viewer.click("1:1");
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] < zoom / 10; }));  // of four pixels
    REQUIRE(viewer.shows([&] { return !viewer.has("1:1"); }));
    open_menu();
    viewer.xdotool("key Down Return");
    CHECK(viewer.shows([&] { return viewer.status()["zoom"] == zoom && !viewer.has("1:1"); }));
    open_menu();
    viewer.click("Copy picture");
    REQUIRE(viewer.shows([&] { return viewer.has("Drawing copied") && !viewer.has("1:1"); }));
    run({"sh", "-c",
         "xclip -selection clipboard -o -t image/png >'" + (folder / "copied.png").string() + "'"});
    run({dapple_program(), "render", (folder / "start.dapple").string(), "-o",
         (folder / "command.png").string()});
    CHECK((decode_png(text_of(folder / "copied.png")).preview.values ==
           decode_png(text_of(folder / "command.png")).preview.values));
    for (const auto& entry : fs::recursive_directory_iterator(folder / "home"))
        CHECK(entry.path().extension() != ".png");  // nothing is left of it
    open_menu();
    viewer.click("Export...");
    CHECK(viewer.shows([&] { return viewer.has("Path"); }));
}

}  // namespace dapple
