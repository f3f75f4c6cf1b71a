#pragma once
// A stretch of a picture's rows, each pixel as a square of sample points that are ink or not.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

inline constexpr int kSamples = 16;  // a side of the grid of sample points in a pixel of a file

/// Rows of pixels that a band of that width has, so that its samples need 8 MB or so.
inline int rows_of_a_band(int width) {
    constexpr std::size_t kBandBytes = 8u << 20;
    const std::size_t row_bytes = static_cast<std::size_t>(width) * kSamples * kSamples / 8;
    return static_cast<int>(std::clamp<std::size_t>(kBandBytes / row_bytes, 1, 256));
}

/// Which samples may be set: from the first ones to before the last ones.
struct SampleWindow {
    int first_row = 0, end_row = std::numeric_limits<int>::max();
    std::int64_t first_column = 0, end_column = std::numeric_limits<std::int64_t>::max();
};

/// Discs and lines as the samples whose middles lie in them. A Band says how many sample_rows() and columns()
/// it has, and its add_span(row, first, last) sets the samples of a row from the first to the last one.
template <class Band>
class SampledShapes {
 public:
    /// A disc, in sample units from the band's corner; sample (i, j) lies at (i + 1/2, j + 1/2).
    void add_disc(double x, double y, double radius, const SampleWindow& limits = {}) {
        const Span rows = rows_between(y - radius, y + radius, limits);
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            const double dy = static_cast<double>(row) + 0.5 - y;
            const double half = std::sqrt(std::max(radius * radius - dy * dy, 0.0));
            set(row, x - half, x + half, limits);
        }
    }

    /// What lies within a distance of the line from a to b, in the same units.
    void add_capsule(glm::dvec2 a, glm::dvec2 b, double radius, const SampleWindow& limits = {}) {
        const glm::dvec2 way = b - a;
        const double length = std::hypot(way.x, way.y);
        if (length == 0) return add_disc(a.x, a.y, radius, limits);
        const glm::dvec2 aside = glm::dvec2(-way.y, way.x) * (radius / length);
        const std::array corners{a + aside, b + aside, b - aside, a - aside};
        const Span rows = rows_between(std::min(a.y, b.y) - radius, std::max(a.y, b.y) + radius, limits);
        for (std::int64_t row = rows.first; row <= rows.last; ++row) {
            const double y = static_cast<double>(row) + 0.5;
            // It is convex, so each row of it is one stretch: from the leftmost to the rightmost of both
            // discs' and of the four sides between them.
            double left = std::numeric_limits<double>::infinity(), right = -left;
            const auto reach = [&](double from, double to) {
                left = std::min(left, from);
                right = std::max(right, to);
            };
            for (const glm::dvec2 end : {a, b}) {
                const double square = radius * radius - (y - end.y) * (y - end.y);
                if (square >= 0) reach(end.x - std::sqrt(square), end.x + std::sqrt(square));
            }
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const glm::dvec2 p = corners[i], q = corners[(i + 1) % corners.size()];
                if ((p.y <= y) == (q.y <= y)) continue;
                const double x = p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y);
                reach(x, x);
            }
            set(row, left, right, limits);
        }
    }

    /// What rings go around more often one way than the other: closed ones, in the same units.
    template <class Rings>
    void add_shape(const Rings& rings) {
        crossings_.resize(static_cast<std::size_t>(band().sample_rows()));
        for (const auto& ring : rings) {
            for (std::size_t i = 1; i < ring.size(); ++i) {
                const glm::dvec2 a = ring[i - 1], b = ring[i];
                const Span rows = rows_between(std::min(a.y, b.y), std::max(a.y, b.y), {});
                for (std::int64_t row = rows.first; row <= rows.last; ++row) {
                    const double y = static_cast<double>(row) + 0.5;
                    if ((a.y <= y) == (b.y <= y)) continue;
                    crossings_[static_cast<std::size_t>(row)].push_back(
                        {a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), a.y < b.y ? 1 : -1});
                }
            }
        }
        for (std::size_t row = 0; row < crossings_.size(); ++row) {
            std::ranges::sort(crossings_[row], {}, &Crossing::x);
            int around = 0;
            for (std::size_t i = 0; i + 1 < crossings_[row].size(); ++i) {
                around += crossings_[row][i].turn;
                if (around != 0)
                    set(static_cast<std::int64_t>(row), crossings_[row][i].x, crossings_[row][i + 1].x, {});
            }
            crossings_[row].clear();
        }
    }

 private:
    struct Span {
        std::int64_t first, last;  // none if last < first
    };
    struct Crossing {
        double x;
        int turn;
    };

    // The samples whose middles lie between, of those from `first` to before `end`. Without the calls that
    // rounding takes on processors of long ago: what is below 0 is cut off before.
    static Span samples_between(double low, double high, double first, double end) {
        const double from = std::max(low - 0.5, first), to = std::min(high - 0.5, end - 1);
        // Written so that what is not a number has none.
        if (!(to >= 0 && from <= to)) return {0, -1};
        const auto below = static_cast<std::int64_t>(from);
        return {below + (static_cast<double>(below) < from), static_cast<std::int64_t>(to)};
    }

    Span rows_between(double low, double high, const SampleWindow& limits) const {
        return samples_between(low, high, limits.first_row, std::min(band().sample_rows(), limits.end_row));
    }

    void set(std::int64_t row, double left, double right, const SampleWindow& limits) {
        const std::int64_t end = std::min(band().columns(), limits.end_column);
        const Span span =
            samples_between(left, right, static_cast<double>(limits.first_column), static_cast<double>(end));
        if (span.first <= span.last) band().add_span(row, span.first, span.last);
    }

    Band& band() { return static_cast<Band&>(*this); }
    const Band& band() const { return static_cast<const Band&>(*this); }

    std::vector<std::vector<Crossing>> crossings_;  // by row, while a shape is added
};

/// The samples of a band as bits, kSamples by kSamples a pixel: sample row after sample row, the leftmost
/// sample in the lowest bit. Threads may add to it at once whose limits have no row in common.
class SampleBand : public SampledShapes<SampleBand> {
 public:
    static constexpr int kPixelsAWord = 64 / kSamples;

    SampleBand(int width, int rows)
        : words_((width + kPixelsAWord - 1) / kPixelsAWord),
          sample_rows_(rows * kSamples),
          bits_(static_cast<std::size_t>(words_) * sample_rows_) {}

    /// The samples of a row from the first to the last one, all of which it has.
    void add_span(std::int64_t row, std::int64_t first, std::int64_t last) {
        std::uint64_t* const line = bits_.data() + static_cast<std::size_t>(row) * words_;
        const std::int64_t from = first / 64, to = last / 64;
        const std::uint64_t head = ~std::uint64_t{0} << (first % 64);
        const std::uint64_t tail = ~std::uint64_t{0} >> (63 - last % 64);
        if (from == to) {
            line[from] |= head & tail;
            return;
        }
        line[from] |= head;
        // Few, as a rule: no call that fills memory.
        for (std::int64_t word = from + 1; word < to; ++word) line[word] |= ~std::uint64_t{0};
        line[to] |= tail;
    }

    int sample_rows() const { return sample_rows_; }
    std::int64_t columns() const { return words_ * std::int64_t{64}; }

    /// A row of pixels.
    void clear_row(int y) {
        const std::size_t words = static_cast<std::size_t>(words_) * kSamples;
        std::fill_n(bits_.begin() + static_cast<std::ptrdiff_t>(words * y), words, 0);
    }

    /// Calls visit(x, samples) for each pixel of a row that has any: how many of its samples are set.
    template <class Visit>
    void for_each_covered(int y, int width, std::vector<std::uint64_t>& counts, const Visit& visit) const {
        counts.assign(words_, 0);
        for (int row = y * kSamples; row < (y + 1) * kSamples; ++row) count(row, counts);
        for (int word = 0; word < words_; ++word) {
            if (counts[word] == 0) continue;  // bare paper
            const int first = word * kPixelsAWord;
            for (int x = first; x < std::min(first + kPixelsAWord, width); ++x) {
                const std::uint64_t halves = counts[word] >> (x - first) * kSamples;
                visit(x, static_cast<int>((halves & 0xff) + (halves >> 8 & 0xff)));
            }
        }
    }

    Grid<float> coverage(int width) const {
        Grid<float> result(width, sample_rows_ / kSamples);
        std::vector<std::uint64_t> counts;
        for (int y = 0; y < result.height; ++y)
            for_each_covered(y, width, counts, [&](int x, int samples) {
                result.at(x, y) = static_cast<float>(samples) / (kSamples * kSamples);
            });
        return result;
    }

 private:
    // Adds to each byte of the counts how many bits that byte of the row has set. A byte is half a
    // pixel's samples in a row, so it counts to 128 at most. Without branches and without the processor's
    // own count, which the oldest ones lack: compilers do several words at a time.
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

/// A stretch of bands, numbered from 0, of so many pens each.
struct Bands {
    int count = 0;
    std::size_t pens = 1;
    int threads = 1;  // 0: all cores
};

/// Hands over all of them in turn, in the calling thread: the next ones are drawn meanwhile, side by side, as
/// a file of pixels takes as long to compress as to draw. What the sink throws passes through.
void hand_over_bands(const Bands& bands, const std::function<Grid<float>(int band, std::size_t pen)>& draw,
                     const std::function<void(int band, std::span<const Grid<float>>)>& sink);

}  // namespace dapple
