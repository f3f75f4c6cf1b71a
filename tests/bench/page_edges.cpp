#include "tests/bench/page_edges.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

namespace dapple {
namespace {

class Page {
 public:
    explicit Page(const RelaxedDots& drawn)
        : drawn_(drawn),
          size_(glm::dvec2(drawn.density->width(), drawn.density->height()) /
                static_cast<double>(drawn.density->longer_side())) {}

    glm::dvec2 size() const { return size_; }
    /// Dots on an area of 1.
    double wanted(glm::dvec2 p) const {
        return kDotsPerScale * drawn_.scale * std::max(drawn_.density->at(p), 1e-6);
    }
    double distance(glm::dvec2 p) const { return 1 / std::sqrt(wanted(p)); }
    /// In which band a place lies; from their number on in none.
    std::size_t band(glm::dvec2 p) const {
        const double edge = std::min({p.x, size_.x - p.x, p.y, size_.y - p.y});
        return static_cast<std::size_t>(std::max(edge, 0.0) / distance(p) * 4);
    }

    /// The spectrum of the dots in a strip along a line, at so many waves a distance; added to what is there.
    /// The line lies at that place across; the strip from it on, or before it.
    void add_spectrum(bool lies, double at, bool before, std::vector<double>& powers) const {
        constexpr int kSteps = 4000;
        const double length = lies ? size_.x : size_.y, across = lies ? size_.y : size_.x;
        const double line = std::clamp(at, 1e-4, across - 1e-4);
        // Distances from the line's begin.
        std::vector<double> ways{0};
        for (int i = 0; i < kSteps; ++i) {
            const double along = (i + 0.5) / kSteps * length;
            const glm::dvec2 p = lies ? glm::dvec2(along, line) : glm::dvec2(line, along);
            ways.push_back(ways.back() + length / kSteps / distance(p));
        }
        std::vector<double> places;
        for (const glm::dvec2 dot : drawn_.dots) {
            const double away = ((lies ? dot.y : dot.x) - at) * (before ? -1 : 1);
            if (away < 0 || away > 2 * distance(dot)) continue;
            const double step = (lies ? dot.x : dot.y) / length * kSteps;
            const auto first = static_cast<std::size_t>(std::clamp(step, 0.0, kSteps - 1.0));
            places.push_back(std::lerp(ways[first], ways[first + 1], step - static_cast<double>(first)));
        }
        for (std::size_t k = 0; k < powers.size(); ++k) {
            std::complex<double> sum = 0;
            for (const double place : places)
                sum += std::polar(1.0, 2 * std::numbers::pi * frequency(k) * place);
            if (!places.empty()) powers[k] += std::norm(sum) / static_cast<double>(places.size());
        }
    }

    static double frequency(std::size_t k) { return 0.1 + 0.005 * static_cast<double>(k); }

 private:
    const RelaxedDots& drawn_;
    glm::dvec2 size_;
};

constexpr std::size_t kFrequencies = 560;

}  // namespace

PageEdges page_edges(const RelaxedDots& drawn) {
    const Page page(drawn);
    PageEdges edges;
    std::array<double, 6> wanted{};
    for (const glm::dvec2 dot : drawn.dots) {
        const std::size_t band = page.band(dot);
        if (band < wanted.size()) ++edges.bands[band];
    }
    // Places twenty to a distance on black.
    const double step = 1 / std::sqrt(kDotsPerScale * drawn.scale) / 20;
    for (double y = step / 2; y < page.size().y; y += step) {
        for (double x = step / 2; x < page.size().x; x += step) {
            const std::size_t band = page.band({x, y});
            if (band < wanted.size()) wanted[band] += page.wanted({x, y}) * step * step;
        }
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) edges.bands[i] /= wanted[i];

    std::vector<double> along(kFrequencies), inside(kFrequencies);
    for (const bool lies : {true, false}) {
        const double across = lies ? page.size().y : page.size().x;
        page.add_spectrum(lies, 0, false, along);
        page.add_spectrum(lies, across, true, along);
        for (const double share : {0.3, 0.6}) page.add_spectrum(lies, share * across, false, inside);
    }
    edges.peak = std::ranges::max(along) / 4;
    edges.peak_inside = std::ranges::max(inside) / 4;
    return edges;
}

}  // namespace dapple
