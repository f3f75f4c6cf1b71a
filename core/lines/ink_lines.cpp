#include "core/lines/ink_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "core/lines/line_field.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

constexpr float kCoarser = 2.3f;                 // times the fine scale
constexpr float kSeed = 0.035f, kGoOn = 0.012f;  // salience where a line begins, and where it ends
constexpr float kGap = 7;                        // sigmas that a line may lead through nothing
constexpr float kStep = 0.7f;                    // sigmas, but a pixel at least
constexpr float kOneLine = 2.5f;                 // sigmas within which there are no two lines
constexpr float kHalfLength = 0.01f;             // of the longer side: lines of that length count half
constexpr float kBusyLength = 0.4f;              // more of it where hardly anything stands out
constexpr float kHalfSalience = 0.025f;          // salience of long lines of middling strength
constexpr float kEven = 0.38f;                   // makes half the strength what suits most pictures
constexpr float kLight = -0.45f;                 // mean phase of lines of light
constexpr float kWeakest = 0.05f;
constexpr double kTolerance = 1e-4;  // by which a line may move to have fewer points

struct TracePoint {
    glm::vec2 at;
    float contrast, salience, phase;
};

struct Trace {
    std::vector<TracePoint> points;
    bool closed = false, joins_front = false, joins_back = false;
};

// What is drawn already: at each pixel the nearest point of a line, if there is one near.
class DrawnLines {
 public:
    DrawnLines(glm::ivec2 size, float radius) : radius_(radius), near_(size.x, size.y, kNone) {}

    struct Point {
        glm::vec2 at, along;
    };

    const Point* near(int x, int y) const {
        return near_.at(x, y) == kNone ? nullptr : &points_[near_.at(x, y)];
    }

    void add(const std::vector<TracePoint>& line) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const glm::vec2 way = line[std::min(i + 1, line.size() - 1)].at - line[i > 0 ? i - 1 : 0].at;
            const float length = glm::length(way);
            add({line[i].at, length > 0 ? way / length : glm::vec2(1, 0)});
        }
    }

 private:
    static constexpr int kNone = -1;

    void add(const Point& point) {
        points_.push_back(point);
        const auto first = [&](float v) { return std::max(static_cast<int>(v - radius_), 0); };
        const auto end = [&](float v, int size) { return std::min(static_cast<int>(v + radius_) + 1, size); };
        for (int y = first(point.at.y); y < end(point.at.y, near_.height); ++y)
            for (int x = first(point.at.x); x < end(point.at.x, near_.width); ++x) {
                int& nearest = near_.at(x, y);
                const glm::vec2 pixel(x, y);
                const float before = nearest == kNone ? radius_ : glm::distance(pixel, points_[nearest].at);
                if (glm::distance(pixel, point.at) < before) nearest = static_cast<int>(points_.size()) - 1;
            }
    }

    float radius_;
    Grid<int> near_;
    std::vector<Point> points_;
};

// Traces lines on the field of one scale. All places are in its pixels.
class Tracer {
 public:
    Tracer(const LineField& field, float sigma, const DrawnLines& drawn)
        : field_(field),
          drawn_(drawn),
          step_(std::max(kStep * sigma, 1.0f)),
          gap_(static_cast<std::size_t>(std::lround(kGap * sigma / step_))),
          passed_(field.size().x, field.size().y) {}

    // Whether no line leads through the seed yet, nor was one tried.
    bool is_new(const LineField::Seed& seed) const {
        return passed_.at(seed.x, seed.y) == 0 && !drawn_.near(seed.x, seed.y);
    }

    Trace trace(const LineField::Seed& from) {
        const glm::vec2 seed(from.x, from.y), normal = field_.normal_at(seed), along(-normal.y, normal.x);
        began_ = steps_ + 1;
        Trace trace;
        const std::vector<TracePoint> after = go(seed, along, trace.closed, trace.joins_back);
        if (!trace.closed) {
            bool closed = false;
            trace.points = go(seed, -along, closed, trace.joins_front);
            std::ranges::reverse(trace.points);
        }
        trace.points.push_back(point_at(seed));
        trace.points.insert(trace.points.end(), after.begin(), after.end());
        if (trace.closed) trace.points.push_back(trace.points.front());
        return trace;
    }

 private:
    TracePoint point_at(glm::vec2 place) const {
        return {place, field_.contrast_at(place), field_.salience_at(place), field_.phase_at(place)};
    }

    // Moved across the flow towards where contrast is highest, by a parabola, and not far at once.
    glm::vec2 onto_ridge(glm::vec2 place, glm::vec2 normal) const {
        constexpr float kReach = 0.7f, kMost = 0.3f;
        const float before = field_.contrast_at(place - kReach * normal), here = field_.contrast_at(place);
        const float after = field_.contrast_at(place + kReach * normal), bend = before - 2 * here + after;
        const float shift = bend < 0 ? 0.5f * kReach * (before - after) / bend : after - before;
        return place + std::clamp(shift, -kMost, kMost) * normal;
    }

    // Along the flow, as before and not back.
    static glm::vec2 onward(glm::vec2 normal, glm::vec2 before) {
        const glm::vec2 along(-normal.y, normal.x);
        return glm::dot(along, before) < 0 ? -along : along;
    }

    // From a seed on, until it closes, meets another line or finds nothing more.
    std::vector<TracePoint> go(const glm::vec2 seed, const glm::vec2 first, bool& closed, bool& joins) {
        constexpr float kSharpest = 0.6f, kSame = 0.8f;  // cosines
        constexpr std::size_t kNearSeed = 8;
        std::vector<TracePoint> points;
        std::size_t sound = 0;  // points up to the last one that stands out
        glm::vec2 place = seed, along = first;
        while (points.size() - sound <= gap_) {
            const glm::vec2 halfway = onward(field_.normal_at(place + 0.5f * step_ * along), along);
            const glm::vec2 ahead = place + step_ * halfway, normal = field_.normal_at(ahead);
            const glm::vec2 turned = onward(normal, halfway);
            place = onto_ridge(ahead, normal);
            if (glm::dot(turned, along) < kSharpest) break;
            along = turned;
            const bool away = points.size() > kNearSeed, within = field_.inside(place);
            closed = away && glm::distance(place, seed) < step_ && glm::dot(along, first) > kSame;
            if (closed || (within && was_here(place, away))) break;
            points.push_back(point_at(place));
            const DrawnLines::Point* const other =
                within ? drawn_.near(rounded(place).x, rounded(place).y) : nullptr;
            const bool touches = other && glm::distance(other->at, place) < step_;
            if (touches) points.back().at = other->at;
            joins =
                touches || (!within && points.size() == sound + 1);  // it goes on beyond the picture's edge
            if (joins || (within && points.back().salience >= kGoOn)) sound = points.size();
            if (joins || !within || (other && std::abs(glm::dot(other->along, along)) > kSame)) break;
        }
        if (!closed) points.resize(sound);
        return points;
    }

    static glm::ivec2 rounded(glm::vec2 place) { return {std::lround(place.x), std::lround(place.y)}; }

    // Marks a place inside as passed. Whether this trace, when it is away from its seed, has passed it
    // before.
    bool was_here(glm::vec2 place, bool away) {
        constexpr int kJustNow = 8;
        const glm::ivec2 at = rounded(place);
        const int last = passed_.at(at.x, at.y);
        if (away && last >= began_ && steps_ - last > kJustNow) return true;
        ++steps_;
        for (int y = at.y - 1; y <= at.y + 1; ++y)
            for (int x = at.x - 1; x <= at.x + 1; ++x) passed_.at(x, y) = steps_;
        return false;
    }

    const LineField& field_;
    const DrawnLines& drawn_;
    float step_;
    std::size_t gap_;            // steps that may lead through nothing
    Grid<int> passed_;           // the step at which a trace was there last
    int steps_ = 0, began_ = 0;  // so far, and when this trace began
};

// Means of three, ends as they are, so many times.
template <class Value>
void smooth(std::vector<Value>& values, int times, bool closed) {
    const std::size_t n = values.size();
    if (n < 3) return;
    for (int time = 0; time < times; ++time) {
        Value before = closed ? values[n - 2] : values[0];
        for (std::size_t i = closed ? 0 : 1; i + 1 < n; ++i) {
            const Value here = values[i];
            values[i] = 0.25f * before + 0.5f * here + 0.25f * values[i + 1];
            before = here;
        }
        if (closed) values[n - 1] = values[0];
    }
}

// Salience along the line, and length, the more of that the busier it is all about; 0..1, 0.5 for long lines
// of middling salience.
float strength_of(const Trace& trace, float longer_side) {
    float salience = 0, contrast = 0, length = 0;
    for (std::size_t i = 0; i < trace.points.size(); ++i) {
        salience += trace.points[i].salience;
        contrast += trace.points[i].contrast;
        if (i > 0) length += glm::distance(trace.points[i - 1].at, trace.points[i].at);
    }
    salience /= static_cast<float>(trace.points.size());
    contrast /= static_cast<float>(trace.points.size());
    length /= longer_side;
    const float busy = 1 - std::min(salience / contrast, 1.0f);
    const float shares =
        salience / (salience + kHalfSalience) * length / (length + kHalfLength + kBusyLength * busy * busy);
    return portable::pow(shares, kEven);
}

// By the contrast of an edge, and more in the dark, where dots would drown a fine line.
float width_of(float contrast, float encoded) {
    constexpr float kFaint = 0.05f, kStrong = 0.6f, kShade = 0.3f;
    const float edge = std::clamp((contrast - kFaint) / (kStrong - kFaint), 0.0f, 1.0f);
    const float dark = kShade * (1 - encoded) * (1 - encoded);
    return kHairWidth + (kBoldWidth - kHairWidth) * std::min(edge + dark, 1.0f);
}

// From a third of the width at the end to all of it, as a round nib lifts.
float taper(float from_end) {
    constexpr float kTaper = 0.015f, kEnd = 0.3f;
    const float t = std::min(from_end / kTaper, 1.0f);
    return kEnd + (1 - kEnd) * t * (2 - t);
}

InkLine finished(const Trace& trace, float strength, const Grid<float>& picture, double units_per_pixel) {
    const std::size_t n = trace.points.size();
    std::vector<glm::vec2> places(n);
    std::vector<float> from_front(n);
    InkLine line{std::vector<glm::dvec2>(n), std::vector<float>(n), strength};
    float phase = 0;
    for (std::size_t i = 0; i < n; ++i) {
        places[i] = trace.points[i].at;
        line.widths[i] = width_of(trace.points[i].contrast, value_at(picture, places[i]));
        phase += trace.points[i].phase;
    }
    line.light = phase < kLight * static_cast<float>(n);
    if (line.light)
        for (float& width : line.widths) width /= 2;  // paper looks wider than ink
    smooth(places, 4, trace.closed);
    smooth(line.widths, 20, trace.closed);
    for (std::size_t i = 0; i < n; ++i) {
        line.points[i] = (glm::dvec2(places[i]) + 0.5) * units_per_pixel;
        if (i > 0)
            from_front[i] =
                from_front[i - 1] + static_cast<float>(glm::distance(line.points[i - 1], line.points[i]));
    }
    for (std::size_t i = 0; i < n && !trace.closed; ++i) {
        if (!trace.joins_front) line.widths[i] *= taper(from_front[i]);
        if (!trace.joins_back) line.widths[i] *= taper(from_front.back() - from_front[i]);
    }
    simplify(line.points, line.widths);
    return line;
}

}  // namespace

std::vector<InkLine> find_lines(const Grid<float>& light) {
    std::vector<InkLine> lines;
    if (light.width < 3 || light.height < 3) return lines;
    const Grid<float> picture = encoded_lightness(light);
    const auto longer_side = static_cast<float>(std::max(picture.width, picture.height));
    const double units_per_pixel = double(reduction(light)) / std::max(light.width, light.height);
    const float fine = std::max(kFineScale * longer_side, kLeastScale);

    std::vector<Trace> traces;
    // On a picture that is so many times smaller.
    const auto trace_all = [&](const Grid<float>& smaller, float sigma, float times) {
        const LineField field(smaller, sigma);
        DrawnLines drawn(field.size(), kOneLine * sigma);
        for (Trace trace : traces) {
            for (TracePoint& point : trace.points) point.at = (point.at + 0.5f) / times - 0.5f;
            drawn.add(trace.points);
        }
        Tracer tracer(field, sigma, drawn);
        for (const LineField::Seed& seed : field.seeds(kSeed)) {
            if (!tracer.is_new(seed)) continue;
            Trace trace = tracer.trace(seed);
            const float strength = trace.points.size() < 2 ? 0 : strength_of(trace, longer_side / times);
            if (strength < kWeakest) continue;
            drawn.add(trace.points);
            for (TracePoint& point : trace.points) point.at = (point.at + 0.5f) * times - 0.5f;
            lines.push_back(finished(trace, strength, picture, units_per_pixel));
            traces.push_back(std::move(trace));
        }
    };
    trace_all(picture, fine, 1);
    trace_all(halved(picture), kCoarser * fine / 2, 2);
    std::ranges::stable_sort(lines,
                             [](const InkLine& a, const InkLine& b) { return a.strength > b.strength; });
    return lines;
}

std::vector<InkLine> pieces_of(const InkLine& line, const KeepsPoint& keeps) {
    constexpr double kApart = 1.0 / 1024;
    constexpr std::size_t kFewest = 7;
    InkLine all{.points = {line.points[0]},
                .widths = {line.widths[0]},
                .strength = line.strength,
                .light = line.light};
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const glm::dvec2 from = line.points[i - 1], way = line.points[i] - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / kApart)));
        for (int k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            all.points.push_back(k < steps ? from + way * share : line.points[i]);
            all.widths.push_back(std::lerp(line.widths[i - 1], line.widths[i], static_cast<float>(share)));
        }
    }
    std::vector<InkLine> pieces;
    for (std::size_t i = 0, begin = 0; i <= all.points.size(); ++i) {
        if (i < all.points.size() && keeps(all, i)) continue;
        const auto first = static_cast<std::ptrdiff_t>(begin), end = static_cast<std::ptrdiff_t>(i);
        begin = i + 1;
        if (end - first < static_cast<std::ptrdiff_t>(kFewest)) continue;
        InkLine& piece =
            pieces.emplace_back(InkLine{.points = {all.points.begin() + first, all.points.begin() + end},
                                        .widths = {all.widths.begin() + first, all.widths.begin() + end},
                                        .strength = line.strength,
                                        .light = line.light});
        simplify(piece.points, piece.widths);
    }
    return pieces;
}

void simplify(std::vector<glm::dvec2>& points, std::vector<float>& widths) {
    // How far an edge of the line moves if there were nothing between two of its points.
    const auto moved = [&](std::size_t k, std::size_t from, std::size_t to) {
        const glm::dvec2 along = points[to] - points[from], off = points[k] - points[from];
        const double square = glm::dot(along, along);
        const double t = square > 0 ? std::clamp(glm::dot(off, along) / square, 0.0, 1.0) : 0;
        const double width = widths.empty() ? 0
                                            : static_cast<double>(widths[k] - widths[from]) -
                                                  t * static_cast<double>(widths[to] - widths[from]);
        return glm::distance(off, t * along) + std::abs(width) / 2;
    };
    std::vector<char> stays(points.size(), 0);
    stays.front() = stays.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double most = kTolerance;
        std::size_t worst = from;
        for (std::size_t k = from + 1; k < to; ++k) {
            const double missed = moved(k, from, to);
            if (missed > most) {
                most = missed;
                worst = k;
            }
        }
        if (worst == from) continue;
        stays[worst] = 1;
        open.push_back({from, worst});
        open.push_back({worst, to});
    }
    std::size_t n = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!stays[k]) continue;
        points[n] = points[k];
        if (!widths.empty()) widths[n] = widths[k];
        ++n;
    }
    points.resize(n);
    if (!widths.empty()) widths.resize(n);
}

std::vector<Cubic> smooth_curve(std::span<const glm::dvec2> points) {
    constexpr double kCorner = 0.5;  // cosine of a turn
    const std::size_t last = points.size() - 1;
    const bool closed = last > 2 && points.front() == points.back();
    // The direction at a point, into and out of which segments lead: that of the parabola through it and its
    // neighbours. At a corner and at an end, that of the segment.
    const auto direction = [&](std::size_t at, bool out) {
        const bool end = (at == 0 || at == last) && !closed;
        const glm::dvec2 before = points[at] - points[at > 0 ? at - 1 : closed ? last - 1 : 0];
        const glm::dvec2 after = points[at < last ? at + 1 : closed ? 1 : last] - points[at];
        const double a = glm::length(before), b = glm::length(after);
        if (end || glm::dot(before, after) < kCorner * a * b) return out ? after / b : before / a;
        return glm::normalize(before * (b / a) + after * (a / b));
    };
    const auto length = [&](std::size_t i) { return glm::distance(points[i], points[i + 1]); };
    // Beside a short segment a long one keeps nearly straight: its handles would bulge.
    const auto reach = [&](std::size_t i, std::size_t beside) {
        constexpr double kMostTimes = 1.5;
        return std::min(length(i), kMostTimes * length(beside)) / 3;
    };
    std::vector<Cubic> curves;
    for (std::size_t i = 0; i < last; ++i) {
        const std::size_t before = i > 0    ? i - 1
                                   : closed ? last - 1
                                            : i,
                          after = i + 1 < last ? i + 1
                                  : closed     ? 0
                                               : i;
        curves.push_back({points[i], points[i] + reach(i, before) * direction(i, true),
                          points[i + 1] - reach(i, after) * direction(i + 1, false), points[i + 1]});
    }
    return curves;
}

InkLine flattened(const InkLine& line) {
    constexpr int kParts = 6;
    InkLine flat{.points = {line.points[0]}, .widths = {}, .strength = line.strength, .light = line.light};
    if (!line.widths.empty()) flat.widths = {line.widths[0]};
    const std::vector<Cubic> curves = smooth_curve(line.points);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto& [a, b, c, d] = curves[i];
        for (int k = 1; k <= kParts; ++k) {
            const double t = static_cast<double>(k) / kParts, u = 1 - t;
            flat.points.push_back(
                k == kParts ? d : u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
            if (!line.widths.empty())
                flat.widths.push_back(std::lerp(line.widths[i], line.widths[i + 1], static_cast<float>(t)));
        }
    }
    return flat;
}

}  // namespace dapple
