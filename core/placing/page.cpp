#include "core/placing/page.h"

#include <algorithm>
#include <cmath>

namespace dapple {

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
    std::size_t to = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const float x = dots.x[i], y = dots.y[i];
        if (!is_on(part.across, x) || !is_on(part.down, y)) continue;
        dots.x[to] = static_cast<float>(x - part.across.offset);
        dots.y[to] = static_cast<float>(y - part.down.offset);
        for (FloatBuffer* column : {&dots.threshold, &dots.critical, &dots.radius}) {
            if (!column->empty()) (*column)[to] = (*column)[i];
        }
        ++to;
    }
    for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold, &dots.critical, &dots.radius}) {
        if (!column->empty()) column->resize(to);
    }
}

void move_to(const PagePart& part, std::span<PlacedTile> tiles) {
    for (PlacedTile& tile : tiles) {
        tile.x -= part.across.offset;
        tile.y -= part.down.offset;
    }
}

}  // namespace dapple
