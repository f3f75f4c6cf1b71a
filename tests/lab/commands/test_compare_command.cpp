#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <string>

#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

const std::string kFew =
    "compare --methods dapple,white-noise,rank-1 --dots 1024 --picture-dots 300 --most 1000 ";

// A ramp: small, as rendering a large picture takes most of the time.
std::string ramp_in(const TemporaryFolder& folder) {
    PictureFile ramp{.width = 96, .height = 96};
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) ramp.values.push_back(float(x + y) / 192);
    write_picture(folder / "ramp.png", ramp);
    return (folder / "ramp.png").string() + " ";
}

}  // namespace

TEST_CASE("compare measures methods whose numbers are known, in tables, JSON and a page") {
    const TemporaryFolder folder;
    const std::string json_file = (folder / "c.json").string(), page_file = (folder / "c.html").string();
    const Outcome outcome = run_lab(kFew + ramp_in(folder) + "--json " + json_file + " --page " + page_file);
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("| white noise | 1,024 | 1,024 |") != std::string::npos);
    CHECK(outcome.out.find("Dapple is not first in") != std::string::npos);

    const nlohmann::json methods = nlohmann::json::parse(text_of(folder / "c.json"))["methods"];
    REQUIRE(methods.size() == 3);
    const nlohmann::json noise = methods[1]["grey"][0], lattice = methods[2]["grey"][0];
    CHECK(noise["nearest_mean"].get<double>() == doctest::Approx(0.4653).epsilon(0.05));
    CHECK(noise["l2_star"].get<double>() == doctest::Approx(std::sqrt(5.0 / 36 / 1024)).epsilon(0.7));
    CHECK(noise["seam"].is_null());
    CHECK(lattice["top_share"].get<double>() == doctest::Approx(1));
    CHECK(lattice["nearest_min"].get<double>() == doctest::Approx(lattice["nearest_mean"].get<double>()));
    CHECK(methods[0]["grey"][0]["dots"] == 1024);
    CHECK(methods[0]["pictures"][0]["ssim"].get<double>() > methods[1]["pictures"][0]["ssim"].get<double>());
    CHECK(methods[0]["growth"].size() == 1);

    pugi::xml_document page;
    REQUIRE(page.load_file(page_file.c_str()));
    // Dots and spectrum of each on grey; the picture and its drawings.
    CHECK(page.select_nodes("//img").size() == 2 * 3 + 1 + 3);
    CHECK(page.select_nodes("//svg").size() >= 2);
    // Nothing beside it is needed, and nothing is asked of a network.
    for (const pugi::xpath_node& source : page.select_nodes("//@src | //@href | //@srcset | //@data"))
        CHECK(std::string(source.attribute().value()).starts_with("data:"));
    CHECK(page.select_nodes("//script | //link | //iframe | //object").empty());
    for (const pugi::xpath_node& style : page.select_nodes("//style | //@style")) {
        const std::string text = style.node() ? style.node().text().get() : style.attribute().value();
        CHECK(text.find("url(") == std::string::npos);
        CHECK(text.find("@import") == std::string::npos);
    }
}

TEST_CASE("icons come instead of the still life, and their drawings' cells are marked") {
    const TemporaryFolder folder;
    const Outcome outcome = run_lab(
        "compare --icons --methods dapple,white-noise --dots 256 --picture-dots 256 --most 1 --json " +
        (folder / "c.json").string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("### star, 256 dots") != std::string::npos);
    CHECK(outcome.out.find("still life") == std::string::npos);
    const nlohmann::json methods = nlohmann::json::parse(text_of(folder / "c.json"))["methods"];
    REQUIRE(methods[0]["pictures"].size() == 5);
    for (std::size_t i = 0; i < 5; ++i)
        for (const char* const mark : {"cvt_energy", "capacity_deviation", "centroid_displacement"})
            CHECK(methods[0]["pictures"][i][mark].get<double>() <
                  methods[1]["pictures"][i][mark].get<double>());
}

TEST_CASE("what takes longer than allowed is a dash in the table and null in JSON") {
    const TemporaryFolder folder;
    const Outcome outcome = run_lab(
        "compare --methods best-candidate --dots 400000 --picture-dots 100 --most 1 "
        "--seconds 0.5 --json " +
        (folder / "c.json").string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("| best candidate | 400,000 | - | - |") != std::string::npos);
    const nlohmann::json method = nlohmann::json::parse(text_of(folder / "c.json"))["methods"][0];
    CHECK(method["grey"][0]["seconds"].is_null());
    CHECK(method["pictures"][0]["seconds"].get<double>() < 0.5);
}

TEST_CASE("Ctrl+C ends a comparison with a sentence, and no file is written") {
    const TemporaryFolder folder;
    // In the foreground: otherwise timeout signals twice, and a second signal ends the program at once.
    const Outcome outcome = run_in_shell(
        "timeout --foreground -s INT 6 \"$DAPPLE_LAB\" compare --methods best-candidate --dots 4M --most 1 "
        "--seconds 1000 --json " +
        (folder / "c.json").string());
    CHECK(outcome.status != 0);
    CHECK(outcome.err.find("stopped: 0 of 1 methods were measured") != std::string::npos);
    CHECK(outcome.sentences() == 1);
    CHECK(folder.entries() == 0);
}

TEST_CASE("compare says in one sentence what is wrong with its options") {
    struct Wrong {
        std::string arguments, words;
    };
    for (const Wrong& wrong :
         {Wrong{"--methods dapple,nonsense", "--methods: nonsense is not known; there are dapple, "},
          Wrong{"--json report.txt", "report.txt: does not end in .json"},
          Wrong{"--page report.pdf", "report.pdf: does not end in .html"}, Wrong{"--dots 0", "--dots"},
          Wrong{"--dots 1e9", "--dots"}, Wrong{"--seconds 0", "--seconds"},
          Wrong{"/nowhere/cat.jpg", "/nowhere/cat.jpg"}}) {
        CAPTURE(wrong.arguments);
        const Outcome outcome = run_lab("compare " + wrong.arguments);
        CHECK(outcome.status != 0);
        CHECK(outcome.sentences() == 1);
        CHECK(outcome.err.find(wrong.words) != std::string::npos);
    }
}
