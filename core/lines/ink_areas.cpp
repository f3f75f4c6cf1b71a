#include "core/lines/ink_areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

#include "core/image/blur.h"
#include "core/lines/curve.h"
#include "core/lines/line_field.h"

namespace dapple {

namespace {

constexpr double kSpeck = 0.015;  // side of a square of paper that is filled
constexpr double kRingTolerance = 1e-4;

using Ring = std::vector<glm::dvec2>;

// Where the values cross a level, as closed rings with the greater ones on the right of their way as it is
// seen: marching squares, straight between neighbours. Nothing is above the level outside, where rings run
// along the grid's edge. In pixels from the upper left corner.
class LevelRings {
 public:
    LevelRings(const Grid<float>& grid, float level)
        : grid_(grid),
          level_(level),
          columns_(grid.width + 2),
          next_(2 * columns_ * (grid.height + 2), kNone) {
        for (int y = 0; y <= grid.height; ++y)
            for (int x = 0; x <= grid.width; ++x) join_in_cell(x, y);
    }

    std::vector<Ring> rings() {
        std::vector<Ring> all;
        for (std::int32_t start = 0; start < static_cast<std::int32_t>(next_.size()); ++start) {
            if (next_[start] == kNone) continue;
            Ring& ring = all.emplace_back();
            for (std::int32_t at = start; at != kNone;) {
                ring.push_back(crossing(at));
                const std::int32_t to = next_[at];
                next_[at] = kNone;
                at = to;
            }
        }
        return all;
    }

 private:
    static constexpr std::int32_t kNone = -1;

    // One pixel more on each side than the grid has.
    float value(int x, int y) const {
        const bool outside = x == 0 || y == 0 || x > grid_.width || y > grid_.height;
        return outside ? level_ - 1e-4f : grid_.at(x - 1, y - 1);
    }

    // Of four neighbours, clockwise. A way leads from the edge on which the values fall to one on which they
    // rise; which of two goes by their mean.
    void join_in_cell(int x, int y) {
        const std::array<float, 4> v{value(x, y), value(x + 1, y), value(x + 1, y + 1), value(x, y + 1)};
        const int here = 2 * (y * columns_ + x);
        const std::array<int, 4> edges{here, here + 3, here + 2 * columns_, here + 1};
        const bool inside = (v[0] + v[1] + v[2] + v[3]) / 4 >= level_;
        for (int i = 0; i < 4; ++i) {
            if (!(v[i] >= level_ && v[(i + 1) % 4] < level_)) continue;
            int j = i;
            do j = (j + (inside ? 1 : 3)) % 4;
            while (!(v[j] < level_ && v[(j + 1) % 4] >= level_));
            next_[edges[i]] = edges[j];
        }
    }

    // Edges to the right have even numbers, those down odd ones.
    glm::dvec2 crossing(std::int32_t edge) const {
        const int x = edge / 2 % columns_, y = edge / 2 / columns_, down = edge % 2;
        const double from = value(x, y), to = value(x + 1 - down, y + down);
        const double part = (level_ - from) / (to - from);
        const glm::dvec2 place(x - 0.5 + (down ? 0 : part), y - 0.5 + (down ? part : 0));
        return glm::clamp(place, glm::dvec2(0), glm::dvec2(grid_.width, grid_.height));
    }

    const Grid<float>& grid_;
    float level_;
    int columns_;
    std::vector<std::int32_t> next_;
};

// Below 0 for holes.
double area_of(const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        twice += ring[i - 1].x * ring[i].y - ring[i].x * ring[i - 1].y;
    return twice / 2;
}

// From where a line at that height crosses the rings to where it crosses them next, and so on, in order.
std::vector<double> crossings(std::span<const Ring> rings, double y) {
    std::vector<double> xs;
    for (const Ring& ring : rings)
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const glm::dvec2 a = ring[i - 1], b = ring[i];
            if ((a.y <= y) != (b.y <= y)) xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
    std::ranges::sort(xs);
    return xs;
}

bool contains(const Ring& ring, glm::dvec2 point) {
    const std::vector<double> xs = crossings(std::span(&ring, 1), point.y);
    return std::ranges::count_if(xs, [&](double x) { return x < point.x; }) % 2 == 1;
}

// A segment whose width goes from one to another, with round ends, in pixels.
void cover_segment(Grid<float>& grid, glm::dvec2 a, glm::dvec2 b, double radius_a, double radius_b) {
    const double reach = std::max(radius_a, radius_b) + 1;
    const glm::dvec2 low = glm::min(a, b) - reach, high = glm::max(a, b) + reach, along = b - a;
    const double square = glm::dot(along, along);
    const int left = static_cast<int>(std::clamp(low.x, 0.0, double(grid.width)));
    const int right = static_cast<int>(std::clamp(high.x, -1.0, grid.width - 1.0));
    const int bottom = static_cast<int>(std::clamp(high.y, -1.0, grid.height - 1.0));
    for (int y = static_cast<int>(std::clamp(low.y, 0.0, double(grid.height))); y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const glm::dvec2 pixel(x + 0.5, y + 0.5);
            const double t = square > 0 ? std::clamp(glm::dot(pixel - a, along) / square, 0.0, 1.0) : 0;
            const double radius = radius_a + (radius_b - radius_a) * t;
            // Lines narrower than a pixel cover as much of it as they are wide.
            const double from_middle = glm::distance(pixel, a + t * along);
            const double covered = std::min(from_middle + 0.5, radius) - std::max(from_middle - 0.5, -radius);
            grid.at(x, y) = std::max(grid.at(x, y), static_cast<float>(std::clamp(covered, 0.0, 1.0)));
        }
}

// Rows of a pixel are taken at so many heights, each exactly along the row.
void cover_area(Grid<float>& grid, const std::vector<Ring>& rings) {
    constexpr int kRows = 5;
    double top = grid.height, bottom = 0;
    for (const glm::dvec2 point : rings.front()) {
        top = std::min(top, point.y);
        bottom = std::max(bottom, point.y);
    }
    const int last = std::min(static_cast<int>(bottom), grid.height - 1);
    std::vector<float> row(static_cast<std::size_t>(grid.width));
    for (int y = std::max(static_cast<int>(top), 0); y <= last; ++y) {
        std::ranges::fill(row, 0.0f);
        for (int i = 0; i < kRows; ++i) {
            const std::vector<double> xs = crossings(rings, y + (i + 0.5) / kRows);
            for (std::size_t k = 1; k < xs.size(); k += 2) {
                const double from = std::max(xs[k - 1], 0.0), to = std::min(xs[k], double(grid.width));
                for (int x = static_cast<int>(from); x < to; ++x)
                    row[static_cast<std::size_t>(x)] +=
                        static_cast<float>((std::min(to, x + 1.0) - std::max(from, double(x))) / kRows);
            }
        }
        for (int x = 0; x < grid.width; ++x)
            grid.at(x, y) = std::max(grid.at(x, y), std::min(row[static_cast<std::size_t>(x)], 1.0f));
    }
}

}  // namespace

std::vector<InkArea> find_blacks(const Grid<float>& light, double darkness, double least_size) {
    constexpr double kBlur = 1.7, kWider = 5, kOpening = 1.3, kNear = 2;  // in sigmas of fine lines
    constexpr float kSharper = 2, kSoft = 0.06f;
    if (light.empty()) return {};
    const Grid<float> picture = encoded_lightness(light);
    const double longer_side = std::max(picture.width, picture.height);
    const double sigma = std::max<double>(kFineScale * longer_side, kLeastScale);
    const Grid<float> smooth = blurred(picture, kBlur * sigma), wide = blurred(picture, kWider * sigma);
    const auto dark = static_cast<float>(1 - darkness);
    const auto ink_of = [&](float encoded) {
        return std::clamp(0.5f + (dark - encoded) / kSoft, 0.0f, 1.0f);
    };
    // Lines of light stand out of what is dark. Beside what is dark up to an edge, the edge itself is the
    // outline, to which sharpening leads, not where the blurred values happen to reach the threshold.
    Grid<float> ink(picture.width, picture.height), sharp = ink;
    for (std::size_t i = 0; i < ink.values.size(); ++i) {
        const float detail = kSharper * (smooth.values[i] - wide.values[i]);
        ink.values[i] = ink_of(smooth.values[i] + std::max(detail, 0.0f));
        sharp.values[i] = ink_of(smooth.values[i] + detail);
    }
    const Grid<float> near = blurred(ink, kNear * sigma);
    for (std::size_t i = 0; i < ink.values.size(); ++i)
        ink.values[i] = std::max(ink.values[i], std::min(sharp.values[i], 8 * near.values[i]));
    // What is narrower than the Gaussian reaches goes, be it ink or paper.
    ink = blurred(std::move(ink), kOpening * sigma);

    const glm::dvec2 units =
        glm::dvec2(double(light.width) / picture.width, double(light.height) / picture.height) /
        double(std::max(light.width, light.height));
    std::vector<InkArea> areas;
    std::vector<Ring> holes;
    for (Ring& ring : LevelRings(ink, 0.5f).rings()) {
        for (glm::dvec2& point : ring) point *= units;
        ring.push_back(ring.front());
        const double area = area_of(ring);
        if (area < 0 ? -area < kSpeck * kSpeck : area < least_size * least_size) continue;
        std::vector<float> none;
        simplify(ring, none, kRingTolerance);
        if (ring.size() < 4) continue;
        if (area < 0)
            holes.push_back(std::move(ring));
        else
            areas.push_back({{std::move(ring)}});
    }
    // Smaller ones first: a hole belongs to the smallest area around it.
    std::ranges::stable_sort(areas, [](const InkArea& a, const InkArea& b) {
        return area_of(a.rings.front()) < area_of(b.rings.front());
    });
    for (Ring& hole : holes)
        for (InkArea& area : areas)
            if (area_of(area.rings.front()) > -area_of(hole) && contains(area.rings.front(), hole.front())) {
                area.rings.push_back(std::move(hole));
                break;
            }
    return areas;
}

std::vector<InkLine> outside(const std::vector<InkLine>& lines, const std::vector<InkArea>& areas,
                             double margin) {
    constexpr int kSide = 1024;
    constexpr double kStep = 1.0 / kSide, kShortest = 0.006;
    const Grid<float> covered = coverage({}, areas, margin, kSide, kSide);
    const auto is_outside = [&](glm::dvec2 point) {
        const int x = static_cast<int>(point.x * kSide), y = static_cast<int>(point.y * kSide);
        return x >= covered.width || y >= covered.height || covered.at(x, y) < 0.5f;
    };
    std::vector<InkLine> pieces;
    for (const InkLine& line : lines) {
        InkLine piece{{}, {}, line.strength, line.light};
        const auto end_piece = [&] {
            if (piece.points.size() > 1 && (static_cast<double>(piece.points.size()) > kShortest / kStep)) {
                simplify(piece.points, piece.widths, kRingTolerance / 10);
                pieces.push_back(piece);
            }
            piece.points.clear();
            piece.widths.clear();
        };
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const std::size_t before = i > 0 ? i - 1 : 0;
            const double length = glm::distance(line.points[before], line.points[i]);
            const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep)));
            for (int k = 1; k <= steps; ++k) {
                const double t = double(k) / steps;
                const glm::dvec2 point = line.points[before] + (line.points[i] - line.points[before]) * t;
                if (!is_outside(point)) {
                    end_piece();
                    continue;
                }
                piece.points.push_back(k == steps ? line.points[i] : point);
                piece.widths.push_back(line.widths[before] +
                                       (line.widths[i] - line.widths[before]) * static_cast<float>(t));
            }
        }
        end_piece();
    }
    return pieces;
}

Grid<float> coverage(const std::vector<InkLine>& lines, const std::vector<InkArea>& areas, double gap,
                     int width, int height) {
    Grid<float> grid(width, height);
    const double pixels = std::max(width, height);
    for (const InkLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            cover_segment(grid, line.points[i - 1] * pixels, line.points[i] * pixels,
                          (static_cast<double>(line.widths[i - 1]) / 2 + gap) * pixels,
                          (static_cast<double>(line.widths[i]) / 2 + gap) * pixels);
    for (const InkArea& area : areas) {
        std::vector<Ring> rings = area.rings;
        for (Ring& ring : rings)
            for (glm::dvec2& point : ring) point *= pixels;
        cover_area(grid, rings);
        if (!(gap > 0)) continue;
        for (const Ring& ring : rings)
            for (std::size_t i = 1; i < ring.size(); ++i)
                cover_segment(grid, ring[i - 1], ring[i], gap * pixels, gap * pixels);
    }
    return grid;
}

}  // namespace dapple
