#pragma once
// Points of the unit square that wait to be chosen, each with a cost: found by place, cheapest first.

#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace dapple {

class Candidates {
 public:
    /// All candidates begin with the same cost.
    Candidates(std::vector<glm::dvec2> positions, double cost);

    std::size_t size() const { return positions_.size(); }
    glm::dvec2 position(std::uint32_t i) const { return positions_[i]; }
    double cost(std::uint32_t i) const { return cost_[i]; }

    /// The cheapest candidate; of costs that are equal but for rounding the first. There must be one left.
    std::uint32_t cheapest() const { return winner_[1]; }
    void set_cost(std::uint32_t i, double cost);
    /// Sets all costs, which is faster than one by one.
    void set_costs(std::vector<double> costs);
    /// Takes a candidate out for good.
    void remove(std::uint32_t i);
    bool is_waiting(std::uint32_t i) const { return waiting_[i]; }

    /// Calls visit(i, squared distance) for every waiting candidate within a radius of a place, inside or
    /// outside the square.
    template <class Visit>
    void for_each_near(glm::dvec2 p, double radius, Visit visit) const;

 private:
    std::uint32_t better(std::uint32_t a, std::uint32_t b) const;
    int cell_on_axis(double v) const;

    std::vector<glm::dvec2> positions_;
    std::vector<double> cost_;
    std::vector<bool> waiting_;
    std::uint32_t leaves_ = 1;           // of the tree of winners, a power of two
    std::vector<std::uint32_t> winner_;  // node k has the children 2 k and 2 k + 1; the root is 1
    int side_ = 1;                       // cells a side
    std::vector<std::uint32_t> first_;   // of each cell in members_
    std::vector<std::uint32_t> members_;
};

template <class Visit>
void Candidates::for_each_near(glm::dvec2 p, double radius, Visit visit) const {
    const int x0 = cell_on_axis(p.x - radius), x1 = cell_on_axis(p.x + radius);
    const int y0 = cell_on_axis(p.y - radius), y1 = cell_on_axis(p.y + radius);
    for (int y = y0; y <= y1; ++y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(side_);
        for (std::uint32_t k = first_[row + x0]; k < first_[row + x1 + 1]; ++k) {
            const std::uint32_t i = members_[k];
            const glm::dvec2 d = positions_[i] - p;
            const double squared = d.x * d.x + d.y * d.y;
            if (squared <= radius * radius && waiting_[i]) visit(i, squared);
        }
    }
}

/// Points of several kinds, to be found by kind and place.
class GridOfKinds {
 public:
    /// `kinds`: each point's kind, below `count`.
    GridOfKinds(const std::vector<glm::dvec2>& points, const std::vector<std::size_t>& kinds,
                std::size_t count)
        : numbers_(count) {
        std::vector<std::vector<glm::dvec2>> of_kind(count);
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            of_kind[kinds[i]].push_back(points[i]);
            numbers_[kinds[i]].push_back(i);
        }
        for (auto& kind : of_kind) grids_.emplace_back(std::move(kind), 0);
    }

    /// Calls visit(i, squared distance) for every point of a kind within a radius of a place.
    template <class Visit>
    void for_each_near(std::size_t kind, glm::dvec2 p, double radius, Visit visit) const {
        grids_[kind].for_each_near(
            p, radius, [&](std::uint32_t i, double squared) { visit(numbers_[kind][i], squared); });
    }

 private:
    std::vector<Candidates> grids_;
    std::vector<std::vector<std::uint32_t>> numbers_;
};

}  // namespace dapple
