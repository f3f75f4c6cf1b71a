#include "app/viewer/model/crop_percent.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <numbers>

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

double percent_proportion(CropProportion proportion, const Rectangle<double>& box, glm::ivec2 picture,
                          glm::dvec2 room) {
    const glm::dvec2 pixels(glm::max(picture, 1));
    const double percent = pixels.y / pixels.x;
    const glm::dvec2 side = (box.high - box.low) * pixels;
    if (proportion == CropProportion::picture) return 1;
    if (proportion == CropProportion::page) return room.x / room.y * percent;
    constexpr std::array kLongToShort{0.0, 0.0, 1.0, 4.0 / 3, 1.5, 16.0 / 9, std::numbers::sqrt2};
    const double longer = kLongToShort[static_cast<std::size_t>(proportion)];
    return (side.x >= side.y || longer == 0 ? longer : 1 / longer) * percent;
}

Rectangle<double> in_proportion(Rectangle<double> box, double proportion, glm::ivec2 moved) {
    if (!(proportion > 0)) return box;
    glm::dvec2 size = box.high - box.low;
    // What was moved says how large it is; else it keeps as much as it can.
    const bool by_width = moved.x != 0 || (moved.y == 0 && size.x < size.y * proportion);
    if (by_width)
        size.y = size.x / proportion;
    else
        size.x = size.y * proportion;
    for (int axis = 0; axis < 2; ++axis) {
        const double &low = box.low[axis], &high = box.high[axis];
        const double middle = (low + high) / 2;
        const double room = moved[axis] < 0   ? high
                            : moved[axis] > 0 ? 100 - low
                                              : 2 * std::min(middle, 100 - middle);
        size *= std::min(1.0, room / size[axis]);
    }
    for (int axis = 0; axis < 2; ++axis) {
        double &low = box.low[axis], &high = box.high[axis];
        const double middle = (low + high) / 2;
        if (moved[axis] < 0) {
            low = high - size[axis];
        } else if (moved[axis] > 0) {
            high = low + size[axis];
        } else {
            low = middle - size[axis] / 2;
            high = middle + size[axis] / 2;
        }
    }
    return box;
}

}  // namespace dapple
