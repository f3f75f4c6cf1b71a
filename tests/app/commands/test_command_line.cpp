// The command line: its help, and what is understood or refused before anything is drawn.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "io/command_line/program.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

TEST_CASE("what is printed onto a full disk is told of, and is a failure") {
    for (const char* arguments : {"tile list", "--help", "render --help", "--version"}) {
        CAPTURE(arguments);
        const Outcome full = run_in_shell(std::string("\"$DAPPLE\" ") + arguments + " >/dev/full");
        CHECK(full.status == 1);
        CHECK(full.err.find("the standard output cannot be written: ") != std::string::npos);
    }
}

TEST_CASE("help names every option and shows examples") {
    const Outcome all = run_dapple("--help"), render = run_dapple("render --help");
    CHECK(all.status == 0);
    CHECK(all.err.empty());
    CHECK(all.out.find("render") != std::string::npos);
    for (const char* option :
         {"--output",     "--scale",    "--dots",       "--placer",      "--tile",        "--ranking",
          "--dot-radius", "--width",    "--margin",     "--dpi",         "--black-point", "--white-point",
          "--exposure",   "--contrast", "--brightness", "--gamma",       "--blur",        "--invert",
          "--ink",        "--paper",    "--order",      "--sheet",       "--region",      "--tiles",
          "--background", "--threads",  "--huge",       "--stats",       "--format",      "--gcode",
          "--feed",       "--dwell",    "--page",       "--orientation", "--height",      "--fit",
          "--crop",       "--rotate",   "Examples:"}) {
        CAPTURE(std::string(option));
        CHECK(render.out.find(option) != std::string::npos);
    }
}

TEST_CASE("a misspelt command is told with the nearest one, and a name that may be a picture is none") {
    const Scene scene;
    scene.must_fail("rendr x", "there is no command \"rendr\"; did you mean \"render\"?");
    scene.must_fail("tile shwo paper16", "there is no command \"shwo\"; did you mean \"show\"?");
    scene.must_fail("render --dotz 5 -o a.svg", "there is no option --dotz; did you mean --dots?");
    scene.must_fail("tile search --poinst=5", "there is no option --poinst; did you mean --points?");
    scene.must_fail("render --frobnicate", "there is no option --frobnicate; dapple render --help lists");
    scene.must_fail("frobnicate", "there is no command \"frobnicate\"; --help lists");
    scene.must_fail("missing.png --nonsense", "--nonsense");
}

TEST_CASE("a command that the laboratory's program has is told with its name, unless it is a picture's") {
    const Scene scene;
    for (const char* command : {"analyse", "compare", "reproduce", "volume", "tile rules", "tile search",
                                "tile rank", "tile check"}) {
        const Outcome outcome = run_dapple(command + std::string(" cat.png -o x.html"));
        CHECK(outcome.status == 2);
        CHECK(outcome.err == std::string("dapple: the command ") + command +
                                 " is in dapple-lab: dapple-lab " + command + " --help\n");
    }
    const std::string here = "cd " + scene.folder.path().string() + " && ";
    const Outcome named =
        run_in_shell(here + "cp cat.png volume && unset DISPLAY WAYLAND_DISPLAY; \"$DAPPLE\" volume");
    CHECK(named.err.find("dapple-lab") == std::string::npos);
}

TEST_CASE("help ends its lines at the terminal's edge, between words and below where they began") {
    CHECK(wrapped("one two three\n\nfour", 7) == "one two\nthree\n\nfour");
    CHECK(wrapped("  --dots N   one two three four", 28) == "  --dots N   one two three\n             four");
    CHECK(wrapped("             one two three four", 28) == "             one two three\n             four");
    CHECK(wrapped("  dapple render cat.jpg -o cat.svg", 20) == "  dapple render cat.jpg -o cat.svg");
    CHECK(wrapped("a/very/long/name/of/a/file and more", 20) == "a/very/long/name/of/a/file\nand more");
    const std::string help = run_dapple("render --help").out;
    const auto words_of = [](const std::string& text) {
        std::istringstream words(text);
        return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
    };
    for (const std::size_t width : {60, 80, 120}) {
        const std::string narrow = wrapped(help, width);
        CHECK(words_of(narrow) == words_of(help));
        std::istringstream lines(narrow);
        for (std::string line; std::getline(lines, line);) {
            CAPTURE(line);
            const std::string words = line.substr(std::min(line.find_first_not_of(' '), line.size()));
            const bool one_word = words.find(' ') == words.npos;
            const bool to_copy = line.size() == words.size() + 2 && words.find("  ") == words.npos;
            CHECK((line.size() <= width || one_word || to_copy));
        }
    }
}

TEST_CASE("what is wrong with the command line ends with 2, what cannot be done with 1") {
    const Scene scene;
    CHECK(run_dapple("render --gcode plough -o " + scene("a.nc")).status == 2);
    CHECK(run_dapple("render --dotz 5 -o " + scene("a.svg")).status == 2);
    CHECK(run_dapple("render --dots none -o " + scene("a.svg")).status == 2);
    CHECK(run_dapple("render " + scene("no.png") + " -o " + scene("a.svg")).status == 1);
    CHECK(run_dapple("--help").out.find("Exit status: ") != std::string::npos);
    CHECK(run_dapple("manual").out.find(".SH EXIT STATUS\n") != std::string::npos);
}

TEST_CASE(
    "a tile for the window that is none is refused before there is a window, and no command swallows it") {
    const Scene scene;
    scene.must_fail("--tile missing.tile", "missing.tile: no such tile or tile file");
    scene.must_fail("--tile 1,2/17", "17 points");
    scene.must_fail("--tile paper16 render -o " + scene("s.svg"), "--tile: applies to the window");
    CHECK_FALSE(std::filesystem::exists(scene("s.svg")));
}

TEST_CASE("a count is understood as people write it") {
    const Scene scene;
    const auto dots = [&](const std::string& text) {
        REQUIRE(
            run_dapple("render " + scene("cat.png") + " -o " + scene("n.csv") + " --dots " + text).status ==
            0);
        const std::string table = text_of(scene("n.csv"));
        return std::ranges::count(table, '\n') - 1;
    };
    CHECK(dots("1,200") == 1200);
    CHECK(dots("2k") == 2000);
    CHECK(dots("1.5K") == 1500);
    CHECK(dots("0.002M") == 2000);
    CHECK(dots("1e3") == 1000);
}

TEST_CASE("what needs more memory than there is is refused before it begins, unless it is allowed") {
    const Scene scene;
    const std::string out = " -o " + scene("x");
    scene.must_fail("render" + out + ".svg --order shortest --dots 5G", "of memory, and ");
    scene.must_fail("render" + out + ".svg --style line --dots 5G",
                    "available; choose fewer, or try with --memory ");
    scene.must_fail("analyse" + out + ".json --dots 2147483648",
                    "analysing 2,100,000,000 dots would need about ");
    scene.must_fail("render" + out + ".svg --order space --dots 100k --memory 1M",
                    "and 1.0 MB are allowed; choose fewer");
    scene.must_fail("lights" + out + ".csv --samples 1M --memory 10M", "1,000,000 samples would need about ");
    scene.must_fail("render" + out + ".svg --memory much",
                    "--memory: much is not possible; give bytes, such as 12G");
    // Streams hold a piece at a time.
    CHECK(run_dapple("render" + out + ".svg --order recursion --relax 0 --dots 100k --memory 1M").status ==
          0);
    CHECK(run_dapple("render" + out + ".svg --order space --dots 100k --memory 1G").status == 0);
}

TEST_CASE("option values that cannot be are refused with the option's name") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("old.svg") + " ";
    struct Wrong {
        const char* option;
        const char* words;
    };
    for (const Wrong& wrong :
         {Wrong{"--scale -1", "--scale: -1 is not possible"},
          Wrong{"--scale 0", "--scale: 0 is not possible"},
          Wrong{"--scale nan", "--scale: nan is not a number"},
          Wrong{"--scale inf", "--scale: inf is not a number"},
          Wrong{"--scale 12x", "--scale: 12x is not a number"},
          Wrong{"--scale 1e30", "--scale: 1e+30 would make"},
          Wrong{"--dots 0", "--dots: 0 is not possible"},
          Wrong{"--dots -5", "--dots: -5 is not possible"},
          Wrong{"--dots 1.5", "--dots: 1.5 is not possible"},
          Wrong{"--dots 10.000", "--dots: 10.000 is not possible"},
          Wrong{"--dots 10,00", "--dots: 10,00 is not possible"},
          Wrong{"--dots 1,0000", "--dots: 1,0000 is not possible"},
          Wrong{"--dots 1.2345k", "--dots: 1.2345k is not possible"},
          Wrong{"--dots 99999999999", "--dots: 99999999999 is not possible"},
          Wrong{"--dots 10 --scale 10", "--dots: cannot be given together with --scale"},
          Wrong{"--placer best", "--placer: best is not known"},
          Wrong{"--ranking best", "--ranking: best is not known"},
          Wrong{"--tile best", "best: no such tile"},
          Wrong{"--tile 1,2/17", "17 points"},
          Wrong{"--dot-radius 0", "--dot-radius: 0 is not possible"},
          Wrong{"--dot-radius -1", "--dot-radius: -1 is not possible"},
          Wrong{"--width 0", "--width: 0 is not possible"},
          Wrong{"--width nan", "--width: nan is not a length in mm, cm, in or pt"},
          Wrong{"--dpi 0", "--dpi: 0 is not possible"},
          Wrong{"--threads -1", "--threads: -1 is not possible"},
          Wrong{"--threads 1.5", "--threads: 1.5 is not a whole number"},
          Wrong{"--black-point 2", "--black-point: 2 is not possible"},
          Wrong{"--black-point 0.5 --white-point 0.5", "--black-point: must be below"},
          Wrong{"--exposure 21", "--exposure: 21 is not possible"},
          Wrong{"--exposure bright", "--exposure: bright is not a number"},
          Wrong{"--contrast 1.1", "--contrast: 1.1 is not possible"},
          Wrong{"--gamma 0", "--gamma: 0 is not possible"},
          Wrong{"--blur -3", "--blur: -3 is not possible"},
          Wrong{"--sheet 4,1/3x4", "--sheet: '4,1/3x4': sheets are counted"},
          Wrong{"--region 1,2,3", "--region: '1,2,3' is not a region"},
          Wrong{"--region 10,10,1e308x1e308", "the region reaches to 1e+308 x 1e+308 mm, and"},
          Wrong{"--region 0,0,0x5", "--region: '0,0,0x5': a region needs a width"},
          Wrong{"--region -1,0,5x5", "--region: '-1,0,5x5': a region's corner"},
          Wrong{"--region 150,0,60x10", "--region: the region reaches to 210"},
          Wrong{"--region 0,0,9x9 --sheet 1,1/2x2", "--region: cannot be given"},
          Wrong{"--ink blue", "--ink: blue: not a colour"},
          Wrong{"--scale 1e-300", "--scale: 1e-300 gives no dots; give a higher"},
          Wrong{"--width 1e-9", "--width: 1e-9 is not possible; give a length in mm, cm, in or pt from"},
          Wrong{"--margin 99.999", "--margin: 99.999 mm on either side leave no room"},
          Wrong{"--region 0,0,1e-9x1e-9", "--region: 1e-09 x 1e-09 mm is too small"},
          Wrong{"--crop 0,0,1e-9x1e-9", "--crop: the part is 1e-09 x 1e-09 pixels"},
          Wrong{"--crop 0%,0%,1e-9%x100%", "--crop: the part is"},
          Wrong{"--dot-shape point --dot-radius 1", "--dot-radius: a point is as large as the pen makes it"},
          Wrong{"--dot-radius 1e6", "--dot-radius: 1e6 is not possible"},
          Wrong{"--margin 0 --dot-radius 900..1000", "--dot-radius: the dots are too large"},
          Wrong{"--nonsense", "--nonsense"}}) {
        scene.must_fail(from + wrong.option, wrong.words);
    }
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.png") + " --tiles",
                    "--tiles: only an SVG");
    scene.must_fail(
        "render " + scene("cat.png") + " -o " + scene("new.png") + " --width 100000 --dpi 2400",
        "--dpi: the page would be 9448819 x 6299213 pixels, and the most is 1000000 a side and 4 gigapixels");
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.png") + " --dpi 100000",
                    "choose 9800 pixels per inch or less, a smaller page");
}

TEST_CASE("a command line that is wrong ends with 2, what cannot be done with 1, and what is done with 0") {
    const Scene scene;
    const std::string map = " -o " + scene("new.json"), svg = " -o " + scene("new.svg");
    put_text(scene.folder / "text.jpg", "This is no picture.\n");
    struct Expected {
        std::string arguments;
        int status;
    };
    for (const Expected& e :
         {Expected{"--version", 0}, Expected{"render --help", 0}, Expected{"tile list", 0},
          // Known to be wrong before anything is looked at.
          Expected{"frobnicate", 2}, Expected{"--nonsense", 2}, Expected{"render", 2},
          Expected{"render --dots 0" + svg, 2}, Expected{"render --nonsense" + svg, 2},
          Expected{"render --gamma 1 --tone auto" + svg, 2},
          Expected{"render --gamma 1 --tone-strength 0.5" + svg, 2}, Expected{"lights -n 0" + map, 2},
          Expected{"tile search --points 17", 2}, Expected{"tile search --points 16 --seed 3", 2},
          Expected{"analyse --nonsense", 2}, Expected{"reproduce --nonsense", 2},
          // Rightly asked for.
          Expected{"render " + scene("none.png") + svg, 1}, Expected{"render " + scene("text.jpg") + svg, 1},
          Expected{"render " + scene("cat.png") + " -o " + scene("none/new.svg"), 1},
          Expected{"lights " + scene("none.hdr") + map, 1}, Expected{"tile check " + scene("none.tile"), 1},
          Expected{"analyse " + scene("none.csv") + " -o " + scene("new.html"), 1}}) {
        CAPTURE(e.arguments);
        const Outcome outcome = run_either(e.arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.status == e.status);
        CHECK(outcome.err.empty() == (e.status == 0));
    }
}

TEST_CASE("an option that has no say in the drawing is refused, with what it is for") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o ";
    scene.must_fail(from + scene("new.svg") + " --dpi 600", "--dpi: only a PNG or a TIFF has pixels");
    scene.must_fail(from + scene("new.csv") + " --dpi 600", "--dpi: only a PNG or a TIFF has pixels");
    scene.must_fail(from + scene("new.png") + " --order space", "--order: the pixels of a PNG or a TIFF");
    for (const std::string colour : {"--ink '#fff'", "--paper '#fff'", "--background"})
        scene.must_fail(from + scene("new.csv") + " " + colour, "a table has no colours");
    scene.must_fail(from + scene("new.svg") + " --paper '#fff'",
                    "--paper: shows in an SVG or a PDF with --background only");
    scene.must_fail(from + scene("new.svg") + " --placer figure8 --scale 100 --ranking energy",
                    "--ranking: does not apply to the figure8 placer");
    scene.must_fail(from + scene("new.svg") + " --order priority --relax 3",
                    "--order: priority: the first dots");
    CHECK_FALSE(std::filesystem::exists(scene("new.svg")));
    // A PNG always has its paper; asking for it is no mistake.
    CHECK(run_dapple(from + scene("new.png") + " --background --paper '#ffe' --dpi 20").status == 0);
}
