#include "app/viewer/model/change_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/settings/settings_text.h"
#include "app/viewer/model/viewer_fields.h"

namespace dapple {
namespace {

// The names of fields are words with low lines between; what is said of all of a group is its name.
constexpr std::array kGroupsOfGroups{"drawing", "saving", "view", "tone", "page"};

std::string as_words(std::string name) {
    if (name.ends_with("_mm")) name.resize(name.size() - 3);
    std::ranges::replace(name, '_', ' ');
    return name;
}

void collect_names(const nlohmann::ordered_json& changed, std::vector<std::string>& names) {
    for (const auto& [name, value] : changed.items()) {
        if (std::ranges::find(kGroupsOfGroups, name) != kGroupsOfGroups.end())
            collect_names(value, names);
        else if (name != kVersionField)
            names.push_back(as_words(name));
    }
}

}  // namespace

std::string change_in_words(const ViewerSettings& before, const ViewerSettings& after) {
    ViewerSettings from = before, to = after;
    const auto all_of = [](ViewerSettings& settings) {
        return [&settings](Fields& fields) { describe(fields, settings); };
    };
    std::vector<std::string> names;
    try {
        collect_names(nlohmann::ordered_json::parse(changed_settings({}, all_of(to), all_of(from))), names);
    } catch (const std::exception&) {  // a tile's name that no text can hold
        return "tile";
    }
    if (names.empty()) return {};
    return names.size() == 1 ? names[0] : fmt::format("{} and {} more", names[0], names.size() - 1);
}

}  // namespace dapple
