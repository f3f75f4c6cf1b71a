#include "core/output/raster.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/image/colour.h"
#include "core/image/tone.h"
#include "core/output/sample_band.h"
#include "core/text/number_words.h"

namespace dapple {

namespace {

// Samples from the page's corner.
struct SampledLine {
    glm::dvec2 from, to;
    int pen;
};

// The shapes among a pen's dots, in a band that begins with that row of pixels.
void add_shapes(SampleBand& samples, const InkPage& page, std::size_t pen, double dpi, int first_row) {
    if (!page.pens.empty() && pen != static_cast<std::size_t>(page.inking.pen)) return;
    const double samples_per_mm = dpi / kMmPerInch * kSamples;
    const glm::dvec2 corner(0, static_cast<double>(first_row) * kSamples);
    for (const InkArea& area : page.inking.shapes) {
        InkArea shape = flattened(area);
        for (std::vector<glm::dvec2>& ring : shape.rings)
            for (glm::dvec2& p : ring) p = p * samples_per_mm - corner;
        samples.add_shape(shape.rings);
    }
}

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
Grid<float> band_of_strokes(const StrokeCanvas& canvas, const InkPage& page, double dpi, int band,
                            std::span<const SampledLine> lines, std::size_t pen, bool several) {
    const int first_row = band * canvas.band_rows;
    SampleBand samples(canvas.size.width, std::min(canvas.band_rows, canvas.size.height - first_row));
    add_shapes(samples, page, pen, dpi, first_row);
    const glm::dvec2 corner(0, static_cast<double>(first_row) * kSamples);
    for (const SampledLine& line : lines) {
        if (several && static_cast<std::size_t>(line.pen) != pen) continue;
        samples.add_capsule(line.from - corner, line.to - corner, canvas.radius_of(line.pen));
    }
    return samples.coverage(canvas.size.width);
}

void rasterise_strokes(const InkPage& page, std::size_t pens, const RasterRequest& request,
                       const CoverageSink& sink) {
    const RasterSize size = raster_size(page.size, request.dpi);
    const StrokeCanvas canvas{.strokes = *page.strokes,
                              .size = size,
                              .samples_per_mm = request.dpi / kMmPerInch * kSamples,
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
                return band_of_strokes(canvas, page, request.dpi, next + i, lines[i], pen, pens > 1);
            },
            [&](int i, std::span<const Grid<float>> band) { sink((next + i) * canvas.band_rows, band); });
        next = end;
    }
}

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
    std::vector<std::size_t> begin{0};
    std::vector<glm::vec2> dots{};
    std::vector<float> radii{};  // page units; empty: all alike
    std::vector<std::uint8_t> pens{};

    int bands() const { return static_cast<int>(begin.size()) - 1; }
};

// As many bands, from that one on, as have `most` dots together, but one at least.
Stretch stretch_from(int first_band, const Canvas& canvas, std::span<const std::uint64_t> counts,
                     std::uint64_t most) {
    Stretch stretch{.first_band = first_band};
    for (int band = first_band; band < canvas.bands(); ++band) {
        const std::uint64_t end = stretch.begin.back() + counts[band];
        if (band > first_band && end > most) break;
        stretch.begin.push_back(static_cast<std::size_t>(end));
    }
    stretch.dots.resize(stretch.begin.back());
    stretch.pens.resize(stretch.begin.back());
    std::vector<std::size_t> next(stretch.begin.begin(), stretch.begin.end() - 1);
    canvas.dots.for_each_piece([&](const Dots& piece) {
        if (!piece.radius.empty()) stretch.radii.resize(stretch.dots.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const BandRange range = bands_touched(canvas, piece.y[i]);
            const int first = std::max(range.first, first_band),
                      last = std::min(range.last, first_band + stretch.bands() - 1);
            for (int band = first; band <= last; ++band) {
                const std::size_t at = next[band - first_band]++;
                stretch.dots[at] = {piece.x[i], piece.y[i]};
                stretch.pens[at] = static_cast<std::uint8_t>(piece.pen);
                if (!piece.radius.empty()) stretch.radii[at] = piece.radius[i];
            }
        }
        return true;
    });
    return stretch;
}

// The coverage of the stretch's i-th band by one pen's dots, and by what lies among them.
Grid<float> draw_band(const Canvas& canvas, const InkPage& page, double dpi, const Stretch& stretch, int i,
                      std::size_t pen) {
    const int first_row = (stretch.first_band + i) * canvas.band_rows;
    SampleBand samples(canvas.size.width, std::min(canvas.band_rows, canvas.size.height - first_row));
    add_shapes(samples, page, pen, dpi, first_row);
    for (std::size_t k = stretch.begin[i]; k < stretch.begin[i + 1]; ++k) {
        if (stretch.pens[k] != pen) continue;
        const glm::vec2 dot = stretch.dots[k];
        const double radius = stretch.radii.empty() ? canvas.radius : stretch.radii[k] * canvas.px_per_unit;
        samples.add_disc(dot.x * canvas.px_per_unit * kSamples,
                         (dot.y * canvas.px_per_unit - first_row) * kSamples, radius * kSamples);
    }
    return samples.coverage(canvas.size.width);
}

void rasterise_dots(const InkPage& page, std::size_t pens, const RasterRequest& request,
                    const CoverageSink& sink) {
    const RasterSize size = raster_size(page.size, request.dpi);
    const double px_per_mm = request.dpi / kMmPerInch;
    const Canvas canvas{.dots = page.dots,
                        .size = size,
                        .px_per_unit = page.size.mm_per_page_unit * px_per_mm,
                        .radius = page.dot_radius_mm * px_per_mm,
                        .band_rows = rows_of_a_band(size.width)};
    const std::vector<std::uint64_t> counts = dots_in_bands(canvas);
    for (int next_band = 0; next_band < canvas.bands();) {
        const Stretch stretch = stretch_from(next_band, canvas, counts, request.dots_at_once);
        hand_over_bands(
            {.count = stretch.bands(), .pens = pens, .threads = request.threads},
            [&](int i, std::size_t pen) { return draw_band(canvas, page, request.dpi, stretch, i, pen); },
            [&](int i, std::span<const Grid<float>> band) {
                sink((next_band + i) * canvas.band_rows, band);
            });
        next_band += stretch.bands();
    }
}

// To two digits, which people can type and which stay below.
double rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

}  // namespace

void hand_over_bands(const Bands& bands, const std::function<Grid<float>(int band, std::size_t pen)>& draw,
                     const std::function<void(int band, std::span<const Grid<float>>)>& sink) {
    const int at_once = bands.threads > 0 ? bands.threads : tbb::info::default_concurrency();
    std::vector<std::vector<Grid<float>>> drawn(static_cast<std::size_t>(at_once),
                                                std::vector<Grid<float>>(bands.pens)),
        ready = drawn;
    const auto draw_from = [&](int first) {
        tbb::parallel_for(0, std::min(at_once, bands.count - first), [&](int i) {
            for (std::size_t pen = 0; pen < bands.pens; ++pen) drawn[i][pen] = draw(first + i, pen);
        });
    };
    tbb::task_arena(at_once).execute([&] {
        draw_from(0);
        for (int first = 0; first < bands.count; first += at_once) {
            drawn.swap(ready);
            tbb::task_group group;
            if (first + at_once < bands.count) group.run([&] { draw_from(first + at_once); });
            try {
                for (int i = 0; i < std::min(at_once, bands.count - first); ++i) sink(first + i, ready[i]);
            } catch (...) {
                group.wait();
                throw;
            }
            group.wait();
        }
    });
}

RasterSize raster_size(const PageSize& page, double dpi) {
    const double width = std::round(page.width_mm / kMmPerInch * dpi),
                 height = std::round(page.height_mm / kMmPerInch * dpi);
    const double shrink = std::min(kLargestSide / std::max({width, height, 1.0}),
                                   std::sqrt(kMostPixels / std::max(width * height, 1.0)));
    // Written so that what is not a number is refused too.
    if (!(shrink >= 1)) {
        throw std::runtime_error(fmt::format(
            "the page would be {:.0f} x {:.0f} pixels, and the most is {:.0f} a side and {:.0f} gigapixels "
            "in all; choose {:.4g} pixels per inch or less, a smaller page or a part of it",
            width, height, kLargestSide, kMostPixels * 1e-9, rounded_down(dpi * shrink)));
    }
    return {std::max(static_cast<int>(width), 1), std::max(static_cast<int>(height), 1)};
}

void rasterise(const InkPage& page, const RasterRequest& request, const CoverageSink& sink) {
    const std::size_t pens = std::max<std::size_t>(page.pens.size(), 1);
    (page.strokes ? rasterise_strokes : rasterise_dots)(page, pens, request, sink);
}

Grid<float> coverage_of(const InkPage& page, const RasterRequest& request) {
    const RasterSize size = raster_size(page.size, request.dpi);
    Grid<float> whole(size.width, size.height);
    rasterise(page, request, [&](int first_row, std::span<const Grid<float>> band) {
        std::ranges::copy(band[0].values, whole.row(first_row));
    });
    return whole;
}

template <class Channel>
Grid<glm::vec<3, Channel>> ink_on_paper(const Grid<float>& coverage, glm::vec3 ink, glm::vec3 paper) {
    // Coverage has few values, so each colour is worked out once.
    constexpr int steps = kSamples * kSamples;
    constexpr float most = std::numeric_limits<Channel>::max();
    std::array<glm::vec<3, Channel>, steps + 1> colours;
    for (int i = 0; i <= steps; ++i) {
        for (int c = 0; c < 3; ++c) {
            const float share = static_cast<float>(i) / steps;
            const float light = srgb_to_linear(ink[c]) * share + srgb_to_linear(paper[c]) * (1.0f - share);
            colours[i][c] = static_cast<Channel>(std::lround(linear_to_srgb(light) * most));
        }
    }
    Grid<glm::vec<3, Channel>> result(coverage.width, coverage.height);
    std::ranges::transform(coverage.values, result.values.begin(), [&](float share) {
        return colours[static_cast<std::size_t>(std::clamp(share, 0.0f, 1.0f) * steps + 0.5f)];
    });
    return result;
}

template <class Channel>
Grid<glm::vec<3, Channel>> ink_on_paper(std::span<const Grid<float>> coverage, std::span<const Pen> pens,
                                        glm::vec3 paper) {
    constexpr float most = std::numeric_limits<Channel>::max();
    std::vector<glm::vec3> light;
    for (const Pen& pen : pens) light.push_back(linear_of(pen.colour));
    const glm::vec3 bare = linear_of(paper);
    Grid<glm::vec<3, Channel>> result(coverage[0].width, coverage[0].height);
    tbb::parallel_for(0, result.height, [&](int y) {
        for (int x = 0; x < result.width; ++x) {
            glm::vec3 colour = bare;
            for (std::size_t pen = 0; pen < light.size(); ++pen) {
                const glm::vec3 below = pens[pen].ink == PenInk::transparent ? colour : glm::vec3(1);
                colour += coverage[pen].at(x, y) * (light[pen] * below - colour);
            }
            if constexpr (sizeof(Channel) == 1)
                result.at(x, y) = srgb_bytes(colour);
            else
                result.at(x, y) = glm::vec<3, Channel>(glm::round(encoded_of(colour) * most));
        }
    });
    return result;
}

template Grid<glm::u8vec3> ink_on_paper<std::uint8_t>(const Grid<float>&, glm::vec3, glm::vec3);
template Grid<glm::u16vec3> ink_on_paper<std::uint16_t>(const Grid<float>&, glm::vec3, glm::vec3);
template Grid<glm::u8vec3> ink_on_paper<std::uint8_t>(std::span<const Grid<float>>, std::span<const Pen>,
                                                      glm::vec3);
template Grid<glm::u16vec3> ink_on_paper<std::uint16_t>(std::span<const Grid<float>>, std::span<const Pen>,
                                                        glm::vec3);

}  // namespace dapple
