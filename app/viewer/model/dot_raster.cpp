#include "app/viewer/model/dot_raster.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>

#include "app/viewer/model/sampled_pixels.h"
#include "core/output/sample_band.h"

namespace dapple {
namespace {

// Rows that one thread draws: several times as many stretches as there are cores, as ink is not spread
// evenly.
constexpr int kRowsAtOnce = 32;

// As dot.vert has it.
double presence(double fade_scale, float critical) {
    const double t = std::clamp((fade_scale / critical - 1) / 0.15, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// The samples of a disc, row by row, worked out once for all discs of a radius: for each of 8 x 8 places of
// its middle between samples. On their average a disc has as many samples as its area, to half a hundredth.
class DiscRows {
 public:
    static constexpr int kPlaces = 8;

    static bool are_there_of(double radius) { return radius >= 4 && radius <= 400; }

    explicit DiscRows(double radius) : reach_(static_cast<std::int64_t>(radius) + 2) {
        const int rows = static_cast<int>(std::ceil(radius)) + 1;
        for (int place = 0; place < kPlaces * kPlaces; ++place) {
            const double x = (place % kPlaces + 0.5) / kPlaces, y = (place / kPlaces + 0.5) / kPlaces;
            Shape& shape = shapes_[static_cast<std::size_t>(place)];
            shape.first_row = -rows;
            for (int row = -rows; row <= rows; ++row) {
                const double dy = row + 0.5 - y, square = radius * radius - dy * dy;
                Span span{1, 0};
                if (square >= 0) {
                    const double half = std::sqrt(square);
                    span = {static_cast<std::int16_t>(std::ceil(x - half - 0.5)),
                            static_cast<std::int16_t>(std::floor(x + half - 0.5))};
                }
                if (span.first > span.last && shape.spans.empty()) ++shape.first_row;
                if (span.first <= span.last) shape.spans.push_back(span);
            }
        }
    }

    // Of a middle that lies no further than its radius beyond the window.
    void add(SampleBand& band, double x, double y, const SampleWindow& window) const {
        // Cut off towards 0, which takes no call as rounding down does.
        constexpr int kBeyond = 1024;
        const auto column = static_cast<std::int64_t>(x + kBeyond) - kBeyond,
                   line = static_cast<std::int64_t>(y + kBeyond) - kBeyond;
        const int across = static_cast<int>((x - static_cast<double>(column)) * kPlaces),
                  down = static_cast<int>((y - static_cast<double>(line)) * kPlaces);
        const Shape& shape = shapes_[static_cast<std::size_t>(down * kPlaces + across)];
        const std::int64_t top = line + shape.first_row;
        const std::int64_t first = std::max<std::int64_t>(window.first_row - top, 0);
        const std::int64_t end =
            std::min<std::int64_t>(window.end_row - top, static_cast<std::int64_t>(shape.spans.size()));
        const std::int64_t last_column = std::min(window.end_column, band.columns()) - 1;
        if (column - reach_ >= window.first_column && column + reach_ <= last_column) {
            for (std::int64_t i = first; i < end; ++i) {
                const Span span = shape.spans[static_cast<std::size_t>(i)];
                band.add_span(top + i, column + span.first, column + span.last);
            }
            return;
        }
        for (std::int64_t i = first; i < end; ++i) {
            const Span span = shape.spans[static_cast<std::size_t>(i)];
            const std::int64_t from = std::max(column + span.first, window.first_column),
                               to = std::min(column + span.last, last_column);
            if (from <= to) band.add_span(top + i, from, to);
        }
    }

 private:
    struct Span {
        std::int16_t first, last;
    };
    struct Shape {
        int first_row = 0;
        std::vector<Span> spans;  // no gaps: a disc is convex
    };
    std::int64_t reach_;
    std::array<Shape, kPlaces * kPlaces> shapes_;
};

// How many samples of each of a row's pixels are ink.
void count_row(const SampleBand& band, int y, std::span<std::uint16_t> counts) {
    std::vector<std::uint64_t> words;
    std::ranges::fill(counts, std::uint16_t{0});
    band.for_each_covered(y, static_cast<int>(counts.size()), words,
                          [&](int x, int samples) { counts[x] = static_cast<std::uint16_t>(samples); });
}
void count_row(const SampledPixels& pixels, int y, std::span<std::uint16_t> counts) {
    pixels.count(y, counts);
}

// Its pixels are the parts of the picture's.
template <class Band, int kSide, class Discs>
class SampledView {
 public:
    // Empty, in the memory that there is if it fits.
    void begin(const RasterView& view, int parts) {
        parts_ = parts;
        picture_ = view.size;
        const glm::ivec2 size = view.size * parts;
        if (size != view_.size || view.pens != bands_.size()) {
            bands_.clear();
            for (std::size_t pen = 0; pen < view.pens; ++pen) bands_.emplace_back(size.x, size.y);
        } else {
            tbb::parallel_for(0, size.y, [&](int y) {
                for (Band& band : bands_) band.clear_row(y);
            });
        }
        view_ = view;
        view_.size = size;
        view_.origin *= parts;
        view_.pixels_per_unit *= parts;
        const auto sample = [&](double pixel, int pixels) {
            return static_cast<int>(std::lround(std::clamp(pixel * parts, 0.0, double(pixels)) * kSide));
        };
        page_ = {{sample(view.page.low.x, size.x), sample(view.page.low.y, size.y)},
                 {sample(view.page.high.x, size.x), sample(view.page.high.y, size.y)}};
    }

    void add(std::span<const RasterDots> dots, const RasterLook& look) {
        const double scale = view_.pixels_per_unit * kSide;
        const glm::dvec2 origin = view_.origin * double{kSide};
        const double reach = std::max(look.radius, look.largest_radius) * look.grow * scale;
        const double usual = look.radius * look.grow * scale;
        std::optional<Discs> usual_disc;
        if (Discs::are_there_of(usual)) usual_disc.emplace(usual);
        for_each_stretch([&](const SampleWindow& window) {
            for (const RasterDots& some : dots) {
                const Dots& piece = *some.piece;
                if (look.hidden >> piece.pen & 1) continue;
                if (origin.y + double(some.high) * scale + reach < window.first_row ||
                    origin.y + double(some.low) * scale - reach > window.end_row)
                    continue;
                const auto pen = static_cast<std::size_t>(piece.pen);
                Band& band = bands_[pen < bands_.size() ? pen : 0];
                const bool own_radii = !piece.radius.empty();
                const bool fades = look.fade_scale > 0 && !piece.critical.empty();
                const std::size_t end = some.first + some.count;
                for (std::size_t i = some.first; i < end; i += some.limit ? 1 : some.every) {
                    if (some.limit && !(piece.critical[i] <= *some.limit)) continue;
                    const double y = origin.y + double(piece.y[i]) * scale;
                    const double radius = own_radii ? double(piece.radius[i]) * look.grow * scale : usual;
                    if (!(y + radius >= window.first_row && y - radius <= window.end_row)) continue;
                    const double x = origin.x + double(piece.x[i]) * scale;
                    const double there = fades ? presence(look.fade_scale, piece.critical[i]) : 1;
                    if (there <= 0) continue;
                    if (there < 1 || own_radii || !usual_disc)
                        band.add_disc(x, y, radius * std::sqrt(there), window);
                    else if (x + radius >= 0 && x - radius <= view_.size.x * double{kSide})
                        usual_disc->add(band, x, y, window);
                }
            }
        });
    }

    void add(const RasterLines& lines, const RasterLook& look) {
        const double scale = view_.pixels_per_unit * kSide;
        const glm::dvec2 origin = view_.origin * double{kSide};
        for_each_stretch([&](const SampleWindow& window) {
            for (std::size_t i = 0; i < lines.lines.size(); i += lines.every) {
                const std::size_t pen = lines.pens.empty() ? 0 : lines.pens[i];
                if (look.hidden >> pen & 1) continue;
                const glm::dvec4 line = glm::dvec4(lines.lines[i]) * scale;
                const glm::dvec2 from = origin + glm::dvec2(line.x, line.y),
                                 to = origin + glm::dvec2(line.z, line.w);
                const double width = lines.widths.empty() ? lines.width : lines.widths[i];
                const double radius = width / 2 * look.grow * scale;
                if (!(std::max(from.y, to.y) + radius >= window.first_row &&
                      std::min(from.y, to.y) - radius <= window.end_row))
                    continue;
                bands_[pen < bands_.size() ? pen : 0].add_capsule(from, to, radius, window);
            }
        });
    }

    template <class Pixel>
    void finish(std::vector<Grid<Pixel>>& pictures) const {
        constexpr std::size_t kPens = sizeof(Pixel);
        pictures.resize((bands_.size() + kPens - 1) / kPens);
        for (Grid<Pixel>& picture : pictures)
            if (picture.width != picture_.x || picture.height != picture_.y)
                picture = Grid<Pixel>(picture_.x, picture_.y);
        std::vector<float> across;  // how much of a full byte one sample is
        for (int x = 0; x < picture_.x; ++x)
            across.push_back(255.0f / static_cast<float>(std::max(on_page(x, page_.low.x, page_.high.x), 1)));
        tbb::parallel_for(tbb::blocked_range<int>(0, picture_.y, kRowsAtOnce), [&](const auto& rows) {
            std::vector<std::uint16_t> counts(view_.size.x);
            std::vector<int> sums(picture_.x);
            for (int y = rows.begin(); y < rows.end(); ++y) {
                const float down =
                    1.0f / static_cast<float>(std::max(on_page(y, page_.low.y, page_.high.y), 1));
                for (std::size_t pen = 0; pen < pictures.size() * kPens; ++pen) {
                    std::ranges::fill(sums, 0);
                    if (pen < bands_.size()) sum_parts(bands_[pen], y, counts, sums);
                    Pixel* const row = pictures[pen / kPens].row(y);
                    for (int x = 0; x < picture_.x; ++x) {
                        const auto byte = static_cast<std::uint8_t>(
                            static_cast<int>(static_cast<float>(sums[x]) * across[x] * down + 0.5f));
                        if constexpr (kPens == 1)
                            row[x] = byte;
                        else
                            row[x][static_cast<int>(pen % kPens)] = byte;
                    }
                }
            }
        });
    }

 private:
    void for_each_stretch(const auto& draw) {
        const int rows = view_.size.y;
        tbb::parallel_for(0, (rows + kRowsAtOnce - 1) / kRowsAtOnce, [&](int i) {
            const SampleWindow window{
                .first_row = std::max(i * kRowsAtOnce * kSide, page_.low.y),
                .end_row = std::min(std::min((i + 1) * kRowsAtOnce, rows) * kSide, page_.high.y),
                .first_column = page_.low.x,
                .end_column = page_.high.x};
            if (window.first_row < window.end_row) draw(window);
        });
    }

    void sum_parts(const Band& band, int y, std::span<std::uint16_t> counts, std::span<int> sums) const {
        for (int part = 0; part < parts_; ++part) {
            count_row(band, y * parts_ + part, counts);
            if (parts_ == 1) {
                std::ranges::copy(counts, sums.begin());
                continue;
            }
            for (std::size_t x = 0; x < sums.size(); ++x)
                for (const std::uint16_t count : counts.subspan(x * parts_, parts_)) sums[x] += count;
        }
    }

    // Of a pixel's samples in one direction those between; what lies on the page is all there is.
    int on_page(int pixel, int first, int end) const {
        const int side = kSide * parts_;
        return std::clamp(end - pixel * side, 0, side) - std::clamp(first - pixel * side, 0, side);
    }

    RasterView view_;           // in parts of pixels
    glm::ivec2 picture_{0, 0};  // pixels
    int parts_ = 1;
    Rectangle<int> page_{{0, 0}, {0, 0}};  // samples
    std::vector<Band> bands_;              // a pen each
};

}  // namespace

// Both are kept, as a view that moves is drawn quickly and one that rests fully.
struct DotRaster::Samples {
    SampledView<SampledPixels, SampledPixels::kSide, DiscStamps> quick;
    SampledView<SampleBand, kSamples, DiscRows> full;
    Fineness fineness = Fineness::quick;

    void visit(const auto& work) {
        if (fineness == Fineness::quick)
            work(quick);
        else
            work(full);
    }
};

DotRaster::DotRaster() : samples_(std::make_unique<Samples>()) {}
DotRaster::~DotRaster() = default;

RasterGrain raster_grain(const RasterView& view, Fineness fineness, double radius) {
    // Which samples a dot meets is chance where it is no larger than they lie apart, and not even that: the
    // same tile's points lie on many of its squares.
    constexpr double kSmallestRadius = 4;  // samples
    constexpr double kMostSamples = 256e6, kMostQuickSamples = 48e6;
    const auto samples = [&](const RasterGrain& grain) {
        return std::pow(grain.samples(), 2) * view.size.x * view.size.y * static_cast<double>(view.pens);
    };
    RasterGrain grain{fineness};
    if (samples(grain) > 8 * kMostRasterMemory) grain.fineness = Fineness::quick;
    const double most = fineness == Fineness::quick ? kMostQuickSamples : kMostSamples;
    const double wanted = std::ceil(kSmallestRadius / (radius * view.pixels_per_unit * grain.samples()));
    const double allowed = std::floor(std::sqrt(most / samples(grain)));
    grain.parts = static_cast<int>(std::clamp(wanted, 1.0, std::max(allowed, 1.0)));
    return grain;
}

void DotRaster::begin(const RasterView& view, const RasterGrain& grain) {
    samples_->fineness = grain.fineness;
    samples_->visit([&](auto& sampled) { sampled.begin(view, grain.parts); });
}

void DotRaster::add(std::span<const RasterDots> dots, const RasterLook& look) {
    samples_->visit([&](auto& sampled) { sampled.add(dots, look); });
}

void DotRaster::add(const RasterLines& lines, const RasterLook& look) {
    samples_->visit([&](auto& sampled) { sampled.add(lines, look); });
}

template <class Pixel>
void DotRaster::finish(std::vector<Grid<Pixel>>& pictures) const {
    samples_->visit([&](const auto& sampled) { sampled.finish(pictures); });
}

template void DotRaster::finish(std::vector<Grid<std::uint8_t>>&) const;
template void DotRaster::finish(std::vector<Grid<glm::u8vec4>>&) const;

}  // namespace dapple
