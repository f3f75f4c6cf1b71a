#include "core/lines/ink_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iterator>

#include "core/lines/curve.h"
#include "core/lines/line_field.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

constexpr float kCoarser = 2.3f;                 // times the fine scale
constexpr float kLeastScale = 0.8f;              // pixels
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

// What is drawn already: at each pixel the point of a line that is near, if there is one.
class DrawnLines {
 public:
    DrawnLines(int width, int height) : near_(width, height, kNone) {}

    struct Point {
        glm::vec2 at, along;
    };

    const Point* near(glm::vec2 place) const {
        const int x = static_cast<int>(std::lround(place.x)), y = static_cast<int>(std::lround(place.y));
        if (x < 0 || y < 0 || x >= near_.width || y >= near_.height) return nullptr;
        const std::int32_t point = near_.at(x, y);
        return point == kNone ? nullptr : &points_[static_cast<std::size_t>(point)];
    }

    void add(const Point& point, float radius) {
        const auto index = static_cast<std::int32_t>(points_.size());
        points_.push_back(point);
        const auto first = [](float v) { return std::max(static_cast<int>(std::ceil(v)), 0); };
        const auto last = [](float v, int size) {
            return std::min(static_cast<int>(std::floor(v)), size - 1);
        };
        for (int y = first(point.at.y - radius); y <= last(point.at.y + radius, near_.height); ++y)
            for (int x = first(point.at.x - radius); x <= last(point.at.x + radius, near_.width); ++x) {
                const glm::vec2 pixel(x, y);
                const float distance = glm::distance(pixel, point.at);
                std::int32_t& here = near_.at(x, y);
                if (distance > radius) continue;
                if (here == kNone ||
                    distance < glm::distance(pixel, points_[static_cast<std::size_t>(here)].at))
                    here = index;
            }
    }

 private:
    static constexpr std::int32_t kNone = -1;
    Grid<std::int32_t> near_;
    std::vector<Point> points_;
};

// Traces lines on the field of one scale. All places are in its pixels.
class Tracer {
 public:
    Tracer(const LineField& field, float sigma, const DrawnLines& drawn)
        : field_(field),
          step_(std::max(kStep * sigma, 1.0f)),
          gap_(static_cast<std::size_t>(std::lround(kGap * sigma / step_))),
          drawn_(drawn),
          passed_(field.size().x, field.size().y) {}

    // Whether no line leads through the seed yet, nor was one tried.
    bool is_new(const LineField::Seed& seed) const {
        return passed_.at(seed.x, seed.y) == 0 && !drawn_.near({seed.x, seed.y});
    }

    Trace trace(const LineField::Seed& from) {
        const glm::vec2 seed(from.x, from.y);
        began_ = steps_ + 1;
        const glm::vec2 normal = field_.normal_at(seed), along(-normal.y, normal.x);
        Trace result;
        std::vector<TracePoint> onward = go(seed, along, result.closed, result.joins_back);
        if (!result.closed) {
            bool closed = false;
            std::vector<TracePoint> back = go(seed, -along, closed, result.joins_front);
            result.points.assign(back.rbegin(), back.rend());
        }
        result.points.push_back(point_at(seed));
        result.points.insert(result.points.end(), onward.begin(), onward.end());
        if (result.closed) result.points.push_back(result.points.front());
        return result;
    }

 private:
    TracePoint point_at(glm::vec2 place) const {
        return {place, field_.contrast_at(place), field_.salience_at(place), field_.phase_at(place)};
    }

    // Moved across the flow towards where contrast is highest, by a parabola, and not far at once.
    glm::vec2 onto_ridge(glm::vec2 place) const {
        constexpr float kReach = 0.7f, kMost = 0.3f;
        const glm::vec2 normal = field_.normal_at(place);
        const float before = field_.contrast_at(place - kReach * normal), here = field_.contrast_at(place),
                    after = field_.contrast_at(place + kReach * normal);
        const float bend = before - 2 * here + after;
        const float shift = bend < 0         ? 0.5f * kReach * (before - after) / bend
                            : after > before ? kMost
                                             : -kMost;
        return place + std::clamp(shift, -kMost, kMost) * normal;
    }

    glm::vec2 direction_at(glm::vec2 place, glm::vec2 before) const {
        const glm::vec2 normal = field_.normal_at(place), along(-normal.y, normal.x);
        return glm::dot(along, before) < 0 ? -along : along;
    }

    std::vector<TracePoint> go(glm::vec2 seed, glm::vec2 along, bool& closed, bool& joins) {
        constexpr float kSharpest = 0.6f, kSame = 0.8f, kTouch = 0.8f;
        constexpr std::size_t kNearSeed = 8;
        std::vector<TracePoint> points;
        std::size_t sound = 0;  // points up to the last one that stands out
        glm::vec2 place = seed;
        const glm::vec2 first = along;
        while (points.size() - sound <= gap_) {
            const glm::vec2 halfway = direction_at(place + 0.5f * step_ * along, along);
            place = onto_ridge(place + step_ * halfway);
            const glm::vec2 turned = direction_at(place, halfway);
            if (glm::dot(turned, along) < kSharpest) break;
            along = turned;
            if (!field_.inside(place)) {
                joins = points.size() == sound;  // it goes on, beyond the picture
                if (joins) points.push_back(point_at(place));
                if (joins) ++sound;
                break;
            }
            const bool away = points.size() > kNearSeed;
            if (away && glm::distance(place, seed) < step_ && glm::dot(along, first) > kSame) {
                closed = true;
                return points;
            }
            if (was_here(place, away)) break;
            points.push_back(point_at(place));
            if (points.back().salience >= kGoOn) sound = points.size();
            const DrawnLines::Point* const other = drawn_.near(place);
            if (!other) continue;
            if (glm::distance(other->at, place) < kTouch * step_) {
                points.back().at = other->at;
                sound = points.size();
                joins = true;
                break;
            }
            if (std::abs(glm::dot(other->along, along)) > kSame) break;
        }
        points.resize(sound);
        return points;
    }

    // Marks a place as passed. Whether this trace, when it is away from its seed, has passed it before.
    bool was_here(glm::vec2 place, bool away) {
        constexpr std::int32_t kJustNow = 8;
        const int x = static_cast<int>(std::lround(place.x)), y = static_cast<int>(std::lround(place.y));
        const std::int32_t last = passed_.at(x, y);
        if (away && last >= began_ && steps_ - last > kJustNow) return true;
        ++steps_;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                if (i >= 0 && j >= 0 && i < passed_.width && j < passed_.height) passed_.at(i, j) = steps_;
        return false;
    }

    const LineField& field_;
    float step_;
    std::size_t gap_;  // steps that may lead through nothing
    const DrawnLines& drawn_;
    Grid<std::int32_t> passed_;           // the step at which a trace was there last
    std::int32_t steps_ = 0, began_ = 0;  // so far, and when this trace began
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

InkLine finished(const Trace& trace, float strength, const Grid<float>& picture, glm::dvec2 units_per_pixel) {
    std::vector<glm::vec2> places;
    std::vector<float> widths;
    for (const TracePoint& point : trace.points) {
        places.push_back(point.at);
        widths.push_back(width_of(point.contrast, value_at(picture, point.at)));
    }
    smooth(places, 4, trace.closed);
    smooth(widths, 20, trace.closed);
    float phase = 0;
    for (const TracePoint& point : trace.points) phase += point.phase;
    InkLine line{{}, {}, strength, phase < kLight * static_cast<float>(trace.points.size())};
    for (const glm::vec2 place : places) line.points.push_back((glm::dvec2(place) + 0.5) * units_per_pixel);
    std::vector<float> from_front(places.size());
    for (std::size_t i = 1; i < places.size(); ++i)
        from_front[i] =
            from_front[i - 1] + static_cast<float>(glm::distance(line.points[i - 1], line.points[i]));
    for (std::size_t i = 0; i < places.size(); ++i) {
        float width = widths[i];
        if (!trace.closed && !trace.joins_front) width *= taper(from_front[i]);
        if (!trace.closed && !trace.joins_back) width *= taper(from_front.back() - from_front[i]);
        line.widths.push_back(width);
    }
    simplify(line.points, line.widths, kTolerance);
    return line;
}

void draw(const Trace& trace, float radius, DrawnLines& drawn) {
    const std::vector<TracePoint>& points = trace.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 before = points[i > 0 ? i - 1 : 0].at;
        const glm::vec2 after = points[std::min(i + 1, points.size() - 1)].at;
        const float length = glm::distance(before, after);
        drawn.add({points[i].at, length > 0 ? (after - before) / length : glm::vec2(1, 0)}, radius);
    }
}

}  // namespace

std::vector<InkLine> find_lines(const Grid<float>& light) {
    std::vector<InkLine> lines;
    if (light.width < 3 || light.height < 3) return lines;
    const Grid<float> picture = encoded_lightness(light, kLongestSide);
    const auto longer_side = static_cast<float>(std::max(picture.width, picture.height));
    const glm::dvec2 units_per_pixel =
        glm::dvec2(double(light.width) / picture.width, double(light.height) / picture.height) /
        double(std::max(light.width, light.height));
    const float fine = std::max(static_cast<float>(kFineScale) * longer_side, kLeastScale);

    std::vector<Trace> traces;
    // On a picture that is so many times smaller.
    const auto trace_all = [&](const Grid<float>& smaller, float sigma, float times) {
        DrawnLines drawn(smaller.width, smaller.height);
        for (Trace trace : traces) {
            for (TracePoint& point : trace.points) point.at = (point.at + 0.5f) / times - 0.5f;
            draw(trace, kOneLine * sigma, drawn);
        }
        const LineField field(smaller, sigma);
        Tracer tracer(field, sigma, drawn);
        for (const LineField::Seed& seed : field.seeds(kSeed)) {
            if (!tracer.is_new(seed)) continue;
            Trace trace = tracer.trace(seed);
            const float strength = trace.points.size() < 2 ? 0 : strength_of(trace, longer_side / times);
            if (strength < kWeakest) continue;
            draw(trace, kOneLine * sigma, drawn);
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

}  // namespace dapple
