// Files that --pens reads.

#include <doctest/doctest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/settings/palettes.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

PenChoice pens_of(const std::string& text) {
    const TemporaryFolder folder;
    put_text(folder / "mine.json", text);
    return read_pens(folder / "mine.json");
}

// What reading it says; empty if nothing.
std::string complaint_about(const std::string& text) {
    try {
        pens_of(text);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("pens in JSON are those that their fields say, as lines of text are") {
    const PenChoice pens = pens_of(R"(
        [{"name": "Sky", "width_mm": 0.3, "colour": "#3aa0d8", "gap_mm": 0.6, "gain_mm": 0.05},
         {"name": "Dark ochre", "colour": "#852"}])");
    CHECK(pens.set == PenSet::own);
    CHECK(text_of(pens) == "Sky:#3aa0d8:0.3+0.05:0.6,Dark ochre:#885522");
    CHECK(pens == pens_of("# mine\nSky:#3aa0d8:0.3+0.05:0.6\nDark ochre:#852\n"));
    CHECK(pens_of(R"([{"name": "A", "colour": "#111", "width_mm": 0, "gain_mm": 0}])").own[0].width_mm == 0);
}

TEST_CASE("a file of pens that is wrong is told with its name, the pen and the field") {
    const std::string good = R"({"name": "A", "colour": "#111"}, )";
    struct Wrong {
        std::string text, words;
    };
    for (const auto& [text, words] :
         {Wrong{"[" + good + R"({"name": "B", "colour": "#111", "width": 0.3}])",
                "pen 2: width: is not known"},
          Wrong{"[" + good + R"({"colour": "#111"}])", "pen 2: name: is missing"},
          Wrong{R"([{"name": 3, "colour": "#111"}])", "pen 1: name: 3 is not a text"},
          Wrong{R"([{"name": "<b>", "colour": "#111"}])", R"(pen 1: name: "<b>" is not possible)"},
          Wrong{R"([{"name": "A"}])", "pen 1: colour: is missing"},
          Wrong{R"([{"name": "A", "colour": "blue-ish"}])", "pen 1: colour: "},
          Wrong{R"([{"name": "A", "colour": "#111", "width_mm": "0.3"}])",
                R"(pen 1: width_mm: "0.3" is not)"},
          Wrong{R"([{"name": "A", "colour": "#111", "width_mm": -1}])", "pen 1: width_mm: -1 is not"},
          Wrong{R"([{"name": "A", "colour": "#111", "width_mm": 51}])", "a number from 0 to 50"},
          Wrong{R"([{"name": "A", "colour": "#111", "width_mm": 1e999}])", "is not JSON"},
          Wrong{R"([{"name": "A", "colour": "#111", "width_mm": 1, "gain_mm": true}])",
                "pen 1: gain_mm: true"},
          Wrong{R"([{"name": "A", "colour": "#111", "gap_mm": 1}])",
                "pen 1: gap_mm: applies to a pen with a width only"},
          Wrong{R"(["A"])", R"(pen 1: "A" is no pen)"},
          Wrong{R"({"pens": []})", "has no array of pens"},
          Wrong{"[]", "0 pens are not possible"},
          Wrong{"[" + good + R"({"name": "A", "colour": "#222"}])", "two pens are called A"},
          Wrong{R"([{"name": "cmyk", "colour": "#222"}])", "cmyk is a set of pens"},
          Wrong{"[{\"name\": \"A\", ", "is not JSON from byte"},
          Wrong{std::string(400'000, '[') + std::string(400'000, ']'), "brackets within brackets"},
          Wrong{"Sky:#111:wide", "wide cannot be a pen's width"}}) {
        CAPTURE(text.substr(0, 200));
        const std::string complaint = complaint_about(text);
        CAPTURE(complaint);
        CHECK(complaint.find("mine.json: ") != std::string::npos);
        CHECK(complaint.find(words) != std::string::npos);
    }
}

TEST_CASE("the command takes pens from a file of JSON, and what is wrong in it is a wrong option") {
    const Scene scene;
    put_text(scene("mine.json"), R"([{"name": "Sky", "colour": "#9cf", "width_mm": 0.4},
                                     {"name": "Ink", "colour": "#111", "width_mm": 0.4}])");
    const std::string draw = "render " + scene("cat.png") + " --dots 500 --pens ";
    REQUIRE(run_dapple(draw + scene("mine.json") + " -o " + scene("a.csv")).status == 0);
    REQUIRE(run_dapple(draw + "Sky:#9cf:0.4,Ink:#111:0.4 -o " + scene("b.csv")).status == 0);
    CHECK(text_of(scene("a.csv")) == text_of(scene("b.csv")));
    put_text(scene("bad.json"), R"([{"name": "Sky"}])");
    scene.must_fail(draw + scene("bad.json") + " -o " + scene("c.csv"),
                    "bad.json: pen 1: colour: is missing");
}

TEST_CASE("the command takes a palette by its name, and the shell is offered those there are") {
    const Scene scene;
    const std::filesystem::path palettes = scene.folder / "config/dapple/palettes";
    std::filesystem::create_directories(palettes);
    put_text(palettes / "sky.json", R"([{"name": "Sky", "colour": "#9cf", "width_mm": 0.4},
                                        {"name": "Ink", "colour": "#111"}])");
    put_text(palettes / "broken.json", "[]");
    put_text(palettes / "cmyk.json", "a set's name is the set's");
    const std::string at_home = "XDG_CONFIG_HOME=" + scene("config") + " \"$DAPPLE\" ";
    const std::string draw = at_home + "render " + scene("cat.png") + " --dots 500 --pens ";
    REQUIRE(run_in_shell(draw + "sky -o " + scene("a.csv")).status == 0);
    REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 500 --pens Sky:#9cf:0.4,Ink:#111 -o " +
                       scene("b.csv"))
                .status == 0);
    CHECK(text_of(scene("a.csv")) == text_of(scene("b.csv")));
    CHECK(run_in_shell(draw + "cmyk -o " + scene("c.csv")).status == 0);
    const auto complaint = [&](const std::string& pens) {
        const Outcome outcome = run_in_shell(draw + pens + " -o " + scene("d.csv"));
        CHECK(outcome.status != 0);
        CHECK(outcome.sentences() == 1);
        return outcome.err;
    };
    CHECK(complaint("broken").find("broken.json: 0 pens are not possible") != std::string::npos);
    CHECK(complaint("Sea").find("there is no file or palette \"Sea\"; palettes are ballpoints, ") !=
          std::string::npos);
    REQUIRE(run_in_shell(draw + "auto:1:sky -o " + scene("e.csv")).status == 0);
    REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 500 --pens auto:1:Sky:#9cf:0.4,Ink:#111 -o " +
                       scene("f.csv"))
                .status == 0);
    CHECK(text_of(scene("e.csv")) == text_of(scene("f.csv")));
    CHECK(run_in_shell(draw + "auto:2:0.3mm -o " + scene("g.csv")).status == 0);  // a width
    CHECK(complaint("auto:2:sky").find("2 pens leave auto:2 no choice") != std::string::npos);
    CHECK(complaint("auto:2:Sea").find("there is no file or palette \"Sea\"") != std::string::npos);
    const std::string offered = run_in_shell(at_home + "complete -- render --pens ''").out;
    for (const char* word : {"cmyk\t", "ballpoints\t", "sky\t"})
        CHECK(offered.find(word) != std::string::npos);
}

}  // namespace dapple
