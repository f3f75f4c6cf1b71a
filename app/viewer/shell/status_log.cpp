#include "app/viewer/shell/status_log.h"

#include <nlohmann/json.hpp>

namespace dapple {

void add_input(nlohmann::ordered_json& line, const MouseInfo& mouse, const HealthInfo& health,
               const WidgetNotes& widgets) {
    line["longest_frame_ms"] = health.longest_frame_ms;
    line["longest_work_ms"] = health.longest_work_ms;
    line["gl_errors"] = health.gl_errors;
    line["mouse"] = {mouse.position.x, mouse.position.y};
    line["mouse_down"] = mouse.down;
    line["row_with_keys"] = widgets.row_with_keys;
    auto& places = line["widgets"] = nlohmann::ordered_json::object();
    for (const auto& [label, place] : widgets.places)
        places[label] = {place.min.x, place.min.y, place.max.x, place.max.y};
}

nlohmann::ordered_json status_json(const StatusInfo& info, std::uint64_t placings) {
    nlohmann::ordered_json line{
        {"dots", info.dots},       {"duplicates", info.duplicates}, {"scale", info.scale},
        {"zoom", info.zoom},       {"placings", placings},          {"place_ms", info.place_ms},
        {"draw_ms", info.draw_ms}, {"steps", info.steps},           {"all_steps", info.all_steps}};
    if (const auto share = progress_of(info)) line["progress"] = *share;
    if (info.loupe)
        line["loupe"] = {{"repetition", info.loupe->repetition},
                         {"layers", info.loupe->layers},
                         {"level", info.loupe->level}};
    return line;
}

nlohmann::ordered_json status_json(const LightStatus& status) {
    return {{"samples", status.samples}, {"samplings", status.samplings},   {"sampling", status.sampling},
            {"stops", status.stops},     {"difference", status.difference}, {"zoom", status.zoom},
            {"saving", status.saving}};
}

}  // namespace dapple
