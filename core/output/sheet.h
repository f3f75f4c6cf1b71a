#pragma once
// A part of a drawing on a sheet of its own: murals larger than a printer, a plotter or a desk; a detail to
// try first.

#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "core/image/rectangle.h"
#include "core/placing/page.h"

namespace dapple {

/// One of columns x rows equal sheets, counted from 1 at the upper left.
struct Sheet {
    int column = 1, row = 1, columns = 1, rows = 1;

    bool operator==(const Sheet&) const = default;
};

/// "2,1/3x4": the second sheet of the first row, of three columns and four rows. Throws std::runtime_error
/// saying what is wrong.
Sheet parse_sheet(std::string_view text);

/// A part of a page in millimetres from its upper left corner. "120,80,50x40.5": 50 mm wide and 40.5 mm high,
/// its corner 120 mm from the left and 80 mm from the top. Throws std::runtime_error saying what is wrong.
Rectangle<double> parse_region(std::string_view text);

/// A part of a page, and its own size.
struct Excerpt {
    PagePart part;
    PageSize size;
};

/// Each dot is on exactly one sheet: sheets made one by one join without a lost or a doubled dot.
/// The dots lie so much further right and down as the picture's corner, told in millimetres of the page.
Excerpt sheet_of(const PageSize& page, const Sheet& sheet, glm::dvec2 picture_corner_mm = {});

/// Regions with a common edge join as sheets do. A tenth of a millimetre over the page's edge is cut off:
/// page sizes are often told rounded. Throws std::runtime_error if it reaches further.
Excerpt region_of(const PageSize& page, const Rectangle<double>& region, glm::dvec2 picture_corner_mm = {});

/// A line in millimetres from a sheet's upper left corner.
struct CutMark {
    glm::dvec2 from, to;

    bool operator==(const CutMark&) const = default;
};

/// A cross in each of the page's corners, for each pen to draw: where they lie on one another, so do the
/// pens' dots. 6 mm high and wide, or a twentieth of the page's shorter side where that is less.
std::vector<CutMark> registration_marks(const PageSize& page);

}  // namespace dapple
