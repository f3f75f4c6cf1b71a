#include "core/lights/light_samples.h"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "core/failure.h"
#include "core/lights/direction.h"
#include "core/lights/settling.h"
#include "core/maths/portable_math.h"
#include "core/tile/random.h"
#include "core/tile/tile.h"

namespace dapple {

namespace {

constexpr std::int32_t kNobody = -1;
constexpr double kOwnersShare = 0.5;  // of the time that sharing takes

// A map's patches: column i lies between texel columns i - 1 and i, row j between texel rows j - 1 and j; the
// outermost rows are half as high.
struct PatchGrid {
    int width, texel_rows;

    int rows() const { return texel_rows + 1; }
    std::size_t size() const { return static_cast<std::size_t>(width) * rows(); }
    int left(int column) const { return column == 0 ? width - 1 : column - 1; }
    int right(int column) const { return column == width - 1 ? 0 : column + 1; }

    std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * width + column; }

    std::size_t patch_at(glm::dvec2 uv) const {
        const int column = static_cast<int>(uv.x * width + 0.5) % width;
        const int row = std::clamp(static_cast<int>(uv.y * texel_rows + 0.5), 0, texel_rows);
        return index(column, row);
    }
};

// The dots of each patch: those of patch p are order[start[p]] up to order[start[p + 1]].
struct DotsByPatch {
    std::vector<std::uint32_t> start, order;

    std::span<const std::uint32_t> of(std::size_t patch) const {
        return {order.data() + start[patch], start[patch + 1] - start[patch]};
    }

    DotsByPatch(const PatchGrid& grid, std::span<const glm::dvec2> dots)
        : start(grid.size() + 1), order(dots.size()) {
        std::vector<std::uint32_t> patch(dots.size());
        for (std::size_t i = 0; i < dots.size(); ++i) {
            patch[i] = static_cast<std::uint32_t>(grid.patch_at(dots[i]));
            ++start[patch[i] + 1];
        }
        for (std::size_t p = 1; p < start.size(); ++p) start[p] += start[p - 1];
        std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
        for (std::size_t i = 0; i < dots.size(); ++i) order[next[patch[i]]++] = static_cast<std::uint32_t>(i);
    }
};

// Cosines and sines along the axes: a direction is one of each.
struct Ring {
    std::vector<double> cosine, sine;

    Ring(int count, double first, double step) : cosine(count), sine(count) {
        for (int i = 0; i < count; ++i) {
            cosine[i] = portable::cos(first + i * step);
            sine[i] = portable::sin(first + i * step);
        }
    }
};

// OpenEXR: u = 1/2 is +Z and u = 1/4 is +X.
double azimuth(double u) {
    return 2 * std::numbers::pi * (0.5 - u);
}

// Hands owners on until every patch has one, or somebody who watches gives up.
class Owners {
 public:
    Owners(const PatchGrid& grid, std::span<const glm::dvec2> dots, const DotsByPatch& by_patch,
           const Watch& watch)
        : grid_(grid),
          owner_(grid.size(), kNobody),
          distance_(grid.size(), std::numeric_limits<float>::max()) {
        const Ring around(grid.width, azimuth(0), -2 * std::numbers::pi / grid.width);
        const Ring down(grid.rows(), 0, std::numbers::pi / grid.texel_rows);
        around_cosine_.assign(around.cosine.begin(), around.cosine.end());
        around_sine_.assign(around.sine.begin(), around.sine.end());
        down_cosine_.assign(down.cosine.begin(), down.cosine.end());
        down_sine_.assign(down.sine.begin(), down.sine.end());
        dot_direction_.reserve(dots.size());
        for (const glm::dvec2 uv : dots)
            dot_direction_.push_back(glm::vec3(direction_of(uv, SphereConvention::openexr)));
        for (std::size_t p = 0; p < owner_.size(); ++p) {
            if (by_patch.of(p).empty()) continue;
            owner_[p] = static_cast<std::int32_t>(by_patch.of(p).front());
            distance_[p] = -1;  // a patch with dots keeps them
        }
        const int last = grid.rows() - 1;
        const double a_row = kOwnersShare / (2 * grid.rows());
        spread_along(0);
        for (int row = 1; row <= last && watch.goes_on(row * a_row); ++row) spread_from(row - 1, row);
        spread_along(last);
        for (int row = last - 1; row >= 0 && watch.goes_on((2 * last - row) * a_row); --row)
            spread_from(row + 1, row);
    }

    std::int32_t at(int column, int row) const { return owner_[grid_.index(column, row)]; }

 private:
    // Whether the patch is the candidate's now and was not before.
    bool offer(std::int32_t candidate, std::size_t patch, int column, int row) {
        if (candidate == owner_[patch] || candidate == kNobody || distance_[patch] < 0) return false;
        const glm::vec3 here(down_sine_[row] * around_sine_[column], down_cosine_[row],
                             down_sine_[row] * around_cosine_[column]);
        const glm::vec3 d = dot_direction_[candidate] - here;
        const float distance = d.x * d.x + d.y * d.y + d.z * d.z;
        if (distance >= distance_[patch]) return false;
        distance_[patch] = distance;
        owner_[patch] = candidate;
        return true;
    }

    void spread_from(int source, int row) {
        for (int x = 0; x < grid_.width; ++x) {
            const std::size_t patch = grid_.index(x, row);
            offer(owner_[grid_.index(grid_.left(x), source)], patch, x, row);
            offer(owner_[grid_.index(x, source)], patch, x, row);
            offer(owner_[grid_.index(grid_.right(x), source)], patch, x, row);
        }
        spread_along(row);
    }

    // Around each way, and on across the seam as long as that brings something.
    void spread_along(int row) {
        for (int x = 0; x < grid_.width; ++x) pass(grid_.left(x), x, row);
        for (int x = 0; x < grid_.width && pass(grid_.left(x), x, row);) ++x;
        for (int x = grid_.width - 1; x >= 0; --x) pass(grid_.right(x), x, row);
        for (int x = grid_.width - 1; x >= 0 && pass(grid_.right(x), x, row);) --x;
    }

    bool pass(int from, int to, int row) {
        const std::size_t patch = grid_.index(to, row);
        return offer(owner_[grid_.index(from, row)], patch, to, row);
    }

    PatchGrid grid_;
    std::vector<float> around_cosine_, around_sine_, down_cosine_, down_sine_;
    std::vector<glm::vec3> dot_direction_;
    std::vector<std::int32_t> owner_;
    std::vector<float> distance_;  // squared, along the chord
};

// What the two texels of one row give to the patch between them, the same to the patch above as to the one
// below: a quarter each. Within its quarter of a patch a texel's light has its centre of gravity a third of a
// texel from the texel's centre.
struct Pair {
    glm::dvec3 flux;
    double power;
    double x, z;  // of the moment, but for the height's sine
};

class TexelPairs {
 public:
    TexelPairs(const EnvironmentMap& map, const Grid<float>& power)
        : map_(map),
          power_(power),
          before_(map.width(), azimuth((0.5 - kThird) / map.width()), -2 * std::numbers::pi / map.width()),
          after_(map.width(), azimuth((0.5 + kThird) / map.width()), -2 * std::numbers::pi / map.width()) {}

    // Pair i is that of columns i - 1 and i.
    void of_row(int row, std::vector<Pair>& pairs) const {
        const glm::vec3* const radiance = map_.radiance().row(row);
        const double share = map_.solid_angle(row) / 4;
        const int width = map_.width();
        glm::dvec3 left = share * glm::dvec3(radiance[width - 1]);
        double left_power = power_.at(width - 1, row) / 4.0;
        for (int i = 0; i < width; ++i) {
            const int l = i == 0 ? width - 1 : i - 1;
            const glm::dvec3 right = share * glm::dvec3(radiance[i]);
            const double right_power = power_.at(i, row) / 4.0;
            pairs[i] = {left + right, left_power + right_power,
                        left_power * after_.sine[l] + right_power * before_.sine[i],
                        left_power * after_.cosine[l] + right_power * before_.cosine[i]};
            left = right;
            left_power = right_power;
        }
    }

 private:
    static constexpr double kThird = 1.0 / 3;

    const EnvironmentMap& map_;
    const Grid<float>& power_;
    Ring before_, after_;  // by column: a third of a texel to the left and to the right of its centre
};

// The height of a texel row's light within the patches above or below it, and its solid angle in one.
struct RowPart {
    double sine = 0, cosine = 0, solid_angle = 0;
};

enum class Side { above, below };

RowPart part_of_row(const EnvironmentMap& map, int row, Side side) {
    const int height = map.height();
    double centre = side == Side::above ? row + 0.5 - 1.0 / 3 : row + 0.5 + 1.0 / 3;
    // The outermost half rows are even.
    if (side == Side::above && row == 0) centre = 0.25;
    if (side == Side::below && row == height - 1) centre = height - 0.25;
    const double theta = std::numbers::pi * centre / height;
    return {portable::sin(theta), portable::cos(theta), map.solid_angle(row) / 2};
}

void add(LightRegion& whole, const Pair& pair, const RowPart& part) {
    whole.flux += pair.flux;
    whole.power += pair.power;
    whole.solid_angle += part.solid_angle;
    whole.moment += glm::dvec3(part.sine * pair.x, part.cosine * pair.power, part.sine * pair.z);
}

void add(LightRegion& region, const LightRegion& patch, double share, const glm::dvec3& moved) {
    region.flux += share * patch.flux;
    region.power += share * patch.power;
    region.solid_angle += share * patch.solid_angle;
    region.moment += share * (patch.moment + patch.power * moved);
}

// A texel drawn for each region: every quarter of a patch replaces what was drawn before with its share of
// the power so far.
void draw_places(const Grid<float>& power, const PatchGrid& grid, const DotsByPatch& by_patch,
                 const Owners& owners, Random random, std::vector<LightRegion>& regions) {
    std::vector<double> so_far(regions.size());
    const auto offer = [&](std::size_t dot, int column, int row, double part) {
        so_far[dot] += part;
        if (!(part > 0) || random.unit() * so_far[dot] >= part) return;
        regions[dot].drawn = {(column + 0.5) / power.width, (row + 0.5) / power.height};
    };
    for (int j = 0; j < grid.rows(); ++j) {
        for (const int row : {j - 1, j}) {
            if (row < 0 || row >= power.height) continue;
            for (int i = 0; i < grid.width; ++i) {
                const std::span own = by_patch.of(grid.index(i, j));
                for (const int column : {grid.left(i), i}) {
                    const double quarter = power.at(column, row) / 4.0;
                    if (own.size() < 2) {
                        offer(owners.at(i, j), column, row, quarter);
                        continue;
                    }
                    const double share = quarter / static_cast<double>(own.size());
                    for (const std::uint32_t dot : own) offer(dot, column, row, share);
                }
            }
        }
    }
}

}  // namespace

std::vector<LightRegion> share_light(const EnvironmentMap& map, const Grid<float>& power,
                                     std::span<const glm::dvec2> dots, std::optional<std::uint64_t> seed,
                                     const Watch& watch) {
    const PatchGrid grid{map.width(), map.height()};
    const DotsByPatch by_patch(grid, dots);
    const Owners owners(grid, dots, by_patch, watch);
    const TexelPairs pairs(map, power);

    std::vector<LightRegion> regions(dots.size());
    std::vector<Pair> above(grid.width), below(grid.width);
    for (int j = 0; j < grid.rows(); ++j) {
        if (!watch.goes_on(kOwnersShare + (1 - kOwnersShare) * j / grid.rows())) return {};
        RowPart upper, lower;
        std::swap(above, below);
        if (j > 0)
            upper = part_of_row(map, j - 1, Side::below);
        else
            std::ranges::fill(above, Pair{});
        if (j < map.height()) {
            lower = part_of_row(map, j, Side::above);
            pairs.of_row(j, below);
        } else {
            std::ranges::fill(below, Pair{});
        }
        for (int i = 0; i < grid.width; ++i) {
            LightRegion patch;
            add(patch, above[i], upper);
            add(patch, below[i], lower);
            const std::span own = by_patch.of(grid.index(i, j));
            if (own.size() < 2) {
                add(regions[owners.at(i, j)], patch, 1, {});
                continue;
            }
            // Dots that share a patch keep their places about its centre of gravity.
            const double share = 1.0 / static_cast<double>(own.size());
            glm::dvec3 middle{};
            for (const std::uint32_t dot : own)
                middle += share * direction_of(dots[dot], SphereConvention::openexr);
            for (const std::uint32_t dot : own)
                add(regions[dot], patch, share, direction_of(dots[dot], SphereConvention::openexr) - middle);
        }
    }
    if (seed) draw_places(power, grid, by_patch, owners, Random(*seed), regions);
    return regions;
}

namespace {

// Samples in an order in which the first few stand for all as well as so few can.

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

// The numbers of the samples, the most important first. Each of the first n stands for a group of samples
// about itself; the next one parts the group whose light is spread out most. The first n become a set of
// their own by giving the weight of every other sample to the nearest of them, and, if they may move, by
// going to the middle of what they got.
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

constexpr double kPlacingShare = 0.4;  // of the time that samples take: most of it for the density

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The places of the dots that Figure 8 emits, each once: the `count` of them that appear first as its scale
// grows.
std::vector<glm::dvec2> figure8_dots(const RankedTile& tile, const Density& density, std::uint64_t count,
                                     const std::stop_token& stop) {
    const auto placed = place_figure8_count(density, tile.tile(), tile.own_ranks(), count, stop);
    if (!placed) return {};
    const Dots& dots = placed->dots;
    struct Place {
        float x, y;
        double critical;
    };
    std::vector<Place> places(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const double here = density.at({dots.x[i], dots.y[i]});
        places[i] = {dots.x[i], dots.y[i],
                     here > 0 ? dots.threshold[i] / here : std::numeric_limits<double>::max()};
    }
    std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.y, p.x, p.critical); });
    const auto alike = [](const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; };
    places.erase(std::unique(places.begin(), places.end(), alike), places.end());
    std::ranges::stable_sort(places, {}, &Place::critical);
    std::vector<glm::dvec2> chosen(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < count; ++i) chosen[i] = {places[i].x, places[i].y};
    return chosen;
}

std::vector<glm::dvec2> exact_dots(RankedTile& tile, const Density& density, const LightRequest& request,
                                   const std::stop_token& stop) {
    DotPieces dots;
    if (!tile.placer().place(density, {.count = request.count, .threads = request.threads}, dots, stop))
        return {};
    std::vector<glm::dvec2> places;
    places.reserve(dots.size());
    for_each_position(dots, [&](float x, float y) { places.emplace_back(x, y); });
    return places;
}

void check_count(std::uint64_t count) {
    if (count < 1 || count > kMostLightSamples)
        throw failure("{} samples are not possible; ask for 1 to {}", count, kMostLightSamples);
}

int turn_of(const EnvironmentMap& map, std::uint64_t seed) {
    return seed == 0 ? 0 : static_cast<int>(Random(seed).below(static_cast<std::size_t>(map.width())));
}

// Of a density that is turned by so many columns.
std::vector<glm::dvec2> dots_of(const Density& density, int turn, RankedTile& tile,
                                const LightRequest& request, const std::stop_token& stop) {
    std::vector<glm::dvec2> places = request.placer == PlacerKind::figure8
                                         ? figure8_dots(tile, density, request.count, stop)
                                         : exact_dots(tile, density, request, stop);
    for (glm::dvec2& p : places) {
        p.x += static_cast<double>(turn) / density.width();
        if (p.x >= 1) p.x -= 1;
        p.y = std::min(2 * p.y, 1.0);  // the page's unit is the map's width
    }
    return places;
}

// Samples that are settled, of a map with as many texels that have light. None if stopped.
class SettledSamples {
 public:
    SettledSamples(const EnvironmentMap& map, Grid<float> power, const LightRequest& request)
        : map_(map), power_(std::move(power)), request_(request) {
        take_own_texels();
    }

    std::vector<glm::dvec2> dots(RankedTile& tile, const std::stop_token& stop) const {
        const int turn = turn_of(map_, request_.seed);
        Grid<float> rest(power_.width, power_.height);
        for (int y = 0; y < rest.height; ++y)
            for (int x = 0; x < rest.width; ++x)
                rest.at(x, y) = std::max(power_.at((x + turn) % rest.width, y), 0.0f);
        const float most = std::ranges::max(rest.values);
        for (float& value : rest.values) value /= most;
        LightRequest of_rest = request_;
        of_rest.count -= own_.size();
        return dots_of(Density(std::move(rest), Sides::wrap), turn, tile, of_rest, stop);
    }

    std::vector<LightSample> settled(std::span<const glm::dvec2> dots, const Watch& watch) const {
        std::vector<glm::dvec3> lights;
        for (const glm::dvec2 uv : dots) lights.push_back(direction_of(uv, SphereConvention::openexr));
        const TexelTree tree(map_, power_, request_.threads);
        const auto sums = settle(tree, lights, steps_for(request_.count), watch);
        if (!sums) return {};
        std::vector<LightSample> samples;
        for (const glm::ivec2 texel : own_)
            samples.push_back(sample((glm::dvec2(texel) + 0.5) / glm::dvec2(map_.width(), map_.height()),
                                     glm::dvec3(map_.radiance().at(texel.x, texel.y)),
                                     map_.solid_angle(texel.y)));
        for (std::size_t i = 0; i < lights.size(); ++i)
            samples.push_back(sample(uv_of(lights[i], SphereConvention::openexr),
                                     (*sums)[i].flux / (*sums)[i].solid_angle, (*sums)[i].solid_angle));
        return samples;
    }

 private:
    // More have less to gain, and take longer.
    static int steps_for(std::uint64_t count) { return count <= 10'000 ? 8 : count <= 100'000 ? 4 : 2; }

    LightSample sample(glm::dvec2 uv, const glm::dvec3& radiance, double solid_angle) const {
        return {uv, radiance * solid_angle, radiance,
                1 / (solid_angle * static_cast<double>(request_.count))};
    }

    // A texel that has as much power as a sample is to have, or more, is a sample's alone, and so on with
    // what is left; one sample at least is for the others.
    void take_own_texels() {
        while (own_.size() + 1 < request_.count) {
            double rest = 0;
            for (const float power : power_.values) rest += std::max(power, 0.0f);
            const double share = rest / static_cast<double>(request_.count - own_.size());
            std::vector<glm::ivec2> found;
            for (int y = 0; y < power_.height; ++y)
                for (int x = 0; x < power_.width; ++x)
                    if (power_.at(x, y) > 0 && power_.at(x, y) >= share) found.emplace_back(x, y);
            std::ranges::stable_sort(found, std::ranges::greater{},
                                     [&](glm::ivec2 texel) { return power_.at(texel.x, texel.y); });
            found.resize(std::min<std::size_t>(found.size(), request_.count - own_.size() - 1));
            if (found.empty()) return;
            for (const glm::ivec2 texel : found) power_.at(texel.x, texel.y) = -1;
            own_.insert(own_.end(), found.begin(), found.end());
        }
    }

    const EnvironmentMap& map_;
    Grid<float> power_;  // of the texels that are no sample's alone; below 0 for those
    const LightRequest& request_;
    std::vector<glm::ivec2> own_;
};

}  // namespace

std::vector<glm::dvec2> light_dots(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                                   const std::stop_token& stop) {
    check_count(request.count);
    const int turn = turn_of(map, request.seed);
    return dots_of(light_density(map, request.importance, turn), turn, tile, request, stop);
}

namespace {

LightSamples as_placed(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                       const Watch& watch) {
    if (request.radiance == SampleRadiance::point && request.position != SamplePosition::random)
        throw std::runtime_error(
            "the radiance at a sample's point needs a random position: other points have no density");
    LightSamples result{.position = request.position,
                        .radiance = request.radiance,
                        .order = request.order,
                        .seed = request.seed,
                        .total_flux = map.total_flux()};
    check_count(request.count);
    const Clock::time_point placing = Clock::now();
    const Grid<float> power = light_density(map, request.importance).values();
    const auto lit = std::ranges::count_if(power.values, [](float value) { return value > 0; });
    std::optional<SettledSamples> settling;
    if (request.position == SamplePosition::settled && static_cast<std::uint64_t>(lit) >= request.count)
        settling.emplace(map, power, request);
    const std::vector<glm::dvec2> dots =
        settling ? settling->dots(tile, watch.stop) : light_dots(map, tile, request, watch.stop);
    if (!watch.goes_on(kPlacingShare)) return result;
    result.place_ms = ms_since(placing);

    const Clock::time_point sharing = Clock::now();
    const bool drawn = request.position == SamplePosition::random;
    const Watch while_sharing{
        watch.stop, [&watch](double share) { watch.goes_on(kPlacingShare + (1 - kPlacingShare) * share); }};
    if (settling) {
        result.samples = settling->settled(dots, while_sharing);
        result.share_ms = ms_since(sharing);
        return result;
    }
    const std::vector<LightRegion> regions =
        share_light(map, power, dots, drawn ? std::optional(request.seed) : std::nullopt, while_sharing);
    if (regions.empty()) return result;
    result.samples.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const LightRegion& region = regions[i];
        LightSample& sample = result.samples[i];
        sample.uv = dots[i];
        if (request.position == SamplePosition::settled && glm::length(region.moment) > 0)
            sample.uv = uv_of(region.moment, SphereConvention::openexr);
        if (request.position == SamplePosition::random && region.power > 0) sample.uv = region.drawn;
        sample.weight = region.flux;
        sample.radiance = region.flux / region.solid_angle;
        double density = 1 / region.solid_angle;
        if (request.radiance == SampleRadiance::point && region.power > 0) {
            sample.radiance = map.at(sample.uv);
            const glm::ivec2 texel(sample.uv * glm::dvec2(power.width, power.height));
            density = power.at(texel.x, texel.y) / (map.solid_angle(texel.y) * region.power);
        }
        sample.pdf = density / static_cast<double>(dots.size());
    }
    result.share_ms = ms_since(sharing);
    return result;
}

}  // namespace

LightSamples light_samples(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                           const Watch& watch) {
    LightSamples lights = as_placed(map, tile, request, watch);
    if (request.order == LightOrder::placed) return lights;
    std::vector<LightSample> ordered;
    ordered.reserve(lights.samples.size());
    for (const std::uint32_t number : priority_order(lights.samples))
        ordered.push_back(lights.samples[number]);
    lights.samples = std::move(ordered);
    return lights;
}

bool meets_itself(const Tile& tile) {
    return std::ranges::any_of(legal_neighbours(tile.rule, tile.next_kind), [](const Neighbour& neighbour) {
        return neighbour.of == 0 && neighbour.kind == 0 && neighbour.offset == glm::ivec2(1, 0) &&
               neighbour.orientation == Orientation{};
    });
}

}  // namespace dapple
