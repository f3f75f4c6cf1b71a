#include "core/tile/candidates.h"

#include <algorithm>
#include <cmath>

namespace dapple {

Candidates::Candidates(std::vector<glm::dvec2> positions, double cost)
    : positions_(std::move(positions)), cost_(positions_.size(), cost), waiting_(positions_.size(), true) {
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(size()) / 2)));
    const auto cell_of = [&](glm::dvec2 p) {
        return static_cast<std::size_t>(cell_on_axis(p.y)) * static_cast<std::size_t>(side_) +
               static_cast<std::size_t>(cell_on_axis(p.x));
    };
    first_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (const glm::dvec2 p : positions_) ++first_[cell_of(p) + 1];
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    std::vector<std::uint32_t> next = first_;
    members_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) members_[next[cell_of(positions_[i])]++] = i;

    while (leaves_ < size()) leaves_ *= 2;
    winner_.resize(2 * leaves_);
    set_costs(cost_);
}

int Candidates::cell_on_axis(double v) const {
    return static_cast<int>(std::clamp(std::floor(v * side_), 0.0, side_ - 1.0));
}

std::uint32_t Candidates::better(std::uint32_t a, std::uint32_t b) const {
    if (b >= size() || !waiting_[b]) return a;
    if (a >= size() || !waiting_[a]) return b;
    // Equal up to rounding counts as equal, so that the order is the same everywhere.
    return cost_[b] < cost_[a] - 1e-12 * std::abs(cost_[a]) ? b : a;
}

void Candidates::set_cost(std::uint32_t i, double cost) {
    cost_[i] = cost;
    for (std::uint32_t node = (leaves_ + i) / 2; node > 0; node /= 2)
        winner_[node] = better(winner_[2 * node], winner_[2 * node + 1]);
}

void Candidates::set_costs(std::vector<double> costs) {
    cost_ = std::move(costs);
    for (std::uint32_t i = 0; i < leaves_; ++i) winner_[leaves_ + i] = i;
    for (std::uint32_t node = leaves_ - 1; node > 0; --node)
        winner_[node] = better(winner_[2 * node], winner_[2 * node + 1]);
}

void Candidates::remove(std::uint32_t i) {
    waiting_[i] = false;
    set_cost(i, cost_[i]);
}

}  // namespace dapple
