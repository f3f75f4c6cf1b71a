#include "core/lines/inking.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/image/detail.h"
#include "core/image/tone.h"
#include "core/lines/line_field.h"

namespace dapple {
namespace {

using Points = std::vector<glm::dvec2>;

// To the left of the way through a point of a line, of length 1.
glm::dvec2 aside_at(const Points& points, std::size_t i, bool closed) {
    const std::size_t last = points.size() - 1;
    const glm::dvec2 before = i > 0 ? points[i - 1] : closed ? points[last - 1] : points[0];
    const glm::dvec2 after = i < last ? points[i + 1] : closed ? points[1] : points[last];
    const glm::dvec2 way = after - before;
    const double length = glm::length(way);
    return length > 0 ? glm::dvec2(-way.y, way.x) / length : glm::dvec2(0);
}

// A line moved to its side at each point.
template <class Distance>
Points beside(const Points& points, bool closed, const Distance& distance) {
    Points moved(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        moved[i] = points[i] + aside_at(points, i, closed) * distance(i);
    return moved;
}

void add_round_end(Points& ring, glm::dvec2 end, glm::dvec2 from, double radius) {
    constexpr int kSteps = 6;
    const glm::dvec2 x = (from - end) / std::max(radius, 1e-12), y(x.y, -x.x);
    for (int k = 1; k < kSteps; ++k) {
        static constexpr std::array kCos{1.0, 0.8660254037844387, 0.5, 0.0, -0.5, -0.8660254037844387};
        static constexpr std::array kSin{0.0, 0.5, 0.8660254037844387, 1.0, 0.8660254037844387, 0.5};
        ring.push_back(end + radius * (kCos[k] * x + kSin[k] * y));
    }
}

InkArea outline_of(const InkLine& line) {
    const bool closed = line.closed();
    const auto half = [&](std::size_t i) { return line.widths[i] / 2.0; };
    Points left = beside(line.points, closed, half);
    Points right = beside(line.points, closed, [&](std::size_t i) { return -half(i); });
    if (closed) {
        std::ranges::reverse(right);
        return {{std::move(left), std::move(right)}};
    }
    add_round_end(left, line.points.back(), left.back(), half(line.points.size() - 1));
    left.insert(left.end(), right.rbegin(), right.rend());
    add_round_end(left, line.points.front(), right.front(), half(0));
    left.push_back(left.front());
    return {{std::move(left)}};
}

// Cut off at one side of a box (Sutherland and Hodgman 1974): at axis >= limit, or <= it.
Points cut_off(const Points& ring, int axis, double limit, bool keeps_more) {
    Points kept;
    const auto inside = [&](glm::dvec2 p) { return keeps_more ? p[axis] >= limit : p[axis] <= limit; };
    for (std::size_t i = 1; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i - 1], b = ring[i];
        if (inside(a)) kept.push_back(a);
        if (inside(a) == inside(b)) continue;
        glm::dvec2 crossing = a + (b - a) * ((limit - a[axis]) / (b[axis] - a[axis]));
        crossing[axis] = limit;
        kept.push_back(crossing);
    }
    if (!kept.empty()) kept.push_back(kept.front());
    return kept;
}

Points cut_to(Points ring, const Rectangle<double>& box) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [low, high] = std::minmax_element(
            ring.begin(), ring.end(), [&](glm::dvec2 a, glm::dvec2 b) { return a[axis] < b[axis]; });
        const bool before = box.low[axis] > (*low)[axis], beyond = box.high[axis] < (*high)[axis];
        if (before) ring = cut_off(ring, axis, box.low[axis], true);
        if (ring.empty()) break;
        if (beyond) ring = cut_off(ring, axis, box.high[axis], false);
        if (ring.empty()) break;
    }
    return ring;
}

// How far the lines of a hatching lie apart, in pens' widths: no paper shows between them.
constexpr double kApart = 0.8;

void add_passes(Strokes& strokes, const InkLine& line, double pen) {
    const double widest = *std::ranges::max_element(line.widths);
    const int to_each_side = std::max(0, static_cast<int>(std::ceil((widest - pen) / 2 / (kApart * pen))));
    for (int k = -to_each_side; k <= to_each_side; ++k) {
        const double share = to_each_side > 0 ? static_cast<double>(k) / to_each_side : 0;
        const Points pass = beside(line.points, line.closed(), [&](std::size_t i) {
            return share * std::max(line.widths[i] - pen, 0.0) / 2;
        });
        // Where the line is narrower than further on, the passes beside its middle have nothing to add.
        for (std::size_t i = 0; i < pass.size(); ++i) {
            if (k == 0 || line.widths[i] > pen)
                strokes.points.push_back(pass[i]);
            else
                end_stroke(strokes);
        }
        end_stroke(strokes);
    }
}

// To and fro through an area whose edge is drawn already, half a pen's width within.
void add_hatching(Strokes& strokes, const InkArea& area, double pen) {
    struct Crossing {
        double x;
        int turn;
    };
    const double apart = kApart * pen;
    double top = std::numeric_limits<double>::max(), bottom = -top;
    for (const Points& ring : area.rings)
        for (const glm::dvec2 p : ring) top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    const auto first = static_cast<std::ptrdiff_t>(std::ceil(top / apart));
    const auto rows = static_cast<std::ptrdiff_t>(std::floor(bottom / apart)) - first + 1;
    if (rows <= 0) return;
    std::vector<std::vector<Crossing>> crossings(static_cast<std::size_t>(rows));
    for (const Points& ring : area.rings) {
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const auto [a, b] =
                ring[i - 1].y < ring[i].y ? std::pair(ring[i - 1], ring[i]) : std::pair(ring[i], ring[i - 1]);
            for (auto row = static_cast<std::ptrdiff_t>(std::ceil(a.y / apart));
                 static_cast<double>(row) * apart < b.y; ++row) {
                const double along = (static_cast<double>(row) * apart - a.y) / (b.y - a.y);
                crossings[static_cast<std::size_t>(row - first)].push_back(
                    {a.x + along * (b.x - a.x), ring[i - 1].y < ring[i].y ? 1 : -1});
            }
        }
    }
    // Strokes that go on in the next row, if that has something right below their end.
    std::vector<Points> open;
    const auto finish = [&](const Points& points) {
        strokes.points.insert(strokes.points.end(), points.begin(), points.end());
        end_stroke(strokes);
    };
    for (std::size_t row = 0; row < crossings.size(); ++row) {
        const double y = static_cast<double>(first + static_cast<std::ptrdiff_t>(row)) * apart;
        std::ranges::sort(crossings[row], {}, &Crossing::x);
        std::vector<Points> now;
        int inside = 0;
        for (std::size_t i = 0; i + 1 < crossings[row].size(); ++i) {
            inside += crossings[row][i].turn;
            const double from = crossings[row][i].x + pen / 2, to = crossings[row][i + 1].x - pen / 2;
            if (inside == 0 || from >= to) continue;
            const auto below = std::ranges::find_if(open, [&](const Points& stroke) {
                const double x = stroke.back().x;
                return std::min(std::abs(x - from), std::abs(x - to)) < 1.5 * pen;
            });
            Points stroke;
            if (below != open.end()) {
                stroke = std::move(*below);
                open.erase(below);
            }
            const bool back =
                !stroke.empty() && std::abs(stroke.back().x - to) < std::abs(stroke.back().x - from);
            stroke.emplace_back(back ? to : from, y);
            stroke.emplace_back(back ? from : to, y);
            now.push_back(std::move(stroke));
        }
        for (const Points& ended : open) finish(ended);
        open = std::move(now);
    }
    for (const Points& ended : open) finish(ended);
}

void add_area(Strokes& strokes, const InkArea& area, double pen) {
    for (const Points& ring : area.rings) {
        // Rings go around what is filled on the same side, outer ones and holes alike.
        const Points within = beside(ring, true, [&](std::size_t) { return pen / 2; });
        strokes.points.insert(strokes.points.end(), within.begin(), within.end());
        end_stroke(strokes);
    }
    add_hatching(strokes, area, pen);
}

// Each next stroke begins nearest to where the last one ended, and may be drawn from its end.
Strokes in_short_order(const Strokes& strokes) {
    constexpr std::size_t kMost = 20'000;  // of more, looking for it takes too long
    if (strokes.ends.size() > kMost) return strokes;
    const auto begin_of = [&](std::size_t i) { return i == 0 ? 0 : strokes.ends[i - 1]; };
    std::vector<std::size_t> left(strokes.ends.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
    Strokes sorted;
    glm::dvec2 at(0);
    while (!left.empty()) {
        double least = std::numeric_limits<double>::max();
        std::size_t next = 0;
        bool from_end = false;
        for (std::size_t k = 0; k < left.size(); ++k) {
            const glm::dvec2 to_begin = strokes.points[begin_of(left[k])] - at,
                             to_end = strokes.points[strokes.ends[left[k]] - 1] - at;
            const double begin = glm::dot(to_begin, to_begin), end = glm::dot(to_end, to_end);
            if (std::min(begin, end) >= least) continue;
            least = std::min(begin, end);
            next = k;
            from_end = end < begin;
        }
        const auto first = strokes.points.begin() + static_cast<std::ptrdiff_t>(begin_of(left[next])),
                   last = strokes.points.begin() + static_cast<std::ptrdiff_t>(strokes.ends[left[next]]);
        const std::size_t so_far = sorted.points.size();
        sorted.points.insert(sorted.points.end(), first, last);
        if (from_end)
            std::reverse(sorted.points.begin() + static_cast<std::ptrdiff_t>(so_far), sorted.points.end());
        end_stroke(sorted);
        at = sorted.points.back();
        left[next] = left.back();
        left.pop_back();
    }
    return sorted;
}

}  // namespace

InkArea flattened(InkArea area) {
    for (Points& ring : area.rings) ring = flattened({.points = std::move(ring), .widths = {}}).points;
    return area;
}

std::vector<InkArea> shapes_of(const Inking& inking, const Rectangle<double>& part, double mm_per_page_unit) {
    std::vector<InkArea> shapes;
    const auto add = [&](const InkArea& area) {
        InkArea cut;
        for (const Points& ring : area.rings) {
            Points kept = cut_to(ring, part);
            for (glm::dvec2& p : kept) p = (p - part.low) * mm_per_page_unit;
            const auto alike = [](glm::dvec2 a, glm::dvec2 b) { return glm::distance(a, b) < 1e-4; };
            kept.erase(std::unique(kept.begin(), kept.end(), alike), kept.end());
            if (kept.size() > 3) cut.rings.push_back(std::move(kept));
        }
        if (!cut.rings.empty()) shapes.push_back(std::move(cut));
    };
    for (const InkArea& area : inking.areas) add(area);
    for (const InkLine& line : inking.lines) add(outline_of(line));
    return shapes;
}

Strokes strokes_of(const Inking& inking, double pen_width_mm, double mm_per_page_unit) {
    const double pen = pen_width_mm / mm_per_page_unit;
    Strokes strokes;
    for (const InkArea& area : inking.areas) add_area(strokes, flattened(area), pen);
    for (const InkLine& line : inking.lines) add_passes(strokes, flattened(line), pen);
    strokes = in_short_order(strokes);
    for (glm::dvec2& p : strokes.points) p *= mm_per_page_unit;
    return strokes;
}

namespace {

// Dots of less density stand three times as far apart as half of all dots do.
float least_density(const Grid<float>& density) {
    std::vector<float> sorted = density.values;
    std::ranges::sort(sorted);
    double all = 0, so_far = 0;
    for (const float d : sorted) all += d;
    for (const float d : sorted)
        if ((so_far += d) >= all / 2) return d / 9;
    return 0;
}

// How much of the paper dots are to cover, on a grid that is as fine as lines need it.
Grid<float> covered_paper(const Grid<float>& density, const InkCurve& ink) {
    Grid<float> covered(density.width, density.height);
    std::ranges::transform(density.values, covered.values.begin(), [&](float d) { return ink.coverage(d); });
    return covered;
}

double longer_side_of(const Grid<float>& grid) {
    return std::max(grid.width, grid.height);
}

// From the edge of a line to the centres of dots beside it, where these are light.
double gap_for(const DotsAmongLines& dots) {
    constexpr double kBare = 0.2;  // of the dots' spacing
    return dots.radius + kBare * dots.spacing;
}

// 0 where a picture's light is seen as light, 1 where as nearly black.
float darkness_of(float seen) {
    constexpr float kFrom = 0.45f, kTo = 0.2f;
    const float t = std::clamp((kFrom - seen) / (kFrom - kTo), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

}  // namespace

Inking fitted(Inking inking, const Grid<float>& seen, const DotsAmongLines& dots) {
    constexpr double kFineDot = 0.002, kMostTimes = 2.5;  // page units: lines are right for such dots
    const auto times = static_cast<float>(std::clamp(dots.radius / kFineDot, 1.0, kMostTimes));
    const double longer = longer_side_of(seen), gap = gap_for(dots);
    const Grid<float> around = blurred(seen, gap * longer);
    const auto dark_at = [&](glm::dvec2 place) {
        return darkness_of(value_at(around, glm::vec2(place * longer) - 0.5f));
    };
    // A line is lost where both of its sides are nearly black.
    const auto is_lost = [&](const InkLine& line, std::size_t i) {
        const glm::dvec2 aside = aside_at(line.points, i, line.closed()) * (line.widths[i] / 2 + gap);
        return std::min(dark_at(line.points[i] + aside), dark_at(line.points[i] - aside)) > 0.5f;
    };
    Inking result{.lines = {}, .areas = std::move(inking.areas), .white = {}};
    for (InkLine& line : inking.lines) {
        for (float& width : line.widths) width *= times;
        for (const bool lost : {false, true})
            for (InkLine& piece : pieces_of(line, [&](const InkLine&all, std::size_t i) {
                     return (line.light || is_lost(all, i)) == lost;
                 }))
                (lost ? result.white : result.lines).push_back(std::move(piece));
    }
    return result;
}

Grid<float> room_for_dots(const Inking& inking, const Density& density, const Grid<float>& seen,
                          const InkCurve& ink, const DotsAmongLines& dots) {
    const Grid<float> own = reduced(density.values()), wanted = covered_paper(own, ink);
    constexpr double kBesideBlack = 0.4;  // of a dot's radius: those that are nearly black reach into it
    constexpr double kBesideWhite = 0.6;  // of a dot's radius: they reach into a white line from both sides
    const int width = own.width, height = own.height;
    const double longer = longer_side_of(own), gap = gap_for(dots);
    const Grid<float> inked = coverage(inking.lines, inking.areas, 0, width, height);
    const Grid<float> near = coverage(inking.lines, inking.areas, gap, width, height);
    const Grid<float> at_edges =
        coverage(inking.lines, inking.areas, kBesideBlack * dots.radius, width, height);
    const Grid<float> white = coverage(inking.white, {}, kBesideWhite * dots.radius, width, height);
    const Grid<float> around = blurred(seen, gap * longer);
    const float least = least_density(own);
    // What of the ink that dots are to bring they cannot where they may not be.
    Grid<float> room(width, height), missing(width, height);
    for (std::size_t i = 0; i < own.values.size(); ++i) {
        const float kept_clear = std::max(
            std::lerp(near.values[i], at_edges.values[i], darkness_of(around.values[i])), white.values[i]);
        room.values[i] = own.values[i] < least ? 0 : 1 - kept_clear;
        missing.values[i] = (1 - room.values[i]) * wanted.values[i] - inked.values[i];
    }
    // It goes to all room nearby: of each place to all around it, in proportion to what there is.
    const double sigma = 1.5 * std::max(dots.spacing, gap) * longer;
    const Grid<float> room_around = blurred(room, sigma);
    constexpr float kLeastRoom = 0.05f;  // deep in black there is none
    for (std::size_t i = 0; i < own.values.size(); ++i)
        missing.values[i] =
            room_around.values[i] > kLeastRoom ? missing.values[i] / room_around.values[i] : 0;
    missing = blurred(std::move(missing), sigma);
    Grid<float> times(width, height);
    for (std::size_t i = 0; i < own.values.size(); ++i) {
        const float left = std::clamp(wanted.values[i] + missing.values[i], 0.0f, 1.0f);
        if (room.values[i] > 0 && own.values[i] > 0)
            times.values[i] = room.values[i] * ink.density(left) / own.values[i];
    }
    return times;
}

Grid<float> negative(Grid<float> light) {
    for (float& value : light.values)
        value = srgb_to_linear(1 - linear_to_srgb(std::clamp(value, 0.0f, 1.0f)));
    return light;
}

std::vector<InkLine> lines_shown(const std::vector<InkLine>& lines, double contours) {
    std::vector<InkLine> shown;
    const double least = 1 - contours;
    for (const InkLine& line : lines) {
        if (line.strength < least) continue;
        // They come in as hairs while the strength rises.
        const auto share = static_cast<float>(std::min(0.5 + 2 * (line.strength - least), 1.0));
        InkLine& one = shown.emplace_back(line);
        for (float& width : one.widths) width = std::max(width * share, std::min(width, kHairWidth));
    }
    return shown;
}

Inking within(Inking inking, const std::function<bool(glm::dvec2 place)>& is_drawn) {
    Inking result{.lines = {}, .areas = std::move(inking.areas), .white = {}};
    for (const InkLine& line : inking.lines)
        for (InkLine& piece :
             pieces_of(line, [&](const InkLine&all, std::size_t i) { return is_drawn(all.points[i]); }))
            result.lines.push_back(std::move(piece));
    return result;
}

Density with_room(const Density& density, const Grid<float>& room) {
    Grid<float> values = density.values();
    const float share = 1 / static_cast<float>(reduction(values));
    tbb::parallel_for(0, values.height, [&](int y) {
        for (int x = 0; x < values.width; ++x)
            values.at(x, y) *= value_at(room, (glm::vec2(x, y) + 0.5f) * share - 0.5f);
    });
    return Density(std::move(values), density.sides(), density.tile_corner(), density.reading());
}

}  // namespace dapple
