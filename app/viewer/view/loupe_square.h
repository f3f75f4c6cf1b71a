#pragma once
// What the loupe looks at: a square of whole tiles around the pointer, and their dots folded into one.

#include <cstddef>
#include <optional>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/view/camera.h"
#include "core/analysis/autocorrelation.h"

namespace dapple {

struct LoupeSquare {
    PagePoint corner;  // on the page
    int level = 0;     // of the tiles: their side is 2^-level page units
    int across = 0;    // tiles, in each direction

    double period() const;  // page units
    bool operator==(const LoupeSquare&) const = default;
};

/// The square around a place, in whole tiles of the page's grid. Its level is the deepest that the dots
/// around that place have gone through, or a deeper one whose tiles are small enough for some dozens of them
/// to lie side by side with few enough dots; `step` goes so many levels further. None if the place is not on
/// the page, or if there are too few dots or whole tiles around it.
std::optional<LoupeSquare> loupe_square(const PlacedDrawing& shown, std::size_t tile_size, PagePoint place,
                                        int step);

/// What the loupe found in it.
struct LoupeInfo {
    double repetition = 0;  // see core/analysis/autocorrelation.h
    int layers = 0, level = 0;
};

/// The dots in it, in units of a tile. Dots that lie on one another, as Figure 8 emits them, count once.
Folding folded(const PlacedDrawing& shown, const LoupeSquare& square);

}  // namespace dapple
