#include "lab/related/penrose.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lab/related/penrose_tiling.h"
#include "lab/related/plain_voronoi.h"

namespace dapple {
namespace {

constexpr double kRootSide = 40;    // page units
constexpr int kMostDivisions = 60;  // divisions: finer than a double can tell apart
constexpr int kAges = 4;            // how many divisions ago a vertex came; longer ago is as long ago as that
constexpr int kPhases = 64;         // densities from one level to the next

struct RankedVertex {
    double critical = 0;  // dots for each unit of area, where the density is 1, from which on it is there
    double density = 1;
    double side = 0;  // of the rhombs that it came with
    PenroseVertex vertex;
};

// A large triangle that holds the page, at no special place of it.
PenroseTriangle root() {
    const double turn = 0.4;
    const auto to = [&](double angle) { return kRootSide * glm::dvec2(std::cos(angle), std::sin(angle)); };
    const glm::dvec2 apex = glm::dvec2(0.43, 0.57) - 0.6 * to(turn + 0.3);
    return {.kind = PenroseKind::acute,
            .apex = apex,
            .left = apex + to(turn),
            .right = apex + to(turn + std::numbers::pi / 5)};
}

// All vertices within the page that are there with `full` dots for each unit of area and density.
class PenrosePlacer {
 public:
    PenrosePlacer(const DotsWanted& wanted, double full)
        : wanted_(wanted), page_(page_of(wanted)), full_(full) {
        place(root(), kRootSide, 0);
    }

    std::vector<RankedVertex> vertices;

 private:
    double density_at(glm::dvec2 p) const { return wanted_.density ? double(wanted_.density->at(p)) : 1; }

    bool on_page(glm::dvec2 p) const { return p.x >= 0 && p.y >= 0 && p.x < page_.x && p.y < page_.y; }

    void place(const PenroseTriangle& triangle, double side, int level) {
        if (level == kMostDivisions || wanted_.stop.stop_requested()) return;
        const double before = penrose_vertices(side), after = penrose_vertices(side / kGolden);
        if (full_ * highest_in(triangle) <= before) return;
        const DividedTriangle divided = divide(triangle);
        for (const PenroseVertex& vertex : divided.born()) {
            if (!on_page(vertex.place)) continue;
            const double threshold = before + vertex.share * (after - before);
            const double density = density_at(vertex.place);
            if (full_ * density > threshold)
                vertices.push_back({threshold / density, density, side / kGolden, vertex});
        }
        for (const PenroseTriangle& part : divided.parts()) place(part, side / kGolden, level + 1);
    }

    // 0 off the page.
    double highest_in(const PenroseTriangle& t) const {
        const glm::dvec2 low = glm::min(glm::min(t.apex, t.left), t.right);
        const glm::dvec2 high = glm::max(glm::max(t.apex, t.left), t.right);
        if (high.x < 0 || high.y < 0 || low.x >= page_.x || low.y >= page_.y) return 0;
        if (!wanted_.density) return 1;
        const double width = std::max(high.x - low.x, high.y - low.y);
        const int depth = std::max(0, int(std::floor(-std::log2(width))));
        const double per_side = std::ldexp(1.0, depth);
        const auto index = [&](double x) {
            return std::int64_t(std::clamp(std::floor(x * per_side), 0.0, per_side - 1));
        };
        float highest = 0;
        for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
            for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
                highest = std::max(highest, wanted_.density->bounds({depth, x, y}).max);
        return double(highest);
    }

    const DotsWanted& wanted_;
    glm::dvec2 page_;
    double full_;
};

// Where a vertex stands between two levels, at so many dots for each unit of area.
struct Stage {
    int age = 0, phase = 0;
};

Stage stage_of(const RankedVertex& vertex, double per_area) {
    const double levels =
        std::log(per_area / penrose_vertices(vertex.side * kGolden)) / (2 * std::log(kGolden));
    const double whole = std::floor(levels);
    return {std::clamp(int(whole), 0, kAges - 1),
            std::clamp(int((levels - whole) * kPhases), 0, kPhases - 1)};
}

// Ways to go, in the frame of a vertex and in mean distances of the dots.
class Corrections {
 public:
    Corrections();

    glm::dvec2 of(const RankedVertex& vertex, double per_area) const {
        const Stage stage = stage_of(vertex, per_area);
        const Entry& entry = entries_[index(vertex, stage)];
        return entry.count > 0
                   ? onto_page(vertex.vertex, entry.sum / double(entry.count)) / std::sqrt(per_area)
                   : glm::dvec2{};
    }

 private:
    struct Entry {
        glm::dvec2 sum{};
        int count = 0;
    };

    static std::size_t index(const RankedVertex& vertex, Stage stage) {
        return (std::size_t(vertex.vertex.type) * kAges + std::size_t(stage.age)) * kPhases +
               std::size_t(stage.phase);
    }
    static glm::dvec2 onto_page(const PenroseVertex& vertex, glm::dvec2 way) {
        const glm::dvec2 x = vertex.along / std::hypot(vertex.along.x, vertex.along.y);
        const glm::dvec2 y = (vertex.mirrored ? -1.0 : 1.0) * glm::dvec2(-x.y, x.x);
        return way.x * x + way.y * y;
    }
    static glm::dvec2 into_frame(const PenroseVertex& vertex, glm::dvec2 way) {
        const glm::dvec2 x = vertex.along / std::hypot(vertex.along.x, vertex.along.y);
        const glm::dvec2 y = (vertex.mirrored ? -1.0 : 1.0) * glm::dvec2(-x.y, x.x);
        return {way.x * x.x + way.y * x.y, way.x * y.x + way.y * y.y};
    }

    std::vector<Entry> entries_ = std::vector<Entry>(std::size_t(kPenroseTypes) * kAges * kPhases);
};

Corrections::Corrections() {
    constexpr int kSteps = 10;
    constexpr double kFewest = 1500, kRim = 3;  // dots; mean distances from the edge, whose cells are cut
    for (int phase = 0; phase < kPhases; ++phase) {
        const double per_area = kFewest * std::pow(kGolden, 2 * (phase + 0.5) / kPhases);
        std::vector<RankedVertex> vertices = PenrosePlacer({}, per_area).vertices;
        std::vector<glm::dvec2> dots;
        for (const RankedVertex& vertex : vertices) dots.push_back(vertex.vertex.place);
        const Domain page{1, 1, Topology::window};
        for (int step = 0; step < kSteps; ++step) {
            const std::vector<CellMoments> cells = plain_cells(dots, page);
            for (std::size_t i = 0; i < dots.size(); ++i)
                if (cells[i].weight > 0) dots[i] += cells[i].first / cells[i].weight;
        }
        const double rim = kRim / std::sqrt(per_area);
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 from = vertices[i].vertex.place;
            if (std::min(std::min(from.x, 1 - from.x), std::min(from.y, 1 - from.y)) < rim) continue;
            Entry& entry = entries_[index(vertices[i], stage_of(vertices[i], per_area))];
            entry.sum += into_frame(vertices[i].vertex, (dots[i] - from) * std::sqrt(per_area));
            ++entry.count;
        }
    }
}

// As many as are wanted, those that come first, and at how many dots for each unit of area and density.
std::vector<RankedVertex> first_vertices(const DotsWanted& wanted, double& full) {
    full = 1.02 * double(wanted.count) / (wanted.density ? wanted.density->mean() : 1) + 16;
    while (true) {
        std::vector<RankedVertex> vertices = PenrosePlacer(wanted, full).vertices;
        if (wanted.stop.stop_requested()) return {};
        if (vertices.size() < wanted.count) {
            full *= 1.1;
            continue;
        }
        std::ranges::sort(vertices, [](const RankedVertex& a, const RankedVertex& b) {
            return std::tie(a.critical, a.vertex.place.y, a.vertex.place.x) <
                   std::tie(b.critical, b.vertex.place.y, b.vertex.place.x);
        });
        if (vertices.size() > wanted.count) full = vertices[wanted.count].critical;
        vertices.resize(wanted.count);
        return vertices;
    }
}

}  // namespace

PlainDots penrose_tiles(const DotsWanted& wanted) {
    static const Corrections corrections;
    double full = 0;
    const glm::dvec2 page = page_of(wanted), last(std::nextafter(page.x, 0.0), std::nextafter(page.y, 0.0));
    PlainDots dots;
    dots.reserve(wanted.count);
    for (const RankedVertex& vertex : first_vertices(wanted, full)) {
        const glm::dvec2 place = vertex.vertex.place + corrections.of(vertex, full * vertex.density);
        dots.push_back(glm::clamp(place, glm::dvec2(0), last));
    }
    return dots;
}

PlainDots penrose_vertices_only(const DotsWanted& wanted) {
    double full = 0;
    PlainDots dots;
    dots.reserve(wanted.count);
    for (const RankedVertex& vertex : first_vertices(wanted, full)) dots.push_back(vertex.vertex.place);
    return dots;
}

}  // namespace dapple
