#include "lab/related/gaussian_blue_noise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "core/analysis/distances.h"
#include "core/image/grid.h"
#include "lab/related/plain_lloyd.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

constexpr double kEnd = 17;            // a kernel ends at e^-kEnd of its middle
constexpr double kLongestStep = 0.35;  // in distances between dots
constexpr double kLeastShare = 0.02;   // of the mean density
// Of a step, over what others push by: the steepest waves of two kernels' energy have 4 pi / e, and momentum
// wants no more than one over that.
constexpr double kStride = 0.2;

// What a Gaussian of that variance so far away pushes by.
glm::dvec2 push(glm::dvec2 offset, double variance) {
    return -offset * std::exp(-glm::dot(offset, offset) / (2 * variance));
}

// No longer than a dot may go at once.
glm::dvec2 within(glm::dvec2 move) {
    return move * std::min(1.0, kLongestStep / std::max(glm::length(move), 1e-300));
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

    // What all of them push by. A Gaussian is one across times one down.
    glm::dvec2 push_at(glm::dvec2 at, double variance, double reach) const {
        const Line across(at.x, width_, variance, reach), down(at.y, height_, variance, reach);
        glm::dvec2 force(0);
        for (int y = 0; y < int(down.falls.size()); ++y) {
            const float* const row = masses_.row(inside(down.first + y, masses_.height));
            double mass = 0, moment = 0;
            for (int x = 0; x < int(across.falls.size()); ++x) {
                const double seen = row[inside(across.first + x, masses_.width)] * across.falls[x];
                mass += seen;
                moment += seen * across.offset(x);
            }
            force -= down.falls[y] * glm::dvec2(moment, mass * down.offset(y));
        }
        return force;
    }

 private:
    // The lattice's places within reach along one axis, and what a Gaussian has fallen to at each.
    struct Line {
        Line(double from, double pitch, double variance, double reach)
            : at(from), side(pitch), first(int(std::floor((at - reach) / side + 0.5))) {
            for (int i = 0; offset(i) <= reach; ++i)
                falls.push_back(std::exp(-offset(i) * offset(i) / (2 * variance)));
        }
        double offset(int i) const { return (first + i + 0.5) * side - at; }

        double at, side;
        int first;
        std::vector<double> falls{};
    };

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

class Energy {
 public:
    explicit Energy(const DotsWanted& wanted) : wanted_(wanted) {
        const double mean = double(wanted.count) / (page_.x * page_.y);  // dots on an area
        if (!wanted.density) return;
        in_black_ = double(wanted.count) / std::max(wanted.density->mean(), 1e-12);
        least_ = kLeastShare * mean;
        margin_ = std::min({reach_of(1 / std::sqrt(least_)), page_.x, page_.y});
        masses_ =
            std::make_unique<Masses>(*wanted.density, wanted.count, kGaussianKernel / std::sqrt(in_black_));
    }

    // A step down from there, over the distance between dots there.
    struct Step {
        glm::dvec2 way{};
        double spacing = 1;
    };

    std::vector<Step> steps(const PlainDots& dots) const {
        const Neighbours neighbours(dots, wanted_, margin_);
        std::vector<Step> steps(dots.size());
        tbb::parallel_for(std::size_t{0}, dots.size(),
                          [&](std::size_t i) { steps[i] = step(dots[i], neighbours); });
        return steps;
    }

    // On the page, which goes on as in a mirror, or on the unit square, whose edges meet.
    glm::dvec2 inside(glm::dvec2 p) const {
        return wanted_.density ? glm::dvec2(mirrored(p.x, page_.x), mirrored(p.y, page_.y))
                               : on_unit_torus(p);
    }
    glm::dvec2 way(glm::dvec2 from, glm::dvec2 to) const {
        return wanted_.density ? to - from : to - from - glm::round(to - from);
    }

 private:
    static double reach_of(double spacing) { return std::sqrt(2 * kEnd * 2) * kGaussianKernel * spacing; }

    Step step(glm::dvec2 dot, const Neighbours& neighbours) const {
        double here = in_black_;
        if (wanted_.density) {
            const glm::dvec2 last = page_ * (1 - 1e-9);  // beyond it there is no density
            here = std::max(in_black_ * wanted_.density->at(glm::min(dot, last)), least_);
        }
        const double spacing = 1 / std::sqrt(here), sigma = kGaussianKernel * spacing;
        const double variance = 2 * sigma * sigma, reach = std::min(reach_of(spacing), margin_);
        glm::dvec2 force(0);
        neighbours.for_each_within(dot, reach, [&](glm::dvec2 offset) { force += push(offset, variance); });
        if (masses_) force -= masses_->push_at(dot, variance, reach);
        return {within(kStride / spacing * force), spacing};
    }

    const DotsWanted& wanted_;
    const glm::dvec2 page_ = page_of(wanted_);
    double in_black_ = double(wanted_.count);  // dots on an area
    double least_ = 0, margin_ = std::numeric_limits<double>::infinity();
    std::unique_ptr<const Masses> masses_{};
};

}  // namespace

PlainDots gaussian_blue_noise(const DotsWanted& wanted) {
    PlainDots dots =
        wanted.density ? random_dots(*wanted.density, wanted.count, wanted.seed) : white_noise(wanted);
    const Energy energy(wanted);
    PlainDots ahead = dots;
    std::vector<double> since(dots.size());  // steps since a dot had no momentum
    for (int step = 0; step < kGaussianSteps; ++step) {
        if (wanted.stop.stop_requested()) return {};
        const std::vector<Energy::Step> steps = energy.steps(ahead);
        PlainDots moves(dots.size());  // over the distance between dots
        double along = 0, length = 0;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            moves[i] = energy.way(dots[i], ahead[i]) / steps[i].spacing + steps[i].way;
            along += glm::dot(steps[i].way, moves[i]);
            length += glm::length(steps[i].way);
        }
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 way = steps[i].way, move = moves[i];
            // Momentum that leads up has gone too far (O'Donoghue & Candes 2015). What pushes on a picture is
            // no energy's slope, as kernels differ: there each dot's by itself may not lead far to the side.
            const double up = wanted.density ? glm::length(way) * glm::length(move) / 2 : 0;
            since[i] = (wanted.density ? glm::dot(way, move) : along) < up ? 0 : since[i] + 1;
            const double momentum = since[i] / (since[i] + 3);
            dots[i] = energy.inside(ahead[i] + steps[i].spacing * way);
            ahead[i] = energy.inside(dots[i] + steps[i].spacing * within(momentum * move));
        }
        if (length < kGaussianStill * double(dots.size())) break;
    }
    return dots;
}

}  // namespace dapple
