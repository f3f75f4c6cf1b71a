#pragma once
// Where `dapple render` draws: the page, the picture on it, and the part of it that is wanted.

#include <glm/vec2.hpp>

#include "app/commands/render.h"
#include "core/drawing/page_setup.h"
#include "core/output/sheet.h"

namespace dapple {

struct DrawnPage {
    PageLayout layout;
    Excerpt whole;
    Excerpt part;  // the sheet or the region that is drawn, or the whole
};

/// Whether neither a sheet nor a region was asked for.
bool draws_whole_page(const RenderOptions& options);

/// The layout for a picture of so many pixels, before it is known how large the dots are if that follows from
/// their number. Throws std::runtime_error, "--option: why", for a page that cannot be.
PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options);

/// Throws as layout_for() does, for a part that does not lie on the page.
DrawnPage drawn_page(const PageLayout& layout, const RenderOptions& options);

/// Whether lines through the dots are written.
bool draws_lines(const DrawingSettings& settings, DrawingFormat format);

/// Where dots are placed for what is written: on the part, and on the whole page for lines, which are cut off
/// at the part's edges.
const Excerpt& placed_on(const DrawnPage& page, const DrawingSettings& settings, DrawingFormat format);

/// The part for which dots are placed: that, and in what is seen rather than plotted what lies so near that
/// its dots, of that radius in page units, reach over its edges.
PagePart reached(const DrawnPage& page, const DrawingSettings& settings, DrawingFormat format, double radius);

/// A rectangle on the page, in millimetres, seen from the excerpt's corner.
Rectangle<double> seen_from(const Excerpt& excerpt, const PageLayout& layout,
                            const Rectangle<double>& on_page);

}  // namespace dapple
