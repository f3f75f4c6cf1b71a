#include "app/viewer/model/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "core/settings/fields.h"
#include "core/settings/setting.h"

namespace dapple {

namespace {

using Notes = std::map<std::string, FieldNote>;

// The words for a field whose row has the same name: "dot_size" is "Dot size".
std::string words_of(std::string field) {
    std::ranges::replace(field, '_', ' ');
    field.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(field.front())));
    return field;
}

// Whether what has several parts was changed as one, by its own row: a switch that says what goes with it,
// margins made alike, a frame that was dragged, and what is always chosen as a whole.
bool is_one_change(const std::string& name, const nlohmann::ordered_json& changed) {
    const bool several = changed.size() > 1;
    return changed.contains("on") || (several && (name == "margins_mm" || name == "crop")) ||
           name == "tile" || name == "mask" || name == "gcode_template";
}

void collect_rows(const std::string& before, const nlohmann::ordered_json& changed, const Notes& known,
                  std::vector<std::string>& rows) {
    for (const auto& [name, value] : changed.items()) {
        const auto row = known.find(before + name);
        if (value.is_object() && !is_one_change(name, value))
            collect_rows(before + name + ".", value, known, rows);
        else
            rows.push_back(row == known.end() ? words_of(name) : row->second.row);
    }
}

// Pens are one text in files: what was changed of it first.
std::string row_of_pens(const PenChoice& before, const PenChoice& after) {
    if (before.set != after.set) return setting::pens.names.row;
    if (after.set == PenSet::automatic && before.own != after.own) return "Palette";
    if (before.automatic != after.automatic) return "How many";
    if (before.width_mm != after.width_mm) return "Tip width";
    if (before.gain_mm != after.gain_mm) return "Dot gain";
    if (before.black != after.black) return "Black in greys";
    const Palette &from = before.own, &to = after.own;
    const auto [old_end, new_end] = std::ranges::mismatch(from, to);
    const auto i = static_cast<std::size_t>(old_end - from.begin());
    if (old_end == from.end() && new_end + 1 == to.end()) return "Add a pen";
    if (old_end != from.end() && std::ranges::equal(old_end + 1, from.end(), new_end, to.end()))
        return "Remove " + old_end->name;
    if (from.size() != to.size() || from == to) return from == to ? setting::pens.names.row : "Palette";
    if (i + 1 < to.size() && from[i] == to[i + 1] && from[i + 1] == to[i])
        return fmt::format("Draw {} earlier", to[i].name);
    if (!std::ranges::equal(old_end + 1, from.end(), new_end + 1, to.end())) return "Palette";
    const Pen &old = from[i], &now = to[i];
    const char* const row = old.name != now.name           ? "Pen"
                            : old.colour != now.colour     ? "Colour"
                            : old.width_mm != now.width_mm ? "Width"
                            : old.gap_mm != now.gap_mm     ? "Gap"
                                                           : "Gain";
    return fmt::format("{} {}", row, i + 1);
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
        collect_rows("", changed, notes_of(all_of(to)), rows);
    } catch (const std::exception&) {  // a tile's name that no text can hold
        return "Tile";
    }
    if (rows.empty()) return {};
    // White ink on black paper is one choice, and so is the way back.
    const std::string its_parts[] = {setting::invert.names.row, setting::ink.names.row,
                                     setting::paper.names.row};
    const auto is_part = [&](const std::string& row) { return std::ranges::count(its_parts, row) > 0; };
    if (std::ranges::count_if(rows, is_part) == std::ssize(its_parts)) {
        std::erase_if(rows, is_part);
        rows.insert(rows.begin(), setting::pens.names.row);
    }
    std::ranges::replace(rows, std::string(setting::pens.names.row),
                         row_of_pens(before.drawing.pens, after.drawing.pens));
    // One row may say two things.
    std::vector<std::string> once;
    for (std::string& row : rows)
        if (std::ranges::find(once, row) == once.end()) once.push_back(std::move(row));
    rows = std::move(once);
    return rows.size() == 1 ? rows[0] : fmt::format("{} and {} more", rows[0], rows.size() - 1);
}

}  // namespace dapple
