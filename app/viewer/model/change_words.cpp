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

// Fields whose row has another name than theirs, or has several of them.
constexpr std::array kRows = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"automatic_tone", "Tone from"},
    {"automatic_exposure", "Exposure"},
    {"count", "Dots"},
    {"scale", "Fineness"},
    {"relax", "Even out"},
    {"dot_size/sizing", "Dot size"},
    {"deepest_level", "Divided up to"},
    {"page/paper", "Paper size"},
    {"margins_mm", "Margin"},
    {"crop", "Crop"},
    {"crop/on", "Crop"},
    {"crop/left", "From left"},
    {"crop/top", "From top"},
    {"crop/right", "To right"},
    {"crop/bottom", "To bottom"},
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
    {"density/source", "Density"},
    {"picture_opacity", "Photograph"},
    {"zoom_mode", "Zooming in"},
    {"colouring", "Dots coloured"},
    {"comparison/on", "Split view"},
    {"comparison/placer", "Right placer"},
    {"comparison/tile", "Right tile"},
    {"comparison/ranking", "Right ranking"},
    {"comparison/by", "Right side has"},
    {"comparison/divider", "Divider"},
    {"loupe/on", "Loupe"},
    {"loupe/step", "Its tiles"},
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

// Whether a group's changes are those of one row: a margin for all sides, a frame that is dragged, a switch
// that says what goes with it, a template and its name.
bool is_one_change(const std::string& name, const nlohmann::ordered_json& changed) {
    const std::size_t count = changed.size();
    return changed.contains("on") || name == "mask" || name == "gcode_template" ||
           (name == "margins_mm" && count == 4) || (name == "crop" && count > 1);
}

void collect_rows(const std::string& group, const nlohmann::ordered_json& changed,
                  std::vector<std::string>& rows) {
    for (const auto& [name, value] : changed.items()) {
        if (!value.is_object())
            rows.push_back(row_of(group, name));
        else if (is_one_change(name, value))
            rows.push_back(value.contains("on") ? row_of(name, "on") : row_of(group, name));
        else
            collect_rows(name, value, rows);
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
        auto changed = nlohmann::ordered_json::parse(changed_settings({}, all_of(to), all_of(from)));
        changed.erase(kVersionField);
        collect_rows("", changed, rows);
    } catch (const std::exception&) {  // a tile's name that no text can hold
        return "Tile";
    }
    if (rows.empty()) return {};
    return rows.size() == 1 ? rows[0] : fmt::format("{} and {} more", rows[0], rows.size() - 1);
}

}  // namespace dapple
