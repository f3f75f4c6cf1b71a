#include "app/viewer/panels/settings_panels.h"

#include <array>

#include "app/viewer/model/crop_percent.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

bool draw_crop_rows(PageSetup& setup, CropTool& tool, glm::ivec2 picture, glm::dvec2 room) {
    if (!section("Crop")) {
        tool.on = false;  // what cannot be seen is not to frame
        return false;
    }
    std::optional<Crop>& crop = setup.crop;
    Rectangle<double> box = crop_percent(crop, picture);
    bool changed = false;
    if (choice_row("Proportions", tool.proportion, names_of(tool.proportion),
                   "Proportions that the frame keeps while dragged. page: the paper within its margins. "
                   "Others are upright if the frame is.")) {
        box = in_proportion(box, percent_proportion(tool.proportion, box, picture, room));
        changed = tool.proportion != CropProportion::free;
    }
    switch_row("Crop frame", tool.on,
               "Shows the whole picture with a frame around what is drawn: drag the frame, its edges or its "
               "corners.");
    constexpr std::array kSides{"From left, %", "From top, %", "To right, %", "To bottom, %"};
    for (int i = 0; i < 4; ++i)
        changed |= slider_row(kSides[static_cast<std::size_t>(i)], (i < 2 ? box.low : box.high)[i % 2],
                              {.max = 100,
                               .neutral = i < 2 ? 0.0 : 100.0,
                               .format = "%.1f",
                               .tip = i % 2 == 0 ? "In percent of the picture's width, before rotation."
                                                 : "In percent of the picture's height, before rotation."});
    if (changed) crop = crop_of_percent(box);
    changed |= segmented_row("Rotate", setup.quarter_turns, std::array{"0", "90", "180", "270"},
                             "Rotates the picture on the page, in degrees clockwise.");
    changed |= switch_row(setting::mirror, setup.mirrored);
    const Absent absent(crop ? nullptr : "The whole picture is drawn.");
    if (!wide_button("Remove the crop", "Draws the whole picture.")) return changed;
    crop.reset();
    return true;
}

}  // namespace dapple
