#include "lab/related/plain_lloyd.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>

#include "core/tile/random.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

glm::dvec2 page_of(const Density& density) {
    return glm::dvec2(density.width(), density.height()) / double(density.longer_side());
}

PlainDots relaxed_random_dots(const DotsWanted& wanted, LloydWeight weight) {
    PlainDots dots =
        wanted.density ? random_dots(*wanted.density, wanted.count, wanted.seed) : white_noise(wanted);
    for (int step = 0; step < kLloydSteps; ++step) {
        if (wanted.stop.stop_requested()) return {};
        if (wanted.density)
            lloyd_step(dots, *wanted.density, weight);
        else
            plain_lloyd_step(dots);
    }
    return dots;
}

}  // namespace

std::vector<glm::dvec2> random_dots(const Density& density, std::size_t count, std::uint64_t seed) {
    const std::vector<float>& values = density.values().values;
    const double highest = *std::max_element(values.begin(), values.end());
    if (!(highest > 0)) throw std::runtime_error("the picture is white: there is nothing to draw");
    const glm::dvec2 page = page_of(density);
    Random random(seed);
    std::vector<glm::dvec2> dots;
    dots.reserve(count);
    while (dots.size() < count) {
        const double x = random.unit() * page.x, y = random.unit() * page.y;
        if (random.unit() * highest < density.at({x, y})) dots.emplace_back(x, y);
    }
    return dots;
}

double lloyd_step(std::vector<glm::dvec2>& dots, const Density& density, LloydWeight weight) {
    const glm::dvec2 page = page_of(density);
    const std::vector<CellMoments> cells = weighted_cells(dots, density, weight);
    double energy = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const CellMoments& cell = cells[i];
        energy += cell.xx + cell.yy;
        if (cell.weight > 0) dots[i] = glm::clamp(dots[i] + cell.first / cell.weight, glm::dvec2(0), page);
    }
    return energy;
}

void plain_lloyd_step(std::vector<glm::dvec2>& dots) {
    const std::vector<CellMoments> cells = plain_cells(dots);
    for (std::size_t i = 0; i < dots.size(); ++i)
        if (cells[i].weight > 0) dots[i] = on_unit_torus(dots[i] + cells[i].first / cells[i].weight);
}

PlainDots lloyd(const DotsWanted& wanted) {
    return relaxed_random_dots(wanted, LloydWeight::density);
}

PlainDots lloyd_squared(const DotsWanted& wanted) {
    return relaxed_random_dots(wanted, LloydWeight::density_squared);
}

}  // namespace dapple
