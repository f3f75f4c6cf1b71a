#pragma once
// A part of a drawing on a sheet of its own: murals larger than a printer, a plotter or a desk; a detail to
// try first.

#include <glm/vec2.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/rectangle.h"
#include "core/placing/page.h"

namespace dapple {

/// One of columns x rows equal sheets, counted from 1 at the upper left. Neighbours share a strip so wide,
/// to cut and to glue in; without one, they end where the next begins.
struct Sheet {
    int column = 1, row = 1, columns = 1, rows = 1;
    double overlap_mm = 0;

    bool operator==(const Sheet&) const = default;
};

inline constexpr double kWidestOverlapMm = 1000;
/// Along a side, of those that are drawn together.
inline constexpr int kMostSheetsAtOnce = 100;

/// "2,1/3x4": the second sheet of the first row, of three columns and four rows. Throws std::runtime_error
/// saying what is wrong.
Sheet parse_sheet(std::string_view text);

/// "3x4": all sheets of three columns and four rows, of which this is the first; up to
/// kMostSheetsAtOnce a side. Throws std::runtime_error saying what is wrong.
Sheet parse_sheets(std::string_view text);

/// "3x4".
std::string grid_text(const Sheet& sheet);

/// Whether there are more than one.
bool is_several(const Sheet& sheet);

/// All of them, row by row.
std::vector<Sheet> all_sheets(const Sheet& sheet);

/// "B3": the column's letter and the row's number; AA follows Z.
std::string name_of(const Sheet& sheet);

/// A part of a page in millimetres from its upper left corner. "120,80,50x40.5": 50 mm wide and 40.5 mm high,
/// its corner 120 mm from the left and 80 mm from the top; each may have a unit (see millimetres_of()), and
/// the last one's is that of all without: "1,1,4x3in". Throws std::runtime_error saying what is wrong.
Rectangle<double> parse_region(std::string_view text);

/// The same region as parse_region() reads it, in millimetres: "120,80,50x40.5".
std::string text_of_region(const Rectangle<double>& region);

/// A part of a page, and its own size.
struct Excerpt {
    PagePart part;
    PageSize size;
};

/// Each dot is on exactly one sheet, but for those in shared strips, which are on all that share them: sheets
/// made one by one join without a lost or a doubled dot. The dots lie so much further right and down as the
/// picture's corner, told in millimetres of the page. Throws std::runtime_error if the strips are so wide
/// that sheets which are no neighbours would share some of the page.
Excerpt sheet_of(const PageSize& page, const Sheet& sheet, glm::dvec2 picture_corner_mm = {});

/// Regions with a common edge join as sheets do. A tenth of a millimetre over the page's edge is cut off:
/// page sizes are often told rounded. Throws std::runtime_error if it reaches further.
Excerpt region_of(const PageSize& page, const Rectangle<double>& region, glm::dvec2 picture_corner_mm = {});

/// Millimetres from a sheet's upper left corner to the next one's, across and down.
glm::dvec2 sheet_step(const PageSize& page, const Sheet& sheet);

/// A line in millimetres from a sheet's upper left corner.
struct CutMark {
    glm::dvec2 from, to;

    bool operator==(const CutMark&) const = default;
};

/// Short lines at a sheet's edges that tell where to cut it: along the middles of the strips that it shares.
/// They lie in what is cut off where two strips cross, and end at most 5 mm from the edge. None without an
/// overlap, where the sheet's edges are where to cut.
std::vector<CutMark> cut_marks(const PageSize& page, const Sheet& sheet);

/// A cross in each of the page's corners, for each pen to draw: where they lie on one another, so do the
/// pens' dots. 6 mm high and wide, or a twentieth of the page's shorter side where that is less.
std::vector<CutMark> registration_marks(const PageSize& page);

// A page that shows which sheet of a mural goes where, and tells how to cut and join them.

struct AssemblyPlan {
    PageSize page;       // the whole mural
    Sheet sheets;        // how many there are, and their overlap
    std::string name;    // the files are name-A1 and so on,
    std::string ending;  // with this ending
};

/// An SVG of an upright A4 page: the mural to scale with its sheets' names, the shared strips grey and the
/// lines to cut along dashed, and the steps in words. The same plan is the same file.
void write_assembly_plan(std::ostream& out, const AssemblyPlan& plan);

}  // namespace dapple
