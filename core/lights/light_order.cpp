#include "core/lights/light_order.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <queue>
#include <tuple>

#include "core/image/environment.h"
#include "core/lights/direction.h"

namespace dapple {

namespace {

// Samples with nothing between them in the order so far, one of which stands for all.
struct Group {
    std::size_t begin, end;
    std::uint32_t first;
    double spread;  // of unit vectors with that sum, times power, times two

    bool operator<(const Group& other) const {
        return std::tie(spread, other.begin) < std::tie(other.spread, begin);
    }
};

class Groups {
 public:
    explicit Groups(std::span<const LightSample> samples) : numbers_(samples.size()) {
        std::iota(numbers_.begin(), numbers_.end(), 0u);
        for (const LightSample& sample : samples) {
            directions_.push_back(direction_of(sample.uv, SphereConvention::openexr));
            powers_.push_back(luminance(sample.weight));
        }
    }

    Group all() const { return with_first(0, numbers_.size(), nearest_to_middle(0, numbers_.size())); }

    // Halves of the group's light, side by side along the axis on which it is spread out most; the one that
    // has the group's first keeps it, and is returned first.
    std::pair<Group, Group> halves(const Group& group) {
        const auto begin = numbers_.begin() + std::ptrdiff_t(group.begin);
        const auto end = numbers_.begin() + std::ptrdiff_t(group.end);
        const int axis = widest_axis(group);
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            return std::tie(directions_[a][axis], a) < std::tie(directions_[b][axis], b);
        });
        double half = 0, so_far = 0;
        for (auto i = begin; i < end; ++i) half += powers_[*i] / 2;
        auto middle = begin + 1;
        for (so_far = powers_[*begin]; middle < end - 1 && so_far + powers_[*middle] <= half; ++middle)
            so_far += powers_[*middle];
        const auto cut = std::size_t(middle - numbers_.begin());
        const bool in_lower = std::find(begin, middle, group.first) != middle;
        const auto rest = [&](std::size_t from, std::size_t to) {
            return with_first(from, to, nearest_to_middle(from, to));
        };
        if (in_lower) return {with_first(group.begin, cut, group.first), rest(cut, group.end)};
        return {with_first(cut, group.end, group.first), rest(group.begin, cut)};
    }

 private:
    // Of the group's light; where it has none, of its samples.
    glm::dvec3 moment(std::size_t begin, std::size_t end) const {
        glm::dvec3 sum{}, even{};
        for (std::size_t i = begin; i < end; ++i) {
            sum += powers_[numbers_[i]] * directions_[numbers_[i]];
            even += directions_[numbers_[i]];
        }
        return glm::length(sum) > 0 ? sum : even;
    }

    std::uint32_t nearest_to_middle(std::size_t begin, std::size_t end) const {
        const glm::dvec3 middle = moment(begin, end);
        std::uint32_t nearest = numbers_[begin];
        for (std::size_t i = begin; i < end; ++i)
            if (glm::dot(directions_[numbers_[i]], middle) > glm::dot(directions_[nearest], middle))
                nearest = numbers_[i];
        return nearest;
    }

    Group with_first(std::size_t begin, std::size_t end, std::uint32_t first) const {
        double power = 0;
        glm::dvec3 sum{};
        for (std::size_t i = begin; i < end; ++i) {
            power += powers_[numbers_[i]];
            sum += powers_[numbers_[i]] * directions_[numbers_[i]];
        }
        return {begin, end, first, std::max(power - glm::length(sum), 0.0)};
    }

    int widest_axis(const Group& group) const {
        glm::dvec3 sum{}, squares{};
        double power = 0;
        for (std::size_t i = group.begin; i < group.end; ++i) {
            const std::uint32_t number = numbers_[i];
            const glm::dvec3 weighed = powers_[number] * directions_[number];
            power += powers_[number];
            sum += weighed;
            squares += weighed * directions_[number];
        }
        const glm::dvec3 spread = power > 0 ? squares - sum * sum / power : glm::dvec3(0);
        return spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    }

    std::vector<glm::dvec3> directions_;
    std::vector<double> powers_;
    std::vector<std::uint32_t> numbers_;  // a group's side by side
};

}  // namespace

std::vector<std::uint32_t> priority_order(std::span<const LightSample> samples) {
    if (samples.empty()) return {};
    Groups groups(samples);
    std::priority_queue<Group> waiting;
    std::vector<std::uint32_t> order{groups.all().first};
    waiting.push(groups.all());
    while (order.size() < samples.size()) {
        const Group group = waiting.top();
        waiting.pop();
        if (group.end - group.begin < 2) continue;
        const auto [kept, parted] = groups.halves(group);
        order.push_back(parted.first);
        waiting.push(kept);
        waiting.push(parted);
    }
    return order;
}

}  // namespace dapple
