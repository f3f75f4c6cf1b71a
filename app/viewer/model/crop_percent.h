#pragma once
// The crop as the window edits it: in percent of the picture, whatever unit it came in.

#include <glm/vec2.hpp>
#include <optional>

#include "core/drawing/page_setup.h"
#include "core/text/names.h"

namespace dapple {

/// The window makes none narrower or lower.
inline constexpr double kLeastCropPercent = 1;

/// The crop in percent of a picture of so many pixels; none is all of it.
Rectangle<double> crop_percent(const std::optional<Crop>& crop, glm::ivec2 picture);
/// In percent, kept within the picture and so wide and high as that; all of the picture is none.
std::optional<Crop> crop_of_percent(Rectangle<double> box);

/// Proportions that a crop is kept to.
enum class CropProportion { free, picture, square, four_three, three_two, sixteen_nine, a_series, page };
constexpr auto names_of(CropProportion) {
    return names("free", "picture", "1:1", "4:3", "3:2", "16:9", "A series", "page");
}

struct CropTool {
    bool on = false;  // all of the picture is shown, for a frame over it
    CropProportion proportion = CropProportion::free;
};

/// How wide a crop is to its height, in percent each, so that it has the proportion on a picture of so many
/// pixels; 0: free. 3:2 and its like lie as the box does. `room` is the page's within its margins, and turned
/// with the picture.
double percent_proportion(CropProportion proportion, const Rectangle<double>& box, glm::ivec2 picture,
                          glm::dvec2 room);

/// The box with that proportion, within the picture. What was moved of it: -1 the left or upper side, 1 the
/// right or lower one, 0 neither; the other side stays, or the middle. Of a box of which nothing was moved,
/// the largest around its middle.
Rectangle<double> in_proportion(Rectangle<double> box, double proportion, glm::ivec2 moved = {0, 0});

}  // namespace dapple
