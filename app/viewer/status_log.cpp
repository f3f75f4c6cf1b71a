#include "app/viewer/status_log.h"

#include <nlohmann/json.hpp>

namespace dapple {

std::string status_json(const StatusFacts& facts, std::uint64_t placings, const MouseFacts& mouse,
                        const WidgetPlaces& widgets) {
    nlohmann::ordered_json line{{"dots", facts.dots},
                                {"duplicates", facts.duplicates},
                                {"scale", facts.scale},
                                {"zoom", facts.zoom},
                                {"placings", placings},
                                {"place_ms", facts.place_ms},
                                {"draw_ms", facts.draw_ms},
                                {"mouse", {mouse.position.x, mouse.position.y}},
                                {"mouse_down", mouse.down}};
    auto& places = line["widgets"] = nlohmann::ordered_json::object();
    for (const auto& [label, place] : widgets)
        places[label] = {place.min.x, place.min.y, place.max.x, place.max.y};
    return line.dump();
}

}  // namespace dapple
