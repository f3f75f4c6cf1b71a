#include "tests/bench/volume_marks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <numeric>

#include "lab/volume/space_cells.h"

namespace dapple {

VolumeSpectrum volume_spectrum(std::span<const glm::dvec3> dots, double most) {
    using Complex = std::complex<double>;
    const double root = std::cbrt(static_cast<double>(dots.size()));
    const int end = static_cast<int>(most * root);
    // Of k and -k one counts: x from 0 on.
    struct Sum {
        double frequency, power;
    };
    std::vector<std::vector<Sum>> planes(static_cast<std::size_t>(end) + 1);
    std::vector<double> windows;
    double squares = 0;
    for (const glm::dvec3& dot : dots) {
        double window = 1;
        for (int axis = 0; axis < 3; ++axis) window *= std::pow(std::sin(std::numbers::pi * dot[axis]), 2);
        windows.push_back(window);
        squares += window * window;
    }
    tbb::parallel_for(0, end + 1, [&](int kx) {
        const int side = 2 * end + 1;
        std::vector<Complex> sums(static_cast<std::size_t>(side) * side);
        std::vector<Complex> along_z(static_cast<std::size_t>(side));
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec3& dot = dots[i];
            const auto turn = [](double angle) { return std::polar(1.0, -2 * std::numbers::pi * angle); };
            const Complex x = windows[i] * turn(kx * dot.x), y_step = turn(dot.y), z_step = turn(dot.z);
            along_z[0] = turn(-end * dot.z);
            for (int k = 1; k < side; ++k) along_z[k] = along_z[k - 1] * z_step;
            Complex y = x * turn(-end * dot.y);
            for (int ky = 0; ky < side; ++ky, y *= y_step)
                for (int kz = 0; kz < side; ++kz) sums[ky * side + kz] += y * along_z[kz];
        }
        for (int ky = -end; ky <= end; ++ky)
            for (int kz = -end; kz <= end; ++kz) {
                const double frequency =
                    std::sqrt(double(kx) * kx + double(ky) * ky + double(kz) * kz) / root;
                if (frequency * root < 3 || frequency > most) continue;
                planes[kx].push_back({frequency, std::norm(sums[(ky + end) * side + kz + end]) / squares});
            }
    });
    VolumeSpectrum spectrum;
    constexpr double kShell = 0.1;
    std::map<int, std::pair<double, int>> shells;
    double low = 0;
    int lows = 0;
    for (const auto& plane : planes)
        for (const auto& [frequency, power] : plane) {
            auto& [sum, count] = shells[static_cast<int>(frequency / kShell)];
            sum += power;
            ++count;
            spectrum.highest = std::max(spectrum.highest, power);
            if (frequency >= 0.5) continue;
            low += power;
            ++lows;
        }
    for (const auto& [shell, sum] : shells)
        spectrum.shells.push_back({(shell + 0.5) * kShell, sum.first / sum.second});
    spectrum.power_below_half = lows > 0 ? low / lows : 0;
    return spectrum;
}

VolumeDistances volume_distances(std::span<const glm::dvec3> dots, double volume) {
    if (dots.size() < 2) return {};
    const double packed = std::cbrt(std::sqrt(2.0) * volume / static_cast<double>(dots.size()));
    const SpaceCells cells(dots, box_around(dots), packed);
    std::vector<double> nearest(dots.size());
    tbb::parallel_for(std::size_t{0}, dots.size(), [&](std::size_t i) {
        const std::size_t other = cells.nearest(dots[i], [&](std::size_t j) { return j != i; });
        nearest[i] = glm::distance(dots[i], dots[other]);
    });
    const double sum = std::accumulate(nearest.begin(), nearest.end(), 0.0);
    return {sum / static_cast<double>(dots.size()) / packed, *std::ranges::min_element(nearest) / packed};
}

}  // namespace dapple
