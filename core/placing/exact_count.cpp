#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/placing/placer.h"

namespace dapple {

namespace {

constexpr double kMaxScale = 1e30;

// More than the expected scale by this share brings the count with near certainty: it strays less than chance
// would.
double margin(std::uint64_t count) {
    return 2 / std::sqrt(static_cast<double>(count));
}

// The critical scale of the last of the `count` dots that stay, when the dots beyond are dropped. Those are
// few and have the highest critical scales of all, so only high ones are looked at.
float limit_of(const Dots& dots, std::size_t count, double scale) {
    const std::size_t dropped = dots.size() - count;
    const double share = static_cast<double>(dropped + 1) / static_cast<double>(dots.size());
    std::vector<float> high;
    for (double below = 4 * share; high.size() <= dropped; below *= 4) {
        const auto from = static_cast<float>(scale * std::max(0.0, 1 - below));
        high.clear();
        std::copy_if(dots.critical.begin(), dots.critical.end(), std::back_inserter(high),
                     [from](float c) { return c >= from; });
    }
    std::nth_element(high.begin(), high.begin() + static_cast<std::ptrdiff_t>(dropped), high.end(),
                     std::greater<>());
    return high[dropped];
}

// Of dots that tie, in their order, the ones that come first. A black area has very many, one in each tile:
// taking them as they come would fill the area from one side, so they are taken in the order of their
// reversed binary indices.
std::vector<bool> first_of_ties(std::size_t ties, std::size_t wanted) {
    std::vector<bool> taken(ties, false);
    const std::size_t bits = static_cast<std::size_t>(std::bit_width(ties));
    for (std::size_t i = 0; wanted > 0; ++i) {
        std::size_t reversed = 0;
        for (std::size_t bit = 0; bit < bits; ++bit) reversed |= (i >> bit & 1) << (bits - 1 - bit);
        if (reversed >= ties) continue;
        taken[reversed] = true;
        --wanted;
    }
    return taken;
}

// Leaves the `count` dots of lowest critical scale, in their order, and gives a scale just above the highest
// of them.
double keep_lowest(Dots& dots, std::size_t count, double scale) {
    const float limit = limit_of(dots, count, scale);
    std::size_t below = 0, ties = 0;
    for (const float c : dots.critical) {
        below += c < limit;
        ties += c == limit;
    }
    const std::vector<bool> taken = first_of_ties(ties, count - below);
    std::size_t to = 0, tie = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const float critical = dots.critical[i];
        if (critical > limit || (critical == limit && !taken[tie++])) continue;
        dots.x[to] = dots.x[i];
        dots.y[to] = dots.y[i];
        dots.threshold[to] = dots.threshold[i];
        dots.critical[to] = critical;
        ++to;
    }
    for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold, &dots.critical}) column->resize(to);
    return std::nextafter(limit, std::numeric_limits<float>::max());  // a dot exists above its critical scale
}

}  // namespace

std::optional<double> place_exactly(Placer& placer, const Density& density, const ExactCount& request,
                                    Dots& dots, std::stop_token stop) {
    if (request.count == 0) {
        dots = {};
        return 0.0;
    }
    if (!(density.mean() > 0)) {
        throw std::runtime_error(
            "there is nothing to draw: the picture is white everywhere; darken it or invert it");
    }
    const double expected = static_cast<double>(request.count) / (16 * density.mean());
    PlacingRequest placing;
    placing.critical = true;
    placing.threads = request.threads;
    const double more = 1 + margin(request.count);
    placing.scale = expected * more;
    while (true) {
        if (!placer.place(density, placing, dots, stop)) return std::nullopt;
        if (dots.size() >= request.count) break;
        if (placing.scale > kMaxScale) {
            throw std::runtime_error("so many dots do not fit: the picture's dark part is too small");
        }
        // The share that is missing, and a little; small drawings grow by steps of a whole tile's ranks.
        const double share = static_cast<double>(request.count + 1) / static_cast<double>(dots.size() + 1);
        placing.scale *= std::clamp(share * more, more, 4.0);
    }
    return keep_lowest(dots, request.count, placing.scale);
}

}  // namespace dapple
