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

namespace dapple {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = DAPPLE_SOURCE;

struct Include {
    std::string from, to;  // rooms
    std::string where;     // "core/tile/tile.cpp includes core/image/grid.h"
};

std::string room_of(const fs::path& file) {
    return file.parent_path().generic_string();
}

/// Of our own files; generated ones are left out.
std::vector<Include> includes_below(const char* folder) {
    const std::regex include("#include \"((?:core|app)/[^\"]+)\"");
    std::vector<Include> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSource / folder)) {
        const fs::path file = fs::relative(entry.path(), kSource);
        if (file.extension() != ".h" && file.extension() != ".cpp") continue;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            const std::string to = room_of(match[1].str());
            if (to != room_of(file))
                found.push_back({room_of(file), to, file.generic_string() + " includes " + match[1].str()});
        }
    }
    return found;
}

using Arrows = std::map<std::string, std::set<std::string>>;

/// What of the includes no arrow allows.
std::vector<std::string> against(const Arrows& arrows, const std::vector<Include>& includes) {
    std::vector<std::string> wrong;
    for (const Include& include : includes) {
        const auto room = arrows.find(include.from);
        const bool allowed = room != arrows.end() && room->second.contains(include.to);
        if (!allowed) wrong.push_back(include.where);
    }
    return wrong;
}

}  // namespace

TEST_CASE("each room of core knows only the rooms below it") {
    const Arrows arrows{
        {"core/image", {}},
        {"core/text", {}},
        {"core/tile", {"core/text"}},
        {"core/placing", {"core/image", "core/tile"}},
        {"core/relaxing", {"core/image", "core/placing"}},
        {"core/routing", {"core/placing"}},
        {"core/drawing", {"core/image", "core/placing", "core/relaxing", "core/text"}},
        {"core/analysis", {"core/image", "core/text"}},
        {"core/lights", {"core/image", "core/placing", "core/text", "core/tile"}},
        {"core/output",
         {"core/analysis", "core/image", "core/placing", "core/routing", "core/text", "core/tile"}},
        {"core/reports",
         {"core/analysis", "core/image", "core/lights", "core/output", "core/placing", "core/text",
          "core/tile"}},
    };
    const std::vector<Include> includes = includes_below("core");
    REQUIRE(includes.size() > 50);
    const std::vector<std::string> wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("in the window arrows lead from the shell over panels and canvas to the model, and never back") {
    const Arrows arrows{
        {"app/viewer", {"app", "app/files", "app/settings", "app/viewer/model", "app/viewer/shell"}},
        {"app/viewer/shell",
         {"app", "app/files", "app/settings", "app/viewer/canvas", "app/viewer/model", "app/viewer/panels",
          "app/viewer/widgets"}},
        {"app/viewer/panels", {"app", "app/files", "app/settings", "app/viewer/model", "app/viewer/widgets"}},
        {"app/viewer/canvas", {"app/viewer/model", "app/viewer/widgets"}},
        {"app/viewer/model", {"app", "app/files", "app/settings"}},
        {"app/viewer/widgets", {"app"}},
    };
    std::vector<Include> includes = includes_below("app/viewer");
    REQUIRE(includes.size() > 50);
    std::erase_if(includes, [](const Include& include) { return include.to.starts_with("core/"); });
    const std::vector<std::string> wrong = against(arrows, includes);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("what the window is about needs neither Dear ImGui nor OpenGL nor a window") {
    std::vector<std::string> wrong;
    for (const char* folder : {"core", "app/viewer/model"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kSource / folder)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);) {
                for (const char* library : {"<imgui", "<epoxy", "<GLFW", "<GL/"}) {
                    if (line.starts_with("#include") && line.find(library) != std::string::npos)
                        wrong.push_back(entry.path().string() + ": " + line);
                }
            }
        }
    }
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

TEST_CASE("commands, files and decoders don't know the window, and core knows none of them") {
    std::vector<std::string> wrong;
    for (const Include& include : includes_below("app")) {
        const bool below_the_window = !include.from.starts_with("app/viewer") && include.from != "app";
        if (below_the_window && include.to.starts_with("app/viewer")) wrong.push_back(include.where);
        const bool files = include.from == "app/files" || include.from == "app/decoding";
        const bool settings = include.from == "app/settings";
        if ((files || settings) && (include.to == "app/commands" || include.to == "app/analysis"))
            wrong.push_back(include.where);
        if (files && include.to == "app/settings") wrong.push_back(include.where);
    }
    for (const Include& include : includes_below("core"))
        if (include.to.starts_with("app")) wrong.push_back(include.where);
    CAPTURE(wrong);
    CHECK(wrong.empty());
}

}  // namespace dapple
