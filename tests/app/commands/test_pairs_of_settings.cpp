// Settings meet: each two values of two settings occur together in some run of the command, which ends well
// and writes a file of finite numbers. Two values that exclude each other are in the table of those.

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

struct Values {
    const char* setting;
    std::vector<std::string> values;  // as options; empty: as usual
};

// Small counts: it is the meeting that is tried.
const std::vector<Values> kSettings{
    {"picture", {"@colour.png", "@cat.png", "@black.png"}},
    // The ending of the file's name, and what only such a file can have.
    {"format",
     {"svg", "svg --tiles --background", "gcode", "gcode --gcode servo", "png", "csv", "pdf --background",
      "hpgl", "dxf", "json", "tif --bits 16"}},
    {"pens",
     {"", "--pens cmyk", "--pens greys --pen-ink opaque", "--pens auto:3 --pen-order listed",
      "--pens Red:#f00:0.3,Blue:#00f:0.6", "--pens cmyk:0.4:black=0.5"}},
    {"relax", {"", "--relax 0", "--relax 1", "--relax 2", "--relax 3"}},
    {"settle for", {"", "--settle-for samples"}},
    {"placer", {"", "--placer figure8", "--tile paper16", "--ranking farthest"}},
    {"dots", {"--dots 200", "--scale 20", "--dots 300 --dot-radius 0.7", "--dot-radius 1.5..3", "--dots 1"}},
    {"style", {"", "--style line", "--style nearest"}},
    {"shape", {"", "--dot-shape point", "--dot-shape spiral", "--dot-shape 'M0,0 L1,1'", "--pen-width 0.5"}},
    {"page",
     {"", "--page a6 --margin 5", "--width 60", "--page a5 --fit fill --rotate 90",
      "--height 90 --margin 1,2,3,4"}},
    {"part", {"", "--region 5,5,30x20", "--sheet 1,1/2x2", "--sheets 2x1 --overlap 3"}},
    {"tone",
     {"", "--tone true", "--tone-strength 1", "--brightness 0.3 --gamma 0.7", "--exposure -2 --detail 1",
      "--black 0.7", "--blur 2"}},
    {"light", {"", "--invert", "--mask @mask.png", "--crop 10%,0,50%x70%", "--finer @mask.png"}},
    {"order", {"", "--order space", "--order recursion", "--order priority"}},
};

struct Value {
    std::size_t setting = 0, value = 0;
    const std::string& text() const { return kSettings[setting].values[value]; }
    auto operator<=>(const Value&) const = default;
};
using Pair = std::pair<Value, Value>;

// Each of these with any of those: the command refuses the two in a sentence.
const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> kExclude{
    {{"png", "tif --bits 16"}, {"--order space", "--order recursion", "--order priority"}},
    {{"csv", "json"},
     {"--style line", "--style nearest", "--dot-shape point", "--dot-shape spiral",
      "--dot-shape 'M0,0 L1,1'"}},
    {{"png", "tif --bits 16", "pdf --background", "csv", "json"}, {"--pen-width 0.5"}},
    {{"--relax 1", "--relax 2", "--relax 3"}, {"--placer figure8", "--order priority"}},
    {{"--dots 300 --dot-radius 0.7", "--dot-radius 1.5..3"}, {"--dot-shape point"}},
    {{"--style line", "--style nearest"},
     {"--dot-shape point", "--dot-shape spiral", "--dot-shape 'M0,0 L1,1'"}},
    {{"--black 0.7"}, {"--dot-radius 1.5..3", "--style line", "--style nearest"}},
    {{"@black.png"}, {"--invert"}},  // nothing is left to draw
    {{"--finer @mask.png"},
     {"--style line", "--style nearest", "--dot-shape point", "--pens Red:#f00:0.3,Blue:#00f:0.6",
      "--pens cmyk:0.4:black=0.5"}},
};

bool named(const std::vector<std::string>& names, const Value& value) {
    return std::ranges::find(names, value.text()) != names.end();
}

bool exclude(const Value& a, const Value& b) {
    return std::ranges::any_of(kExclude, [&](const auto& two) {
        return (named(two.first, a) && named(two.second, b)) || (named(two.first, b) && named(two.second, a));
    });
}

std::set<Pair> all_pairs() {
    std::set<Pair> pairs;
    for (std::size_t s = 0; s < kSettings.size(); ++s)
        for (std::size_t t = s + 1; t < kSettings.size(); ++t)
            for (std::size_t i = 0; i < kSettings[s].values.size(); ++i)
                for (std::size_t k = 0; k < kSettings[t].values.size(); ++k)
                    if (!exclude({s, i}, {t, k})) pairs.insert({{s, i}, {t, k}});
    return pairs;
}

// A value of each setting, which all go together. Begun with two that have not met yet; then, setting by
// setting, the one that meets the most others for the first time.
std::optional<std::vector<Value>> run_with(const Pair& first, const std::set<Pair>& unmet) {
    std::vector<Value> run{first.first, first.second};
    for (std::size_t setting = 0; setting < kSettings.size(); ++setting) {
        if (setting == first.first.setting || setting == first.second.setting) continue;
        std::optional<Value> best;
        std::ptrdiff_t most = -1;
        for (std::size_t i = 0; i < kSettings[setting].values.size(); ++i) {
            const Value value{setting, i};
            if (std::ranges::any_of(run, [&](const Value& other) { return exclude(value, other); })) continue;
            const auto meets = std::ranges::count_if(
                run, [&](const Value& other) { return unmet.contains(std::minmax(value, other)); });
            if (meets <= most) continue;
            most = meets;
            best = value;
        }
        if (!best) return std::nullopt;
        run.push_back(*best);
    }
    std::ranges::sort(run);
    return run;
}

std::string arguments_of(const std::vector<Value>& run, const Scene& scene, const std::string& output) {
    std::string arguments = "render", ending;
    for (const Value& value : run) {
        const std::string& text = value.text();
        const bool format = std::string_view(kSettings[value.setting].setting) == "format";
        const std::size_t options = format ? std::min(text.find(' '), text.size()) : 0;
        if (format) ending = text.substr(0, options);
        arguments += " " + text.substr(options);
    }
    for (std::size_t at = arguments.find('@'); at != arguments.npos; at = arguments.find('@'))
        arguments.replace(at, 1, scene(""));
    return arguments + " -o " + scene(output + "." + ending);
}

// "nan" or "inf" where a number would be.
bool has_what_is_no_number(const std::string& text) {
    for (const std::string_view word : {"nan", "inf"})
        for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
            const bool begins = at == 0 || !std::isalpha(static_cast<unsigned char>(text[at - 1]));
            const std::size_t end = at + word.size();
            if (begins && (end == text.size() || !std::isalpha(static_cast<unsigned char>(text[end]))))
                return true;
        }
    return false;
}

}  // namespace

TEST_CASE("each two values of two settings are drawn together, without a crash and with finite numbers") {
    const Scene scene;
    write_picture(scene("colour.png"), coloured_picture());
    PictureFile black{.width = 24, .height = 16};
    black.values.assign(24 * 16, 0.0f);
    write_picture(scene("black.png"), black);
    PictureFile mask{.width = 8, .height = 8};
    for (int i = 0; i < 64; ++i) mask.values.push_back(static_cast<float>(i % 8) / 7);
    write_picture(scene("mask.png"), mask);
    std::set<Pair> unmet = all_pairs();
    std::size_t runs = 0;
    const std::size_t all = unmet.size();
    while (!unmet.empty()) {
        const Pair first = *unmet.begin();
        const auto run = run_with(first, unmet);
        CAPTURE(first.first.text());
        CAPTURE(first.second.text());
        REQUIRE(run);  // else what they exclude leaves them no company
        const std::string output = "run" + std::to_string(runs++);
        const std::string arguments = arguments_of(*run, scene, output);
        const Outcome outcome = run_dapple(arguments);
        CAPTURE(arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.status == 0);
        for (std::size_t i = 0; i < run->size(); ++i)
            for (std::size_t k = i + 1; k < run->size(); ++k) unmet.erase({(*run)[i], (*run)[k]});
        for (const auto& entry : std::filesystem::directory_iterator(scene(""))) {
            if (!entry.path().filename().string().starts_with(output)) continue;
            const std::string ending = entry.path().extension().string();
            CAPTURE(entry.path().string());
            CHECK(entry.file_size() > 0);
            if (ending != ".png" && ending != ".tif" && ending != ".pdf")
                CHECK_FALSE(has_what_is_no_number(text_of(entry.path())));
            std::filesystem::remove(entry.path());
        }
    }
    MESSAGE(all, " pairs in ", runs, " runs");
}
