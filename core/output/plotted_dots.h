#pragma once
// Dots as machines take them: in millimetres, with the origin at the page's lower left corner and y upwards.

#include <functional>

#include "core/output/progress.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"

namespace dapple {

struct PlottedDot {
    double x_mm = 0, y_mm = 0;  // from the lower left corner
    double radius_mm = 0;
    int pen = 0;
};

/// Calls visit(PlottedDot) for each dot, in the order given. `radius_mm` is of dots that have none of their
/// own.
template <class Visit>
void for_each_plotted_dot(const DotStream& dots, const PageSize& page, double radius_mm,
                          const WritingProgress& progress, const Visit& visit) {
    const double unit = page.mm_per_page_unit;
    DotsReport report(dots.count, page, progress);
    dots.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const PlottedDot dot{piece.x[i] * unit, page.height_mm - piece.y[i] * unit,
                                 piece.radius.empty() ? radius_mm : piece.radius[i] * unit, piece.pen};
            report.next(dot.x_mm, dot.y_mm, dot.radius_mm);
            visit(dot);
        }
        return true;
    });
}

}  // namespace dapple
