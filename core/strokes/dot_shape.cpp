#include "core/strokes/dot_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/failure.h"
#include "core/maths/portable_math.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

using std::numbers::pi;

constexpr double kFlatnessMm = 0.005;     // what a curve's chord may lie beside it
constexpr double kTurnFlatnessMm = 0.01;  // within a dot, where the next turn lies over it
constexpr int kCurveLines = 24;           // of a curve of a path
constexpr std::size_t kLongestPath = 10'000;
constexpr double kSmallestArc = 1e-6, kLargestArc = 1000;  // radii, where a path's box is 1 wide

int lines_of_circle(double radius_mm, double flatness_mm = kFlatnessMm) {
    const double half = portable::acos(std::max(1 - flatness_mm / radius_mm, 0.5));
    return std::clamp(static_cast<int>(std::ceil(pi / half)), 8, 256);
}

glm::dvec2 on_circle(double radius, double turns) {
    return radius * glm::dvec2(portable::cos(2 * pi * turns), portable::sin(2 * pi * turns));
}

void add_circle(Strokes& strokes, double radius) {
    const int lines = lines_of_circle(radius);
    for (int i = 0; i <= lines; ++i)
        strokes.points.push_back(on_circle(radius, static_cast<double>(i % lines) / lines));
}

// Evenly from the middle, so that what is left of the last turn is no gap, and once around the rim.
void add_spiral(Strokes& strokes, double radius, double pen_width) {
    const int turns = static_cast<int>(std::ceil(radius / pen_width - 1e-9));
    for (int turn = 0; turn < turns; ++turn) {
        // Narrow turns need fewer lines than wide ones.
        const int lines = lines_of_circle(radius * (turn + 1) / turns, kTurnFlatnessMm);
        for (int i = 0; i < lines; ++i) {
            const double part = static_cast<double>(i) / lines;
            strokes.points.push_back(on_circle(radius * (turn + part) / turns, part));
        }
    }
    add_circle(strokes, radius);
}

void add_hatch(Strokes& strokes, double radius, double pen_width) {
    const int gaps = static_cast<int>(std::ceil(2 * radius / pen_width - 1e-9));
    for (int i = 0; i <= gaps; ++i) {
        const double y = -radius + 2 * radius * i / gaps;
        const double half = std::sqrt(std::max(radius * radius - y * y, 0.0));
        const double first = i % 2 == 0 ? -half : half;
        strokes.points.emplace_back(first, y);
        if (half > 1e-9 * radius) strokes.points.emplace_back(-first, y);
    }
    // Around the rim, where the lines' round ends leave gaps; the last one ended at a quarter of a turn.
    const int lines = lines_of_circle(radius);
    for (int i = 1; i <= lines; ++i)
        strokes.points.push_back(on_circle(radius, 0.25 + static_cast<double>(i) / lines));
}

// A path's letters and numbers.
class PathText {
 public:
    explicit PathText(std::string_view text) : rest_(text) {}

    bool at_end() {
        skip();
        return rest_.empty();
    }
    bool at_number() { return !at_end() && std::string_view("+-.0123456789").find(rest_[0]) != rest_.npos; }
    char letter() {
        skip();
        const char c = rest_[0];
        rest_.remove_prefix(1);
        return c;
    }
    double number(char command) {
        skip();
        const std::size_t end = std::min(rest_.find_first_not_of("+-.0123456789eE"), rest_.size());
        const std::optional<double> value = number_of<double>(rest_.substr(0, end));
        if (!value || !std::isfinite(*value))
            throw failure("after {} there has to be a number in place of '{}'", command,
                          rest_.empty() ? "the end" : rest_.substr(0, std::max<std::size_t>(end, 1)));
        rest_.remove_prefix(end);
        return *value;
    }
    glm::dvec2 point(char command) {
        const double x = number(command);
        return {x, number(command)};
    }

 private:
    void skip() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n\r,"), rest_.size())); }

    std::string_view rest_;
};

// An arc as its end points tell it, by the formulas of SVG 1.1, appendix F.6.
struct Arc {
    glm::dvec2 radii;
    double turned, from, way;  // radians
    glm::dvec2 middle;

    glm::dvec2 at(double share) const {
        const double angle = from + way * share;
        const glm::dvec2 p(radii.x * portable::cos(angle), radii.y * portable::sin(angle));
        return middle + glm::dvec2(p.x * portable::cos(turned) - p.y * portable::sin(turned),
                                   p.x * portable::sin(turned) + p.y * portable::cos(turned));
    }
};

Arc arc_between(glm::dvec2 a, glm::dvec2 b, glm::dvec2 radii, double turned, bool large, bool clockwise) {
    const glm::dvec2 half = (a - b) / 2.0;
    const glm::dvec2 p(portable::cos(turned) * half.x + portable::sin(turned) * half.y,
                       -portable::sin(turned) * half.x + portable::cos(turned) * half.y);
    const double needed = p.x * p.x / (radii.x * radii.x) + p.y * p.y / (radii.y * radii.y);
    if (needed > 1) radii *= std::sqrt(needed);
    const double rx = radii.x * radii.x, ry = radii.y * radii.y;
    const double below = rx * p.y * p.y + ry * p.x * p.x;
    const double factor = std::sqrt(std::max((rx * ry - below) / below, 0.0)) * (large == clockwise ? -1 : 1);
    const glm::dvec2 c(factor * radii.x * p.y / radii.y, -factor * radii.y * p.x / radii.x);
    const glm::dvec2 middle = glm::dvec2(portable::cos(turned) * c.x - portable::sin(turned) * c.y,
                                         portable::sin(turned) * c.x + portable::cos(turned) * c.y) +
                              (a + b) / 2.0;
    const auto angle = [&](glm::dvec2 q) {
        return portable::atan2((q.y - c.y) / radii.y, (q.x - c.x) / radii.x);
    };
    const double from = angle(p);
    double way = angle(-p) - from;
    if (clockwise && way < 0) way += 2 * pi;
    if (!clockwise && way > 0) way -= 2 * pi;
    return {radii, turned, from, way, middle};
}

class PathReader {
 public:
    explicit PathReader(std::string_view text) : text_(text) {}

    Strokes read() {
        while (!text_.at_end()) {
            char command = text_.letter();
            if (std::string_view("MLHVCQAZ").find(command) == std::string_view::npos) {
                throw failure("'{}' is not known; there are M, L, H, V, C, Q, A and Z, in capitals", command);
            }
            if (!began_ && command != 'M') throw failure("begins with {}; a path begins with M", command);
            do {
                take(command);
                if (command == 'M') command = 'L';  // what follows are lines
            } while (command != 'Z' && text_.at_number());
        }
        end_stroke(strokes_);
        if (strokes_.ends.empty()) throw std::runtime_error("is empty");
        for (const glm::dvec2 p : strokes_.points) {
            if (!inside_box(p)) {
                throw failure("reaches to {:.4g},{:.4g}; its box is from 0,0 to 1,1", p.x, p.y);
            }
        }
        return std::move(strokes_);
    }

 private:
    // Nor is what is not a number.
    static bool inside_box(glm::dvec2 p) {
        constexpr double kRounding = 1e-6;
        return glm::all(glm::greaterThanEqual(p, glm::dvec2(-kRounding))) &&
               glm::all(glm::lessThanEqual(p, glm::dvec2(1 + kRounding)));
    }

    void line_to(glm::dvec2 p) {
        if (closed_) strokes_.points.push_back(at_);
        closed_ = false;
        strokes_.points.push_back(at_ = p);
    }
    template <class At>
    void curve(glm::dvec2 end, const At& at) {
        const glm::dvec2 start = at_;
        for (int i = 1; i < kCurveLines; ++i) line_to(at(start, static_cast<double>(i) / kCurveLines));
        line_to(end);
    }

    void take(char command) {
        switch (command) {
            case 'M':
                end_stroke(strokes_);
                closed_ = false;
                began_ = true;
                begin_ = at_ = text_.point(command);
                strokes_.points.push_back(at_);
                return;
            case 'L':
                return line_to(text_.point(command));
            case 'H':
                return line_to({text_.number(command), at_.y});
            case 'V':
                return line_to({at_.x, text_.number(command)});
            case 'Q': {
                const glm::dvec2 b = text_.point(command), c = text_.point(command);
                return curve(c, [=](glm::dvec2 a, double t) {
                    return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
                });
            }
            case 'C': {
                const glm::dvec2 b = text_.point(command), c = text_.point(command), d = text_.point(command);
                return curve(d, [=](glm::dvec2 a, double t) {
                    const double s = 1 - t;
                    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
                });
            }
            case 'A':
                return take_arc();
            default:  // Z
                if (!closed_) line_to(begin_);
                end_stroke(strokes_);
                closed_ = true;
        }
    }

    bool flag() {
        const double value = text_.number('A');
        if (value != 0 && value != 1) throw failure("A: {:g} is given for a flag, which is 0 or 1", value);
        return value == 1;
    }

    void take_arc() {
        const glm::dvec2 radii = text_.point('A');
        const double turned = text_.number('A') * pi / 180;
        const bool large = flag(), clockwise = flag();
        const glm::dvec2 end = text_.point('A');
        if (std::min(radii.x, radii.y) < kSmallestArc || std::max(radii.x, radii.y) > kLargestArc)
            throw failure("A: the two radii have to be from {:g} to {:g}", kSmallestArc, kLargestArc);
        if (glm::distance(at_, end) < kSmallestArc) return line_to(end);
        const Arc arc = arc_between(at_, end, radii, turned, large, clockwise);
        curve(end, [&](glm::dvec2, double t) { return arc.at(t); });
    }

    PathText text_;
    Strokes strokes_;
    glm::dvec2 at_{0}, begin_{0};
    bool began_ = false, closed_ = false;
};

// From the unit box to one of that half side about 0,0.
Strokes path_of_half_side(Strokes path, double half_side) {
    for (glm::dvec2& p : path.points) p = (2.0 * p - 1.0) * half_side;
    return path;
}

// A path is read once for all dots.
Strokes mark_with(const DotMark& mark, const Strokes& path, double radius_mm, double pen_width_mm) {
    const double reach = radius_mm - pen_width_mm / 2;
    Strokes strokes;
    if (mark.shape == DotShape::point || reach < 0.02 * pen_width_mm || reach < 1e-4) {
        strokes.points.emplace_back(0, 0);
        end_stroke(strokes);
        return strokes;
    }
    const double slant = reach * std::numbers::sqrt2 / 2;
    switch (mark.shape) {
        case DotShape::circle:
        case DotShape::point:
            break;
        case DotShape::stroke:
            strokes.points = {{-slant, slant}, {slant, -slant}};
            break;
        case DotShape::spiral:
            add_spiral(strokes, reach, pen_width_mm);
            break;
        case DotShape::hatch:
            add_hatch(strokes, reach, pen_width_mm);
            break;
        case DotShape::ring:
            add_circle(strokes, reach);
            break;
        case DotShape::cross:
            strokes.points = {{-reach, 0}, {reach, 0}};
            end_stroke(strokes);
            strokes.points.insert(strokes.points.end(), {{0, -reach}, {0, reach}});
            break;
        case DotShape::path:
            return path_of_half_side(path, reach);
    }
    end_stroke(strokes);
    return strokes;
}

}  // namespace

DotMark parse_dot_mark(std::string_view text) {
    const std::optional<DotShape> shape = value_named<DotShape>(text);
    if (shape && *shape != DotShape::path) return {*shape, {}};
    if (!text.starts_with('M')) {
        throw failure(
            "'{}' is not known; there are circle, point, stroke, spiral, hatch, ring, cross, or a "
            "path in a box from 0,0 to 1,1, as in 'M0,0 L1,1'",
            text);
    }
    static_cast<void>(parse_dot_path(text));
    return {DotShape::path, std::string(text)};
}

bool is_disc(DotShape shape) {
    return shape == DotShape::circle || shape == DotShape::point || shape == DotShape::spiral ||
           shape == DotShape::hatch;
}

std::string text_of(const DotMark& mark) {
    return mark.shape == DotShape::path ? mark.path : std::string(name_of(mark.shape));
}

Strokes parse_dot_path(std::string_view d) {
    try {
        if (d.size() > kLongestPath) throw failure("is longer than {} letters", kLongestPath);
        return PathReader(d).read();
    } catch (const std::runtime_error& error) {
        throw failure("the path '{}'{}: {}", d.substr(0, 60), d.size() > 60 ? "..." : "", error.what());
    }
}

Strokes mark_of(const DotMark& mark, double radius_mm, double pen_width_mm) {
    const Strokes path = mark.shape == DotShape::path ? parse_dot_path(mark.path) : Strokes{};
    return mark_with(mark, path, radius_mm, pen_width_mm);
}

StrokeStream marks_of(const DotStream& dots, const PageSize& page, const DotMark& mark, double radius_mm,
                      double pen_width_mm, const std::vector<double>& pen_widths_mm) {
    const Strokes path = mark.shape == DotShape::path ? parse_dot_path(mark.path) : Strokes{};
    StrokeStream stream{.width_mm = pen_width_mm, .widths_mm = pen_widths_mm};
    // By pen; the first of one pen.
    auto usual = std::make_shared<std::vector<Strokes>>();
    for (std::size_t pen = 0; pen < std::max<std::size_t>(pen_widths_mm.size(), 1); ++pen)
        usual->push_back(mark_with(mark, path, radius_mm, stream.width_of(static_cast<int>(pen))));
    stream.points = dots.count * usual->front().points.size();
    const double unit = page.mm_per_page_unit;
    stream.for_each_stroke = [=, widths = stream](const TakeStroke& take) {
        std::vector<glm::dvec2> moved;
        dots.for_each_piece([&](const Dots& piece) {
            const auto pen = static_cast<std::size_t>(piece.pen);
            const Strokes& as_usual = pen < usual->size() ? (*usual)[pen] : usual->front();
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const glm::dvec2 centre = glm::dvec2(piece.x[i], piece.y[i]) * unit;
                std::optional<Strokes> own;
                if (!piece.radius.empty())
                    own = mark_with(mark, path, piece.radius[i] * unit, widths.width_of(piece.pen));
                const Strokes& strokes = own ? *own : as_usual;
                std::size_t begin = 0;
                for (const std::size_t end : strokes.ends) {
                    moved.clear();
                    for (; begin < end; ++begin) moved.push_back(strokes.points[begin] + centre);
                    take(moved, piece.pen);
                }
            }
            return true;
        });
    };
    return stream;
}

}  // namespace dapple
