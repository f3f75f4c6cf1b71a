#include "dapple/settings.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bindings/library/state.h"
#include "core/settings/drawing_fields.h"
#include "core/settings/settings_text.h"

namespace dapple {
namespace {

using Json = nlohmann::ordered_json;

const SettingsPlace kPlace{"settings", FileNames::relative};

Describe all_fields(Settings::State& state) {
    return [&state](Fields& fields) { describe_drawing(fields, state.drawing, state.saving); };
}

// The program reads past what it does not know, as a newer one may have written it; whoever types a field
// wants to hear of a slip.
void check_known(const Json& given, const Json& known, const std::string& within) {
    for (const auto& [name, value] : given.items()) {
        const auto found = known.find(name);
        if (found == known.end())
            throw std::runtime_error(
                fmt::format("settings: {}{} is not known; the usual settings list all fields", within, name));
        if (value.is_object() && found->is_object()) check_known(value, *found, within + name + ".");
    }
}

}  // namespace

Settings::Settings() : state_(std::make_shared<const State>()) {}

Settings::Settings(std::string_view json) : Settings() {
    set(json);
}

void Settings::set(std::string_view json) {
    Json given = Json::parse(json, nullptr, false);
    if (given.is_object()) {
        if (!given.contains(kVersionField)) given[kVersionField] = 1;
        const Json known = Json::parse(text());
        for (const char* group : {"drawing", "saving"})
            if (given.contains(group) && given[group].is_object())
                check_known(given[group], known[group], std::string(group) + ".");
        for (const auto& [name, value] : given.items())
            if (name != kVersionField && name != "picture" && name != "view" && !known.contains(name))
                throw std::runtime_error(
                    fmt::format("settings: {} is not known; fields are in \"drawing\" and \"saving\"", name));
    }
    const auto changed = std::make_shared<State>(*state_);
    read_settings(given.is_object() ? given.dump() : std::string(json), kPlace, all_fields(*changed));
    state_ = changed;
}

void Settings::set_dots(std::uint64_t count) {
    set(fmt::format(R"({{"drawing": {{"count": {}}}}})", count));
}

std::string Settings::text() const {
    State state = *state_;
    return settings_text("", kPlace, all_fields(state));
}

std::string Settings::rows() {
    State usual;
    Json rows = Json::object();
    for (const auto& [field, note] : notes_of(all_fields(usual))) {
        Json& row = rows[field] = {{"row", note.row}};
        if (!note.choices.empty()) row["choices"] = note.choices;
        if (!note.setting) continue;
        const auto& [names, range, ignored, track, format, length, value, help, more] = *note.setting;
        if (*help) row["tip"] = fmt::format("{}.", help);
        if (range.most == std::numeric_limits<double>::max()) continue;
        const bool all = track.from == track.to;
        row.update({{"least", range.least},
                    {"most", range.most},
                    {"from", all ? range.least : track.from},
                    {"to", all ? range.most : track.to},
                    {"logarithmic", track.logarithmic},
                    {"format", format}});
        if (length) row["unit"] = "mm";
    }
    return rows.dump();
}

std::string Settings::changed() const {
    return changed_drawing_settings(kPlace, state_->drawing, state_->saving);
}

}  // namespace dapple
