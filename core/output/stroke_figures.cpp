#include "core/output/stroke_figures.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "core/strokes/dot_shape.h"

namespace dapple {

StrokeFigures figures_of(const StrokeStream& strokes, const MachineProgram& program) {
    StrokeFigures result;
    MachineClock clock(program);
    std::optional<glm::dvec2> last;
    strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        clock.take(pen);
        clock.stroke(points);
        ++result.strokes;
        result.segments += points.size() - 1;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double way = glm::distance(points[i - 1], points[i]);
            result.drawn_m += way / 1000;
            result.longest_mm = std::max(result.longest_mm, way);
        }
        if (last) result.pen_up_m += glm::distance(*last, points[0]) / 1000;
        last = points.back();
    });
    result.time = clock.finish();
    return result;
}

PlottingTime plotting_time_of_rings(const DotStream& dots, double mm_per_page_unit, double dot_radius_mm,
                                    const MachineProgram& program) {
    MachineClock clock(program);
    std::vector<glm::dvec2> ring;
    dots.for_each_piece([&](const Dots& piece) {
        if (piece.size() > 0) clock.take(piece.pen);
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double radius = piece.radius.empty() ? dot_radius_mm : piece.radius[i] * mm_per_page_unit;
            ring = mark_of({DotShape::ring, {}}, radius, 0).points;
            for (glm::dvec2& point : ring) point += glm::dvec2(piece.x[i], piece.y[i]) * mm_per_page_unit;
            clock.stroke(ring);
        }
        return true;
    });
    return clock.finish();
}

}  // namespace dapple
