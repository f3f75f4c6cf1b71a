// dapple tile and dapple-lab tile, run as a person runs it.

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/tile/tile_file.h"
#include "io/files/tile_library.h"
#include "lab/search/exhaustive_search.h"
#include "tests/child_process.h"
#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

void check_refused(const std::string& arguments, const std::string& reason) {
    const Outcome outcome = run_either(arguments);
    CAPTURE(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status != 0);
    CHECK(outcome.sentences() == 1);
    CHECK(outcome.err.find(reason) != std::string::npos);
}

}  // namespace

TEST_CASE("the list names every built-in tile with its number of points") {
    const Outcome outcome = run_dapple("tile list");
    CHECK(outcome.status == 0);
    for (const char* name : built_in_tile_names()) {
        const StoredTile stored = load_tile(name);
        const std::size_t at = outcome.out.find("\n" + std::string(name) + " ");
        REQUIRE(at != std::string::npos);
        const std::string line = outcome.out.substr(at + 1, outcome.out.find('\n', at + 1) - at - 1);
        CHECK(line.find(fmt::format(" {} ", stored.tile.size())) != std::string::npos);
    }
}

TEST_CASE("the built-in tiles are the paper's, the lattices and those that do not repeat") {
    const std::set<std::pair<std::string, std::string>> integers{
        {"paper16", "14217,2895/16"},         {"paper20", "205786,15079/20"},
        {"lattice24", "2422572,1554785/24"},  {"lattice28", "46281975,18512790/28"},
        {"best32", "794048332,154885773/32"}, {"lattice36", "11143698930,1857283155/36"}};
    for (const auto& [name, pair] : integers) {
        // The same points, though perhaps counted from another one.
        const Tile expected = parse_tile_integers(pair);
        const auto key = [](const BinaryPoint p) { return std::pair(p.x >> 30, p.y >> 30); };
        std::set<std::pair<std::uint64_t, std::uint64_t>> a, b;
        for (const BinaryPoint p : expected.points) a.insert(key(p));
        for (const BinaryPoint p : load_tile(name).tile.points) b.insert(key(p));
        CHECK(a == b);
    }
    for (const int points : {16, 64, 256, 1024, 4096}) {
        const StoredTile stored = load_tile(fmt::format("aperiodic{}", points));
        CHECK(stored.tile.size() == points);
        CHECK(stored.tile.rule != Rule{});
    }
}

TEST_CASE("every built-in tile renders exactly 10,000 dots, no two at one place") {
    const TemporaryFolder folder;
    for (const char* name : built_in_tile_names()) {
        const std::string file = folder / "dots.csv";
        const Outcome outcome =
            run_dapple(fmt::format("render -o {} --dots 10000 --relax 0 --tile {}", file, name));
        CAPTURE(name);
        CHECK(outcome.err.starts_with("10,000 dots"));
        REQUIRE(outcome.status == 0);
        const std::string text = text_of(file);
        std::set<std::string> places;
        std::size_t lines = 0;
        for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1) {
            places.insert(text.substr(at, text.find(',', text.find(',', at) + 1) - at));
            ++lines;
        }
        CHECK(lines == 10'000);
        CHECK(places.size() == 10'000);
    }
}

TEST_CASE("a tile that is found is a file that renders, and the same seed finds it again") {
    const TemporaryFolder folder;
    const std::string first = folder / "first.tile", second = folder / "second.tile";
    const std::string search = "tile search --points 16 --rule any --moves 1000 --seed 7 -o ";
    const Outcome outcome = run_lab(search + first + " --threads 2");
    REQUIRE(outcome.status == 0);
    // The command that it tells to make the same again, with fewer threads.
    const std::string told = "the same again: dapple-lab ";
    const std::size_t at = outcome.out.find(told);
    REQUIRE(at != std::string::npos);
    std::string again = outcome.out.substr(at + told.size());
    again.pop_back();
    REQUIRE(run_lab(again + " --threads 1 -o " + second).status == 0);
    CHECK(text_of(first) == text_of(second));
    const std::string found = text_of(first);
    CHECK(read_tile(found).tile.size() == 16);
    CHECK(found.find(
              "# found by dapple-lab tile search --points 16 --rule any --seed 7 --runs 2 --moves 1000\n") !=
          std::string::npos);
    CHECK(run_dapple(
              fmt::format("render -o {} --dots 500 --relax 0 --tile {}", (folder / "a.svg").string(), first))
              .status == 0);
}

TEST_CASE("another seed finds another tile") {
    const TemporaryFolder folder;
    const std::string file = folder / "seeded.tile";
    // The words alone: what stands beside them in the file names the seed. Without one it is 1.
    std::set<std::vector<std::string>> found;
    for (const std::string seed : {"--seed 1", "--seed 2", "--seed 3", ""}) {
        REQUIRE(run_lab("tile search --points 32 --rule 3760 --moves 4000 --runs 1 -o " + file + " " + seed)
                    .status == 0);
        found.insert(read_tile(text_of(file)).tile.words);
    }
    CHECK(found.size() == 3);
}

TEST_CASE("a search under nohup goes on to its end when the terminal closes, and stops without") {
    const TemporaryFolder folder;
    const auto search = [&](const std::string& before, const std::string& file) {
        // It saves what it has at once: then the terminal closes.
        return run_in_shell(
            before + "\"$DAPPLE_LAB\" tile search --points 64 --rule 3760 --moves 6e4 --runs 1 -o " + file +
            " & while kill -0 $! && ! [ -e " + file + " ]; do sleep 0.02; done; kill -HUP $!; wait $!");
    };
    const Outcome ignored = search("trap '' HUP; ", folder / "a.tile"), heard = search("", folder / "b.tile");
    CHECK(ignored.status == 0);
    CHECK(ignored.out.find("the same again: ") != std::string::npos);
    CHECK(heard.out.find("stopped: ") != std::string::npos);
}

TEST_CASE("a timed search does not claim that it can be made again, and takes the time that it is given") {
    const TemporaryFolder folder;
    const std::string file = folder / "timed.tile";
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome =
        run_lab("tile search --points 16 --rule 3760 --seconds 1.5 --runs 3 --threads 2 -o " + file);
    REQUIRE(outcome.status == 0);
    CHECK(std::chrono::steady_clock::now() - begin >= std::chrono::milliseconds(1500));
    CHECK(outcome.out.find("the same again: ") == std::string::npos);
    CHECK(outcome.out.find("this takes about as long and always finds the same one: dapple-lab tile search "
                           "--points 16 --rule 3760 --seed 1 --runs 3 --moves ") != std::string::npos);
    CHECK(text_of(file).find(" --seconds 1.5; timed, ") != std::string::npos);
    // However short, it is a search.
    CHECK(run_lab("tile search --points 4 --rule any --seconds 0.01 -o " + file).status == 0);
    CHECK(read_tile(text_of(file)).tile.size() == 4);
}

TEST_CASE("several kinds are searched for, checked, shown and rendered, and found again") {
    const TemporaryFolder folder;
    const std::string file = folder / "kinds.tile", again = folder / "again.tile";
    const std::string search = "tile search --kinds 3 --points 64 --seed 2 --moves 50000";
    const Outcome outcome = run_lab(search + " -o " + file);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("the same again: dapple-lab " + search + "\n") != std::string::npos);
    REQUIRE(run_lab(search + " -o " + again).status == 0);
    CHECK(text_of(file) == text_of(again));
    const nlohmann::json json = nlohmann::json::parse(run_lab("tile check --json " + file).out);
    CHECK(json["kinds"] == 3);
    CHECK(json["points"] == 64);
    CHECK(json["kind_coincidence"] > 0.3);
    CHECK(run_lab("tile check " + file).out.find("3 kinds of 64 points") != std::string::npos);
    const std::string drawing = folder / "kinds.svg";
    REQUIRE(run_dapple("tile show " + file + " -o " + drawing).status == 0);
    CHECK(text_of(drawing).find("half-size copies of kinds ") != std::string::npos);
    const std::string picture = folder / "grey.pgm", csv = folder / "dots.csv";
    std::ofstream(picture) << "P2 1 1 255\n0\n";
    REQUIRE(run_dapple("render " + picture + " --tile " + file + " --dots 5000 -o " + csv).status == 0);
    for (const char* wrong : {"--rule 3760", "--runs 2", "--tone 0 --pairs 0"})
        CHECK(run_lab(search + " -o " + file + " " + wrong).status != 0);
    const auto coherent_share = [&](const std::string& peaks) {
        REQUIRE(run_lab(search + peaks + " -o " + again).status == 0);
        return nlohmann::json::parse(run_lab("tile check --json " + again).out)["coherent_share"]
            .get<double>();
    };
    CHECK(coherent_share(" --peaks 0") > coherent_share(" --peaks 4"));
    CHECK(run_lab("tile search --kinds 3 --points 62 -o " + file).status != 0);
    CHECK(run_lab("tile search --kinds 3 --points 64").status != 0);
    CHECK(run_lab("tile rank --ranking farthest " + file + " -o " + again).status != 0);
}

TEST_CASE("a search finds what it is told to weigh: points apart, an even tone, or no repetition") {
    const TemporaryFolder folder;
    const std::string file = folder / "a.tile";
    const auto marks = [&](const std::string& weights) {
        const Outcome outcome =
            run_lab("tile search --points 64 --rule 3760 --moves 2e4 --runs 1 -o " + file + weights);
        REQUIRE(outcome.status == 0);
        CHECK(outcome.out.find(weights + " --moves 20000\n") != std::string::npos);
        return nlohmann::json::parse(run_lab("tile check --json " + file).out);
    };
    const nlohmann::json usual = marks(""), apart = marks(" --pairs 100"), even = marks(" --pairs 0"),
                         spread = marks(" --peaks 20"), repeating = marks(" --peaks 0");
    CHECK(apart["relative_radius"] > even["relative_radius"]);
    CHECK(apart["low_frequency_power"] > usual["low_frequency_power"]);
    CHECK(usual["low_frequency_power"] > even["low_frequency_power"]);
    CHECK(repeating["coherent_share"] > spread["coherent_share"]);
}

TEST_CASE("the rules are listed from the one that repeats least, with those that are the same turned") {
    const Outcome outcome = run_lab("tile rules --top 2");
    REQUIRE(outcome.status == 0);
    std::istringstream lines(outcome.out);
    std::string heading, first, second, more;
    std::getline(lines, heading);
    std::getline(lines, first);
    std::getline(lines, second);
    CHECK_FALSE(std::getline(lines, more));
    CHECK(first.starts_with("1427 "));
    CHECK(first.find(" 0.1452 ") != std::string::npos);
    CHECK(first.find(" 7241") != std::string::npos);
    CHECK(second.find(" 0.1554 ") != std::string::npos);
}

TEST_CASE("several cycles together are searched for, printed and saved") {
    const TemporaryFolder folder;
    const std::string file = (folder / "best.tile").string();
    const Outcome outcome = run_lab("tile search --cycles 4,4,4,4 --top 4 -o " + file);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(std::regex_search(outcome.out, std::regex("   1  0\\.744484 .* 0013 0211 0233 1322\n")));
    CHECK(std::regex_search(outcome.out, std::regex("   3  0\\.744484 .* 0103 0212 0323 1213\n")));
    CHECK(std::regex_search(outcome.out, std::regex("   4  0\\.554906 ")));
    CHECK(load_tile(file).tile.words == std::vector<std::string>{"0013", "0211", "0233", "1322"});

    check_refused("tile search --cycles 4,4,5", "have 13 points together");
    check_refused("tile search --cycles 4,4,8",
                  "--cycles: 8 is not possible; give a whole number from 1 to 6");
    check_refused("tile search --cycles 4,,4", "--cycles");
    check_refused("tile search --cycles 4,4 --points 8", "is the sum of --cycles");
    check_refused("tile search --cycles 4,4 --by symmetry", "does not go with --cycles");
    check_refused("tile search --cycles 4,4 --rule any -o " + file,
                  "belongs to a search with --rule identity");
    CHECK(run_lab("tile search --cycles 1,1,1,1").out == "in each such tile some points coincide\n");
}

TEST_CASE("tile search finds the tile of lowest discrepancy, or of most symmetry, and saves it") {
    const TemporaryFolder folder;
    const std::string file = (folder / "first.tile").string(),
                      search = "tile search --points 8 --top 2 -o " + file;
    const Outcome even = run_lab(search + " --by discrepancy");
    REQUIRE(even.status == 0);
    CHECK(even.out.find("   1  0.544732         0.193414  ") != std::string::npos);
    CHECK(text_of(folder / "first.tile").find("23200311") != std::string::npos);
    const Outcome symmetric = run_lab(search + " --by symmetry");
    CHECK(symmetric.out.find("   1  0.638390 ") != std::string::npos);
    CHECK(symmetric.out.find(" 0.500     ") != std::string::npos);
    check_refused("tile search --points 16 --rule any --by symmetry -o " + file, "--by");
    check_refused("tile search --points 24 --by symmetry", "--by: symmetry looks at every tile");
    check_refused("tile search --resume " + file + " --by symmetry", "--resume");
}

TEST_CASE("an identity search prints the paper's radii and saves the best tile") {
    const TemporaryFolder folder;
    const std::string file = folder / "best.tile";
    const Outcome outcome = run_lab("tile search --points 16 --top 4 -o " + file);
    CHECK(outcome.status == 0);
    for (const char* radius : {"0.696594", "0.652788", "0.640257", "0.638781", "14217,2895/16"})
        CHECK(outcome.out.find(radius) != std::string::npos);
    const Outcome check = run_lab("tile check --json " + file);
    CHECK(nlohmann::json::parse(check.out)["relative_radius"].get<double>() ==
          doctest::Approx(0.696594).epsilon(1e-6));
}

TEST_CASE("a search by radius that is stopped keeps what it found, and goes on to the same tiles") {
    const TemporaryFolder folder;
    const std::string state = folder / "dapple-search-20.txt";
    const std::string in_folder =
        fmt::format("cd {} && \"$DAPPLE_LAB\" tile search ", folder.path().string());
    // The time is over before the first part is done or while there are few.
    const Outcome stopped = run_in_shell(in_folder + "--points 20 --top 3 --seconds 0.001");
    CHECK(stopped.status == 0);
    REQUIRE(stopped.out.find("stopped") != std::string::npos);
    CHECK(text_of(state).starts_with("dapple exhaustive search 1"));
    const Outcome resumed = run_lab("tile search --resume " + state);
    CHECK(resumed.status == 0);
    for (const char* radius : {"0.832358", "0.714068"}) CHECK(resumed.out.find(radius) != std::string::npos);

    // What is finished says so, is told again without a search, and may be replaced.
    const std::string finished = text_of(state);
    CHECK(finished.find("finished yes\n") != std::string::npos);
    const Outcome again = run_lab("tile search --resume " + state);
    CHECK(again.out == resumed.out);
    CHECK(text_of(state) == finished);
    CHECK(run_in_shell(in_folder + "--points 20 --top 1 --seconds 0.01").status == 0);
    CHECK(text_of(state) != finished);
}

TEST_CASE("a search by radius is saved as it goes, and when it is stopped by whatever stops programs") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const TemporaryFolder folder, said;
        const std::string state = folder / "dapple-search-60.txt";
        ChildProcess search({lab_program(), "tile", "search", "--points", "60"},
                            {.folder = folder.path(), .output = said / "out", .errors = said / "err"});
        REQUIRE(search.brings([&] { return std::filesystem::exists(state); }));
        CHECK(read_search_state(text_of(state)).points == 60);
        search.send(signal);
        if (signal == SIGHUP) search.send(signal);  // as from a shell that ends and a terminal that is gone
        CHECK(search.wait() == 0);
        CHECK(text_of(said / "out").find("--resume dapple-search-60.txt goes on") != std::string::npos);
        const SearchState stopped = read_search_state(text_of(state));
        CHECK_FALSE(stopped.finished);
        CHECK(std::ranges::count(stopped.done, true) > 0);
        CHECK(folder.entries() == 1);
    }
}

TEST_CASE("a search by radius that ends at its first go leaves no file behind") {
    const TemporaryFolder folder;
    CHECK(
        run_in_shell(fmt::format("cd {} && \"$DAPPLE_LAB\" tile search --points 12", folder.path().string()))
            .status == 0);
    CHECK(folder.entries() == 0);
}

TEST_CASE("a search by radius can be guessed at instead: words, their error, and hours, for each radius") {
    const Outcome outcome = run_lab("tile search --points 16 --estimate");
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("hours of one core") != std::string::npos);
    CHECK(std::ranges::count(outcome.out, '\n') == 11);
}

TEST_CASE("an unfinished search is never replaced by another one") {
    const TemporaryFolder folder;
    const std::string state = folder / "dapple-search-40.txt";
    const std::string start = fmt::format("cd {} && \"$DAPPLE_LAB\" tile search --points 40 --seconds 0.01",
                                          folder.path().string());
    for (const std::string& kept :
         {write_search_state(start_exhaustive_search(40, 5)), std::string("my notes\n")}) {
        put_text(state, kept);
        for (const std::string options : {"", " --top 1"}) {
            const Outcome refused = run_in_shell(start + options);
            CAPTURE(refused.err);
            CHECK(refused.status != 0);
            CHECK(refused.sentences() == 1);
            CHECK(refused.err.starts_with("dapple-lab: dapple-search-40.txt: "));
            CHECK(refused.out == "");
            CHECK(text_of(state) == kept);
        }
    }
}

TEST_CASE("a search by evenness saves its best tile as it goes, and whatever stops programs ends it") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const TemporaryFolder folder, said;
        const std::string file = folder / "best.tile";
        ChildProcess search({lab_program(), "tile", "search", "--points", "64", "--rule", "3760", "--moves",
                             "1e12", "-o", file},
                            {.output = said / "out", .errors = said / "err"});
        REQUIRE(search.brings([&] { return std::filesystem::exists(file); }));
        CHECK(text_of(file).find("not finished") != std::string::npos);
        search.send(signal);
        CHECK(search.wait() == 0);
        CHECK(text_of(said / "out").find("stopped") != std::string::npos);
        CHECK(text_of(file).find("not finished") == std::string::npos);
        CHECK(read_tile(text_of(file)).tile.size() == 64);
        CHECK(folder.entries() == 1);
    }
}

TEST_CASE("check tells the criteria in words and as JSON") {
    const Outcome words = run_lab("tile check 14217,2895/16");
    CHECK(words.status == 0);
    CHECK(words.out.find("0.652788") != std::string::npos);
    const nlohmann::json marks = nlohmann::json::parse(run_lab("tile check --json paper16").out);
    CHECK(marks["balanced"] == true);
    CHECK(marks["integers"] == "14217,2895/16");
    CHECK(marks["relative_radius"].get<double>() == doctest::Approx(0.652788).epsilon(1e-6));
    CHECK(marks["coherent_share"].get<double>() == doctest::Approx(1));
    CHECK(marks["low_frequency_power"].get<double>() == doctest::Approx(0.120).epsilon(0.005));
    CHECK(marks["orientation_coincidence"].get<double>() == doctest::Approx(1));
    // Tiles that are never turned are all alike, at whatever distance; those of the other are as rules have
    // it.
    for (const nlohmann::json& share : marks["coincidence_at_lags_from_1"])
        CHECK(share.get<double>() == doctest::Approx(1));
    const nlohmann::json turned = nlohmann::json::parse(run_lab("tile check --json aperiodic4096").out);
    // docs/pictures.md measured 7.13 in a drawing of the same dots, by the pipeline.
    CHECK(turned["seam_on_black"].get<double>() == doctest::Approx(7.13).epsilon(0.001));
    CHECK(words.out.find("seam on black            2.61") != std::string::npos);
    const std::vector<double> lags = turned["coincidence_at_lags_from_1"];
    REQUIRE(lags.size() == 64);
    CHECK(lags.at(turned["coincidence_lag"].get<std::size_t>() - 1) == turned["orientation_coincidence"]);
    CHECK(std::ranges::max(lags) == turned["orientation_coincidence"]);
    CHECK(std::ranges::min(lags) < std::ranges::max(lags));
}

TEST_CASE("rank makes a tile file of words, and of a tile another ranking") {
    const TemporaryFolder folder;
    const std::string words = folder / "words.txt", file = folder / "a.tile", other = folder / "b.tile";
    put_text(words, "3760\n0301213303211022\n");
    REQUIRE(run_lab(fmt::format("tile rank {} -o {} --ranking farthest", words, file)).status == 0);
    CHECK(read_tile(text_of(file)).method == RankingMethod::farthest);
    REQUIRE(run_lab(fmt::format("tile rank {} -o {} --ranking searched", file, other)).status == 0);
    CHECK_FALSE(read_tile(text_of(other)).method);
    CHECK(read_tile(text_of(other)).tile.points == read_tile(text_of(file)).tile.points);
}

TEST_CASE("words without ranks are refused where a tile is needed, with the command that ranks them") {
    const TemporaryFolder folder;
    const std::string words = folder / "words.txt";
    put_text(words, "3760\n0301213303211022\n");
    const std::string reason = words + ": has words but no ranks; dapple-lab tile rank " + words +
                               " -o FILE makes a tile file of them";
    check_refused("tile check " + words, reason);
    check_refused("render -o " + (folder / "a.svg").string() + " --tile " + words, reason);
}

TEST_CASE("a byte order mark before a tile file or words is skipped") {
    const TemporaryFolder folder;
    const std::string words = folder / "words.txt", file = folder / "a.tile", marked = folder / "b.tile";
    put_text(words,
             "\xef\xbb\xbf"
             "3760\n0301213303211022\n");
    REQUIRE(run_lab(fmt::format("tile rank {} -o {}", words, file)).status == 0);
    put_text(marked, "\xef\xbb\xbf" + text_of(file));
    CHECK(run_lab("tile check --json " + marked).status == 0);
    CHECK(run_lab(fmt::format("tile rank {} -o {}", marked, file)).status == 0);
}

TEST_CASE("show draws a built-in tile as an SVG") {
    const TemporaryFolder folder;
    const std::string file = folder / "tile.svg";
    REQUIRE(run_dapple("tile show aperiodic64 -o " + file).status == 0);
    // However the ending is written.
    REQUIRE(run_dapple("tile show aperiodic64 -o " + (folder / "LOUD.SVG").string()).status == 0);
    CHECK(text_of(folder / "LOUD.SVG") == text_of(file));
    pugi::xml_document document;
    REQUIRE(document.load_file(file.c_str()));
    CHECK(document.select_nodes("//g[@id='coinciding']/circle").size() == 64);
}

TEST_CASE(
    "the help's example of the paper's ranks shows them, and a tile's own order says that it is another") {
    const TemporaryFolder folder;
    const std::string help = run_dapple("tile --help").out;
    const std::string start = "dapple tile show paper16", end = " -o paper16.svg";
    const std::size_t at = help.find(start), stop = help.find(end, at);
    REQUIRE(at != std::string::npos);
    REQUIRE(stop != std::string::npos);
    const std::string options = help.substr(at + start.size(), stop - at - start.size());
    const auto shown = [&](const std::string& with) {
        const std::string file = folder / "shown.svg";
        REQUIRE(run_dapple("tile show paper16" + with + " -o " + file).status == 0);
        return text_of(file);
    };
    pugi::xml_document document;
    REQUIRE(document.load_string(shown(options).c_str()));
    std::map<int, double> height;
    for (const pugi::xpath_node& node : document.select_nodes("//g[@id='ranks']/text"))
        height[node.node().text().as_int()] = node.node().attribute("y").as_double();
    REQUIRE(height.size() == 16);
    // Appendix A's first four points, 2895, 34215, 40470 and 61620 down of 65535 in a square of 216.
    CHECK(height[1] - height[0] == doctest::Approx((34215 - 2895) * 216 / 65535.0).epsilon(1e-3));
    CHECK(height[2] - height[0] == doctest::Approx((40470 - 2895) * 216 / 65535.0).epsilon(1e-3));
    CHECK(height[3] - height[0] == doctest::Approx((61620 - 2895) * 216 / 65535.0).epsilon(1e-3));
    CHECK(shown(options).find("ranks (paper)") != std::string::npos);
    CHECK(shown("").find("ranks (energy)") != std::string::npos);
}

TEST_CASE("dapple tile refuses what cannot be with one sentence and leaves files alone") {
    const TemporaryFolder folder;
    const std::string kept = folder / "kept.tile", bad = folder / "bad.tile";
    put_text(kept, "mine");
    put_text(bad, "dapple tile 1\nrule 0 0 0 9\n");
    check_refused("tile check nosuch", "no such tile or tile file; there are paper16, ");
    check_refused("tile check " + bad, bad + ": not a tile file, line 2: an orientation");
    check_refused("tile check " + folder.path().string(), "is a folder");
    check_refused("tile check 1,2/3", "multiple of 4");
    check_refused("tile rank " + bad + " -o " + kept, "line 2: an orientation");
    check_refused("tile rank paper16 --ranking best -o " + kept,
                  "best is not known; there are paper, farthest, energy");
    check_refused("tile rank paper16 -o " + (folder / "none/a.tile").string(), "does not exist");
    check_refused("tile show paper16 -o a.png", "does not end in .svg");
    check_refused("tile show nosuch -o " + (folder / "a.svg").string(), "no such tile");
    check_refused("tile search", "--points");
    check_refused("tile search --points 18", "multiple of 4");
    check_refused("tile search --points 64", "up to 60");
    check_refused("tile search --points 16 --seed 3", "--rule any");
    check_refused("tile search --points 16 --rule any", "--output: is needed");
    check_refused("tile search --points 16 --rule odd -o " + kept, "odd is not known");
    check_refused("tile search --points 16 --rule 3768 -o " + kept, "3768 is not known");
    check_refused("tile search --points 16 --tone 2", "--rule any");
    check_refused("tile search --points 16 --rule any --tone 0 --pairs 0 -o " + kept, "above 0");
    check_refused("tile search --points 16 --rule any --peaks -1 -o " + kept, "--peaks");
    check_refused("tile search --points 16 --rule any --seconds 1e-300 -o " + kept, "--seconds");
    check_refused("tile search --points 16 --rule any --moves 1.5 -o " + kept, "--moves");
    check_refused("tile rules --top 571", "--top");
    check_refused("tile search --points 16 --rule any --top 3 -o " + kept, "--rule identity");
    check_refused("tile search --resume " + kept, "line 1");
    check_refused("tile search --resume " + (folder / "none.txt").string(), "no such file");
    check_refused("render -o " + (folder / "a.svg").string() + " --tile " + bad, "line 2: an orientation");
    check_refused("tile", "subcommand");
    CHECK(text_of(kept) == "mine");
    CHECK(folder.entries() == 2);
}

TEST_CASE("check tells the words of small tiles, and of large ones when asked") {
    const Outcome small = run_lab("tile check paper16"), large = run_lab("tile check aperiodic4096"),
                  all = run_lab("tile check aperiodic4096 --words");
    CHECK(small.out.find("\nwords\n  ") != std::string::npos);
    CHECK(std::ranges::count(large.out, '\n') < 20);
    CHECK(large.out.find(" words; --words shows them\n") != std::string::npos);
    CHECK(std::ranges::count(all.out, '\n') > 1000);
    CHECK(all.out.starts_with(large.out.substr(0, large.out.rfind("\n\n"))));
}

}  // namespace dapple
