#include "core/relaxing/stir.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/placing/pieces.h"

namespace dapple {

namespace {

// Each way, over the distance between dots: how far they are carried, and how wide the flow's swirls are.
constexpr float kSpread = 0.2f, kSwirl = 3;
// How far the flow of a spline through independent numbers of variance 1 carries.
constexpr float kPlainSpread = 0.7416198f;  // sqrt(11 / 20)
// So many tiles on a black page are stirred not at all, and so many wholly.
constexpr double kFewTiles = 2, kManyTiles = 16;
// Where dots are further apart than so many rows they are carried as if they were not.
constexpr float kMostRowsApart = 8;

// Nearly normally distributed. No logarithm or sine: their last bits would not be the same everywhere.
float random_at(int level, std::uint64_t column, std::uint64_t row) {
    const std::uint64_t bits = portable::mixed(portable::mixed(portable::mixed(level) + column) + row);
    float sum = 0;
    for (int shift = 0; shift < 64; shift += 16) sum += static_cast<float>(bits >> shift & 0xffff) * 0x1p-16f;
    return (sum - 2) * std::numbers::sqrt3_v<float>;
}

// A quadratic B-spline's weights of three numbers in a row, between the middle of the first two and that of
// the last two, and the weights' slopes.
struct SplineWeights {
    std::array<float, 3> value, slope;
    explicit SplineWeights(float t)
        : value{(1 - t) * (1 - t) / 2, 0.5f + t * (1 - t), t * t / 2}, slope{t - 1, 1 - 2 * t, t} {}
};

// Back onto the page, as a mirror on its edge would show it.
float mirrored(float place, float last) {
    const float inside = std::abs(place);
    return inside > last ? std::max(2 * last - inside, 0.0f) : inside;
}

}  // namespace

glm::vec2 stirring_at(glm::vec2 place, float apart) {
    // Swirls are a power of two wide, so that they are the same where the density changes a little.
    const int level = std::ilogb(apart * std::numbers::sqrt2_v<float>);
    const float cell = std::ldexp(kSwirl, level);
    const glm::vec2 at = place / cell;
    const float column = std::floor(at.x), row = std::floor(at.y);
    const SplineWeights across(at.x - column), down(at.y - row);
    glm::vec2 flow(0);  // the spline's slope, a quarter turned: what flows in flows out
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float height =
                random_at(level, static_cast<std::uint64_t>(column) + k, static_cast<std::uint64_t>(row) + i);
            flow.x += height * across.value[k] * down.slope[i];
            flow.y -= height * across.slope[k] * down.value[i];
        }
    }
    flow *= kSpread / kPlainSpread;
    return flow * (apart / std::max(glm::length(flow), 1.0f));
}

double farthest_stirred(double scale) {
    return double{kMostRowsApart} * relaxing_row(scale);
}

double stirring_of(const PlacingTable& table, double scale) {
    if (table.next_kind.size() == 1 && table.rule == Rule{}) return 0;
    const double tiles = kDotsPerScale * scale / static_cast<double>(table.tile_size);
    return std::clamp((tiles - kFewTiles) / (kManyTiles - kFewTiles), 0.0, 1.0);
}

void stir(DotPieces& dots, const Density& density, const RelaxingRequest& request) {
    const auto strength = static_cast<float>(request.stirring);
    if (strength == 0) return;
    const double longer = density.longer_side();
    // On its right and lower edges there is no density any more.
    const float last_x = std::nextafter(static_cast<float>(density.width() / longer), 0.0f);
    const float last_y = std::nextafter(static_cast<float>(density.height() / longer), 0.0f);
    const auto most_apart = static_cast<float>(farthest_stirred(request.scale));
    const auto in_black = static_cast<float>(kDotsPerScale * request.scale);  // dots on an area of 1
    const Refinement& finer = request.areas.finer;
    const auto move = [&](float& x, float& y) {
        const auto here = static_cast<float>(density.at({x, y}));
        if (!(here > 0)) return;
        const float tone = here / finer.times_at({x, y});
        const float apart = std::min(1 / std::sqrt(std::max(in_black * here, 1e-30f)), most_apart);
        glm::vec2 step = strength * stirring_at({x, y}, apart);
        const float chance = request.keeps_density ? chance_at(x, y, -1) : 0;
        for (int i = 0; i < kShorterTries; ++i) {
            const float to_x = mirrored(x + step.x, last_x), to_y = mirrored(y + step.y, last_y);
            const auto there = static_cast<float>(density.at({to_x, to_y}) / finer.times_at({to_x, to_y}));
            if (request.keeps_density ? keeps_density(tone, there, chance) : there > kLeastShare * tone) {
                x = to_x;
                y = to_y;
                return;
            }
            step *= 0.5f;
        }
    };
    for_each_on_threads(dots.pieces.size(), threads_for(request.threads), [&](std::size_t i) {
        Dots& piece = dots.pieces[i];
        for (std::size_t k = 0; k < piece.size(); ++k) move(piece.x[k], piece.y[k]);
    });
}

}  // namespace dapple
