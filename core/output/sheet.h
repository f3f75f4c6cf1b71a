#pragma once
// A part of a drawing on a sheet of its own: murals larger than a printer, a plotter or a desk.

#include <span>
#include <string_view>

#include "core/placing/dots.h"
#include "core/placing/placer.h"
#include "core/stipple.h"

namespace dapple {

/// One of columns x rows equal sheets, counted from 1 at the upper left.
struct Sheet {
    int column = 1, row = 1, columns = 1, rows = 1;

    bool operator==(const Sheet&) const = default;
};

/// "2,1/3x4": the second sheet of the first row, of three columns and four rows. Throws std::runtime_error
/// saying what is wrong.
Sheet parse_sheet(std::string_view text);

/// Leaves the dots whose centres lie on the sheet, seen from its corner, makes the page the sheet's size and
/// moves the tiles along. Each dot is on exactly one sheet: sheets made one by one join without a lost or a
/// doubled dot.
void cut_to_sheet(const Sheet& sheet, Dots& dots, PageSize& page, std::span<PlacedTile> tiles);

}  // namespace dapple
