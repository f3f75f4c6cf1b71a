#include "lab/related/best_candidate.h"

#include "core/tile/random.h"
#include "lab/related/bent_square.h"
#include "lab/related/growing_grid.h"

namespace dapple {

PlainDots best_candidate(const DotsWanted& wanted) {
    const BentSquare warp(wanted.density);
    const glm::dvec2 page = page_of(wanted);
    GrowingGrid grid({page.x, page.y, wanted.density ? Topology::window : Topology::torus});
    Random random(wanted.seed);
    for (std::size_t i = 0; i < wanted.count; ++i) {
        if (wanted.stop.stop_requested()) return {};
        glm::dvec2 best{};
        double farthest = -1;
        for (std::size_t candidate = 0; candidate <= i; ++candidate) {
            const double x = random.unit(), y = random.unit();
            const glm::dvec2 place = warp({x, y});
            // Two pixels' density is hardly ever 0 where the warp goes, but between them it can be.
            const double density = wanted.density ? wanted.density->at(place) : 1;
            const double distance = grid.nearest2(place, 1e300) * density;
            if (distance > farthest || candidate == 0) {
                farthest = distance;
                best = place;
            }
        }
        grid.add(best);
    }
    return grid.points();
}

}  // namespace dapple
