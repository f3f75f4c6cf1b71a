#pragma once
// Dots as JSON, for programs and web pages.

#include <ostream>

#include "core/output/csv.h"

namespace dapple {

/// {"page": {"width_mm": 200, "height_mm": 150}, "unit": "mm", "columns": ["x_mm", ...], "dots": [[...],
/// ...]}: the page's size, then the table of table_row(), an array for each dot on a line of its
/// own, with the same numbers. Where several pens draw, "pens" lists their names, colours and widths, and the
/// last column is the number of the dot's pen there, from 0. Needs what write_csv() needs.
void write_dots_json(std::ostream& out, const DotStream& dots, const PageSize& page,
                     const CsvColumns& columns, const WritingProgress& progress = {});

}  // namespace dapple
