#include "core/settings/settings_json.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/failure.h"
#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"

namespace dapple {
namespace {

using Json = nlohmann::ordered_json;

const SettingsPlace kPlace{"settings", FileNames::relative};

Describe all_fields(Settings& settings) {
    return [&settings](Fields& fields) { describe_drawing(fields, settings.drawing, settings.saving); };
}

// The program reads past what it does not know, as a newer one may have written it; whoever types a field
// wants to hear of a slip.
void check_known(const Json& given, const Json& known, const std::string& within) {
    for (const auto& [name, value] : given.items()) {
        const auto found = known.find(name);
        if (found == known.end())
            throw failure("settings: {}{} is not known; the default settings list all fields", within, name);
        if (value.is_object() && found->is_object()) check_known(value, *found, within + name + ".");
    }
}

std::string report(const DrawingPlan& plan, const DrawingSettings& settings, double scale,
                   std::uint64_t dots) {
    Settings drawn;
    drawn.drawing.tone = plan.tone;
    drawn.drawing.tone.black = plan.tone.black.value_or(1);
    const PageSize page = plan.layout(scale).page;
    Json pens = Json::array();
    for (const Pen& pen : pens_of(plan, settings))
        pens.push_back({{"name", pen.name}, {"colour", {pen.colour.r, pen.colour.g, pen.colour.b}}});
    return Json{{"dots", dots},
                {"lowered", plan.lowered},
                {"steps", plan.steps},
                {"page_mm", {page.width_mm, page.height_mm}},
                {"radius_mm", plan.radius_mm(scale)},
                {"pens", pens},
                {"tone", Json::parse(json_of(drawn))["drawing"]["tone"]}}
        .dump();
}

}  // namespace

void read_json(std::string_view json, Settings& settings) {
    Json given = Json::parse(json, nullptr, false);
    if (given.is_object()) {
        if (!given.contains(kVersionField)) given[kVersionField] = 1;
        const Json known = Json::parse(json_of(settings));
        for (const char* group : {"drawing", "saving"})
            if (given.contains(group) && given[group].is_object())
                check_known(given[group], known[group], std::string(group) + ".");
        for (const auto& [name, value] : given.items())
            if (name != kVersionField && name != "picture" && name != "view" && !known.contains(name))
                throw failure("settings: {} is not known; fields are in \"drawing\" and \"saving\"", name);
    }
    Settings changed = settings;
    read_settings(given.is_object() ? given.dump() : std::string(json), kPlace, all_fields(changed));
    changed.embedded = changed_drawing_settings(kPlace, changed.drawing, changed.saving);
    settings = std::move(changed);
}

Settings settings_of(std::string_view json) {
    Settings settings;
    read_json(json, settings);
    return settings;
}

std::string json_of(const Settings& settings) {
    Settings written = settings;
    return settings_text("", kPlace, all_fields(written));
}

std::string rows_json() {
    Settings usual;
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

std::string report_json(const DrawingPlan& plan, const DrawingSettings& settings) {
    return report(plan, settings, plan.scale(), static_cast<std::uint64_t>(std::llround(plan.dots())));
}

std::string report_json(const Drawing& drawing) {
    return report(drawing.plan, drawing.settings.drawing, drawing.scale, drawing.count);
}

std::string report_json(std::span<const Finding> findings) {
    Json list = Json::array();
    for (const Finding& finding : findings)
        list.push_back(
            {{"kind", name_of(finding.kind)}, {"text", sentence_of(finding)}, {"amount", finding.amount}});
    return list.dump();
}

}  // namespace dapple
