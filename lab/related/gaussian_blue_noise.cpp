#include "lab/related/gaussian_blue_noise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>

#include "core/analysis/point_grid.h"
#include "core/image/grid.h"
#include "lab/related/plain_lloyd.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

constexpr double kEnd = 9;             // a kernel ends at e^-kEnd of its middle
constexpr double kLongestStep = 0.35;  // in distances between dots
constexpr double kLeastShare = 0.02;   // of the mean density
// A stride in fourth powers of a kernel's deviation: one twice as long would overshoot the energy's steepest
// waves.
constexpr double kStride = 2 * 0.45 * 0.45 / (kGaussianKernel * kGaussianKernel);

// What a Gaussian of that variance so far away pushes by.
glm::dvec2 push(glm::dvec2 offset, double variance) {
    return -offset * std::exp(-glm::dot(offset, offset) / (2 * variance)) / (variance * variance);
}

double mirrored(double at, double length) {
    at = std::abs(at);
    return std::clamp(at > length ? 2 * length - at : at, 0.0, length);
}

// The wanted dots as many small masses, on a lattice over the page and its mirror images.
class Masses {
 public:
    Masses(const Density& density, std::size_t count, double pitch)
        : masses_(int(std::ceil(density.width() / double(density.longer_side()) / pitch)),
                  int(std::ceil(density.height() / double(density.longer_side()) / pitch))) {
        const double longer = density.longer_side();
        width_ = density.width() / longer / masses_.width;
        height_ = density.height() / longer / masses_.height;
        double sum = 0;
        for (int y = 0; y < masses_.height; ++y)
            for (int x = 0; x < masses_.width; ++x)
                sum += masses_.at(x, y) = float(density.at({(x + 0.5) * width_, (y + 0.5) * height_}));
        for (float& mass : masses_.values) mass *= float(double(count) / std::max(sum, 1e-300));
    }

    // What all of them push by.
    glm::dvec2 push_at(glm::dvec2 at, double variance, double reach) const {
        glm::dvec2 force(0);
        const auto last = [](double end, double side) { return int(std::floor(end / side - 0.5)); };
        for (int y = last(at.y - reach, height_) + 1; y <= last(at.y + reach, height_); ++y) {
            const float* const row = masses_.row(inside(y, masses_.height));
            for (int x = last(at.x - reach, width_) + 1; x <= last(at.x + reach, width_); ++x) {
                const glm::dvec2 offset((x + 0.5) * width_ - at.x, (y + 0.5) * height_ - at.y);
                force += double(row[inside(x, masses_.width)]) * push(offset, variance);
            }
        }
        return force;
    }

 private:
    static int inside(int i, int length) {
        const int period = 2 * length, in = ((i % period) + period) % period;
        return std::min(in, period - 1 - in);
    }

    Grid<float> masses_;
    double width_ = 1, height_ = 1;  // of a place on the lattice
};

// All dots, and of a picture's those that a mirror on its edges shows as far as kernels reach.
class Neighbours {
 public:
    Neighbours(const PlainDots& dots, const DotsWanted& wanted, double margin)
        : margin_(wanted.density ? margin : 0), grid_(with_images(dots, wanted), domain(wanted)) {}

    template <class Visit>
    void for_each_within(glm::dvec2 centre, double radius, const Visit& visit) const {
        grid_.for_each_within(centre + margin_, radius,
                              [&](std::uint32_t, glm::dvec2 offset) { visit(offset); });
    }

 private:
    Domain domain(const DotsWanted& wanted) const {
        if (!wanted.density) return {};
        const glm::dvec2 page = page_of(wanted);
        return {page.x + 2 * margin_, page.y + 2 * margin_, Topology::window};
    }
    PlainDots with_images(const PlainDots& dots, const DotsWanted& wanted) const {
        if (!wanted.density) return dots;
        const glm::dvec2 page = page_of(wanted), all = page + 2 * margin_;
        PlainDots result;
        for (const glm::dvec2 dot : dots) {
            for (const double x : {dot.x, -dot.x, 2 * page.x - dot.x}) {
                for (const double y : {dot.y, -dot.y, 2 * page.y - dot.y}) {
                    const glm::dvec2 at = glm::dvec2(x, y) + margin_;
                    if (at.x >= 0 && at.y >= 0 && at.x <= all.x && at.y <= all.y) result.push_back(at);
                }
            }
        }
        return result;
    }

    double margin_;
    PointGrid grid_;
};

}  // namespace

PlainDots gaussian_blue_noise(const DotsWanted& wanted) {
    PlainDots dots =
        wanted.density ? random_dots(*wanted.density, wanted.count, wanted.seed) : white_noise(wanted);
    const glm::dvec2 page = page_of(wanted);
    const double mean = double(wanted.count) / (page.x * page.y);  // dots on an area
    const double in_black =
        wanted.density ? double(wanted.count) / std::max(wanted.density->mean(), 1e-12) : mean;
    const auto sigma_for = [](double dots_on_area) { return kGaussianKernel / std::sqrt(dots_on_area); };
    const auto reach_of = [](double sigma) { return std::sqrt(2 * kEnd * 2) * sigma; };
    const double margin = std::min({reach_of(sigma_for(kLeastShare * mean)), page.x, page.y});
    std::optional<Masses> masses;
    if (wanted.density) masses.emplace(*wanted.density, wanted.count, sigma_for(in_black));
    for (int step = 0; step < kGaussianSteps; ++step) {
        if (wanted.stop.stop_requested()) return {};
        const Neighbours neighbours(dots, wanted, margin);
        PlainDots moved(dots.size());
        tbb::parallel_for(std::size_t{0}, dots.size(), [&](std::size_t i) {
            const glm::dvec2 dot = dots[i];
            double here = mean;
            if (wanted.density) {
                const glm::dvec2 last = page * (1 - 1e-9);  // beyond it there is no density
                here = std::max(in_black * wanted.density->at(glm::min(dot, last)), kLeastShare * mean);
            }
            const double sigma = sigma_for(here), variance = 2 * sigma * sigma;
            const double reach = std::min(reach_of(sigma), wanted.density ? margin : 0.5);
            glm::dvec2 force(0);
            neighbours.for_each_within(dot, reach,
                                       [&](glm::dvec2 offset) { force += push(offset, variance); });
            if (masses) force -= masses->push_at(dot, variance, reach);
            glm::dvec2 move = kStride * std::pow(sigma, 4) * force;
            move *= std::min(1.0, kLongestStep / std::sqrt(here) / std::max(glm::length(move), 1e-300));
            moved[i] = wanted.density
                           ? glm::dvec2(mirrored(dot.x + move.x, page.x), mirrored(dot.y + move.y, page.y))
                           : on_unit_torus(dot + move);
        });
        dots.swap(moved);
    }
    return dots;
}

}  // namespace dapple
