#pragma once
// What the tests of `dapple render` have in common: a picture to draw, and a look into what was drawn.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

namespace dapple {

/// Whether another program that reads what was drawn is there.
inline bool is_installed(const std::string& program) {
    if (run_in_shell(program + " >/dev/null 2>&1").status == 0) return true;
    MESSAGE(program, " does not run: left out");
    return false;
}

/// A soft grey ramp with a black bar: something of everything.
inline PictureFile test_picture() {
    PictureFile picture{.width = 96, .height = 64};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const bool bar = x > 40 && x < 50;
            picture.values.push_back(bar ? 0.0f : static_cast<float>(x) / 95.0f);
        }
    }
    return picture;
}

/// The same ramp in brown above and in blue below, for pens that have no use for a grey.
inline PictureFile coloured_picture() {
    PictureFile picture = test_picture();
    picture.channels = 3;
    picture.values.clear();
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float light = x > 40 && x < 50 ? 0.0f : static_cast<float>(x) / 95.0f;
            const float strength = y < picture.height / 2 ? 1.0f : -1.0f;
            for (const float part : {0.15f, 0.0f, -0.3f})
                picture.values.push_back(std::clamp(light * (1 + strength * part), 0.0f, 1.0f));
        }
    }
    return picture;
}

struct Svg {
    pugi::xml_document document;
    std::vector<pugi::xml_node> circles() const {
        std::vector<pugi::xml_node> found;
        for (const pugi::xml_node& circle : document.child("svg").child("g").children("circle"))
            found.push_back(circle);
        return found;
    }
    std::set<std::pair<std::string, std::string>> places() const {
        std::set<std::pair<std::string, std::string>> places;
        for (const pugi::xml_node& circle : circles()) {
            places.emplace(circle.attribute("cx").value(), circle.attribute("cy").value());
        }
        return places;
    }
};

inline Svg read_svg(const std::filesystem::path& path) {
    Svg svg;
    REQUIRE(svg.document.load_file(path.c_str()));
    return svg;
}

inline nlohmann::json read_json(const std::filesystem::path& path) {
    return nlohmann::json::parse(text_of(path));
}

/// A folder with a picture and an old drawing; after a command that has to fail, all of it must be as it was.
class Scene {
 public:
    Scene() {
        write_picture(folder / "cat.png", test_picture());
        put_text(folder / "old.svg", "the old drawing");
    }

    std::string operator()(const std::string& name) const { return (folder / name).string(); }

    void must_fail(const std::string& arguments, const std::string& words) const {
        const std::size_t before = folder.entries();
        const Outcome outcome = run_either(arguments);
        CAPTURE(arguments);
        CAPTURE(outcome.err);
        CHECK((outcome.status == 1 || outcome.status == 2));
        CHECK(outcome.out.empty());
        CHECK(outcome.sentences() == 1);
        CHECK((outcome.err.starts_with("dapple: ") || outcome.err.starts_with("dapple-lab: ")));
        CHECK(outcome.err.find(words) != std::string::npos);
        CHECK(text_of(folder / "old.svg") == "the old drawing");
        CHECK(folder.entries() == before);
    }

    TemporaryFolder folder;
};

}  // namespace dapple
