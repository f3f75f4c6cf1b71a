#include "lab/related/lbg.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "lab/related/plain_voronoi.h"

namespace dapple {
namespace {

constexpr double kHysteresis = 0.6, kMoreEachStep = 0.01;

// The direction of the cell's long axis, about its centroid.
glm::dvec2 long_axis(const CellMoments& cell, glm::dvec2 to_centroid) {
    const double xx = cell.xx / cell.weight - to_centroid.x * to_centroid.x;
    const double yy = cell.yy / cell.weight - to_centroid.y * to_centroid.y;
    const double xy = cell.xy / cell.weight - to_centroid.x * to_centroid.y;
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

LbgStep lbg_step(const PlainDots& dots, const DotsWanted& wanted, double hysteresis, Random& random) {
    const glm::dvec2 page = page_of(wanted);
    const double share = (wanted.density ? wanted.density->mean() : 1.0) / double(wanted.count);
    const auto kept_on_page = [&](glm::dvec2 p) {
        return wanted.density ? glm::clamp(p, glm::dvec2(0), page) : on_unit_torus(p);
    };
    const std::vector<CellMoments> cells =
        wanted.density ? weighted_cells(dots, *wanted.density, LloydWeight::density) : plain_cells(dots);
    LbgStep step;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const CellMoments& cell = cells[i];
        if (cell.weight < (1 - hysteresis / 2) * share) {
            step.changed = true;
            continue;
        }
        const glm::dvec2 to_centroid = cell.first / cell.weight, centroid = dots[i] + to_centroid;
        if (cell.weight <= (1 + hysteresis / 2) * share) {
            step.dots.push_back(kept_on_page(centroid));
            continue;
        }
        const double radius = std::sqrt(cell.area / std::numbers::pi);  // of a disc of the cell's area
        // Two halves in exact symmetry would stay so; their way is a hair off.
        const glm::dvec2 way = long_axis(cell, to_centroid) * (radius / 2);
        const glm::dvec2 hair = glm::dvec2(random.unit(), random.unit()) * (radius * 1e-3);
        step.dots.push_back(kept_on_page(centroid + way + hair));
        step.dots.push_back(kept_on_page(centroid - way));
        step.changed = true;
    }
    return step;
}

PlainDots lbg(const DotsWanted& wanted) {
    const glm::dvec2 page = page_of(wanted);
    Random random(wanted.seed);
    LbgStep last{.dots = {{random.unit() * page.x, random.unit() * page.y}}, .changed = true};
    for (int step = 0; step < kLbgSteps && last.changed; ++step) {
        if (wanted.stop.stop_requested()) return {};
        LbgStep next = lbg_step(last.dots, wanted, kHysteresis + kMoreEachStep * step, random);
        if (next.dots.empty()) break;
        last = std::move(next);
    }
    return last.dots;
}

}  // namespace dapple
