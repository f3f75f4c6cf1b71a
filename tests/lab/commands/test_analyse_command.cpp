#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/point_sets.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

std::string table_of(const std::vector<glm::dvec2>& points) {
    std::ostringstream text;
    text.precision(17);
    for (const glm::dvec2 p : points) text << p.x << ',' << p.y << '\n';
    return text.str();
}

class Scene {
 public:
    TemporaryFolder folder;

    std::string operator()(const std::string& name) const { return (folder / name).string(); }
    void put(const std::string& name, const std::string& text) const { put_text(folder / name, text); }

    nlohmann::json json(const std::string& arguments) const {
        const Outcome outcome = run_lab("analyse " + arguments + " -o " + (*this)("r.json"));
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        return nlohmann::json::parse(text_of(folder / "r.json"));
    }

    // One sentence with these words, and the report that was there is as it was.
    void refuses(const std::string& arguments, const std::string& words) const {
        put("old.json", "the old report");
        const std::size_t before = folder.entries();
        CAPTURE(arguments);
        const Outcome outcome = run_lab("analyse " + arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.status != 0);
        CHECK(outcome.sentences() == 1);
        CHECK(outcome.err.find(words) != std::string::npos);
        CHECK(text_of(folder / "old.json") == "the old report");
        CHECK(folder.entries() == before);
    }
};

}  // namespace

TEST_CASE("the dots of a drawing that was saved are analysed on its own page, the same from each format") {
    const Scene scene;
    const std::string svg = scene("d.svg"), json = scene("d.json"), csv = scene("d.csv");
    for (const std::string& file : {svg, json, csv})
        REQUIRE(run_dapple("render -o " + file + " --dots 300 --width 120").status == 0);
    const nlohmann::json of_svg = scene.json(svg), of_json = scene.json(json);
    const nlohmann::json of_table = scene.json(csv);
    CHECK(of_table["domain"]["width"] == 120);
    CHECK(of_table["domain"]["height"] == 120);
    // What is said by hand goes before what the table says.
    CHECK(scene.json(csv + " --width 130 --height 125")["domain"]["height"] == 125);
    CHECK(of_json["domain"]["width"] == 120);
    CHECK(of_svg["domain"]["height"] == 120);
    CHECK(of_json["dots"] == 300);
    CHECK(of_json["nearest"] == of_table["nearest"]);
    CHECK(of_svg["nearest"]["mean"].get<double>() ==
          doctest::Approx(of_table["nearest"]["mean"].get<double>()).epsilon(1e-3));
    scene.put("other.svg", "<svg width=\"3cm\" height=\"3cm\"><circle cx=\"1\" cy=\"1\" r=\"1\"/></svg>");
    scene.put("other.json", "[1, 2]");
    scene.refuses(scene("other.svg") + " -o " + scene("old.json"), "is not an SVG that dapple render wrote");
    scene.refuses(scene("other.json") + " -o " + scene("old.json"), "is not a drawing in JSON");
    scene.refuses(svg + " --width 3 -o " + scene("old.json"), "--width: follows from the drawing itself");
    scene.refuses(csv + " --gamma 2 -o " + scene("old.json"), "--gamma: is for pictures");
}

TEST_CASE("analyse says why a drawing without its dots cannot be read") {
    const Scene scene;
    const std::string to_old = " -o " + scene("old.json");
    for (const std::string ending : {"pdf", "gcode", "nc", "hpgl", "dxf"}) {
        const std::string file = scene("d." + ending);
        REQUIRE(run_dapple("render -o " + file + " --dots 300 --width 120").status == 0);
        scene.refuses(file + to_old,
                      "files cannot be read; give points (.csv, .tsv, .txt), a drawing by dapple render");
    }
    scene.refuses(scene("cat.dapple") + to_old,
                  "cat.dapple: a project is neither points nor a picture; draw");
    REQUIRE(run_dapple("render -o " + scene("line.svg") + " --dots 300 --style line").status == 0);
    scene.refuses(scene("line.svg") + to_old, "is drawn with strokes");
    REQUIRE(run_dapple("render -o " + scene("crosses.svg") + " --dots 300 --dot-shape cross").status == 0);
    scene.refuses(scene("crosses.svg") + to_old, "save it as .json or .csv");
}

TEST_CASE("analyse reads the dots of the methods that this program is compared with") {
    const Scene scene;
    const nlohmann::json noise = scene.json("--method white-noise --dots 4000");
    CHECK(noise["dots"] == 4000);
    CHECK(noise["subject"] == "white noise, 4,000 dots asked for");
    CHECK(noise["nearest"]["mean"].get<double>() == doctest::Approx(0.4653).epsilon(0.03));
    CHECK(noise["domain"]["topology"] == "torus");
    CHECK_FALSE(noise.contains("tile"));
    CHECK(scene.json("--method rank-1 --scale 100 --density 0.5")["dots"] == 800);
    CHECK(scene.json("--method white-noise --dots 100 --seed 2")["nearest"] !=
          scene.json("--method white-noise --dots 100 --seed 3")["nearest"]);
    const std::string to_old = " -o " + scene("old.json");
    scene.refuses("--method nonsense" + to_old, "--method: nonsense is not known; there are white-noise, ");
    scene.refuses("--method sobol --tile paper16" + to_old, "--tile: is for this program's own dots");
    scene.refuses("--seed 3" + to_old, "--seed: is for a --method");
    scene.put("good.csv", "0,0\n1,1\n");
    scene.refuses(scene("good.csv") + " --method sobol" + to_old, "--method: is for a constant grey");
}

TEST_CASE("analyse draws a picture with the tone that is asked for") {
    const Scene scene;
    PictureFile grey{.width = 64, .height = 64, .values = std::vector<float>(64 * 64, 0.5f)};
    write_picture(scene.folder / "grey.png", grey);
    const std::string picture = scene("grey.png") + " --scale 500 --relax 0";
    const auto mean_error = [&](const std::string& options) {
        return scene.json(picture + options)["tone_fidelity"][0]["mean_error"].get<double>();
    };
    const auto dots = [&](const std::string& options) {
        return scene.json(picture + options)["dots"].get<double>();
    };
    CHECK(std::abs(mean_error("")) < 0.02);
    CHECK(mean_error(" --brightness 0.2") > 0.1);  // lighter than the picture's own light
    CHECK(dots(" --gamma 0.5") > 1.05 * dots(""));
}

TEST_CASE("a table of a square lattice has the lattice's distances, by its own box or the one given") {
    const Scene scene;
    scene.put("square.csv", table_of(square_lattice(32)));
    const double spacing = std::sqrt(std::sqrt(3.0) / 2);  // 0.9306, over the hexagonal lattice's
    for (const std::string domain : {"--topology torus", "", "--width 1 --height 1 --topology torus"}) {
        const auto report = scene.json(scene("square.csv") + " " + domain);
        CAPTURE(domain);
        CHECK(report["dots"] == 1024);
        CHECK(report["relative_radius"].get<double>() == doctest::Approx(spacing));
        for (const char* key : {"min", "p1", "mean"})
            CHECK(report["nearest"][key].get<double>() == doctest::Approx(spacing));
        CHECK(report["domain"]["width"].get<double>() == doctest::Approx(1));
        CHECK(report["highest_bin"].get<double>() == doctest::Approx(1024).epsilon(1e-3));
        CHECK(report["top_share"].get<double>() == doctest::Approx(1).epsilon(1e-3));
        CHECK(report["low_frequency_power"].get<double>() < 1e-3);
        CHECK(report["radial_power"].size() == 64);
        CHECK(report["radial_frequency"].size() == 64);
        CHECK(report["anisotropy"].size() == 64);
        CHECK(report["pair_correlation"]["g"].size() == 100);
        CHECK(report["discrepancy"]["star_lower"] == report["discrepancy"]["star_upper"]);
        CHECK(report["periodicity"].is_null());
        CHECK_FALSE(report.contains("tile"));
    }
    CHECK(scene.json(scene("square.csv") + " --topology torus --period 0.25")["periodicity"].get<double>() ==
          doctest::Approx(1));
}

TEST_CASE("a table of a hexagonal lattice on its torus has distance 1") {
    const Scene scene;
    const PointSet set = hexagonal_lattice(20, 11);
    scene.put("hexagons.txt", table_of(set.points));
    std::ostringstream domain;
    domain.precision(17);
    domain << " --topology torus --width " << set.domain.width << " --height " << set.domain.height;
    const auto report = scene.json(scene("hexagons.txt") + domain.str());
    CHECK(report["relative_radius"].get<double>() == doctest::Approx(1));
    CHECK(report["nearest"]["mean"].get<double>() == doctest::Approx(1));
    CHECK(report["domain"]["topology"] == "torus");
}

TEST_CASE("the paper's tile on a constant grey has its radius, and repeats entirely") {
    const Scene scene;
    const auto report = scene.json("--tile paper16 --dots 4096 --density 0.5");
    CHECK(report["dots"] == 4096);
    CHECK(report["domain"]["topology"] == "torus");
    CHECK(report["relative_radius"].get<double>() == doctest::Approx(0.652788).epsilon(1e-5));
    CHECK(report["periodicity"].get<double>() == doctest::Approx(1).epsilon(1e-3));
    CHECK(report["period"] == nlohmann::json{1 / 16.0, 1 / 16.0});
    CHECK(report["tile"] == "paper16");
    CHECK(report["mean_density"] == 0.5);
}

TEST_CASE(
    "the default tile is evener than recursive Wang tiles in every column, and nearly so between levels") {
    const Scene scene;
    // Theirs: highest bin 58, and 420 of four times the dots; 2.4 % of the energy in the top 0.1 %, powers
    // 0.118 and 0.135, distances 0.233, 0.618, 0.766.
    struct Least {
        double highest_bin, power_below_03, p1, mean;
    };
    const auto check = [&](int scale, const Least& least) {
        const auto report = scene.json("--scale " + std::to_string(scale));
        CAPTURE(scale);
        CHECK(report["dots"] == 16 * scale);
        CHECK(report["highest_bin"] <= least.highest_bin);
        CHECK(report["power_below_03"] <= least.power_below_03);
        CHECK(report["power_below_05"] < 0.135);
        CHECK(report["nearest"]["min"] > 0.233);
        CHECK(report["nearest"]["p1"] >= least.p1);
        CHECK(report["nearest"]["mean"] >= least.mean);
        if (scale == 4096) CHECK(report["top_share"] < 0.024);
    };
    check(4096, {40, 0.03, 0.65, 0.8});
    check(16384, {60, 0.03, 0.65, 0.8});
    for (const int between : {5161, 7298, 9195, 13004}) check(between, {60, 0.05, 0.49, 0.69});
}

TEST_CASE("Figure 8's dots are counted once, and how many came again") {
    const Scene scene;
    const auto report = scene.json("--placer figure8 --scale 2500");
    CHECK(report["emitted"] == 54608);
    CHECK(report["dots"] == 40960);
    CHECK(report["duplicates"] == 54608 - 40960);
    CHECK(report["relative_radius"].get<double>() > 0);
}

TEST_CASE("a drawing's own table is analysed as it is") {
    const Scene scene;
    write_picture(scene.folder / "grey.png",
                  {.width = 8, .height = 8, .values = std::vector<float>(64, 0.5f)});
    // To its edges, as a torus has it.
    REQUIRE(run_dapple("render " + scene("grey.png") + " --margin 0 --dots 1000 --relax 0 -o " +
                       scene("dots.csv"))
                .status == 0);
    const auto table = scene.json(scene("dots.csv") + " --width 200 --height 200 --topology torus");
    const auto grey = scene.json("--dots 1000");
    CHECK(table["dots"] == 1000);
    CHECK(table["relative_radius"].get<double>() ==
          doctest::Approx(grey["relative_radius"].get<double>()).epsilon(1e-4));
    CHECK(table["top_share"].get<double>() == doctest::Approx(grey["top_share"].get<double>()).epsilon(1e-2));
}

TEST_CASE("a picture's report says how true its tone is, the truer the further off") {
    const Scene scene;
    PictureFile ramp{.width = 96, .height = 64, .values = {}};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) ramp.values.push_back(0.3f + 0.6f * static_cast<float>(x) / 95);
    write_picture(scene.folder / "ramp.png", ramp);
    const auto report = scene.json(scene("ramp.png") + " --dots 3000");
    CHECK(report["dots"] == 3000);
    CHECK(report["domain"]["height"].get<double>() == doctest::Approx(2.0 / 3));
    const auto& tone = report["tone_fidelity"];
    REQUIRE(tone.size() == 4);
    CHECK(tone[0]["blur_spacings"] == 0.5);
    CHECK(tone[3]["rms_error"].get<double>() < tone[0]["rms_error"].get<double>());
    CHECK(tone[3]["ssim"].get<double>() > 0.9);
    CHECK(std::abs(tone[3]["mean_error"].get<double>()) < 0.06);
    // The eye's minute of arc, and a page twice as wide seen from twice as far.
    const double distance = tone[1]["viewing_distance_mm"].get<double>();
    CHECK(distance == doctest::Approx(3437.75 * std::sqrt(200 * 200 * 2.0 / 3 / 3000)).epsilon(1e-3));
    const auto wider = scene.json(scene("ramp.png") + " --dots 3000 --width 400");
    CHECK(wider["tone_fidelity"][1]["viewing_distance_mm"].get<double>() == doctest::Approx(2 * distance));
}

TEST_CASE("a page is well-formed XML with everything in it") {
    const Scene scene;
    scene.put("a&b.csv", table_of(white_noise(500, 1)));
    REQUIRE(run_lab("analyse '" + scene("a&b.csv") + "' -o " + scene("r.html")).status == 0);
    pugi::xml_document page;
    REQUIRE(page.load_file((scene.folder / "r.html").c_str(), pugi::parse_full));
    CHECK(page.select_nodes("//img[starts-with(@src, 'data:image/png;base64,')]").size() >= 2);
    CHECK(page.select_nodes("//*[local-name()='svg']/*[local-name()='title']").size() == 3);
    CHECK(page.select_nodes("//table/tbody/tr").size() > 8);
    CHECK(std::string(page.select_node("//h1").node().text().get()).find("a&b.csv") != std::string::npos);
}

TEST_CASE("a PNG shows the spectrum") {
    const Scene scene;
    REQUIRE(run_lab("analyse --dots 1024 -o " + scene("r.png")).status == 0);
    const Picture picture = read_picture(scene.folder / "r.png");
    CHECK(picture.light.width == 129 * 7);  // 64 bins each way, enlarged as far as 1024 pixels allow
    CHECK(picture.light.height == 129 * 7);
}

TEST_CASE("bad input to an analysis is refused in words, and an old report stays") {
    const Scene scene;
    const std::string to_old = " -o " + scene("old.json");
    scene.put("bad.csv", "1,2\n3,x\n");
    scene.put("nan.csv", "x_mm,y_mm\n1,2\nnan,4\n");
    scene.put("empty.csv", "");
    scene.put("good.csv", "0,0\n1,1\n");
    scene.put("picture.png", "no picture");
    scene.refuses(scene("bad.csv") + to_old, "bad.csv, line 2: \"x\" is not a number");
    scene.refuses(scene("nan.csv") + to_old, "nan.csv, line 3: x is nan");
    scene.refuses(scene("empty.csv") + to_old, "empty.csv: there are no points in it");
    scene.refuses(scene("missing.csv") + to_old, "missing.csv: no such file");
    scene.refuses(scene("missing") + to_old, "missing: no such file");
    scene.put("zeros.csv", std::string(10, '\0'));
    scene.refuses(scene("zeros.csv") + to_old, "zeros.csv: is not text in UTF-8");
    scene.refuses(scene("") + "/.csv" + to_old, ".csv");
    scene.refuses(scene("picture.png") + to_old, "picture.png");
    scene.refuses(scene("good.csv") + " -o " + scene("r.pdf"), "r.pdf: does not end in .json, .html or .png");
    scene.refuses(scene("good.csv") + " -o " + scene("nowhere/r.json"), "nowhere does not exist");
    scene.refuses(scene("good.csv") + " -o " + scene("good.csv"), "does not end in");
    scene.refuses(scene("good.csv") + " --width 0.5 --height 0.5" + to_old, "outside");
    scene.refuses(scene("good.csv") + " --width 3" + to_old, "--height");
    scene.refuses(scene("good.csv") + " --width 0 --height 1" + to_old, "--width");
    scene.refuses(scene("good.csv") + " --dots 100" + to_old, "--dots");
    scene.refuses(scene("good.csv") + " --relax 3" + to_old, "--relax");
    scene.refuses(scene("good.csv") + " --huge" + to_old, "--huge");
    scene.refuses("--huge" + to_old, "--huge");
    scene.refuses("--dot-radius 0.3" + to_old, "--dot-radius");
    scene.refuses("--placer figure8 --scale 100 --ranking energy" + to_old, "--ranking");
    scene.refuses(scene("good.csv") + " --topology sphere" + to_old, "sphere is not known");
    scene.refuses("--density 0" + to_old, "--density");
    scene.refuses("--density nan" + to_old, "--density");
    scene.refuses("--scale 0" + to_old, "--scale: 0 is not possible");
    scene.refuses("--scale 0.001" + to_old, "no dots at this scale");
    scene.refuses("--scale 1e12" + to_old, "dots");
    scene.refuses("--period 3" + to_old, "--period");
    scene.refuses("--tile nonsense" + to_old, "nonsense");
}
