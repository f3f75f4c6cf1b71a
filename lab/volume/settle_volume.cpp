#include "lab/volume/settle_volume.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "core/maths/portable_math.h"
#include "lab/volume/space_cells.h"

namespace dapple {
namespace {

constexpr double kKernel = 0.45, kStride = 2, kFurthest = 0.35;
constexpr double kCutSquared = 14;  // over s^2

// Blurred along one axis; beyond the ends there is nothing.
void blur_axis(Volume& volume, int axis, double sigma) {
    const int reach = static_cast<int>(std::ceil(4 * sigma)), length = volume.size[axis];
    std::vector<float> kernel;
    for (int i = -reach; i <= reach; ++i)
        kernel.push_back(static_cast<float>(portable::exp(-i * i / (2 * sigma * sigma))));
    const float sum = std::accumulate(kernel.begin(), kernel.end(), 0.0f);
    for (float& each : kernel) each /= sum;
    const std::size_t stride = axis == 0   ? 1
                               : axis == 1 ? static_cast<std::size_t>(volume.size.x)
                                           : static_cast<std::size_t>(volume.size.x) * volume.size.y;
    const std::size_t lines = volume.density.size() / static_cast<std::size_t>(length);
    tbb::parallel_for(std::size_t{0}, lines, [&](std::size_t line) {
        float* const first = volume.density.data() + line / stride * stride * length + line % stride;
        std::vector<float> before(static_cast<std::size_t>(length));
        for (int i = 0; i < length; ++i) before[i] = first[i * stride];
        for (int i = 0; i < length; ++i) {
            float value = 0;
            for (int k = std::max(-reach, -i); k <= std::min(reach, length - 1 - i); ++k)
                value += kernel[k + reach] * before[i + k];
            first[i * stride] = value;
        }
    });
}

Volume blurred(const Volume& volume, double sigma) {
    Volume copy = volume;
    if (sigma > 0.2)
        for (int axis = 0; axis < 3; ++axis) blur_axis(copy, axis, sigma);
    return copy;
}

// Between the middles of voxels, beyond which there is nothing.
double interpolated(const Volume& volume, const glm::dvec3& place) {
    const glm::dvec3 low = glm::floor(place - 0.5), part = place - 0.5 - low;
    double value = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 up(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 share = glm::mix(1.0 - part, part, up);
        value += share.x * share.y * share.z * volume.at(low + up + 0.5);
    }
    return value;
}

// The density as it is felt by kernels of any width: copies blurred by a ladder of widths.
class BlurredVolume {
 public:
    BlurredVolume(const Volume& volume, double least, double most) : least_(least) {
        for (double sigma = least;; sigma *= kLadder) {
            copies_.push_back(blurred(volume, sigma));
            if (sigma >= most || copies_.size() == 12) break;
        }
    }

    glm::dvec3 slope(const glm::dvec3& place, double sigma) const {
        const double rung = std::clamp(portable::log(sigma / least_) / portable::log(kLadder), 0.0,
                                       static_cast<double>(copies_.size() - 1));
        const auto low = static_cast<std::size_t>(rung);
        const std::size_t high = std::min(low + 1, copies_.size() - 1);
        return glm::mix(slope_of(copies_[low], place), slope_of(copies_[high], place),
                        rung - static_cast<double>(low));
    }

 private:
    static constexpr double kLadder = 1.5;

    static glm::dvec3 slope_of(const Volume& copy, const glm::dvec3& place) {
        glm::dvec3 slope;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0);
            step[axis] = 0.5;
            slope[axis] = interpolated(copy, place + step) - interpolated(copy, place - step);
        }
        return slope;
    }

    double least_;
    std::vector<Volume> copies_;
};

}  // namespace

void settle(std::vector<glm::dvec3>& dots, const Volume& volume, int steps, const VolumeProgress& progress) {
    if (dots.size() < 2 || steps == 0) return;
    const double sum = std::accumulate(volume.density.begin(), volume.density.end(), 0.0);
    const double dots_per_density = static_cast<double>(dots.size()) / sum;
    const auto filled = std::count_if(volume.density.begin(), volume.density.end(),
                                      [](float density) { return density > 0; });
    const double mean = sum / static_cast<double>(filled);
    // Widths follow the density a little smoothed, so that they do not jump, and never grow beyond bounds.
    const double spacing = std::cbrt(1 / (mean * dots_per_density));
    const Volume smooth = blurred(volume, spacing / 2);
    const auto sigma_at = [&](const glm::dvec3& place) {
        return kKernel / std::cbrt(std::max(interpolated(smooth, place), 0.02 * mean) * dots_per_density);
    };
    double least = 1e30, most = 0;
    for (const glm::dvec3& dot : dots) {
        least = std::min(least, sigma_at(dot));
        most = std::max(most, sigma_at(dot));
    }
    const BlurredVolume field(volume, std::sqrt(2.0) * least, std::sqrt(2.0) * most);
    const double field_weight = portable::pow(2 * std::numbers::pi, 1.5) * dots_per_density;
    std::vector<glm::dvec3> moved(dots.size());
    for (int step = 0; step < steps; ++step) {
        const SpaceCells cells(dots, {glm::dvec3(0), glm::dvec3(volume.size)}, std::max(spacing, 0.05));
        tbb::parallel_for(std::size_t{0}, dots.size(), [&](std::size_t i) {
            const glm::dvec3 place = dots[i];
            const double sigma = sigma_at(place), squared = 2 * sigma * sigma, s = std::sqrt(squared);
            glm::dvec3 force(0);
            cells.near(place, s * std::sqrt(kCutSquared), [&](std::uint32_t j) {
                const glm::dvec3 apart = place - dots[j];
                const double far = glm::dot(apart, apart);
                if (far < kCutSquared * squared) force += apart * portable::exp(-far / (2 * squared));
            });
            force = force / portable::pow(s, 5) + field_weight * field.slope(place, s);
            glm::dvec3 way = kStride * portable::pow(sigma, 5) * force;
            const double furthest = kFurthest / kKernel * sigma, length = glm::length(way);
            if (length > furthest) way *= furthest / length;
            // Back where there is no density: half as far, or not at all.
            moved[i] = volume.at(place + way) > 0         ? place + way
                       : volume.at(place + way / 2.0) > 0 ? place + way / 2.0
                                                          : place;
        });
        dots.swap(moved);
        if (progress && !progress(step + 1)) return;
    }
}

}  // namespace dapple
