#include "core/output/pen_figures.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "core/analysis/distances.h"
#include "core/placing/stipple.h"
#include "core/routing/short_way.h"

namespace dapple {

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
