#pragma once
// Dots as a table, for programs.

#include <ostream>
#include <span>

#include "core/output/progress.h"
#include "core/pens/pen.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"

namespace dapple {

struct CsvColumns {
    double dot_radius_mm = 0;        // where dots have none of their own
    std::size_t tile_size = 0;       // N, which a threshold needs to say level and rank
    std::span<const Pen> pens = {};  // several, for Dots::pen; none: one
    bool figure8 = false;            // that emitted the dots: see figure8_rank_of()
};

/// A dot as a line of the table.
struct TableRow {
    double x_mm = 0, y_mm = 0, radius_mm = 0;
    TileRank at;
    float critical_scale = 0;
};

/// The i-th dot of a piece, which has to have thresholds.
TableRow table_row(const Dots& piece, std::size_t i, const PageSize& page, const CsvColumns& columns);

/// A line x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm and a line a dot, in the
/// order given. Numbers have as many digits as it takes to read back the very same: x_mm / mm_per_page_unit,
/// rounded to float, is the dot's x. The page's size is in every line: a comment or a line of its own would
/// be taken for a dot by many readers of tables, and an empty field is an error to some. Where several pens
/// draw, a last column has the pen's name. Needs Dots::threshold and
/// Dots::critical, and the memory of a piece and a buffer.
void write_csv(std::ostream& out, const DotStream& dots, const PageSize& page, const CsvColumns& columns,
               const WritingProgress& progress = {});

// Dots as JSON, for programs and web pages.

/// {"page": {"width_mm": 200, "height_mm": 150}, "unit": "mm", "columns": ["x_mm", ...], "dots": [[...],
/// ...]}: the page's size, then the table of table_row(), an array for each dot on a line of its
/// own, with the same numbers. Where several pens draw, "pens" lists their names, colours and widths, and the
/// last column is the number of the dot's pen there, from 0. Needs what write_csv() needs.
void write_dots_json(std::ostream& out, const DotStream& dots, const PageSize& page,
                     const CsvColumns& columns, const WritingProgress& progress = {});

}  // namespace dapple
