#include "app/viewer/panels/space_panel.h"

#include <array>

#include "app/viewer/widgets/widgets.h"

namespace dapple {

bool draw_space_panel(SpaceSettings& settings) {
    if (!subsection("In space", false)) return false;
    SpaceChoice& choice = settings.choice;
    hint(
        "The same in three dimensions: a cube of 64 points is the tile. It is divided into eight half as "
        "wide, each a tile again, until there are enough dots. Tile boundaries (key T) show the first "
        "eight.");
    segmented_row(
        "Volume", choice.volume, std::array{"cube", "ball", "gyroid"},
        "What the dots fill: an even cube, a ball that is denser towards its middle, or the sheet of "
        "a gyroid, a minimal surface.",
        SpaceChoice{}.volume);
    slider_row("Dots there", choice.dots,
               {.min = kFewestSpaceDots,
                .max = kMostSpaceDots,
                .neutral = SpaceChoice{}.dots,
                .curve = SliderCurve::logarithmic,
                .format = "%.0f",
                .grouped = true,
                .tip = "Exactly so many dots in the volume, those of the lowest thresholds."});
    switch_row("Settled", choice.settled,
               "In 20 steps the dots move to where they lie evenly; off: they stay as the tile places them.",
               true);
    double degrees = 360 * settings.turn;
    if (slider_row("Turned by", degrees,
                   {.min = 0,
                    .max = 360,
                    .neutral = 360 * SpaceSettings{}.turn,
                    .format = "%.0f",
                    .tip = "How far round they are turned, in degrees; a mouse can drag the picture, too."}))
        settings.turn = degrees / 360;
    switch_row("Turning", settings.turning, "They turn by themselves, once in 24 seconds.", true);
    return true;
}

}  // namespace dapple
