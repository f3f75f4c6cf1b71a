// How large the program is. These limits only fall: what is new takes the place of something, or its size was
// agreed on beforehand.

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/places.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

struct Size {
    int files = 0, lines = 0;
};

/// Calls visit(line) for each line of C++ in these folders, and counts them, folder by folder.
template <class Visit>
std::map<std::string, Size> read_sources(std::initializer_list<const char*> folders, const Visit& visit) {
    std::map<std::string, Size> sizes;
    for (const char* folder : folders) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source_folder() / folder)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            Size& size = sizes[fs::relative(entry.path().parent_path(), source_folder()).generic_string()];
            ++size.files;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line); ++size.lines) visit(line);
        }
    }
    return sizes;
}

Size sum_of(const std::map<std::string, Size>& sizes) {
    Size sum;
    for (const auto& [room, size] : sizes) sum = {sum.files + size.files, sum.lines + size.lines};
    return sum;
}

}  // namespace

TEST_CASE("core, io and app have at most so many lines and files, and the laboratory so many lines") {
    const auto nothing = [](const std::string&) {};
    const auto rooms = read_sources({"core", "io", "app"}, nothing);
    std::string each;
    for (const auto& [room, size] : rooms)
        each +=
            room + ": " + std::to_string(size.files) + " files, " + std::to_string(size.lines) + " lines\n";
    CAPTURE(each);
    CHECK(sum_of(rooms).lines <= 64062);
    CHECK(sum_of(rooms).files <= 416);
    CHECK(sum_of(read_sources({"lab"}, nothing)).lines <= 14500);
}

TEST_CASE("gamma passes at most so many types from its slider to the screen") {
    // In the order in which they are passed. A type that is gone is taken off the list.
    constexpr std::array kPassed{
        "Setting",         "Tone",       "DrawingSettings", "ViewerSettings", "Session",
        "History",         "Pane",       "DotsRequest",     "DensityChoice",  "Worker",
        "Workbench",       "Pipeline",   "DrawingPlan",     "ColourTone",     "InkCurve",
        "InkedDots",       "PageLayout", "Density",         "BlurredDensity", "PlannedDrawing",
        "PlacingRequest",  "Placer",     "PlacedCount",     "DotPieces",      "Dots",
        "RelaxingRequest", "Relaxation", "WarpRequest",     "PlacedDrawing",  "DotsPlaced",
        "DotBlock",        "DotOrigins", "Canvas",          "PictureView",    "Renderer"};
    CHECK(kPassed.size() <= 35);
    std::set<std::string> declared;
    const std::regex declaration("(?:struct|class|enum class) (\\w+)(?: final)?(?: : .*)? \\{.*");
    read_sources({"core", "app"}, [&](const std::string& line) {
        std::smatch match;
        if (std::regex_match(line, match, declaration)) declared.insert(match[1]);
    });
    for (const std::string type : kPassed) {
        CAPTURE(type);
        CHECK(declared.contains(type));
    }
}

}  // namespace dapple
