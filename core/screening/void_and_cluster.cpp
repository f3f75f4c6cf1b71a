#include "core/screening/void_and_cluster.h"

#include <algorithm>
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
    Energies(const Energies&) = delete;
    Energies& operator=(const Energies&) = delete;

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

}  // namespace dapple
