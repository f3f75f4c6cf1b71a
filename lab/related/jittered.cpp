#include "lab/related/jittered.h"

#include <algorithm>
#include <cmath>

#include "core/tile/random.h"
#include "lab/related/bent_square.h"

namespace dapple {

PlainDots jittered_grid(const DotsWanted& wanted) {
    const BentSquare warp(wanted.density);
    const glm::dvec2 page = page_of(wanted);
    Random random(wanted.seed);
    // Cells about as wide as high on the page.
    const auto rows =
        std::size_t(std::max(1L, std::lround(std::sqrt(double(wanted.count) * page.y / page.x))));
    PlainDots dots;
    dots.reserve(wanted.count);
    for (std::size_t row = 0; row < rows; ++row) {
        if (wanted.stop.stop_requested()) return {};
        const std::size_t columns = (row + 1) * wanted.count / rows - row * wanted.count / rows;
        for (std::size_t column = 0; column < columns; ++column) {
            const double x = random.unit(), y = random.unit();
            dots.push_back(warp({(double(column) + x) / double(columns), (double(row) + y) / double(rows)}));
        }
    }
    return dots;
}

}  // namespace dapple
