#include "core/lights/settling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/lights/direction.h"
#include "core/maths/portable_math.h"
#include "core/placing/pieces.h"

namespace dapple {

namespace {

constexpr int kLeaf = 4;             // texels a side of the smallest squares that are summed up
constexpr int kTaskColumns = 16;     // squares with at most so many side by side are a thread's
constexpr std::size_t kAtOnce = 16;  // tasks, between two looks at who watches
// Beyond the middle of the power, which takes half as many steps as going just there; the last goes there.
constexpr double kOvershoot = 1.6;

double distance2(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = a - b;
    return glm::dot(d, d);
}

}  // namespace

TexelSum& TexelSum::operator+=(const TexelSum& other) {
    flux += other.flux;
    solid_angle += other.solid_angle;
    power += other.power;
    moment += other.moment;
    return *this;
}

TexelTree::TexelTree(const EnvironmentMap& map, const Grid<float>& power, int threads)
    : map_(map), power_(power), threads_(threads_for(threads)) {
    const int width = map.width(), height = map.height();
    for (int x = 0; x < width; ++x) {
        const double around = 2 * std::numbers::pi * (0.5 - (x + 0.5) / width);
        around_cosine_.push_back(portable::cos(around));
        around_sine_.push_back(portable::sin(around));
    }
    for (int y = 0; y < height; ++y) {
        down_cosine_.push_back(portable::cos(std::numbers::pi * (y + 0.5) / height));
        down_sine_.push_back(portable::sin(std::numbers::pi * (y + 0.5) / height));
        solid_angle_.push_back(map.solid_angle(y));
    }
    const auto halves = [](int count, int by) { return (count + by - 1) / by; };
    Grid<TexelSum>& first = levels_.emplace_back(halves(width, kLeaf), halves(height, kLeaf));
    for_each_on_threads(std::size_t(first.height), threads_, [&](std::size_t square_row) {
        const int top = int(square_row) * kLeaf;
        for (int y = top; y < std::min(top + kLeaf, height); ++y)
            for (int x = 0; x < width; ++x) first.at(x / kLeaf, int(square_row)) += texel(x, y);
    });
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Grid<TexelSum>& finer = levels_.back();
        Grid<TexelSum> next(halves(finer.width, 2), halves(finer.height, 2));
        for (int y = 0; y < finer.height; ++y)
            for (int x = 0; x < finer.width; ++x) next.at(x / 2, y / 2) += finer.at(x, y);
        levels_.push_back(std::move(next));
    }
}

glm::dvec3 TexelTree::direction(int column, int row) const {
    return {down_sine_[row] * around_sine_[column], down_cosine_[row],
            down_sine_[row] * around_cosine_[column]};
}

TexelSum TexelTree::texel(int column, int row) const {
    const double power = power_.at(column, row);
    if (power < 0) return {};
    const double solid_angle = solid_angle_[std::size_t(row)];
    return {solid_angle * glm::dvec3(map_.radiance().at(column, row)), solid_angle, power,
            power * direction(column, row)};
}

TexelSum TexelTree::around(glm::ivec2 place) const {
    TexelSum sum;
    for (int y = std::max(place.y - 1, 0); y <= std::min(place.y + 1, map_.height() - 1); ++y)
        for (int x = place.x - 1; x <= place.x + 1; ++x) sum += texel((x + map_.width()) % map_.width(), y);
    return sum;
}

template <class Whole, class Texel>
class TexelTree::Descent {
 public:
    Descent(const TexelTree& tree, std::span<const glm::dvec3> lights, const Whole& whole, const Texel& texel)
        : tree_(tree), lights_(lights), whole_(whole), texel_(texel) {}

    void into(const Task& task) {
        near_ = task.lights;
        into(task.square, 0);
    }

    // Appends those of the last lights from `first` on that may be nearest to a texel of the square.
    void keep_near(const Square& square, std::size_t first) {
        const int width = tree_.map_.width(), height = tree_.map_.height(), side = kLeaf << square.level;
        const double left = double(square.column) * side / width, top = double(square.row) * side / height;
        const double right = std::min<double>((square.column + 1.0) * side / width, 1);
        const double bottom = std::min<double>((square.row + 1.0) * side / height, 1);
        const glm::dvec3 middle =
            direction_of({(left + right) / 2, (top + bottom) / 2}, SphereConvention::openexr);
        const bool equator = top < 0.5 && bottom > 0.5;
        const double widest = equator ? 1 : portable::sin(std::numbers::pi * (top < 0.5 ? bottom : top));
        // From the middle to a texel's at most: down, then around.
        const double radius = std::numbers::pi * ((bottom - top) / 2 + (right - left) * widest);
        const std::size_t end = near_.size();
        double least2 = std::numeric_limits<double>::max();
        away2_.resize(end - first);
        for (std::size_t i = first; i < end; ++i) {
            away2_[i - first] = distance2(lights_[near_[i]], middle);
            least2 = std::min(least2, away2_[i - first]);
        }
        const double most = std::sqrt(least2) + 2 * radius, most2 = most * most;
        for (std::size_t i = first; i < end; ++i)
            if (away2_[i - first] <= most2) near_.push_back(near_[i]);
    }

    std::vector<std::uint32_t>& near() { return near_; }

 private:
    void into(const Square& square, std::size_t first) {
        const std::size_t end = near_.size();
        keep_near(square, first);
        if (near_.size() - end == 1)
            whole_(square, near_[end]);
        else if (square.level == 0)
            each_texel(square, end);
        else {
            const Grid<TexelSum>& finer = tree_.levels_[std::size_t(square.level) - 1];
            for (int row = 2 * square.row; row < std::min(2 * square.row + 2, finer.height); ++row)
                for (int column = 2 * square.column; column < std::min(2 * square.column + 2, finer.width);
                     ++column)
                    into({square.level - 1, column, row}, end);
        }
        near_.resize(end);
    }

    void each_texel(const Square& square, std::size_t first) {
        tree_.for_each_texel(square, [&](int column, int row) {
            const glm::dvec3 here = tree_.direction(column, row);
            double least2 = std::numeric_limits<double>::max();
            std::uint32_t nearest = 0;
            for (std::size_t i = first; i < near_.size(); ++i) {
                const double away2 = distance2(lights_[near_[i]], here);
                if (away2 >= least2) continue;
                least2 = away2;
                nearest = near_[i];
            }
            texel_(column, row, nearest);
        });
    }

    const TexelTree& tree_;
    const std::span<const glm::dvec3> lights_;
    const Whole& whole_;
    const Texel& texel_;
    std::vector<std::uint32_t> near_;  // a square's after those of the one that it is a part of
    std::vector<double> away2_;
};

std::vector<TexelTree::Task> TexelTree::tasks(std::span<const glm::dvec3> lights) const {
    std::vector<std::uint32_t> all(lights.size());
    std::iota(all.begin(), all.end(), 0u);
    std::vector<Task> tasks{{{int(levels_.size()) - 1, 0, 0}, std::move(all)}};
    const auto nothing = [](auto...) {};
    Descent descent(*this, lights, nothing, nothing);
    while (tasks.front().square.level > 0 &&
           levels_[std::size_t(tasks.front().square.level)].width < kTaskColumns) {
        std::vector<Task> smaller;
        for (Task& task : tasks) {
            const int level = task.square.level - 1;
            const Grid<TexelSum>& finer = levels_[std::size_t(level)];
            for (int row = 2 * task.square.row; row < std::min(2 * task.square.row + 2, finer.height); ++row)
                for (int column = 2 * task.square.column;
                     column < std::min(2 * task.square.column + 2, finer.width); ++column) {
                    descent.near() = task.lights;
                    descent.keep_near({level, column, row}, 0);
                    smaller.push_back({{level, column, row},
                                       {descent.near().begin() + std::ptrdiff_t(task.lights.size()),
                                        descent.near().end()}});
                }
        }
        tasks = std::move(smaller);
    }
    return tasks;
}

template <class Texel>
void TexelTree::for_each_texel(const Square& square, const Texel& texel) const {
    const int side = kLeaf << square.level;
    for (int row = square.row * side; row < std::min((square.row + 1) * side, map_.height()); ++row)
        for (int column = square.column * side; column < std::min((square.column + 1) * side, map_.width());
             ++column)
            texel(column, row);
}

// What comes of each light's texels: of the tasks side by side, added up in their order.
template <class Result, class Whole, class Texel>
bool TexelTree::for_each_light(std::span<const glm::dvec3> lights, const Watch& watch, const Whole& whole,
                               const Texel& texel, std::vector<Result>& results) const {
    const std::vector<Task> all = tasks(lights);
    results.assign(lights.size(), {});
    std::vector<std::vector<Result>> parts(kAtOnce);
    for (std::size_t first = 0; first < all.size(); first += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, all.size() - first);
        for_each_on_threads(count, threads_, [&](std::size_t i) {
            const std::vector<std::uint32_t>& own = all[first + i].lights;  // ascending
            parts[i].assign(own.size(), {});
            const auto part = [&](std::uint32_t light) -> Result& {
                return parts[i][std::size_t(std::ranges::lower_bound(own, light) - own.begin())];
            };
            Descent(
                *this, lights,
                [&](const Square& square, std::uint32_t light) { whole(square, light, part(light)); },
                [&](int column, int row, std::uint32_t light) { texel(column, row, light, part(light)); })
                .into(all[first + i]);
        });
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < parts[i].size(); ++k)
                results[all[first + i].lights[k]] += parts[i][k];
        if (!watch.goes_on(double(first + count) / double(all.size()))) return false;
    }
    return true;
}

std::optional<std::vector<TexelSum>> TexelTree::nearest_to(std::span<const glm::dvec3> lights,
                                                           const Watch& watch) const {
    std::vector<TexelSum> sums;
    const auto add = [&](const Square& square, std::uint32_t, TexelSum& sum) {
        sum += levels_[std::size_t(square.level)].at(square.column, square.row);
    };
    const auto add_texel = [&](int column, int row, std::uint32_t, TexelSum& sum) {
        sum += texel(column, row);
    };
    if (!for_each_light(lights, watch, add, add_texel, sums)) return std::nullopt;
    return sums;
}

Grid<std::uint32_t> TexelTree::nearest_of(std::span<const glm::dvec3> lights) const {
    Grid<std::uint32_t> nearest(map_.width(), map_.height());
    struct Nothing {
        void operator+=(Nothing) {}
    };
    // Squares and texels have no part in common.
    const auto set_texel = [&](int column, int row, std::uint32_t light, Nothing) {
        nearest.at(column, row) = light;
    };
    const auto set = [&](const Square& square, std::uint32_t light, Nothing) {
        for_each_texel(square, [&](int column, int row) { nearest.at(column, row) = light; });
    };
    std::vector<Nothing> nothing;
    for_each_light(lights, {}, set, set_texel, nothing);
    return nearest;
}

std::vector<glm::ivec2> TexelTree::texels_with(Most most, std::span<const glm::dvec3> lights,
                                               std::span<const std::size_t> which) const {
    struct Best {
        double worth = -1;
        glm::ivec2 texel{};
        void operator+=(const Best& other) {
            if (other.worth > worth) *this = other;
        }
    };
    std::vector<bool> wanted(lights.size());
    for (const std::size_t light : which) wanted[light] = true;
    const auto look = [&](int column, int row, std::uint32_t light, Best& best) {
        if (!wanted[light]) return;
        double worth = power_.at(column, row);
        if (most == Most::spread) worth *= distance2(lights[light], direction(column, row));
        best += {worth, {column, row}};
    };
    const auto look_at_all = [&](const Square& square, std::uint32_t light, Best& best) {
        if (!wanted[light]) return;
        for_each_texel(square, [&](int column, int row) { look(column, row, light, best); });
    };
    std::vector<Best> found;
    for_each_light(lights, {}, look_at_all, look, found);
    std::vector<glm::ivec2> texels;
    for (const std::size_t light : which) texels.push_back(found[light].texel);
    return texels;
}

namespace {

// Lights without power go to the farthest texel of those that stand for the most power times distance
// squared, one to each. False if all have some.
bool send_off_idle_ones(const TexelTree& tree, const std::vector<TexelSum>& sums,
                        std::vector<glm::dvec3>& lights) {
    std::vector<std::size_t> idle, widest(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!(sums[i].power > 0)) idle.push_back(i);
    if (idle.empty()) return false;
    // Of unit vectors with that sum, times two.
    const auto spread = [&](std::size_t i) { return sums[i].power - glm::length(sums[i].moment); };
    std::iota(widest.begin(), widest.end(), std::size_t{0});
    std::ranges::stable_sort(widest, std::ranges::greater{}, spread);
    widest.resize(std::min(idle.size(), lights.size() - idle.size()));
    const auto texels = tree.texels_with(TexelTree::Most::spread, lights, widest);
    for (std::size_t k = 0; k < widest.size(); ++k)
        lights[idle[k]] = tree.direction(texels[k].x, texels[k].y);
    return true;
}

// A light with most of its power in a few texels side by side, such as a sun, is there, and not off it where
// the middle of all its power is.
void go_to_suns(const TexelTree& tree, const std::vector<TexelSum>& sums, std::span<const glm::dvec3> nearest,
                std::vector<glm::dvec3>& lights) {
    constexpr double kSmall = 1 / 25.0;  // beside all that the light stands for
    std::vector<std::size_t> all(lights.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const auto texels = tree.texels_with(TexelTree::Most::power, nearest, all);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const TexelSum sun = tree.around(texels[i]);
        const bool small = sun.solid_angle < kSmall * sums[i].solid_angle;
        if (small && sun.power > 0.5 * sums[i].power) lights[i] = glm::normalize(sun.moment);
    }
}

}  // namespace

std::optional<std::vector<TexelSum>> settle(const TexelTree& tree, std::vector<glm::dvec3>& lights, int steps,
                                            const Watch& watch) {
    constexpr int kMostRounds = 60;  // in which idle lights find a place
    std::optional<std::vector<TexelSum>> sums;
    for (int step = 0; step <= steps; ++step) {
        const auto share = [&](double done) { return (step + done) / (steps + 1); };
        const Watch of_step{watch.stop, [&](double done) { watch.goes_on(share(done)); }};
        sums = tree.nearest_to(lights, of_step);
        const bool last = step == steps;
        for (int round = 0; sums && send_off_idle_ones(tree, *sums, lights) && last && round < kMostRounds;
             ++round)
            sums = tree.nearest_to(lights, {.stop = watch.stop, .progress = {}});
        if (!sums) return sums;
        const std::vector<glm::dvec3> before = lights;
        const double way = last ? 1 : kOvershoot;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const TexelSum& own = (*sums)[i];
            if (!(own.power > 0) || !(glm::length(own.moment) > 0)) continue;
            lights[i] = glm::normalize(glm::mix(lights[i], glm::normalize(own.moment), way));
        }
        if (last) go_to_suns(tree, *sums, before, lights);
    }
    return sums;
}

}  // namespace dapple
