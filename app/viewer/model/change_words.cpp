#include "app/viewer/model/change_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "app/settings/settings_text.h"
#include "app/viewer/model/viewer_fields.h"

namespace dapple {
namespace {

// What is said of all of a group is its name.
constexpr std::array kGroupsOfGroups{"drawing", "saving", "view", "tone", "page"};

// Fields whose row has another name than theirs.
constexpr std::array kRows = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"automatic_tone", "Tone from"},
    {"automatic_exposure", "Exposure"},
    {"count", "Dots"},
    {"scale", "Fineness"},
    {"relax", "Even out"},
    {"deepest_level", "Divided up to"},
    {"page/paper", "Paper size"},
    {"quarter_turns", "Rotate"},
    {"sheet_overlap_mm", "Overlap"},
    {"background", "Paper in files"},
    {"show_tiles", "Tile boundaries"},
    {"style", "Draw"},
    {"order", "Dot order"},
    {"dpi", "Dots per inch"},
    {"gcode_tool", "G-code for"},
    {"gcode_template", "Template"},
    {"feed_mm_per_min", "Feed"},
    {"dwell_s", "Dwell"},
    {"acceleration_mm_per_s2", "Acceleration"},
    {"gcode_pen_up", "Pen up"},
    {"gcode_pen_down", "Pen down"},
    {"picture_opacity", "Photograph"},
    {"zoom_mode", "Zooming in"},
    {"colouring", "Dots coloured"},
    {"comparison", "Split view"},
    {"origins", "Explain dots"},
    {"unit", "Lengths in"},
});

std::string row_of(const std::string& group, const std::string& name) {
    for (const auto& [field, row] : kRows)
        if (field == name || field == group + "/" + name) return std::string(row);
    std::string words = name;
    if (words.ends_with("_mm")) words.resize(words.size() - 3);
    std::ranges::replace(words, '_', ' ');
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

void collect_rows(const std::string& group, const nlohmann::ordered_json& changed,
                  std::vector<std::string>& rows) {
    for (const auto& [name, value] : changed.items()) {
        if (std::ranges::find(kGroupsOfGroups, name) != kGroupsOfGroups.end())
            collect_rows(name, value, rows);
        else if (name != kVersionField)
            rows.push_back(row_of(group, name));
    }
}

}  // namespace

std::string change_in_words(const ViewerSettings& before, const ViewerSettings& after) {
    ViewerSettings from = before, to = after;
    const auto all_of = [](ViewerSettings& settings) {
        return [&settings](Fields& fields) { describe(fields, settings); };
    };
    std::vector<std::string> rows;
    try {
        collect_rows("", nlohmann::ordered_json::parse(changed_settings({}, all_of(to), all_of(from))), rows);
    } catch (const std::exception&) {  // a tile's name that no text can hold
        return "Tile";
    }
    if (rows.empty()) return {};
    return rows.size() == 1 ? rows[0] : fmt::format("{} and {} more", rows[0], rows.size() - 1);
}

}  // namespace dapple
