#include "core/output/raster.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/image/tone.h"

namespace dapple {
namespace {

constexpr int kSamples = 16;                   // a side of the grid of sample points in a pixel
constexpr int kPixelsPerWord = 64 / kSamples;  // one row of samples of so many pixels is a word
constexpr std::size_t kBandBytes = 8u << 20;   // of samples
constexpr double kLargestSide = 1'000'000;
constexpr double kMostPixels = 4e9;

// The page in pixels, and the dots on it.
struct Canvas {
    const DotStream& dots;
    RasterSize size;
    double px_per_unit;
    double radius;  // px
    int band_rows;

    int bands() const { return (size.height + band_rows - 1) / band_rows; }
};

// The samples of a band as bits: sample row after sample row, the leftmost sample in the lowest bit.
class SampleBand {
 public:
    SampleBand(int width, int rows)
        : words_((width + kPixelsPerWord - 1) / kPixelsPerWord),
          sample_rows_(rows * kSamples),
          bits_(static_cast<std::size_t>(words_) * sample_rows_) {}

    // A disc, in sample units from the band's corner; sample (i, j) lies at (i + 1/2, j + 1/2).
    void add_disc(double x, double y, double radius) {
        const auto first_row = static_cast<int>(std::max(std::ceil(y - radius - 0.5), 0.0));
        const auto last_row = static_cast<int>(std::min(std::floor(y + radius - 0.5), sample_rows_ - 1.0));
        for (int row = first_row; row <= last_row; ++row) {
            const double dy = row + 0.5 - y;
            const double half = std::sqrt(std::max(radius * radius - dy * dy, 0.0));
            const double first = std::max(std::ceil(x - half - 0.5), 0.0);
            const double last = std::min(std::floor(x + half - 0.5), words_ * 64.0 - 1.0);
            if (first <= last) set(row, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last));
        }
    }

    Grid<float> coverage(int width) const {
        Grid<float> result(width, sample_rows_ / kSamples);
        std::vector<std::uint64_t> counts(words_);
        for (int y = 0; y < result.height; ++y) {
            std::ranges::fill(counts, 0);
            for (int row = y * kSamples; row < (y + 1) * kSamples; ++row) count(row, counts);
            for (int x = 0; x < width; ++x) {
                const std::uint64_t bytes = counts[x / kPixelsPerWord] >> x % kPixelsPerWord * kSamples;
                result.at(x, y) =
                    static_cast<float>((bytes & 0xff) + (bytes >> 8 & 0xff)) / (kSamples * kSamples);
            }
        }
        return result;
    }

 private:
    void set(int row, std::int64_t first, std::int64_t last) {
        std::uint64_t* const line = bits_.data() + static_cast<std::size_t>(row) * words_;
        const std::int64_t from = first / 64, to = last / 64;
        const std::uint64_t head = ~std::uint64_t{0} << (first % 64);
        const std::uint64_t tail = ~std::uint64_t{0} >> (63 - last % 64);
        if (from == to) {
            line[from] |= head & tail;
            return;
        }
        line[from] |= head;
        std::fill(line + from + 1, line + to, ~std::uint64_t{0});
        line[to] |= tail;
    }

    // Adds to each byte of the counts how many bits that byte of the row has set. A byte is half of a pixel's
    // samples in a row, so it counts to 128 at most. Without branches and without the processor's own
    // count, which the oldest ones lack: compilers do several words at a time.
    void count(int row, std::span<std::uint64_t> counts) const {
        const std::uint64_t* const line = bits_.data() + static_cast<std::size_t>(row) * words_;
        for (int word = 0; word < words_; ++word) {
            std::uint64_t bits = line[word];
            bits -= bits >> 1 & 0x5555555555555555u;
            bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
            counts[word] += (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
        }
    }

    int words_, sample_rows_;
    std::vector<std::uint64_t> bits_;
};

struct BandRange {
    int first, last;  // none if last < first
};

BandRange bands_touched(const Canvas& canvas, float y) {
    const double centre = y * canvas.px_per_unit;
    const auto band = [&](double row) {
        return static_cast<int>(
            std::clamp(std::floor(row / canvas.band_rows), -1.0, static_cast<double>(canvas.bands())));
    };
    return {std::max(band(centre - canvas.radius), 0),
            std::min(band(centre + canvas.radius), canvas.bands() - 1)};
}

// How many dots touch each band.
std::vector<std::uint64_t> dots_in_bands(const Canvas& canvas) {
    std::vector<std::uint64_t> counts(canvas.bands(), 0);
    canvas.dots.for_each_piece([&](const Dots& piece) {
        for (const float y : piece.y) {
            const BandRange range = bands_touched(canvas, y);
            for (int band = range.first; band <= range.last; ++band) ++counts[band];
        }
        return true;
    });
    return counts;
}

// Bands that follow each other, with the dots that touch them: those of the i-th are dots[begin[i] .. begin[i
// + 1]).
struct Stretch {
    int first_band = 0;
    std::vector<std::uint64_t> begin{0};
    std::vector<glm::vec2> dots{};
    std::vector<float> radii{};  // page units; empty: all alike

    int bands() const { return static_cast<int>(begin.size()) - 1; }
};

// As many bands, from that one on, as have `most` dots together, but one at least.
Stretch stretch_from(int first_band, const Canvas& canvas, std::span<const std::uint64_t> counts,
                     std::uint64_t most) {
    Stretch stretch{.first_band = first_band};
    for (int band = first_band; band < canvas.bands(); ++band) {
        const std::uint64_t end = stretch.begin.back() + counts[band];
        if (band > first_band && end > most) break;
        stretch.begin.push_back(end);
    }
    stretch.dots.resize(stretch.begin.back());
    std::vector<std::uint64_t> next(stretch.begin.begin(), stretch.begin.end() - 1);
    canvas.dots.for_each_piece([&](const Dots& piece) {
        if (!piece.radius.empty()) stretch.radii.resize(stretch.dots.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const BandRange range = bands_touched(canvas, piece.y[i]);
            const int first = std::max(range.first, first_band),
                      last = std::min(range.last, first_band + stretch.bands() - 1);
            for (int band = first; band <= last; ++band) {
                const std::uint64_t at = next[band - first_band]++;
                stretch.dots[at] = {piece.x[i], piece.y[i]};
                if (!piece.radius.empty()) stretch.radii[at] = piece.radius[i];
            }
        }
        return true;
    });
    return stretch;
}

Grid<float> draw_band(const Canvas& canvas, const Stretch& stretch, int i) {
    const int first_row = (stretch.first_band + i) * canvas.band_rows;
    SampleBand samples(canvas.size.width, std::min(canvas.band_rows, canvas.size.height - first_row));
    for (std::uint64_t k = stretch.begin[i]; k < stretch.begin[i + 1]; ++k) {
        const glm::vec2 dot = stretch.dots[k];
        const double radius = stretch.radii.empty() ? canvas.radius : stretch.radii[k] * canvas.px_per_unit;
        samples.add_disc(dot.x * canvas.px_per_unit * kSamples,
                         (dot.y * canvas.px_per_unit - first_row) * kSamples, radius * kSamples);
    }
    return samples.coverage(canvas.size.width);
}

// To two digits, which people can type and which stay below.
double rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

}  // namespace

RasterSize raster_size(const PageSize& page, double dpi) {
    const double width = std::round(page.width_mm / 25.4 * dpi),
                 height = std::round(page.height_mm / 25.4 * dpi);
    const double shrink =
        std::min(kLargestSide / std::max(width, height), std::sqrt(kMostPixels / (width * height)));
    // Written so that what is not a number is refused too.
    if (!(shrink >= 1)) {
        throw std::runtime_error(fmt::format(
            "the page would be {:.0f} x {:.0f} pixels, and {:.0f} a side and {:.0f} gigapixels in "
            "all are the most; choose {:.4g} dots to the inch or fewer, a smaller page or a part "
            "of it",
            width, height, kLargestSide, kMostPixels * 1e-9, rounded_down(dpi * shrink)));
    }
    return {std::max(static_cast<int>(width), 1), std::max(static_cast<int>(height), 1)};
}

void rasterise(const DotStream& dots, const PageSize& page, const RasterRequest& request,
               const CoverageSink& sink) {
    const RasterSize size = raster_size(page, request.dpi);
    const double px_per_mm = request.dpi / 25.4;
    const std::size_t row_bytes = static_cast<std::size_t>(size.width) * kSamples * kSamples / 8;
    const Canvas canvas{
        .dots = dots,
        .size = size,
        .px_per_unit = page.mm_per_page_unit * px_per_mm,
        .radius = request.dot_radius_mm * px_per_mm,
        .band_rows = static_cast<int>(std::clamp<std::size_t>(kBandBytes / row_bytes, 1, 256))};
    const std::vector<std::uint64_t> counts = dots_in_bands(canvas);

    const int threads = request.threads > 0 ? request.threads : tbb::info::default_concurrency();
    tbb::task_arena arena(threads);
    std::vector<Grid<float>> drawn(threads);
    for (int next_band = 0; next_band < canvas.bands();) {
        const Stretch stretch = stretch_from(next_band, canvas, counts, request.dots_at_once);
        for (int first = 0; first < stretch.bands(); first += threads) {
            const int count = std::min(threads, stretch.bands() - first);
            arena.execute([&] {
                tbb::parallel_for(0, count, [&](int i) { drawn[i] = draw_band(canvas, stretch, first + i); });
            });
            for (int i = 0; i < count; ++i) sink((next_band + first + i) * canvas.band_rows, drawn[i]);
        }
        next_band += stretch.bands();
    }
}

Grid<float> coverage_of(const DotStream& dots, const PageSize& page, const RasterRequest& request) {
    const RasterSize size = raster_size(page, request.dpi);
    Grid<float> whole(size.width, size.height);
    rasterise(dots, page, request, [&](int first_row, const Grid<float>& band) {
        std::ranges::copy(band.values, whole.row(first_row));
    });
    return whole;
}

Grid<glm::u8vec3> ink_on_paper(const Grid<float>& coverage, glm::vec3 ink, glm::vec3 paper) {
    // Coverage has few values, so each colour is worked out once.
    constexpr int steps = kSamples * kSamples;
    std::array<glm::u8vec3, steps + 1> colours;
    for (int i = 0; i <= steps; ++i) {
        for (int c = 0; c < 3; ++c) {
            const float share = static_cast<float>(i) / steps;
            const float light = srgb_to_linear(ink[c]) * share + srgb_to_linear(paper[c]) * (1.0f - share);
            colours[i][c] = static_cast<std::uint8_t>(std::lround(linear_to_srgb(light) * 255.0f));
        }
    }
    Grid<glm::u8vec3> result(coverage.width, coverage.height);
    std::ranges::transform(coverage.values, result.values.begin(), [&](float share) {
        return colours[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * steps))];
    });
    return result;
}

}  // namespace dapple
