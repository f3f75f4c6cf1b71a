#include "core/analysis/periodogram.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <kiss_fft.h>
#include <kiss_fftr.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>

#include "core/failure.h"

namespace dapple {

namespace {

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
