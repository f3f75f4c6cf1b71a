#include "app/viewer/view/dot_raster.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <optional>

namespace dapple {

namespace {

// A dot's radius, in samples. From kSmoothRadius on its edge is a sample wide and looks smooth by itself;
// below it the edge is harder (dot.vert), and kSmoothSamples samples a side make it smooth. From
// kSmallestRadius on a dot shows its shape.
constexpr double kSmoothRadius = 6, kSmoothSamples = 3;
constexpr double kSmallestRadius = 1.5;
// A page of few pixels has dots far below a sample's size, of which some meet one and others none. They are
// right on average, and this is enough of an average. Some drivers also end loops after 65,535 rounds.
constexpr double kMostPerSide = 128;
constexpr double kQuickSamples = 2.5e6;

}  // namespace

int samples_per_side(double dot_radius, glm::ivec2 pixels, Fineness fineness, const SampleLimits& limits) {
    const glm::dvec2 size(glm::max(pixels, 1));
    const double most = fineness == Fineness::quick ? std::min(kQuickSamples, limits.most) : limits.most;
    const double allowed =
        std::min(std::sqrt(most / (size.x * size.y)), limits.largest_side / std::max(size.x, size.y));
    const double smooth = std::min(std::ceil(kSmoothRadius / dot_radius), kSmoothSamples);
    const double wanted = std::clamp(std::ceil(kSmallestRadius / dot_radius), smooth, kMostPerSide);
    return static_cast<int>(std::max(std::min(wanted, std::floor(allowed)), 1.0));
}

namespace {

constexpr int kSide = SampledPixels::kSide;
constexpr int kFewestPlaces = 8, kMostPlaces = 64;
constexpr int kMostWords = 1 << 15;  // of all stamps: 256 KB, which stay near the processor

// For places that share a pixel evenly: how wide a stamp has to be, and where it begins.
std::vector<int> low_pixels(double radius, int places) {
    std::vector<int> low;
    for (int i = 0; i < places; ++i)
        low.push_back(static_cast<int>(std::floor(static_cast<double>(i) / places - radius)));
    return low;
}

int side_of_stamps(double radius, int places) {
    int side = 1;
    const std::vector<int> low = low_pixels(radius, places);
    for (int i = 0; i < places; ++i)
        side = std::max(side, static_cast<int>(std::ceil((i + 1.0) / places + radius)) - low[i]);
    return side;
}

// Numbers from 0 to 1 that are spread evenly however many of them there are: multiples of the plastic
// number's inverse and of its square (M. Roberts, "The unreasonable effectiveness of quasirandom sequences",
// 2018).
double share(double i, double step) {
    return i * step - std::floor(i * step);
}
constexpr double kAcross = 0.7548776662466927, kDown = 0.5698402909980532;

}  // namespace

void SampledPixels::count(int y, std::span<std::uint16_t> counts) const {
    const std::uint64_t* const line = words_.data() + static_cast<std::size_t>(y) * width_;
    // Without branches and without the processor's own count, which the oldest ones lack: compilers do
    // several words at a time.
    for (int x = 0; x < width_; ++x) {
        std::uint64_t bits = line[x];
        bits -= bits >> 1 & 0x5555555555555555u;
        bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
        bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
        bits += bits >> 8;
        bits += bits >> 16;
        bits += bits >> 32;
        counts[x] = static_cast<std::uint16_t>(bits & 0x7f);
    }
}

DiscStamps::DiscStamps(double radius) : radius_(radius), places_(kMostPlaces) {
    const double pixels = radius / kSide;
    while (places_ > kFewestPlaces &&
           std::pow(places_ * side_of_stamps(pixels, places_), 2) > double{kMostWords})
        places_ /= 2;
    low_ = low_pixels(pixels, places_);
    side_ = side_of_stamps(pixels, places_);
    for (int down = 0; down < places_; ++down)
        for (int across = 0; across < places_; ++across) {
            // Each elsewhere in its place: all at the same points between samples would be too large or too
            // small together.
            const double i = down * places_ + across;
            const double x = (across + share(i, kAcross)) / places_, y = (down + share(i, kDown)) / places_;
            SampledPixels stamp(side_, side_);
            stamp.add_disc((x - low_[across]) * kSide, (y - low_[down]) * kSide, radius);
            words_.insert(words_.end(), stamp.row_of_pixels(0), stamp.row_of_pixels(side_));
        }
}

void DiscStamps::add(SampledPixels& pixels, double x, double y, const SampleWindow& limits) const {
    // Cut off towards 0, which takes no call as rounding down does.
    constexpr int kBeyond = 1024;
    const double in_pixels_x = x / kSide + kBeyond, in_pixels_y = y / kSide + kBeyond;
    const auto column = static_cast<std::int64_t>(in_pixels_x), line = static_cast<std::int64_t>(in_pixels_y);
    const int across = static_cast<int>((in_pixels_x - static_cast<double>(column)) * places_),
              down = static_cast<int>((in_pixels_y - static_cast<double>(line)) * places_);
    const std::int64_t left = column - kBeyond + low_[across], top = line - kBeyond + low_[down];
    const std::int64_t end_column = std::min(limits.end_column, pixels.columns()),
                       end_row = std::min(limits.end_row, pixels.sample_rows());
    // Limits between pixels are the page's edges, which few discs meet.
    if (left * kSide < limits.first_column || (left + side_) * kSide > end_column ||
        (limits.first_row % kSide != 0 && top * kSide < limits.first_row) ||
        (end_row % kSide != 0 && (top + side_) * kSide > end_row))
        return pixels.add_disc(x, y, radius_, limits);
    const std::int64_t first = std::max<std::int64_t>(top, limits.first_row / kSide),
                       end = std::min<std::int64_t>(top + side_, end_row / kSide);
    const std::uint64_t* from = words_.data() +
                                (static_cast<std::size_t>(down) * places_ + across) * side_ * side_ +
                                (first - top) * side_;
    for (std::int64_t row = first; row < end; ++row, from += side_) {
        std::uint64_t* const to = pixels.row_of_pixels(row) + left;
        for (int i = 0; i < side_; ++i) to[i] |= from[i];
    }
}

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
        look_at(view, parts);
        if (bands_size_ != view_.size || bands_.size() != view_.pens) bands_ = empty_bands(view_.size);
        bands_size_ = view_.size;
        for_each_stretch(kRowsAtOnce, [&](int first, int end) { clear({bands_, 0, first, end}); });
    }

    void add(std::span<const RasterDots> dots, const RasterLook& look) {
        const std::optional<Discs> discs = usual_discs(look);
        for_each_stretch(kRowsAtOnce, [&](int first, int end) {
            add({bands_, 0, first, end}, dots, look, discs);
        });
    }

    void add(const RasterLines& lines, const RasterLook& look) {
        for_each_stretch(kRowsAtOnce, [&](int first, int end) { add({bands_, 0, first, end}, lines, look); });
    }

    template <class Pixel>
    void finish(std::vector<Grid<Pixel>>& pictures) {
        make_room(pictures);
        for_each_stretch(kRowsAtOnce, [&](int first, int end) { write({bands_, 0, first, end}, pictures); });
    }

    // Stretch by stretch in memory that stays near the processor.
    template <class Pixel>
    double draw(const RasterView& view, int parts, const RasterInk& ink, const RasterLook& look,
                std::vector<Grid<Pixel>>& pictures) {
        look_at(view, parts);
        make_room(pictures);
        constexpr double kStretchBytes = 384e3;
        const double row_bytes = kSide * kSide / 8.0 * parts * view_.size.x * static_cast<double>(view.pens);
        const int rows = std::clamp(static_cast<int>(kStretchBytes / row_bytes), 4, kRowsAtOnce);
        const std::optional<Discs> discs = usual_discs(look);
        struct Thread {
            std::vector<Band> bands;
            double ink = 0, all = 0;  // seconds
        };
        tbb::enumerable_thread_specific<Thread> threads;
        for_each_stretch(rows, [&](int first, int end) {
            using Clock = std::chrono::steady_clock;
            Thread& thread = threads.local();
            const auto begin = Clock::now();
            if (thread.bands.empty()) thread.bands = empty_bands({view_.size.x, rows * parts});
            const Stretch stretch{thread.bands, first, first, end};
            clear(stretch);
            const auto clean = Clock::now();
            add(stretch, ink.dots, look, discs);
            for (const RasterLines& lines : ink.lines) add(stretch, lines, look);
            thread.ink += std::chrono::duration<double>(Clock::now() - clean).count();
            write(stretch, pictures);
            thread.all += std::chrono::duration<double>(Clock::now() - begin).count();
        });
        double ink_seconds = 0, all_seconds = 1e-9;
        threads.combine_each([&](const Thread& thread) {
            ink_seconds += thread.ink;
            all_seconds += thread.all;
        });
        return ink_seconds / all_seconds;
    }

 private:
    // Rows of the picture whose samples stand in bands, one for each pen, that begin with one of its rows.
    struct Stretch {
        std::vector<Band>& bands;
        int bands_begin, first, end;
    };

    void look_at(const RasterView& view, int parts) {
        parts_ = parts;
        picture_ = view.size;
        view_ = view;
        view_.size *= parts;
        view_.origin *= parts;
        view_.pixels_per_unit *= parts;
        const auto sample = [&](double pixel, int pixels) {
            return static_cast<int>(std::lround(std::clamp(pixel, 0.0, double(pixels)) * side()));
        };
        page_ = {{sample(view.page.low.x, picture_.x), sample(view.page.low.y, picture_.y)},
                 {sample(view.page.high.x, picture_.x), sample(view.page.high.y, picture_.y)}};
    }

    // Of a pixel of the picture.
    int side() const { return kSide * parts_; }

    std::vector<Band> empty_bands(glm::ivec2 size) const {
        std::vector<Band> bands;
        for (std::size_t pen = 0; pen < view_.pens; ++pen) bands.emplace_back(size.x, size.y);
        return bands;
    }

    template <class Pixel>
    void make_room(std::vector<Grid<Pixel>>& pictures) const {
        pictures.resize((view_.pens + sizeof(Pixel) - 1) / sizeof(Pixel));
        for (Grid<Pixel>& picture : pictures)
            if (picture.width != picture_.x || picture.height != picture_.y)
                picture = Grid<Pixel>(picture_.x, picture_.y);
    }

    void for_each_stretch(int rows, const auto& work) const {
        tbb::parallel_for(0, (picture_.y + rows - 1) / rows,
                          [&](int i) { work(i * rows, std::min((i + 1) * rows, picture_.y)); });
    }

    void clear(const Stretch& stretch) const {
        for (Band& band : stretch.bands)
            for (int row = stretch.first * parts_; row < stretch.end * parts_; ++row)
                band.clear_row(row - stretch.bands_begin * parts_);
    }

    // Of the bands; those that lie on the page.
    SampleWindow window_of(const Stretch& stretch) const {
        const int begin = stretch.bands_begin * side();
        return {.first_row = std::max(stretch.first * side(), page_.low.y) - begin,
                .end_row = std::min(stretch.end * side(), page_.high.y) - begin,
                .first_column = page_.low.x,
                .end_column = page_.high.x};
    }

    glm::dvec2 origin_of(const Stretch& stretch) const {
        return view_.origin * double{kSide} - glm::dvec2(0, stretch.bands_begin * side());
    }

    double scale() const { return view_.pixels_per_unit * kSide; }

    std::optional<Discs> usual_discs(const RasterLook& look) const {
        const double radius = look.radius * scale();
        return Discs::are_there_of(radius) ? std::optional<Discs>(radius) : std::nullopt;
    }

    void add(const Stretch& stretch, std::span<const RasterDots> dots, const RasterLook& look,
             const std::optional<Discs>& discs) const {
        const SampleWindow window = window_of(stretch);
        if (window.first_row >= window.end_row) return;
        const glm::dvec2 origin = origin_of(stretch);
        const double scale = this->scale();
        const double reach = std::max(look.radius, look.largest_radius) * scale;
        const double usual = look.radius * scale;
        for (const RasterDots& some : dots) {
            const Dots& piece = *some.piece;
            if (look.hidden >> piece.pen & 1) continue;
            if (origin.y + double(some.high) * scale + reach < window.first_row ||
                origin.y + double(some.low) * scale - reach > window.end_row)
                continue;
            const auto pen = static_cast<std::size_t>(piece.pen);
            Band& band = stretch.bands[pen < view_.pens ? pen : 0];
            const bool own_radii = !piece.radius.empty();
            const bool fades = look.fade_scale > 0 && !piece.critical.empty();
            const std::size_t end = some.first + some.count;
            for (std::size_t i = some.first; i < end; ++i) {
                const double y = origin.y + double(piece.y[i]) * scale;
                const double radius = own_radii ? double(piece.radius[i]) * scale : usual;
                if (!(y + radius >= window.first_row && y - radius <= window.end_row)) continue;
                const double x = origin.x + double(piece.x[i]) * scale;
                const double there = fades ? presence(look.fade_scale, piece.critical[i]) : 1;
                if (there <= 0) continue;
                if (there < 1 || own_radii || !discs)
                    band.add_disc(x, y, radius * std::sqrt(there), window);
                else if (x + radius >= 0 && x - radius <= view_.size.x * double{kSide})
                    discs->add(band, x, y, window);
            }
        }
    }

    void add(const Stretch& stretch, const RasterLines& lines, const RasterLook& look) const {
        const SampleWindow window = window_of(stretch);
        if (window.first_row >= window.end_row) return;
        const glm::dvec2 origin = origin_of(stretch);
        const double scale = this->scale();
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
            stretch.bands[pen < view_.pens ? pen : 0].add_capsule(from, to, radius, window);
        }
    }

    template <class Pixel>
    void write(const Stretch& stretch, std::vector<Grid<Pixel>>& pictures) const {
        constexpr std::size_t kPens = sizeof(Pixel);
        std::vector<float> across;  // how much of a full byte one sample is
        for (int x = 0; x < picture_.x; ++x)
            across.push_back(255.0f / static_cast<float>(std::max(on_page(x, page_.low.x, page_.high.x), 1)));
        std::vector<std::uint16_t> counts(view_.size.x);
        std::vector<int> sums(picture_.x);
        for (int y = stretch.first; y < stretch.end; ++y) {
            const float down = 1.0f / static_cast<float>(std::max(on_page(y, page_.low.y, page_.high.y), 1));
            for (std::size_t pen = 0; pen < pictures.size() * kPens; ++pen) {
                std::ranges::fill(sums, 0);
                if (pen < view_.pens) sum_parts(stretch.bands[pen], y - stretch.bands_begin, counts, sums);
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
    }

    void sum_parts(const Band& band, int row, std::span<std::uint16_t> counts, std::span<int> sums) const {
        for (int part = 0; part < parts_; ++part) {
            count_row(band, row * parts_ + part, counts);
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
        return std::clamp(end - pixel * side(), 0, side()) - std::clamp(first - pixel * side(), 0, side());
    }

    RasterView view_;           // in parts of pixels
    glm::ivec2 picture_{0, 0};  // pixels
    int parts_ = 1;
    Rectangle<int> page_{{0, 0}, {0, 0}};  // samples
    std::vector<Band> bands_;              // a pen each, for all of the picture
    glm::ivec2 bands_size_{0, 0};
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
    constexpr double kLeastSamples = 4;  // samples
    constexpr double kMostSamples = 256e6, kMostQuickSamples = 48e6;
    const auto samples = [&](const RasterGrain& grain) {
        return std::pow(grain.samples(), 2) * view.size.x * view.size.y * static_cast<double>(view.pens);
    };
    RasterGrain grain{fineness};
    if (samples(grain) > 8 * kMostRasterMemory) grain.fineness = Fineness::quick;
    const double most = fineness == Fineness::quick ? kMostQuickSamples : kMostSamples;
    const double wanted = std::ceil(kLeastSamples / (radius * view.pixels_per_unit * grain.samples()));
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
void DotRaster::finish(std::vector<Grid<Pixel>>& pictures) {
    samples_->visit([&](auto& sampled) { sampled.finish(pictures); });
}

template <class Pixel>
double DotRaster::draw(const RasterView& view, const RasterGrain& grain, const RasterInk& ink,
                       const RasterLook& look, std::vector<Grid<Pixel>>& pictures) {
    samples_->fineness = grain.fineness;
    double share = 0;
    samples_->visit([&](auto& sampled) { share = sampled.draw(view, grain.parts, ink, look, pictures); });
    return share;
}

template void DotRaster::finish(std::vector<Grid<std::uint8_t>>&);
template void DotRaster::finish(std::vector<Grid<glm::u8vec4>>&);
template double DotRaster::draw(const RasterView&, const RasterGrain&, const RasterInk&, const RasterLook&,
                                std::vector<Grid<std::uint8_t>>&);
template double DotRaster::draw(const RasterView&, const RasterGrain&, const RasterInk&, const RasterLook&,
                                std::vector<Grid<glm::u8vec4>>&);

}  // namespace dapple
