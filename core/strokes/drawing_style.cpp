#include "core/strokes/drawing_style.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/routing/near_dots.h"

namespace dapple {
namespace {

double squared_apart(const Dots& dots, std::uint32_t a, std::uint32_t b) {
    const double x = double(dots.x[a]) - dots.x[b], y = double(dots.y[a]) - dots.y[b];
    return x * x + y * y;
}

glm::dvec2 place_mm(const Dots& dots, std::size_t i, const PageSize& page) {
    return glm::dvec2(dots.x[i], dots.y[i]) * page.mm_per_page_unit;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the smaller index first

std::vector<Edge> neighbourhood_graph(const Dots& dots) {
    const std::vector<std::uint32_t> near = near_dots(dots.x, dots.y);
    std::vector<Edge> edges;
    for (std::uint32_t p = 0; p < dots.size(); ++p) {
        const auto of_p = std::span(near).subspan(p * kNearDots, kNearDots);
        for (std::size_t k = 0; k < kNearDots; ++k) {
            const std::uint32_t q = of_p[k];
            const double apart = squared_apart(dots, p, q);
            // Whoever is nearer to both is nearer to p than q is, so it stands before q in p's list.
            const bool blocked = std::ranges::any_of(of_p.first(k), [&](std::uint32_t r) {
                return squared_apart(dots, p, r) < apart && squared_apart(dots, q, r) < apart;
            });
            if (!blocked && apart > 0) edges.push_back(std::minmax(p, q));
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

// The graph's edges, each to be gone along once.
class Walk {
 public:
    Walk(std::size_t dots, std::span<const Edge> edges) : first_(dots + 1), taken_(edges.size()) {
        for (const auto& [a, b] : edges) ++first_[a + 1], ++first_[b + 1];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        ways_.resize(2 * edges.size());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto& [a, b] = edges[e];
            ways_[next[a]++] = {e, b};
            ways_[next[b]++] = {e, a};
        }
    }

    std::size_t degree(std::size_t dot) const { return first_[dot + 1] - first_[dot]; }
    std::size_t left(std::size_t dot) const {
        std::size_t count = 0;
        for (std::size_t w = first_[dot]; w < first_[dot + 1]; ++w) count += !taken_[ways_[w].edge];
        return count;
    }

    // Calls visit(dot) for each dot after the first, until there is no edge to take.
    template <class Visit>
    void go_from(std::size_t dot, const Visit& visit) {
        for (;;) {
            std::size_t w = first_[dot];
            while (w < first_[dot + 1] && taken_[ways_[w].edge]) ++w;
            if (w == first_[dot + 1]) return;
            taken_[ways_[w].edge] = true;
            dot = ways_[w].to;
            visit(dot);
        }
    }

 private:
    struct Way {
        std::size_t edge;
        std::uint32_t to;
    };
    std::vector<std::size_t> first_;  // of a dot among the ways
    std::vector<Way> ways_;
    std::vector<char> taken_;
};

}  // namespace

Strokes line_through(const Dots& dots, const PageSize& page) {
    Strokes line;
    line.points.reserve(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) line.points.push_back(place_mm(dots, i, page));
    end_stroke(line, dots.pen);
    return line;
}

Strokes lines_to_nearest(const Dots& dots, const PageSize& page) {
    const std::vector<Edge> edges = neighbourhood_graph(dots);
    Walk walk(dots.size(), edges);
    Strokes strokes;
    const auto begin_at = [&](std::size_t dot) {
        strokes.points.push_back(place_mm(dots, dot, page));
        walk.go_from(dot, [&](std::size_t to) { strokes.points.push_back(place_mm(dots, to, page)); });
        end_stroke(strokes, dots.pen);
    };
    // A stroke that begins elsewhere than where an odd number of lines meet leaves more of those to begin at.
    for (std::size_t i = 0; i < dots.size(); ++i)
        if (walk.degree(i) == 0 || walk.left(i) % 2 == 1) begin_at(i);
    for (std::size_t i = 0; i < dots.size(); ++i)
        if (walk.left(i) > 0) begin_at(i);
    return strokes;
}

}  // namespace dapple
