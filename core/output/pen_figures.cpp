#include "core/output/pen_figures.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "core/placing/stipple.h"
#include "core/routing/short_way.h"
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

PlottingTime time_of(const DrawnInking& inking, const MachineProgram& program) {
    if (inking.strokes.points.empty()) return {};
    return figures_of(stream_of(inking.strokes, 0), program).time;
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

std::vector<PenFigures> pen_figures(const DotPieces& by_pen, const PageSize& page,
                                    std::span<const Pen> pens) {
    std::vector<PenFigures> figures;
    for (const Dots& own : by_pen.pieces) {
        const double unit = page.mm_per_page_unit;
        PenFigures of_pen{.pen = own.pen,
                          .dots = own.size(),
                          .pen_up_m = way_length(own.x, own.y) * unit / 1000,
                          .nearest_mm = std::numeric_limits<double>::infinity()};
        std::vector<glm::dvec2> places(own.size());
        const glm::dvec2 size(page.width_mm, page.height_mm);
        for (std::size_t i = 0; i < own.size(); ++i)
            places[i] = glm::clamp(glm::dvec2(own.x[i], own.y[i]) * unit, glm::dvec2(0), size);
        const double gap = pens[static_cast<std::size_t>(own.pen)].gap_mm;
        for (const double nearest : nearest_distances(places, {size.x, size.y, Topology::window})) {
            of_pen.nearest_mm = std::min(of_pen.nearest_mm, nearest);
            of_pen.nearer_than_gap += nearest < gap;
        }
        figures.push_back(of_pen);
    }
    return figures;
}

PenEvenness pen_evenness(const DotPieces& by_pen, glm::dvec2 corner, const PenDensities& densities,
                         double scale) {
    const double full = kDotsPerScale * scale;
    const Density& page = *densities.all;
    const glm::dvec2 size = glm::dvec2(page.width(), page.height()) / static_cast<double>(page.longer_side());
    const auto places_of = [&](const Dots& dots, std::vector<glm::dvec2>& places) {
        for (std::size_t i = 0; i < dots.size(); ++i)
            places.push_back(glm::clamp(glm::dvec2(dots.x[i], dots.y[i]) + corner, glm::dvec2(0), size));
    };
    PenEvenness evenness;
    evenness.each.resize(densities.each.size());
    std::vector<glm::dvec2> all;
    for (const Dots& own : by_pen.pieces) {
        std::vector<glm::dvec2> places;
        places_of(own, places);
        places_of(own, all);
        const auto pen = static_cast<std::size_t>(own.pen);
        evenness.each[pen].distances = local_distances(places, *densities.each[pen], full);
    }
    for (std::size_t pen = 0; pen < evenness.each.size(); ++pen)
        evenness.each[pen].wanted = full * densities.each[pen]->mean();
    evenness.all = local_distances(all, *densities.all, full);
    return evenness;
}

}  // namespace dapple
