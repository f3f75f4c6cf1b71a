#include "core/lines/ink_areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "core/image/detail.h"
#include "core/lines/line_field.h"

namespace dapple {

namespace {

constexpr double kSpeck = 0.015;  // side of a square of paper that is filled

using Ring = std::vector<glm::dvec2>;

// Where the values cross 0.5, as rings that lead clockwise, as it is seen, round greater ones: marching
// squares, straight between neighbours. Nothing is greater outside, where rings run along the grid's edge. In
// pixels from the upper left corner.
std::vector<Ring> outlines(const Grid<float>& grid) {
    constexpr int kNone = -1;
    // One pixel more on each side than the grid has.
    const auto value = [&](int x, int y) {
        const bool beyond = x == 0 || y == 0 || x > grid.width || y > grid.height;
        return beyond ? 0.4999f : grid.at(x - 1, y - 1);
    };
    // Of the ways between neighbours, to the right even numbers and down odd ones: the one that is next on a
    // ring. Within four neighbours it leads from where values fall, clockwise, to where they rise; of two by
    // their mean.
    const int columns = grid.width + 2;
    std::vector<int> next(2 * static_cast<std::size_t>(columns) * (grid.height + 2), kNone);
    for (int y = 0; y <= grid.height; ++y)
        for (int x = 0; x <= grid.width; ++x) {
            const std::array<float, 4> v{value(x, y), value(x + 1, y), value(x + 1, y + 1), value(x, y + 1)};
            const int here = 2 * (y * columns + x);
            const std::array<int, 4> ways{here, here + 3, here + 2 * columns, here + 1};
            const int step = v[0] + v[1] + v[2] + v[3] >= 2 ? 1 : 3;
            for (int i = 0; i < 4; ++i) {
                if (!(v[i] >= 0.5f && v[(i + 1) % 4] < 0.5f)) continue;
                int j = (i + step) % 4;
                while (!(v[j] < 0.5f && v[(j + 1) % 4] >= 0.5f)) j = (j + step) % 4;
                next[ways[i]] = ways[j];
            }
        }
    const auto crossing = [&](int way) {
        const int x = way / 2 % columns, y = way / 2 / columns, down = way % 2;
        const float from = value(x, y), to = value(x + 1 - down, y + down),
                    part = (0.5f - from) / (to - from);
        const glm::dvec2 place(x - 0.5 + (down ? 0 : part), y - 0.5 + (down ? part : 0));
        return glm::clamp(place, glm::dvec2(0), glm::dvec2(grid.width, grid.height));
    };
    std::vector<Ring> rings;
    for (std::size_t start = 0; start < next.size(); ++start) {
        if (next[start] == kNone) continue;
        Ring& ring = rings.emplace_back();
        for (int way = static_cast<int>(start); way != kNone; way = std::exchange(next[way], kNone))
            ring.push_back(crossing(way));
    }
    return rings;
}

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
    return std::count_if(xs.begin(), xs.end(), [&](double x) { return x < point.x; }) % 2 == 1;
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
    constexpr float kSharper = 4, kSoft = 0.06f;
    if (light.empty()) return {};
    const int longer_side = std::max(light.width, light.height);
    Grid<float> picture = encoded_lightness(light);
    double pixel = double(reduction(light)) / longer_side;
    if (pixel < kFineScale / 1.5) {  // outlines are smooth, and half the pixels will do
        picture = halved(picture);
        pixel *= 2;
    }
    const double sigma = std::max<double>(kFineScale / pixel, kLeastScale);
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

    const glm::dvec2 corner = glm::dvec2(light.width, light.height) / double(longer_side);
    std::vector<InkArea> areas;
    std::vector<Ring> holes;
    for (Ring& ring : outlines(ink)) {
        for (glm::dvec2& point : ring) point = glm::min(point * pixel, corner);
        const double area = area_of(ring);
        if (area < 0 ? -area < kSpeck * kSpeck : area < least_size * least_size) continue;
        std::vector<float> none;
        simplify(ring, none);
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
    const Grid<float> covered = coverage({}, areas, margin, kSide, kSide);
    std::vector<InkLine> pieces;
    for (const InkLine& line : lines)
        for (InkLine& piece : pieces_of(line, [&](const InkLine&all, std::size_t i) {
                 return value_at(covered, glm::vec2(all.points[i] * double{kSide}) - 0.5f) < 0.5f;
             }))
            pieces.push_back(std::move(piece));
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
