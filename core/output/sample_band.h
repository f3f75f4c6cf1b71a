#pragma once
// A stretch of a picture's rows, each pixel as 16 x 16 sample points that are ink or not.

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

inline constexpr int kSamples = 16;                   // a side of the grid of sample points in a pixel
inline constexpr int kPixelsPerWord = 64 / kSamples;  // one row of samples of so many pixels is a word

/// Rows of pixels that a band of that width has, so that its samples need 8 MB or so.
inline int rows_of_a_band(int width) {
    constexpr std::size_t kBandBytes = 8u << 20;
    const std::size_t row_bytes = static_cast<std::size_t>(width) * kSamples * kSamples / 8;
    return static_cast<int>(std::clamp<std::size_t>(kBandBytes / row_bytes, 1, 256));
}

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

    // What lies within a distance of the line from a to b, in the same units.
    void add_capsule(glm::dvec2 a, glm::dvec2 b, double radius) {
        const glm::dvec2 way = b - a;
        const double length = std::hypot(way.x, way.y);
        if (length == 0) return add_disc(a.x, a.y, radius);
        const glm::dvec2 aside = glm::dvec2(-way.y, way.x) * (radius / length);
        const std::array corners{a + aside, b + aside, b - aside, a - aside};
        const auto first_row = static_cast<int>(std::max(std::ceil(std::min(a.y, b.y) - radius - 0.5), 0.0));
        const auto last_row =
            static_cast<int>(std::min(std::floor(std::max(a.y, b.y) + radius - 0.5), sample_rows_ - 1.0));
        for (int row = first_row; row <= last_row; ++row) {
            const double y = row + 0.5;
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
            const double first = std::max(std::ceil(left - 0.5), 0.0);
            const double last = std::min(std::floor(right - 0.5), words_ * 64.0 - 1.0);
            if (first <= last) set(row, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last));
        }
    }

    Grid<float> coverage(int width) const {
        Grid<float> result(width, sample_rows_ / kSamples);
        std::vector<std::uint64_t> counts(words_);
        for (int y = 0; y < result.height; ++y) {
            std::ranges::fill(counts, 0);
            for (int row = y * kSamples; row < (y + 1) * kSamples; ++row) count(row, counts);
            for (int word = 0; word < words_; ++word) {
                if (counts[word] == 0) continue;  // bare paper
                const int first = word * kPixelsPerWord;
                for (int x = first; x < std::min(first + kPixelsPerWord, width); ++x) {
                    const std::uint64_t bytes = counts[word] >> (x - first) * kSamples;
                    result.at(x, y) =
                        static_cast<float>((bytes & 0xff) + (bytes >> 8 & 0xff)) / (kSamples * kSamples);
                }
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
