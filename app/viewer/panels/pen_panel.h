#pragma once
// The section "Pens": which pens draw, and the colours of ink and paper.

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
    ShownPens* shown = nullptr;  // none: no rows for it
};

/// Those kept by name.
struct KeptPalettes {
    PaletteRow* row = nullptr;  // none: no row for them
    Banner* banner = nullptr;   // with a row: see PaletteRow
};

/// True while a setting changes. Pens of one's own are listed near the end: each has a name, a colour, a
/// width, a smallest gap and a dot gain, and can be removed while there is another. At the end one pen can be
/// looked at alone, and each be hidden, which is no setting.
bool draw_pen_panel(DrawingSettings& settings, LengthUnit unit = LengthUnit::mm, const PensSeen& seen = {},
                    const KeptPalettes& kept = {});

}  // namespace dapple
