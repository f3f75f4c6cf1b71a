#include "app/viewer/shell/status_log.h"

#include <nlohmann/json.hpp>

namespace dapple {

void add_input(nlohmann::ordered_json& line, const MouseFacts& mouse, const HealthFacts& health,
               const WidgetPlaces& widgets) {
    line["longest_frame_ms"] = health.longest_frame_ms;
    line["gl_errors"] = health.gl_errors;
    line["mouse"] = {mouse.position.x, mouse.position.y};
    line["mouse_down"] = mouse.down;
    auto& places = line["widgets"] = nlohmann::ordered_json::object();
    for (const auto& [label, place] : widgets)
        places[label] = {place.min.x, place.min.y, place.max.x, place.max.y};
}

nlohmann::ordered_json status_json(const StatusFacts& facts, std::uint64_t placings) {
    nlohmann::ordered_json line{
        {"dots", facts.dots},       {"duplicates", facts.duplicates}, {"scale", facts.scale},
        {"zoom", facts.zoom},       {"placings", placings},           {"place_ms", facts.place_ms},
        {"draw_ms", facts.draw_ms}, {"steps", facts.steps},           {"all_steps", facts.all_steps}};
    if (const auto share = progress_of(facts)) line["progress"] = *share;
    if (facts.right) {
        const auto number = [](const std::optional<double>& value) {
            return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
        };
        line["right"] = {{"dots", facts.right->dots},
                         {"duplicates", facts.right->duplicates},
                         {"scale", facts.right->scale},
                         {"divider", facts.right->divider},
                         {"repetition", number(facts.right->repetition)},
                         {"left_repetition", number(facts.right->left_repetition)}};
    }
    if (facts.loupe)
        line["loupe"] = {{"repetition", facts.loupe->repetition},
                         {"layers", facts.loupe->layers},
                         {"level", facts.loupe->level}};
    return line;
}

nlohmann::ordered_json status_json(const LightStatus& status) {
    return {{"samples", status.samples}, {"samplings", status.samplings},   {"sampling", status.sampling},
            {"stops", status.stops},     {"difference", status.difference}, {"zoom", status.zoom},
            {"saving", status.saving}};
}

}  // namespace dapple
