#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "core/output/progress.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

// Dots as machines take them: in millimetres, with the origin at the page's lower left corner and y upwards.

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

// Strokes as machines take them: with the origin at the page's lower left corner and y upwards.

/// Calls visit(span of points, pen) for each stroke as it is, telling how far it has come.
template <class Visit>
void for_each_stroke(const StrokeStream& strokes, const PageSize& page, const WritingProgress& progress,
                     const Visit& visit) {
    WritingProgress at_most_all;
    if (progress) at_most_all = [&](double share) { progress(std::min(share, 1.0)); };
    DotsReport report(std::max<std::uint64_t>(strokes.points, 1), page, at_most_all);
    strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        for (const glm::dvec2 p : points) report.next(p.x, p.y);
        visit(points, pen);
    });
}

/// Calls visit(span of points in millimetres, pen) for each stroke, turned so.
template <class Visit>
void for_each_plotted_stroke(const StrokeStream& strokes, const PageSize& page,
                             const WritingProgress& progress, const Visit& visit) {
    std::vector<glm::dvec2> turned;
    for_each_stroke(strokes, page, progress, [&](std::span<const glm::dvec2> points, int pen) {
        turned.clear();
        for (const glm::dvec2 p : points) turned.emplace_back(p.x, page.height_mm - p.y);
        visit(std::span<const glm::dvec2>(turned), pen);
    });
}

}  // namespace dapple
