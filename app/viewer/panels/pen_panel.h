#pragma once
// The section "Ink and paper": which pens draw, and the colours of ink and paper.

#include <cstdint>
#include <span>

#include "app/viewer/model/banner.h"
#include "app/viewer/model/shown_pens.h"
#include "app/viewer/panels/palette_row.h"
#include "core/drawing/settings.h"
#include "core/text/length.h"

namespace dapple {

/// The pens that drew what is seen, several or none, and which of them are looked at.
struct PensSeen {
    std::span<const Pen> drawn = {};
    std::span<const std::uint64_t> dots = {};  // how many each of them drew; empty: not known
    ShownPens* shown = nullptr;                // none: no rows for it
};

/// Those kept by name.
struct KeptPalettes {
    PaletteRow* row = nullptr;  // none: no row for them
    Banner* banner = nullptr;   // with a row: see PaletteRow
};

/// True while a setting changes. Each pen that drew has a row with its colour, its dots and an eye, which is
/// no setting. Pens of one's own are listed at the end: each has a name, a colour, a width, a smallest gap
/// and a dot gain, and can be removed while there is another. `mostly_black`: light ink would draw the
/// picture better (see core/image/ink_use.h), and is offered.
bool draw_pen_panel(DrawingSettings& settings, LengthUnit unit = LengthUnit::mm, const PensSeen& seen = {},
                    const KeptPalettes& kept = {}, bool mostly_black = false);

}  // namespace dapple
