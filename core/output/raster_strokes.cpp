#include "core/output/raster_strokes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/output/sample_band.h"
#include "core/text/length.h"

namespace dapple {
namespace {

// Samples from the page's corner.
struct SampledLine {
    glm::dvec2 from, to;
    int pen;
};

struct StrokeCanvas {
    const StrokeStream& strokes;
    RasterSize size;
    double samples_per_mm;
    int band_rows;

    int bands() const { return (size.height + band_rows - 1) / band_rows; }
    // In samples.
    double radius_of(int pen) const { return strokes.width_of(pen) / 2 * samples_per_mm; }

    // Calls visit(line, first band, last band) for each line that touches any.
    template <class Visit>
    void for_each_line(const Visit& visit) const {
        const auto band = [&](double sample) {
            return static_cast<int>(
                std::clamp(std::floor(sample / (band_rows * kSamples)), -1.0, static_cast<double>(bands())));
        };
        const auto one = [&](glm::dvec2 from, glm::dvec2 to, int pen) {
            from *= samples_per_mm;
            to *= samples_per_mm;
            const double radius = radius_of(pen);
            const int first = std::max(band(std::min(from.y, to.y) - radius), 0),
                      last = std::min(band(std::max(from.y, to.y) + radius), bands() - 1);
            if (first <= last) visit(SampledLine{from, to, pen}, first, last);
        };
        strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
            if (points.size() == 1) one(points[0], points[0], pen);
            for (std::size_t i = 1; i < points.size(); ++i) one(points[i - 1], points[i], pen);
        });
    }
};

// The coverage of a band by one pen's lines.
Grid<float> band_of_strokes(const StrokeCanvas& canvas, int band, std::span<const SampledLine> lines,
                            std::size_t pen, bool several) {
    const int first_row = band * canvas.band_rows;
    SampleBand samples(canvas.size.width, std::min(canvas.band_rows, canvas.size.height - first_row));
    const glm::dvec2 corner(0, static_cast<double>(first_row) * kSamples);
    for (const SampledLine& line : lines) {
        if (several && static_cast<std::size_t>(line.pen) != pen) continue;
        samples.add_capsule(line.from - corner, line.to - corner, canvas.radius_of(line.pen));
    }
    return samples.coverage(canvas.size.width);
}

}  // namespace

void rasterise(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
               const CoverageSink& sink) {
    rasterise_pens(strokes, page, request, 1,
                   [&](int first_row, std::span<const Grid<float>> band) { sink(first_row, band[0]); });
}

void rasterise_pens(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
                    std::size_t pens, const PenCoverageSink& sink) {
    const RasterSize size = raster_size(page, request.dpi);
    const double samples_per_mm = request.dpi / kMmPerInch * kSamples;
    const StrokeCanvas canvas{.strokes = strokes,
                              .size = size,
                              .samples_per_mm = samples_per_mm,
                              .band_rows = rows_of_a_band(size.width)};
    std::vector<std::uint64_t> counts(canvas.bands(), 0);
    canvas.for_each_line([&](const SampledLine&, int first, int last) {
        for (int band = first; band <= last; ++band) ++counts[band];
    });
    for (int next = 0; next < canvas.bands();) {
        // As many bands as have so many lines together, but one at least.
        int end = next;
        for (std::uint64_t lines = 0; end < canvas.bands(); ++end) {
            lines += counts[end];
            if (end > next && lines > request.dots_at_once) break;
        }
        std::vector<std::vector<SampledLine>> lines(end - next);
        for (int band = next; band < end; ++band)
            lines[band - next].reserve(static_cast<std::size_t>(counts[band]));
        canvas.for_each_line([&](const SampledLine& line, int first, int last) {
            for (int band = std::max(first, next); band <= std::min(last, end - 1); ++band)
                lines[band - next].push_back(line);
        });
        hand_over_bands(
            {.count = end - next, .pens = pens, .threads = request.threads},
            [&](int i, std::size_t pen) {
                return band_of_strokes(canvas, next + i, lines[i], pen, pens > 1);
            },
            [&](int i, std::span<const Grid<float>> band) { sink((next + i) * canvas.band_rows, band); });
        next = end;
    }
}

Grid<float> coverage_of(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request) {
    const RasterSize size = raster_size(page, request.dpi);
    Grid<float> whole(size.width, size.height);
    rasterise(strokes, page, request, [&](int first_row, const Grid<float>& band) {
        std::ranges::copy(band.values, whole.row(first_row));
    });
    return whole;
}

}  // namespace dapple
