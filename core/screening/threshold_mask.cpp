#include "core/screening/threshold_mask.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/failure.h"
#include "core/maths/portable_math.h"
#include "core/tile/random.h"

namespace dapple {

namespace {

constexpr double kUnit = 1 << 20;         // of energy: what an inked pixel has of itself
constexpr std::uint32_t kNoise = 1024;    // of it that each pixel has from the start, so that few are equal
constexpr std::int32_t kInked = 1 << 30;  // more than any energy: what an inked pixel has more

// An axis of the Gaussian on a circle of so many pixels: what is felt so many pixels before and behind, from
// `first` on. All images of a pixel count.
struct Axis {
    int first = 0;
    std::vector<double> value;
};

Axis axis_of(int side, double sigma) {
    const int reach = static_cast<int>(std::ceil(sigma * std::sqrt(2 * portable::log(2 * kUnit))));
    const int length = std::min(2 * reach + 1, side);
    Axis axis{.first = -(length / 2), .value = std::vector<double>(static_cast<std::size_t>(length))};
    for (int at = -reach; at <= reach; ++at) {
        const int place = ((at - axis.first) % side + side) % side;
        if (place < length)
            axis.value[static_cast<std::size_t>(place)] += portable::exp(-at * at / (2 * sigma * sigma));
    }
    return axis;
}

// The least or the greatest of many numbers, of which few change at a time.
template <class Better>
class Best {
 public:
    explicit Best(const std::vector<std::int32_t>& values) : values_(values) {
        blocks_.resize((values.size() + kBlock - 1) / kBlock);
        groups_.resize((blocks_.size() + kBlock - 1) / kBlock);
        for (std::size_t block = 0; block < blocks_.size(); ++block) blocks_[block] = best_of(values_, block);
        for (std::size_t group = 0; group < groups_.size(); ++group) groups_[group] = best_of(blocks_, group);
    }

    /// Some of the values from `first` to `last`, both included, are others.
    void update(std::size_t first, std::size_t last) {
        first /= kBlock;
        last /= kBlock;
        for (std::size_t block = first; block <= last; ++block) blocks_[block] = best_of(values_, block);
        stale_.push_back(static_cast<std::uint32_t>(first / kBlock));
        if (last / kBlock != first / kBlock) stale_.push_back(static_cast<std::uint32_t>(last / kBlock));
    }

    std::size_t place() {
        std::uint32_t before = std::numeric_limits<std::uint32_t>::max();
        for (const std::uint32_t group : stale_)
            if (group != std::exchange(before, group)) groups_[group] = best_of(blocks_, group);
        stale_.clear();
        const auto best = std::ranges::min_element(groups_, Better());
        return find(values_, find(blocks_, static_cast<std::size_t>(best - groups_.begin()), *best), *best);
    }

 private:
    static constexpr std::size_t kBlock = 64;

    static std::int32_t best_of(const std::vector<std::int32_t>& values, std::size_t block) {
        const std::size_t end = std::min(values.size(), (block + 1) * kBlock);
        std::int32_t best = values[block * kBlock];
        for (std::size_t i = block * kBlock; i < end; ++i)
            best = Better()(values[i], best) ? values[i] : best;
        return best;
    }
    static std::size_t find(const std::vector<std::int32_t>& values, std::size_t block, std::int32_t value) {
        std::size_t i = block * kBlock;
        while (values[i] != value) ++i;
        return i;
    }

    const std::vector<std::int32_t>& values_;
    std::vector<std::int32_t> blocks_, groups_;
    std::vector<std::uint32_t> stale_;  // groups
};

class Energies {
 public:
    Energies(const ThresholdSize& size, const VoidAndClusterOptions& options)
        : size_(size),
          across_(axis_of(size.width, options.sigma)),
          down_(axis_of(size.height, options.sigma)),
          along_(axis_of(size.slices, options.slice_sigma)),
          energy_(noise(size, options.seed)),
          least_(energy_),
          most_(energy_) {
        for (const double y : down_.value)
            for (const double x : across_.value)
                kernel_.push_back(static_cast<std::int32_t>(std::lround(kUnit * x * y)));
    }
    Energies& operator=(Energies&&) = delete;

    void ink(std::size_t pixel) { change(pixel, 1); }
    void clear(std::size_t pixel) { change(pixel, -1); }

    /// The bare pixel of least energy, and the inked one of most.
    std::size_t void_place() { return least_.place(); }
    std::size_t cluster() { return most_.place(); }

    /// Clusters are not asked for any more, which saves half of the time.
    void forget_clusters() { clusters_ = false; }

 private:
    static std::vector<std::int32_t> noise(const ThresholdSize& size, std::uint64_t seed) {
        Random random(seed);
        std::vector<std::int32_t> energy(size.all());
        for (std::int32_t& each : energy) each = static_cast<std::int32_t>(random.below(kNoise));
        return energy;
    }

    void change(std::size_t pixel, std::int32_t by) {
        const std::size_t row = pixel / size_.width, slice = row / size_.height;
        const int x = static_cast<int>(pixel % size_.width), y = static_cast<int>(row % size_.height);
        const auto wrapped = [](int at, int side) { return ((at % side) + side) % side; };
        energy_[pixel] += by * kInked;
        const int left = wrapped(x + across_.first, size_.width);
        const int length = static_cast<int>(across_.value.size()),
                  before_edge = std::min(length, size_.width - left);
        const std::int32_t* kernel = kernel_.data();
        for (std::size_t k = 0; k < down_.value.size(); ++k, kernel += length) {
            const int there = wrapped(y + down_.first + static_cast<int>(k), size_.height);
            const std::size_t begin = (slice * size_.height + there) * size_.width;
            add(begin + left, {kernel, static_cast<std::size_t>(before_edge)}, by);
            if (before_edge < length)
                add(begin, {kernel + before_edge, static_cast<std::size_t>(length - before_edge)}, by);
        }
        for (std::size_t k = 0; k < along_.value.size(); ++k) {
            const int there =
                wrapped(static_cast<int>(slice) + along_.first + static_cast<int>(k), size_.slices);
            if (there == static_cast<int>(slice)) continue;
            const auto felt = static_cast<std::int32_t>(std::lround(kUnit * along_.value[k]));
            add(there * size_.of_slice() + pixel % size_.of_slice(), {&felt, 1}, by);
        }
    }

    void add(std::size_t first, std::span<const std::int32_t> felt, std::int32_t by) {
        for (std::size_t i = 0; i < felt.size(); ++i) energy_[first + i] += by * felt[i];
        least_.update(first, first + felt.size() - 1);
        if (clusters_) most_.update(first, first + felt.size() - 1);
    }

    ThresholdSize size_;
    Axis across_, down_, along_;
    std::vector<std::int32_t> kernel_;  // row after row
    std::vector<std::int32_t> energy_;
    Best<std::less<>> least_;
    Best<std::greater<>> most_;
    bool clusters_ = true;
};

// A few pixels, a tenth of all, as evenly as they can lie.
std::vector<std::size_t> first_pixels(Energies& energies, std::size_t all, std::uint64_t seed) {
    std::vector<std::size_t> pixels(all);
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    Random random(seed + 1);
    const std::size_t count = std::max<std::size_t>(all / 10, 1);
    for (std::size_t i = 0; i < count; ++i) std::swap(pixels[i], pixels[i + random.below(all - i)]);
    pixels.resize(count);
    std::vector<bool> inked(all);
    for (const std::size_t pixel : pixels) {
        energies.ink(pixel);
        inked[pixel] = true;
    }
    while (true) {
        const std::size_t from = energies.cluster();
        energies.clear(from);
        const std::size_t to = energies.void_place();
        energies.ink(to);
        inked[from] = false;
        inked[to] = true;
        if (to == from) break;
    }
    pixels.clear();
    for (std::size_t pixel = 0; pixel < all; ++pixel)
        if (inked[pixel]) pixels.push_back(pixel);
    return pixels;
}

// Along a pixel's side, where it is asked how much of the paper printed pixels cover together.
constexpr int kParts = 8;

std::vector<std::uint32_t> pixels_by_rank(const ThresholdMask& mask, int slice) {
    std::vector<std::uint32_t> pixels(mask.size.of_slice());
    const std::size_t first = pixels.size() * static_cast<std::size_t>(slice);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[mask.ranks[first + i]] = static_cast<std::uint32_t>(i);
    return pixels;
}

// What a printed pixel covers of a pixel so far away from it, as far as its ink reaches: one bit for each
// part.
using Parts = std::bitset<kParts * kParts>;
Parts covered_parts(int dx, int dy, double gain) {
    // The square, rounded at its corners by the gain.
    const auto beyond = [](double at) { return std::max({-at, at - 1, 0.0}); };
    Parts parts;
    for (int y = 0; y < kParts; ++y)
        for (int x = 0; x < kParts; ++x)
            parts[static_cast<std::size_t>(y * kParts + x)] =
                std::hypot(beyond(dx + (x + 0.5) / kParts), beyond(dy + (y + 0.5) / kParts)) <= gain;
    return parts;
}

// Ranks over a whole mask's pixels, any distinct numbers, become those within each slice.
ThresholdMask mask_by_order(const ThresholdSize& size, const std::vector<std::uint32_t>& order) {
    ThresholdMask mask{size, std::vector<std::uint32_t>(size.all())};
    std::vector<std::uint32_t> pixels(size.of_slice());
    for (int slice = 0; slice < size.slices; ++slice) {
        const std::size_t first = pixels.size() * static_cast<std::size_t>(slice);
        std::iota(pixels.begin(), pixels.end(), 0u);
        std::ranges::sort(pixels, {}, [&](std::uint32_t pixel) { return order[first + pixel]; });
        for (std::size_t rank = 0; rank < pixels.size(); ++rank)
            mask.ranks[first + pixels[rank]] = static_cast<std::uint32_t>(rank);
    }
    return mask;
}

}  // namespace

ThresholdMask void_and_cluster(const ThresholdSize& size, const VoidAndClusterOptions& options,
                               const MaskProgress& progress) {
    check_threshold_size(size);
    if (!(options.sigma >= 0.5 && options.sigma <= 4))
        throw failure("sigma {:g}: it is 0.5 to 4 pixels", options.sigma);
    if (!(options.slice_sigma >= 0.5 && options.slice_sigma <= 8))
        throw failure("sigma {:g} of slices: it is 0.5 to 8", options.slice_sigma);
    const std::size_t all = size.all();
    Energies energies(size, options);
    const std::vector<std::size_t> first = first_pixels(energies, all, options.seed);
    constexpr std::size_t kTold = 1 << 14;
    std::vector<std::uint32_t> order(all);
    for (std::size_t rank = first.size(); rank-- > 0;) {
        const std::size_t pixel = energies.cluster();
        energies.clear(pixel);
        order[pixel] = static_cast<std::uint32_t>(rank);
    }
    for (const std::size_t pixel : first) energies.ink(pixel);
    energies.forget_clusters();
    for (std::size_t rank = first.size(); rank < all; ++rank) {
        if (progress && rank % kTold == 0 && !progress(static_cast<double>(rank) / static_cast<double>(all)))
            return {size, {}};
        const std::size_t pixel = energies.void_place();
        energies.ink(pixel);
        order[pixel] = static_cast<std::uint32_t>(rank);
    }
    return mask_by_order(size, order);
}

ThresholdMask tile_mask(RankedTile& tile, int side) {
    constexpr int kMostSide = 2048;
    if (side < 4 || side > kMostSide)
        throw failure("{} pixels: the side of a mask from a tile is 4 to {}", side, kMostSide);
    const ThresholdSize size{side, side, 1};
    const Density grey(Grid<float>(1, 1, 1.0f));
    std::vector<float> critical(size.all());  // of each pixel's first dot
    // About so many dots for each pixel: most have one among the first few.
    for (double dots = 8;; dots *= 4) {
        std::ranges::fill(critical, std::numeric_limits<float>::infinity());
        Stippling drawn;
        stipple(tile, grey, PlacerKind::exact,
                {.scale = dots * static_cast<double>(size.all()) / kDotsPerScale,
                 .threads = 0,
                 .thresholds = true},
                drawn);
        for (const Dots& piece : drawn.dots.pieces)
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const auto at = [&](float place) {
                    return std::clamp(static_cast<int>(place * static_cast<float>(side)), 0, side - 1);
                };
                float& first = critical[static_cast<std::size_t>(at(piece.y[i])) * side + at(piece.x[i])];
                first = std::min(first, piece.critical[i]);
            }
        if (std::ranges::find(critical, std::numeric_limits<float>::infinity()) == critical.end()) break;
    }
    std::vector<std::uint32_t> pixels(size.all()), order(size.all());
    std::iota(pixels.begin(), pixels.end(), 0u);
    std::ranges::stable_sort(pixels, {}, [&](std::uint32_t pixel) { return critical[pixel]; });
    for (std::size_t rank = 0; rank < pixels.size(); ++rank)
        order[pixels[rank]] = static_cast<std::uint32_t>(rank);
    return mask_by_order(size, order);
}

void check_threshold_size(const ThresholdSize& size) {
    const auto is_side = [](int side) { return side >= 4 && side <= kMostThresholdSide; };
    if (!is_side(size.width) || !is_side(size.height))
        throw failure("{} x {} pixels: a mask's sides are 4 to {}", size.width, size.height,
                      kMostThresholdSide);
    if (size.slices < 1 || size.slices > kMostThresholdSlices)
        throw failure("{} slices: a mask has 1 to {}", size.slices, kMostThresholdSlices);
    if (size.all() > kMostThresholdPixels)
        throw failure("{} x {} x {} pixels: a mask has at most {} in all", size.width, size.height,
                      size.slices, kMostThresholdPixels);
}

Grid<float> thresholds_of(const ThresholdMask& mask, int slice, double gain) {
    const auto [width, height, slices] = mask.size;
    const auto all = static_cast<double>(mask.size.of_slice());
    Grid<float> thresholds(width, height);
    const std::vector<std::uint32_t> pixels = pixels_by_rank(mask, slice);
    if (gain <= 0) {
        for (std::size_t rank = 0; rank < pixels.size(); ++rank)
            thresholds.values[pixels[rank]] = static_cast<float>((static_cast<double>(rank) + 0.5) / all);
        return thresholds;
    }
    struct Near {
        int dx, dy;
        Parts parts;
    };
    std::vector<Near> neighbours;
    const int reach = static_cast<int>(std::ceil(gain));
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (const Parts parts = covered_parts(dx, dy, gain); parts.any())
                neighbours.push_back({dx, dy, parts});
    Grid<Parts> covered(width, height);
    std::size_t parts = 0;
    for (const std::uint32_t pixel : pixels) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        const std::size_t before = parts;
        for (const Near& neighbour : neighbours) {
            const auto wrapped = [](int at, int side) { return ((at % side) + side) % side; };
            Parts& there = covered.at(wrapped(x + neighbour.dx, width), wrapped(y + neighbour.dy, height));
            parts += (neighbour.parts & ~there).count();
            there |= neighbour.parts;
        }
        thresholds.values[pixel] =
            static_cast<float>(static_cast<double>(before + parts) / 2 / (all * kParts * kParts));
    }
    return thresholds;
}

Grid<float> screened(const Grid<float>& light, const Grid<float>& thresholds) {
    Grid<float> pixels(light.width, light.height);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x) {
            const float ink = 1 - light.at(x, y);
            const bool inked = ink > thresholds.at(x % thresholds.width, y % thresholds.height);
            pixels.at(x, y) = inked ? 0.0f : 1.0f;
        }
    return pixels;
}

std::vector<glm::dvec2> inked_places(const ThresholdMask& mask, std::uint32_t count, int slice) {
    std::vector<glm::dvec2> places;
    for (int y = 0; y < mask.size.height; ++y)
        for (int x = 0; x < mask.size.width; ++x)
            if (mask.rank(x, y, slice) < count) places.emplace_back(x + 0.5, y + 0.5);
    return places;
}

}  // namespace dapple
