#include "core/analysis/periodogram.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <kiss_fft.h>
#include <kiss_fftr.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>

#include "core/failure.h"

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

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kWidth = 10;  // cells a point is spread over, on each axis
constexpr double kOversampling = 1.5;
// The kernel exp(beta (sqrt(1 - z^2) - 1)), |z| <= 1; beta as Barnett et al. advise in their section 4.1.
constexpr double kBeta = 0.97 * std::numbers::pi * kWidth * (1 - 0.5 / kOversampling);

struct FreeKissConfig {
    void operator()(void* config) const { kiss_fft_free(config); }
};
using ComplexConfig = std::unique_ptr<kiss_fft_state, FreeKissConfig>;
using RealConfig = std::unique_ptr<kiss_fftr_state, FreeKissConfig>;

FourierSums zero_sums(int max_x, int max_y) {
    FourierSums sums{max_x, max_y, {}};
    sums.sum.resize((std::size_t(max_x) + 1) * (2 * std::size_t(max_y) + 1));
    return sums;
}

double kernel(double z) {
    return std::exp(kBeta * (std::sqrt(std::max(0.0, 1 - z * z)) - 1));
}

// The kernel's Fourier transform at frequencies 0..highest of a grid of `size` cells, in cells.
std::vector<float> kernel_transform(int highest, int size) {
    constexpr int kSteps = 40 * kWidth;  // the trapezoid rule is exact to the kernel's value at its edge
    constexpr double kHalf = kWidth / 2.0;
    std::array<double, kSteps> weight;
    for (int s = 0; s < kSteps; ++s)
        weight[std::size_t(s)] = (s == 0 ? 1 : 2) * kernel(double(s) / kSteps) * kHalf / kSteps;
    std::vector<float> transform(std::size_t(highest) + 1);
    tbb::parallel_for(0, highest + 1, [&](int k) {
        double sum = 0;
        for (int s = 0; s < kSteps; ++s)
            sum += weight[std::size_t(s)] * std::cos(kTwoPi * k * (s * kHalf / kSteps) / size);
        transform[std::size_t(k)] = float(sum);
    });
    return transform;
}

// Cells first..first + 9 around a place, and what each of them gets.
struct Spread {
    int first;
    std::array<float, kWidth> weight;
};

Spread spread(double place) {
    const int first = int(std::ceil(place - kWidth / 2.0));
    Spread s{first, {}};
    for (int c = 0; c < kWidth; ++c)
        s.weight[std::size_t(c)] = float(kernel((first + c - place) / (kWidth / 2.0)));
    return s;
}

// Points on the unit torus, in units of grid cells, sorted by strips of rows so that a strip writes into its
// own rows and the first nine of the next one. Every other strip can then be filled at the same time.
struct Strips {
    std::vector<glm::dvec2> points;
    std::vector<std::size_t> start;  // an even number of strips, and the end
};

Strips sort_by_strips(std::span<const glm::dvec2> points, glm::dvec2 period, int columns, int rows) {
    const std::size_t count = std::size_t(std::max(2, rows / 64 * 2));  // at least 16 rows each
    Strips strips{std::vector<glm::dvec2>(points.size()), std::vector<std::size_t>(count + 1)};
    std::vector<glm::dvec2> place(points.size());
    std::vector<std::uint32_t> strip(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 unit = points[i] / period;
        place[i] = (unit - glm::dvec2(std::floor(unit.x), std::floor(unit.y))) * glm::dvec2(columns, rows);
        const int first = (int(std::ceil(place[i].y - kWidth / 2.0)) + rows) % rows;
        strip[i] = std::uint32_t(std::size_t(first) * count / std::size_t(rows));
        ++strips.start[strip[i] + 1];
    }
    std::partial_sum(strips.start.begin(), strips.start.end(), strips.start.begin());
    std::vector<std::size_t> next(strips.start.begin(), strips.start.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) strips.points[next[strip[i]]++] = place[i];
    return strips;
}

// Row after row of `columns` + kWidth cells: the last kWidth belong to the first ones of the row.
std::vector<float> spread_points(const Strips& strips, int columns, int rows, std::stop_token stop) {
    const std::size_t stride = std::size_t(columns + kWidth);
    std::vector<float> grid(stride * std::size_t(rows));
    for (std::size_t parity = 0; parity < 2; ++parity) {
        tbb::parallel_for(std::size_t(0), (strips.start.size() - 1) / 2, [&](std::size_t pair) {
            const std::size_t s = 2 * pair + parity;
            if (stop.stop_requested()) return;
            for (std::size_t i = strips.start[s]; i < strips.start[s + 1]; ++i) {
                const Spread x = spread(strips.points[i].x);
                const Spread y = spread(strips.points[i].y);
                const std::size_t column = std::size_t((x.first + columns) % columns);
                for (int r = 0; r < kWidth; ++r) {
                    const int row = (y.first + r + rows) % rows;
                    float* cell = grid.data() + std::size_t(row) * stride + column;
                    const float wy = y.weight[std::size_t(r)];
                    for (std::size_t c = 0; c < kWidth; ++c) cell[c] += x.weight[c] * wy;
                }
            }
        });
    }
    return grid;
}

// Transforms the rows and keeps the frequencies 0..max_x of each: max_x + 1 columns of `rows` values.
std::vector<kiss_fft_cpx> transform_rows(std::vector<float>& grid, int columns, int rows, int max_x,
                                         std::stop_token stop) {
    constexpr int kBatch = 8;  // rows at a time, so that the columns are written in whole cache lines
    const std::size_t stride = std::size_t(columns + kWidth);
    const std::size_t half = std::size_t(columns) / 2 + 1;
    std::vector<kiss_fft_cpx> out((std::size_t(max_x) + 1) * std::size_t(rows));
    tbb::enumerable_thread_specific<RealConfig> configs(
        [&] { return RealConfig(kiss_fftr_alloc(columns, 0, nullptr, nullptr)); });
    tbb::parallel_for(0, (rows + kBatch - 1) / kBatch, [&](int batch) {
        if (stop.stop_requested()) return;
        std::vector<kiss_fft_cpx> spectrum(half * kBatch);
        const int first = batch * kBatch;
        const int count = std::min(kBatch, rows - first);
        for (int r = 0; r < count; ++r) {
            float* row = grid.data() + std::size_t(first + r) * stride;
            for (int c = 0; c < kWidth; ++c) row[c] += row[columns + c];
            kiss_fftr(configs.local().get(), row, spectrum.data() + std::size_t(r) * half);
        }
        for (std::size_t i = 0; i <= std::size_t(max_x); ++i)
            for (int r = 0; r < count; ++r)
                out[i * std::size_t(rows) + std::size_t(first + r)] = spectrum[std::size_t(r) * half + i];
    });
    return out;
}

int grid_size(int highest) {
    const int wanted = std::max(32, int(std::ceil(kOversampling * (2 * highest + 1))));
    return kiss_fftr_next_fast_size_real(wanted);
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

FourierSums exact_fourier_sums(std::span<const glm::dvec2> points, glm::dvec2 period, int max_x, int max_y,
                               std::stop_token stop) {
    FourierSums sums = zero_sums(max_x, max_y);
    tbb::parallel_for(0, max_x + 1, [&](int i) {
        std::vector<std::complex<double>> column(2 * std::size_t(max_y) + 1);
        for (const glm::dvec2 p : points) {
            if (stop.stop_requested()) return;
            // Turns are reduced before the sine and cosine; powers of the step then lose a few digits of 16.
            const double start = i * (p.x / period.x) - max_y * (p.y / period.y);
            const double step = p.y / period.y;
            double re = std::cos(kTwoPi * (start - std::floor(start)));
            double im = -std::sin(kTwoPi * (start - std::floor(start)));
            const double step_re = std::cos(kTwoPi * step), step_im = -std::sin(kTwoPi * step);
            for (std::complex<double>& term : column) {
                term += std::complex<double>(re, im);
                const double next = re * step_re - im * step_im;
                im = re * step_im + im * step_re;
                re = next;
            }
        }
        for (int j = -max_y; j <= max_y; ++j)
            sums.sum[sums.index(i, j)] = std::complex<float>(column[std::size_t(j + max_y)]);
    });
    return sums;
}

FourierSums fast_fourier_sums(std::span<const glm::dvec2> points, glm::dvec2 period, int max_x, int max_y,
                              std::stop_token stop) {
    FourierSums sums = zero_sums(max_x, max_y);
    const int columns = grid_size(max_x), rows = grid_size(max_y);
    std::vector<kiss_fft_cpx> half;
    {
        const Strips strips = sort_by_strips(points, period, columns, rows);
        std::vector<float> grid = spread_points(strips, columns, rows, stop);
        half = transform_rows(grid, columns, rows, max_x, stop);
    }
    const std::vector<float> kernel_x = kernel_transform(max_x, columns);
    const std::vector<float> kernel_y = kernel_transform(max_y, rows);
    const ComplexConfig config(kiss_fft_alloc(rows, 0, nullptr, nullptr));
    tbb::enumerable_thread_specific<std::vector<kiss_fft_cpx>> columns_out(
        [&] { return std::vector<kiss_fft_cpx>(std::size_t(rows)); });
    tbb::parallel_for(0, max_x + 1, [&](int i) {
        if (stop.stop_requested()) return;
        std::vector<kiss_fft_cpx>& column = columns_out.local();
        kiss_fft(config.get(), half.data() + std::size_t(i) * std::size_t(rows), column.data());
        for (int j = -max_y; j <= max_y; ++j) {
            const kiss_fft_cpx value = column[std::size_t(j < 0 ? j + rows : j)];
            const float scale = 1 / (kernel_x[std::size_t(i)] * kernel_y[std::size_t(std::abs(j))]);
            sums.sum[sums.index(i, j)] = {value.r * scale, value.i * scale};
        }
    });
    return sums;
}

Periodogram periodogram(std::span<const glm::dvec2> points, const Domain& domain,
                        const PeriodogramOptions& options, std::stop_token stop) {
    Periodogram result{.domain = domain,
                       .points = points.size(),
                       .highest_frequency = options.highest_frequency,
                       .power = {0}};
    if (points.empty()) return result;

    const double n = double(points.size());
    const double highest = options.highest_frequency * std::sqrt(n / domain.area());
    const double columns = std::floor(highest * domain.width * (1 + 1e-12));
    const double rows = std::floor(highest * domain.height * (1 + 1e-12));
    if (!((columns + 1) * (2 * rows + 1) < 0x1p28))
        throw failure(
            "a spectrum of {} points up to {} times the square root of their number is too large; "
            "ask for a lower frequency",
            points.size(), options.highest_frequency);
    result.max_x = int(columns);
    result.max_y = int(rows);

    const double terms = n * (columns + 1) * (2 * rows + 1);
    const bool exact =
        options.route == FourierRoute::exact || (options.route == FourierRoute::automatic && terms < 1e7);
    const auto sums = exact ? exact_fourier_sums : fast_fourier_sums;
    const FourierSums f = sums(points, {domain.width, domain.height}, result.max_x, result.max_y, stop);
    result.power.resize(f.sum.size());
    for (std::size_t k = 0; k < f.sum.size(); ++k) result.power[k] = float(double(std::norm(f.sum[k])) / n);
    return result;
}

}  // namespace dapple
