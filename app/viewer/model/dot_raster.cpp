#include "app/viewer/model/dot_raster.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>

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
    static constexpr double kSmallest = 4, kLargest = 400;  // samples

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
    template <class Band>
    void add(Band& band, double x, double y, const SampleWindow& window) const {
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

template <int kSide>
class SampledView {
 public:
    // Empty, in the memory that there is if it fits.
    void begin(const RasterView& view) {
        if (view.size == view_.size && view.pens == bands_.size()) {
            tbb::parallel_for(std::size_t{0}, bands_.size(), [&](std::size_t pen) { bands_[pen].clear(); });
        } else {
            bands_.clear();
            for (std::size_t pen = 0; pen < view.pens; ++pen) bands_.emplace_back(view.size.x, view.size.y);
        }
        view_ = view;
        const auto sample = [](double pixel, int pixels) {
            return static_cast<int>(std::lround(std::clamp(pixel, 0.0, double(pixels)) * kSide));
        };
        page_ = {{sample(view.page.low.x, view.size.x), sample(view.page.low.y, view.size.y)},
                 {sample(view.page.high.x, view.size.x), sample(view.page.high.y, view.size.y)}};
    }

    void add(std::span<const RasterDots> dots, const RasterLook& look) {
        const double scale = view_.pixels_per_unit * kSide;
        const glm::dvec2 origin = view_.origin * double{kSide};
        const double reach = std::max(look.radius, look.largest_radius) * look.grow * scale;
        const double usual = look.radius * look.grow * scale;
        std::optional<DiscRows> usual_disc;
        if (usual >= DiscRows::kSmallest && usual <= DiscRows::kLargest) usual_disc.emplace(usual);
        for_each_stretch([&](const SampleWindow& window) {
            for (const RasterDots& some : dots) {
                const Dots& piece = *some.piece;
                if (look.hidden >> piece.pen & 1) continue;
                if (origin.y + double(some.high) * scale + reach < window.first_row ||
                    origin.y + double(some.low) * scale - reach > window.end_row)
                    continue;
                const auto pen = static_cast<std::size_t>(piece.pen);
                SampleBandOf<kSide>& band = bands_[pen < bands_.size() ? pen : 0];
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
            if (picture.width != view_.size.x || picture.height != view_.size.y)
                picture = Grid<Pixel>(view_.size.x, view_.size.y);
        // Where a pixel lies partly beyond the page, what lies on it is all there is.
        const auto on_page = [](int pixel, int first, int end) {
            return std::clamp(end - pixel * kSide, 0, kSide) - std::clamp(first - pixel * kSide, 0, kSide);
        };
        tbb::parallel_for(tbb::blocked_range<int>(0, view_.size.y, kRowsAtOnce), [&](const auto& rows) {
            std::vector<std::uint64_t> counts;
            for (int y = rows.begin(); y < rows.end(); ++y) {
                const int down = on_page(y, page_.low.y, page_.high.y);
                for (std::size_t i = 0; i < pictures.size(); ++i) {
                    Pixel* const row = pictures[i].row(y);
                    std::fill(row, row + view_.size.x, Pixel(0));
                    for (std::size_t k = 0; k < kPens && i * kPens + k < bands_.size(); ++k)
                        bands_[i * kPens + k].for_each_covered(
                            y, view_.size.x, counts, [&](int x, int samples) {
                                int all = kSide * kSide;
                                if (down < kSide || x * kSide < page_.low.x || (x + 1) * kSide > page_.high.x)
                                    all = std::max(down * on_page(x, page_.low.x, page_.high.x), 1);
                                const auto byte = static_cast<std::uint8_t>((samples * 255 + all / 2) / all);
                                if constexpr (kPens == 1)
                                    row[x] = byte;
                                else
                                    row[x][static_cast<int>(k)] = byte;
                            });
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

    RasterView view_;
    Rectangle<int> page_{{0, 0}, {0, 0}};     // samples
    std::vector<SampleBandOf<kSide>> bands_;  // a pen each
};

}  // namespace

// Both are kept, as a view that moves is drawn quickly and one that rests fully.
struct DotRaster::Samples {
    SampledView<8> quick;
    SampledView<16> full;
    RasterGrain grain = RasterGrain::quick;

    void visit(const auto& work) {
        if (grain == RasterGrain::quick)
            work(quick);
        else
            work(full);
    }
};

DotRaster::DotRaster() : samples_(std::make_unique<Samples>()) {}
DotRaster::~DotRaster() = default;

double DotRaster::memory(const RasterView& view, RasterGrain grain) {
    const double side = static_cast<int>(grain);
    return side * side / 8 * view.size.x * view.size.y * static_cast<double>(view.pens);
}

void DotRaster::begin(const RasterView& view, RasterGrain grain) {
    samples_->grain = grain;
    samples_->visit([&](auto& sampled) { sampled.begin(view); });
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
