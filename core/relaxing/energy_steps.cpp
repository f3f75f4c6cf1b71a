#include "core/relaxing/energy_steps.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "core/relaxing/dot_rows.h"

namespace dapple {

namespace {

// Kernels end where the product of two is e^-7 of its middle.
constexpr float kEnd = 7;
// In distances between dots.
constexpr float kLongest = 0.35f;
// The widest two kernels, in rows squared: they end with the rows that are looked at.
constexpr float kMostVariance = EnergySteps::kFarthestRow * EnergySteps::kFarthestRow / (2 * kEnd);

static_assert(EnergySteps::kLongestStep * EnergySteps::kLongestStep >
              kLongest * kLongest * kMostVariance / (2 * kPictureKernel * kPictureKernel));

constexpr float kLeastDensity = 1e-6f;
// In standard deviations: farther in, nothing of an edge is felt, wherever it waves to.
constexpr float kDeviationsFromEdge = 5;

// Where one side is a hundred times as dense as the other, what a blur lacks of a Gaussian pulls on dots of
// the sparse side as hard as they push each other.
constexpr BlurQuality kForSamples{.octave = 8, .most_pixels = 5};

constexpr int kLanes = 8;
typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float))));
typedef std::int32_t LaneMask __attribute__((vector_size(kLanes * sizeof(float))));

// What kernels push, lane by lane, so that sums are the same with vectors of any width. Weighed by areas, or
// all alike, which takes less time.
template <bool kWeighed>
class Pushes {
 public:
    Pushes(float x, float y, float variance)
        : x_(x), y_(y), per_variance_(-0.5f / variance), end2_(2 * kEnd * variance) {}

    void add(float x, float y, float area) {
        near_x_[held_] = x;
        near_y_[held_] = y;
        if constexpr (kWeighed) area_[held_] = area;
        if (++held_ == kRoom) push();
    }

    float sum_x() {
        push();
        return sum(push_x_);
    }
    float sum_y() {
        push();
        return sum(push_y_);
    }

 private:
    void push() {
        for (std::size_t i = held_; i % kLanes != 0; ++i) {
            near_x_[i] = x_, near_y_[i] = y_;  // pushes nothing
            if constexpr (kWeighed) area_[i] = 0;
        }
        for (std::size_t i = 0; i < held_; i += kLanes) {
            Lanes x, y;
            std::memcpy(&x, near_x_ + i, sizeof x);
            std::memcpy(&y, near_y_ + i, sizeof y);
            x = x_ - x;
            y = y_ - y;
            const Lanes distance2 = x * x + y * y;
            Lanes weight = distance2 * per_variance_;
            take_exponential(weight);
            const LaneMask near = distance2 < end2_;
            weight = (Lanes)((LaneMask)weight & near);
            if constexpr (kWeighed) {
                Lanes area;
                std::memcpy(&area, area_ + i, sizeof area);
                weight *= area;
            }
            push_x_ += weight * x;
            push_y_ += weight * y;
        }
        held_ = 0;
    }

    static float sum(const Lanes& v) {
        return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
    }

    static constexpr std::size_t kRoom = 128;
    static_assert(kRoom % kLanes == 0);
    const float x_, y_, per_variance_, end2_;
    Lanes push_x_{}, push_y_{};
    std::size_t held_ = 0;
    float near_x_[kRoom], near_y_[kRoom], area_[kWeighed ? kRoom : 1];
};

}  // namespace

BlurredDensity blurred_for_kernels(const Density& density, double scale, float kernel,
                                   const DotAreas& areas) {
    const PageRows page(density, scale);
    const double pixels2 = page.pixels * page.pixels;
    const float on_black = 2 * kernel * kernel * page.spacing * page.spacing;
    Grid<float> ink = density.values();
    if (areas.differ()) {
        const double longer = density.longer_side();
        for (int y = 0; y < ink.height; ++y) {
            float* const row = ink.row(y);
            for (int x = 0; x < ink.width; ++x)
                row[x] *= areas.at(row[x], glm::dvec2(x + 0.5, y + 0.5) / longer);
        }
    }
    const float narrowest = on_black / areas.finer.most_times();
    return {std::move(ink), std::min(narrowest, kMostVariance) * pixels2, kMostVariance * pixels2,
            kernel == kSampleKernel ? kForSamples : BlurQuality{}};
}

float ink_for(const Density& density, double scale, float kernel, double dots) {
    const PageRows page(density, scale);
    const double black = 1 / (page.spacing * page.spacing);  // dots on a square row
    const float most_apart = std::sqrt(kMostVariance / 2) / kernel;
    double ink = expected_dots(density, scale);
    const auto add_edge = [&](float length, const auto& place_of) {
        const int steps = 4 * static_cast<int>(length) + 1;
        for (int i = 0; i < steps; ++i) {
            const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(steps) * length;
            const auto tone = static_cast<float>(density.at(place_of(along)));
            const float apart = std::min(page.spacing / std::sqrt(std::max(tone, kLeastDensity)), most_apart);
            const float beyond = beyond_edge(kWavesOfDensity, (along - length / 2) / apart, tone) * apart;
            ink += black * tone * beyond * length / steps;
        }
    };
    for (const float y : {0.0f, std::nextafter(page.height, 0.0f)})
        add_edge(page.width, [&](float x) { return page.place(x, y); });
    for (const float x : {0.0f, std::nextafter(page.width, 0.0f)})
        add_edge(page.height, [&](float y) { return page.place(x, y); });
    return static_cast<float>(dots / std::max(ink, dots / 2));
}

template <bool kWeighed>
DotStep EnergySteps::by_dots(float x, float y, float variance) {
    const float reach = std::sqrt(2 * kEnd * variance);
    const float from = x - reach, to = x + reach;
    const float in_rows = y - static_cast<float>(rows_.first_row());
    const auto first = std::max(static_cast<std::int64_t>(std::floor(in_rows - reach)), cursors_.first());
    const auto last = std::min(static_cast<std::int64_t>(std::floor(in_rows + reach)), cursors_.end() - 1);
    const float *const xs = rows_.x.data(), *const ys = rows_.y.data();
    const float* const areas = rows_.areas.data();
    Pushes<kWeighed> pushes(x, y, variance);
    for (std::int64_t near = first; near <= last; ++near) {
        std::size_t& cursor = cursors_.at(near);
        const std::size_t begin = rows_.begin(near), end = rows_.end(near);
        while (cursor < end && xs[cursor] < from) ++cursor;
        while (cursor > begin && xs[cursor - 1] >= from) --cursor;
        for (std::size_t i = cursor; i < end && xs[i] <= to; ++i)
            pushes.add(xs[i], ys[i], kWeighed ? areas[i] : 1);
    }
    return {pushes.sum_x(), pushes.sum_y()};
}

DotStep EnergySteps::slope(float x, float y, const Kernels& kernels, float tone) const {
    const auto pixels = static_cast<float>(page_.pixels);
    const BlurredDensity::Slope seen =
        blurred_.at(x * page_.pixels, y * page_.pixels, kernels.variance * pixels * pixels);
    float share = 1, slope_x = 0, slope_y = 0;
    const float deviation = std::sqrt(kernels.variance);
    const auto end = [&](float away, float from_middle, float inwards, float& slope) {
        if (away > kDeviationsFromEdge * deviation) return;
        const float beyond = beyond_edge(kWavesOfDensity, from_middle / kernels.apart, tone) * kernels.apart;
        const BlurredStep step((away + beyond) / deviation);
        slope += inwards * step.slope / (deviation * step.value);
        share *= step.value;
    };
    const float across = x - page_.width / 2, down = y - page_.height / 2;
    end(x, down, 1, slope_x);
    end(page_.width - x, down, -1, slope_x);
    end(y, across, 1, slope_y);
    end(page_.height - y, across, -1, slope_y);
    return {share * (seen.x * pixels + seen.value * slope_x),
            share * (seen.y * pixels + seen.value * slope_y)};
}

DotStep EnergySteps::step(std::size_t dot, float stride) {
    const float x = rows_.x[dot], y = rows_.y[dot];
    const float tone = areas_.tone_of(blurred_.sharpest(x * page_.pixels, y * page_.pixels));
    const float density = tone * areas_.finer.times_at(page_.place(x, y));
    const float on_black2 = page_.spacing * page_.spacing;
    Kernels kernels;
    kernels.variance =
        std::min(2 * kernel_ * kernel_ * on_black2 / std::max(density, kLeastDensity), kMostVariance);
    kernels.apart = std::sqrt(kernels.variance / 2) / kernel_;
    const DotStep dots =
        areas_.differ() ? by_dots<true>(x, y, kernels.variance) : by_dots<false>(x, y, kernels.variance);
    const DotStep rise = slope(x, y, kernels, tone);
    const float ink = ink_ * 2 * std::numbers::pi_v<float> * kernels.variance * kernels.variance / on_black2;
    // The energy bends most along waves as long as kernels are wide.
    stride *= (kPictureKernel / kernel_) * (kPictureKernel / kernel_);
    // Around a dot others are about as large, so that forces are as much stronger or weaker.
    if (areas_.differ()) stride /= rows_.areas[dot];
    DotStep step{stride * (dots.x + ink * rise.x), stride * (dots.y + ink * rise.y)};
    const float most = kLongest * kernels.apart, length2 = step.x * step.x + step.y * step.y;
    if (length2 > most * most) {
        const float shorter = most / std::sqrt(length2);
        step.x *= shorter;
        step.y *= shorter;
    }
    return step;
}

}  // namespace dapple
