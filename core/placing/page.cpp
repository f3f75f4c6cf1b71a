#include "core/placing/page.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dapple {

namespace {

constexpr int kLevels = 8;        // of tiles as large as a few dots and more
constexpr int kCandidates = 256;  // the first digits; those after them alternate, far from any border

double way_to_border(double place) {
    return std::abs(place - std::round(place));
}

// The corner from which both ends of a side are farthest from borders, in sides of the tiles that these are
// of.
double corner_off_ends(double length) {
    double best = 0, farthest = -1;
    for (int i = 0; i < kCandidates; ++i) {
        const double corner = std::ldexp(std::floor(std::ldexp((i + 1.0 / 3) / kCandidates, 20)), -20);
        double way = 1;
        for (int level = 0; level < kLevels; ++level) {
            way = std::min({way, way_to_border(std::ldexp(corner, level)),
                            way_to_border(std::ldexp(length - corner, level))});
        }
        if (way <= farthest) continue;
        farthest = way;
        best = corner;
    }
    return best;
}

}  // namespace

glm::dvec2 corner_off_edges(int width, int height) {
    const double longer = std::max(width, height);
    return {corner_off_ends(width / longer), corner_off_ends(height / longer)};
}

Density page_density(Grid<float> values, Reading reading) {
    const glm::dvec2 corner = values.empty() ? glm::dvec2(0) : corner_off_edges(values.width, values.height);
    return Density(std::move(values), Sides::paper, corner, reading);
}

Density in_finer_cells(const Density& cells, int times) {
    Grid<float> finer(cells.width() * times, cells.height() * times);
    for (int y = 0; y < finer.height; ++y)
        for (int x = 0; x < finer.width; ++x) finer.at(x, y) = cells.values().at(x / times, y / times);
    return Density(std::move(finer), cells.sides(), cells.tile_corner(), Reading::by_cell);
}

namespace {

constexpr double kMargin = 0x1p-20;  // over what rounding to float does to a position on the page, 0..1

bool is_on(const PageSpan& span, float position) {
    return position >= span.first && position < span.end;
}

}  // namespace

PagePart widened(const PagePart& part, double by) {
    PagePart wider = part;
    for (PageSpan* span : {&wider.across, &wider.down}) {
        span->first = static_cast<float>(span->first - by);
        span->end = static_cast<float>(std::min(span->end + by, double{std::numeric_limits<float>::max()}));
    }
    return wider;
}

PageWindow window_around(const PagePart& part) {
    const auto start = [](const PageSpan& span) { return std::clamp(span.first - kMargin, -kMargin, 1.0); };
    const auto length = [&](const PageSpan& span) {
        return std::clamp(span.end + kMargin, 0.0, 1.0 + kMargin) - start(span);
    };
    return {static_cast<std::int64_t>(std::ldexp(start(part.across), 62)),
            static_cast<std::int64_t>(std::ldexp(start(part.down), 62)), length(part.across),
            length(part.down)};
}

void cut_to(const PagePart& part, Dots& dots) {
    if (part == PagePart{}) return;
    leave(dots, [&](std::size_t i) { return is_on(part.across, dots.x[i]) && is_on(part.down, dots.y[i]); });
    for (float& x : dots.x) x = static_cast<float>(x - part.across.offset);
    for (float& y : dots.y) y = static_cast<float>(y - part.down.offset);
}

void move_to(const PagePart& part, std::span<PlacedTile> tiles) {
    for (PlacedTile& tile : tiles) {
        tile.x -= part.across.offset;
        tile.y -= part.down.offset;
    }
}

}  // namespace dapple
