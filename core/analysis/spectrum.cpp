#include "core/analysis/spectrum.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace dapple {

namespace {

constexpr glm::u8vec3 kPeakColour{255, 140, 0};

glm::u8vec3 grey_of(float power) {
    const double share = std::log1p(double(power)) / std::log1p(double(kPeakPower));
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * std::min(share, 1.0)));
    return {grey, grey, grey};
}

// The spectrum as it will be coloured, a value a pixel: both halves, shrunk by a whole number, highest first.
Grid<float> shrunk(const Periodogram& spectrum, int bins_per_pixel) {
    const int reach_x = spectrum.max_x / bins_per_pixel, reach_y = spectrum.max_y / bins_per_pixel;
    Grid<float> powers(2 * reach_x + 1, 2 * reach_y + 1);
    const auto place = [&](int k, int reach) {
        // Rounds to the nearest pixel, halves away from 0, so that k and -k land opposite each other.
        const int pixel = (std::abs(k) + bins_per_pixel / 2) / bins_per_pixel;
        return std::min(pixel, reach) * (k < 0 ? -1 : 1) + reach;
    };
    for (int i = -spectrum.max_x; i <= spectrum.max_x; ++i)
        for (int j = -spectrum.max_y; j <= spectrum.max_y; ++j) {
            if (i == 0 && j == 0) continue;
            float& power = powers.at(place(i, reach_x), place(j, reach_y));
            power = std::max(power, spectrum.at(i, j));
        }
    return powers;
}

}  // namespace

Grid<glm::u8vec3> spectrum_picture(const Periodogram& spectrum, int longer_side) {
    const int bins = 2 * std::max(spectrum.max_x, spectrum.max_y) + 1;
    const int bins_per_pixel = (bins + longer_side - 1) / longer_side;
    const Grid<float> powers = shrunk(spectrum, std::max(bins_per_pixel, 1));
    const int times = std::max(1, longer_side / std::max(powers.width, powers.height));

    Grid<glm::u8vec3> picture(powers.width * times, powers.height * times);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) picture.at(x, y) = grey_of(powers.at(x / times, y / times));

    const int margin = times < 3 ? 1 : 0;
    for (int y = 0; y < powers.height; ++y)
        for (int x = 0; x < powers.width; ++x) {
            if (!(powers.at(x, y) > kPeakPower)) continue;
            for (int v = std::max(0, y * times - margin);
                 v < std::min(picture.height, (y + 1) * times + margin); ++v)
                for (int u = std::max(0, x * times - margin);
                     u < std::min(picture.width, (x + 1) * times + margin); ++u)
                    picture.at(u, v) = kPeakColour;
        }
    return picture;
}

namespace {

// Calls visit(i, j, P) once for each pair k, -k other than 0, i ascending.
template <class Visit>
void for_each_pair(const Periodogram& spectrum, Visit&& visit) {
    for (int i = 0; i <= spectrum.max_x; ++i)
        for (int j = i == 0 ? 1 : -spectrum.max_y; j <= spectrum.max_y; ++j)
            visit(i, j, double(spectrum.at(i, j)));
}

double decibel(double ratio) {
    return 10 * std::log10(std::max(ratio, 1e-10));
}

}  // namespace

std::vector<Ring> radial_power(const Periodogram& spectrum) {
    const double root_n = std::sqrt(double(spectrum.points));
    const std::size_t count = std::size_t(spectrum.highest_frequency * root_n * (1 + 1e-12));
    std::vector<Ring> rings(count);
    std::vector<double> squares(count);
    const auto ring_of = [&](int i, int j) {
        return std::size_t(std::sqrt(spectrum.squared_frequency(i, j)) + 0.5) - 1;  // ring 0 wraps: no ring
    };
    for_each_pair(spectrum, [&](int i, int j, double power) {
        const std::size_t r = ring_of(i, j);
        if (r >= count) return;
        rings[r].bins += 1;
        rings[r].power += power;
    });
    for (std::size_t r = 0; r < count; ++r) {
        rings[r].frequency = double(r + 1) / root_n;
        if (rings[r].bins > 0) rings[r].power /= double(rings[r].bins);
    }
    // A second pass, since a difference of large sums would lose the variance of a flat ring.
    for_each_pair(spectrum, [&](int i, int j, double power) {
        const std::size_t r = ring_of(i, j);
        if (r < count) squares[r] += (power - rings[r].power) * (power - rings[r].power);
    });
    for (std::size_t r = 0; r < count; ++r)
        if (rings[r].bins > 1 && rings[r].power > 0)
            rings[r].anisotropy_db =
                decibel(squares[r] / double(rings[r].bins - 1) / (rings[r].power * rings[r].power));
    return rings;
}

double low_frequency_power(const Periodogram& spectrum, double f, double from) {
    const double limit = f * f * double(spectrum.points), least = from * from * double(spectrum.points);
    double sum = 0;
    std::size_t bins = 0;
    for_each_pair(spectrum, [&](int i, int j, double power) {
        const double squared = spectrum.squared_frequency(i, j);
        if (!(squared >= least && squared < limit)) return;
        sum += power;
        ++bins;
    });
    return bins > 0 ? sum / double(bins) : 0;
}

Peaks spectral_peaks(const Periodogram& spectrum) {
    const double n = double(spectrum.points);
    Peaks peaks;
    std::vector<float> powers;
    for_each_pair(spectrum, [&](int i, int j, double power) {
        const double squared = spectrum.squared_frequency(i, j);
        if (!(squared > 0.25 * n && squared < 4 * n)) return;
        powers.push_back(float(power));
        if (power > peaks.highest_bin) {
            peaks.highest_bin = power;
            peaks.highest_x = i;
            peaks.highest_y = j;
        }
    });
    if (powers.empty() || peaks.highest_bin == 0) return peaks;
    const std::size_t top = std::max<std::size_t>(1, powers.size() / 1000);
    std::nth_element(powers.begin(), powers.begin() + std::ptrdiff_t(top), powers.end(), std::greater<>());
    const double strongest = std::accumulate(powers.begin(), powers.begin() + std::ptrdiff_t(top), 0.0);
    peaks.top_share =
        strongest / std::accumulate(powers.begin() + std::ptrdiff_t(top), powers.end(), strongest);
    return peaks;
}

double effective_nyquist(const std::vector<Ring>& rings, double threshold) {
    double highest = 0;
    for (std::size_t halves = 1; halves <= rings.size(); ++halves) {
        // The disc holds the arc 2 acos(r / 2 f), 2 f = halves, of the circle of radius r about the origin;
        // the half ring more gives the last ring a share.
        double noise = 0, weight = 0;
        for (std::size_t r = 1; r <= halves; ++r) {
            const double arc = double(r) * std::acos(double(r) / (double(halves) + 0.5));
            noise += arc * rings[r - 1].power;
            weight += arc;
        }
        if (noise <= threshold * weight) highest = double(halves) * rings.front().frequency;
    }
    return highest;
}

}  // namespace dapple
