#include "app/viewer/model/change_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/settings/settings_text.h"
#include "app/viewer/model/viewer_fields.h"

namespace dapple {
namespace {

using Rows = std::map<std::string, std::string>;

// Of a field whose row is called as it is.
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

void collect_rows(const std::string& before, const nlohmann::ordered_json& changed, const Rows& known,
                  std::vector<std::string>& rows) {
    for (const auto& [name, value] : changed.items()) {
        const auto row = known.find(before + name);
        if (value.is_object() && !is_one_change(name, value))
            collect_rows(before + name + ".", value, known, rows);
        else
            rows.push_back(row == known.end() ? words_of(name) : row->second);
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
        collect_rows("", changed, rows_of(all_of(to)), rows);
    } catch (const std::exception&) {  // a tile's name that no text can hold
        return "Tile";
    }
    if (rows.empty()) return {};
    return rows.size() == 1 ? rows[0] : fmt::format("{} and {} more", rows[0], rows.size() - 1);
}

}  // namespace dapple
