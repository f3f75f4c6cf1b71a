#include "app/viewer/model/crop_percent.h"

#include <glm/common.hpp>

namespace dapple {

Rectangle<double> crop_percent(const std::optional<Crop>& crop, glm::ivec2 picture) {
    if (!crop) return {{0, 0}, {100, 100}};
    if (crop->unit == Crop::Unit::percent) return crop->box;
    const glm::dvec2 percent = 100.0 / glm::dvec2(glm::max(picture, 1));
    return {crop->box.low * percent, crop->box.high * percent};
}

std::optional<Crop> crop_of_percent(Rectangle<double> box) {
    box.low = glm::clamp(box.low, glm::dvec2(0), glm::dvec2(100 - kLeastCropPercent));
    box.high = glm::clamp(box.high, box.low + kLeastCropPercent, glm::dvec2(100));
    if (box == Rectangle<double>{{0, 0}, {100, 100}}) return std::nullopt;
    return Crop{box, Crop::Unit::percent};
}

}  // namespace dapple
