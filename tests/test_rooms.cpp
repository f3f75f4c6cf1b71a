// Who may know whom: the folders are rooms in an order, and each includes only what lies below it.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/places.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = source_folder();

struct Include {
    std::string from, to;  // rooms
    std::string where;     // "core/tile/tile.cpp includes core/image/grid.h"
};

/// Its folder; what starts a program is a room of its own.
std::string room_of(const fs::path& file) {
    return file == "app/main.cpp"   ? "main"
           : file == "lab/main.cpp" ? "lab main"
                                    : file.parent_path().generic_string();
}

/// The includes of our own files; those of generated ones are left out.
std::vector<Include> includes_below(const char* folder) {
    const std::regex include("#include \"((?:core|io|app|lab)/[^\"]+)\"");
    std::vector<Include> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSource / folder)) {
        const fs::path file = fs::relative(entry.path(), kSource);
        if (file.extension() != ".h" && file.extension() != ".cpp") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            const std::string to = room_of(match[1].str());
            if (to != room_of(file) && to != "core/maths" && to != "core")  // which are for all
                found.push_back({room_of(file), to, file.generic_string() + " includes " + match[1].str()});
        }
    }
    return found;
}

using Arrows = std::map<std::string, std::set<std::string>>;

/// What of the includes no arrow allows, a line each.
std::string against(const Arrows& arrows, const std::vector<Include>& includes) {
    std::string wrong;
    for (const Include& include : includes) {
        const auto room = arrows.find(include.from);
        const bool allowed = room != arrows.end() && room->second.contains(include.to);
        if (!allowed) wrong += include.where + '\n';
    }
    return wrong;
}

}  // namespace

TEST_CASE("each room of core knows only the rooms below it") {
    const Arrows arrows{
        {"core/maths", {}},
        {"core/image", {}},
        {"core/text", {}},
        {"core/tile", {"core/text"}},
        {"core/placing", {"core/image", "core/text", "core/tile"}},
        {"core/relaxing", {"core/image", "core/placing"}},
        {"core/routing", {"core/placing"}},
        {"core/strokes", {"core/image", "core/placing", "core/routing", "core/text"}},
        {"core/lines", {"core/image", "core/strokes"}},
        {"core/pens", {"core/image", "core/placing", "core/relaxing", "core/routing", "core/text"}},
        {"core/drawing",
         {"core/analysis", "core/image", "core/lines", "core/output", "core/pens", "core/placing",
          "core/relaxing", "core/routing", "core/strokes", "core/text", "core/tile"}},
        {"core/settings",
         {"core/drawing", "core/image", "core/output", "core/relaxing", "core/text", "core/tile"}},
        {"core/analysis", {"core/image", "core/text"}},
        {"core/lights", {"core/image", "core/placing", "core/text", "core/tile"}},
        {"core/screening", {"core/image", "core/placing", "core/tile"}},
        {"core/output",
         {"core/analysis", "core/image", "core/lines", "core/pens", "core/placing", "core/routing",
          "core/strokes", "core/text"}},
    };
    const std::vector<Include> includes = includes_below("core");
    REQUIRE(includes.size() > 50);
    const std::string wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("each room of io knows core and the rooms of io below it") {
    const Arrows arrows{
        {"io/decoding", {"core/image", "core/text", "io"}},
        // What is written, and what is read; PDF, PNG and TIFF are written here, where their libraries are.
        {"io/files",
         {"core/drawing", "core/image", "core/lights", "core/lines", "core/output", "core/pens",
          "core/placing", "core/strokes", "core/text", "core/tile", "io", "io/decoding"}},
        // A film shows dots and strokes come, in the order of a plot.
        {"io/film",
         {"core/drawing", "core/image", "core/output", "core/placing", "core/routing", "core/strokes",
          "core/text", "io", "io/files"}},
        {"io/settings",
         {"core/drawing", "core/output", "core/pens", "core/settings", "core/text", "io", "io/files"}},
        {"io/reports", {"core/image", "core/lights", "core/text", "core/tile"}},
        // Options, and what is said on the standard error. --relax and --order say their range.
        {"io/command_line",
         {"core/drawing", "core/image", "core/output", "core/placing", "core/relaxing", "core/settings",
          "core/text", "io", "io/files", "io/settings"}},
        {"io", {"core/text"}},  // what its rooms share
    };
    const std::vector<Include> includes = includes_below("io");
    REQUIRE(includes.size() > 50);
    const std::string wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("each room of the program knows only the rooms below it") {
    const Arrows arrows{
        {"main", {"app/commands", "app/viewer", "io/command_line"}},
        {"app/viewer", {"io", "io/files", "io/settings", "app/viewer/model", "app/viewer/shell"}},
        {"app/viewer/shell",
         {"io", "io/files", "io/settings", "app/viewer/background", "app/viewer/canvas", "app/viewer/desktop",
          "app/viewer/model", "app/viewer/panels", "app/viewer/view", "app/viewer/widgets"}},
        {"app/viewer/panels",
         {"io", "io/files", "io/settings", "app/viewer/background", "app/viewer/model", "app/viewer/view",
          "app/viewer/widgets"}},
        {"app/viewer/canvas",
         {"app/viewer/background", "app/viewer/model", "app/viewer/view", "app/viewer/widgets"}},
        {"app/viewer/model",
         {"io", "io/files", "io/film", "io/settings", "app/viewer/background", "app/viewer/desktop",
          "app/viewer/view"}},
        {"app/viewer/view", {"io", "io/files", "io/film", "app/viewer/background"}},
        {"app/viewer/background", {"io", "io/files"}},
        {"app/viewer/desktop", {"io", "io/files", "io/settings"}},
        {"app/viewer/widgets", {"io"}},
        {"app/commands", {"io", "io/command_line", "io/files", "io/film", "io/reports", "io/settings"}},
    };
    std::vector<Include> includes = includes_below("app");
    std::erase_if(includes, [](const Include& include) { return include.to.starts_with("core/"); });
    REQUIRE(includes.size() > 200);
    const std::string wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("each room of the program knows of core no more than its subject needs") {
    const Arrows arrows{
        {"main", {"core/text"}},
        // Options, calls and reports. The first four are what a drawing is asked by; of the others: `analyse`
        // measures points, `lights` samples maps, `mask` makes masks, `tile` shows tiles, and --relax and
        // --order say their range.
        {"app/commands",
         {"core/drawing", "core/image", "core/settings", "core/text", "core/analysis", "core/lights",
          "core/output", "core/placing", "core/relaxing", "core/screening", "core/tile"}},
        {"app/viewer", {}},
        // Dots, tiles and lights as they are drawn on the screen.
        {"app/viewer/canvas",
         {"core/drawing", "core/image", "core/lights", "core/output", "core/pens", "core/placing",
          "core/text"}},
        // Drawings as they are asked for and placed.
        {"app/viewer/background",
         {"core/drawing", "core/image", "core/lines", "core/pens", "core/placing", "core/routing",
          "core/strokes", "core/text", "core/tile"}},
        // How many dots fit into memory.
        {"app/viewer/desktop", {"core/drawing"}},
        // What of a drawing is seen, and what is measured of that.
        {"app/viewer/view",
         {"core/analysis", "core/drawing", "core/image", "core/output", "core/placing", "core/text"}},
        // What a person has open.
        {"app/viewer/model",
         {"core/drawing", "core/image", "core/lights", "core/output", "core/pens", "core/routing",
          "core/settings", "core/text"}},
        // Rows of settings.
        {"app/viewer/panels",
         {"core/drawing", "core/image", "core/output", "core/pens", "core/placing", "core/relaxing",
          "core/settings", "core/text"}},
        {"app/viewer/shell", {"core/drawing", "core/image", "core/settings", "core/text"}},
        {"app/viewer/widgets", {"core/image", "core/settings", "core/text"}},
    };
    std::vector<Include> includes = includes_below("app");
    std::erase_if(includes, [](const Include& include) { return !include.to.starts_with("core/"); });
    REQUIRE(includes.size() > 150);
    const std::string wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("each room of the laboratory knows only the rooms below it") {
    const Arrows arrows{
        {"lab/search", {}},
        {"lab/related", {}},
        {"lab/volume", {"io", "io/files"}},
        {"lab/analysis", {"io", "io/files", "io/reports", "lab/related"}},
        {"lab/compare", {"io", "io/files", "io/reports", "lab/analysis", "lab/related"}},
        {"lab/reproduce", {"io", "io/files", "io/reports", "lab/analysis", "lab/search"}},
        {"lab/commands",
         {"io", "io/command_line", "io/files", "io/film", "io/reports", "io/settings", "lab/analysis",
          "lab/compare", "lab/related", "lab/reproduce", "lab/search", "lab/volume"}},
        {"lab/mpi", {"io/command_line", "io/files", "lab/commands", "lab/search"}},
        {"lab main", {"io/command_line", "lab/commands"}},
    };
    std::vector<Include> includes = includes_below("lab");
    std::erase_if(includes, [](const Include& include) { return include.to.starts_with("core/"); });
    REQUIRE(includes.size() > 20);
    const std::string wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("the library and the Python module know core alone, and the header for C nothing but C") {
    std::string wrong;
    const auto read = [&](const char* folder, const std::regex& allowed) {
        int includes = 0;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSource / folder)) {
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                if (!line.starts_with("#include")) continue;
                ++includes;
                if (!std::regex_match(line, allowed)) wrong += entry.path().string() + ": " + line + '\n';
            }
        }
        return includes;
    };
    CHECK(read("bindings/include", std::regex("#include <stddef.h>")) == 1);
    CHECK(read("bindings/library", std::regex(R"(#include (<.+>|"(core|dapple)/.+"))")) > 10);
    CHECK(read("bindings/python", std::regex(R"(#include (<.+>|"core/.+"))")) > 10);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("what the window is about needs neither Dear ImGui nor OpenGL nor a window") {
    std::string wrong;
    for (const char* folder : {"core", "app/viewer/model"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSource / folder)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                for (const char* library : {"<imgui", "<epoxy", "<GLFW", "<GL/"}) {
                    if (line.starts_with("#include") && line.find(library) != std::string::npos)
                        wrong += entry.path().string() + ": " + line + '\n';
                }
            }
        }
    }
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("includes are counted from room to room") {
    std::map<std::string, int> counts;
    for (const char* folder : {"core", "io", "app", "lab"})
        for (const Include& include : includes_below(folder)) ++counts[include.from + " to " + include.to];
    std::string lines;
    for (const auto& [way, count] : counts) lines += way + ": " + std::to_string(count) + '\n';
    CAPTURE(lines);  // doctest's --success shows it
    CHECK(counts["app/viewer/shell to app/viewer/canvas"] > 0);
}

}  // namespace dapple
