#include "core/strokes/strokes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

namespace dapple {
namespace {

// The part of a line that lies in the box, as shares of its length (Liang and Barsky 1984).
struct LinePart {
    double from, to;
};

std::optional<LinePart> part_inside(const Rectangle<double>& box, glm::dvec2 a, glm::dvec2 b) {
    LinePart part{0, 1};
    for (int axis = 0; axis < 2; ++axis) {
        const double way = b[axis] - a[axis];
        const double low = box.low[axis] - a[axis], high = box.high[axis] - a[axis];
        if (way == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        part.from = std::max(part.from, std::min(low / way, high / way));
        part.to = std::min(part.to, std::max(low / way, high / way));
    }
    if (part.from > part.to) return std::nullopt;
    return part;
}

}  // namespace

void end_stroke(Strokes& strokes, int pen) {
    const std::size_t begin = strokes.ends.empty() ? 0 : strokes.ends.back();
    if (strokes.points.size() <= begin) return;
    if (pen != 0 || !strokes.pens.empty()) {
        strokes.pens.resize(strokes.ends.size(), 0);
        strokes.pens.push_back(pen);
    }
    strokes.ends.push_back(strokes.points.size());
}

int pen_of(const Strokes& strokes, std::size_t stroke) {
    return strokes.pens.empty() ? 0 : strokes.pens[stroke];
}

void append(Strokes& to, const Strokes& more) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < more.ends.size(); ++i) {
        to.points.insert(to.points.end(), more.points.begin() + static_cast<std::ptrdiff_t>(begin),
                         more.points.begin() + static_cast<std::ptrdiff_t>(more.ends[i]));
        end_stroke(to, pen_of(more, i));
        begin = more.ends[i];
    }
}

StrokeStream stream_of(const Strokes& strokes, double width_mm) {
    return {.points = strokes.points.size(),
            .width_mm = width_mm,
            .for_each_stroke = [&strokes](const TakeStroke& take) {
                std::size_t begin = 0;
                for (std::size_t i = 0; i < strokes.ends.size(); ++i) {
                    const std::size_t end = strokes.ends[i];
                    take(std::span(strokes.points).subspan(begin, end - begin), pen_of(strokes, i));
                    begin = end;
                }
            }};
}

StrokeStream only(const StrokeStream& stream, int pen) {
    StrokeStream of_pen = stream;
    of_pen.for_each_stroke = [all = stream.for_each_stroke, pen](const TakeStroke& take) {
        all([&](std::span<const glm::dvec2> points, int its_pen) {
            if (its_pen == pen) take(points, its_pen);
        });
    };
    return of_pen;
}

Strokes collected(const StrokeStream& stream) {
    Strokes all;
    stream.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        all.points.insert(all.points.end(), points.begin(), points.end());
        end_stroke(all, pen);
    });
    return all;
}

Strokes cut_to(const Rectangle<double>& box, const StrokeStream& stream) {
    Strokes inside;
    stream.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        if (points.size() == 1 && part_inside(box, points[0], points[0]))
            inside.points.push_back(points[0] - box.low);
        bool goes_on = false;  // the last point is the next line's first
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec2 a = points[i - 1], b = points[i];
            const auto part = part_inside(box, a, b);
            if (!goes_on || !part || part->from > 0) end_stroke(inside, pen);
            if (!part) {
                goes_on = false;
                continue;
            }
            const auto at = [&](double share) {
                return glm::clamp(share >= 1 ? b : a + share * (b - a), box.low, box.high) - box.low;
            };
            if (!goes_on || part->from > 0) inside.points.push_back(at(part->from));
            inside.points.push_back(at(part->to));
            goes_on = part->to >= 1;
        }
        end_stroke(inside, pen);
    });
    return inside;
}

}  // namespace dapple
