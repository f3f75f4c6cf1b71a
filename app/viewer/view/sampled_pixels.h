#pragma once
// Pixels of 8 x 8 sample points that are ink or not, each in a word of its own, for pictures that are drawn
// again in each frame: dots of one radius are stamped on them, pixel by pixel, in a tenth of the time that
// rows of samples take.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/output/sample_band.h"

namespace dapple {

/// Of a pixel's word the lowest byte is its top row of samples, the lowest bit of that the leftmost one.
/// Threads may add to it at once whose limits have no row of pixels in common.
class SampledPixels : public SampledShapes<SampledPixels> {
 public:
    static constexpr int kSide = 8;

    SampledPixels(int width, int height)
        : width_(width), height_(height), words_(static_cast<std::size_t>(width) * height) {}

    int sample_rows() const { return height_ * kSide; }
    std::int64_t columns() const { return std::int64_t{width_} * kSide; }

    /// The samples of a row from the first to the last one, all of which it has.
    void add_span(std::int64_t row, std::int64_t first, std::int64_t last) {
        std::uint64_t* const line = row_of_pixels(row / kSide);
        const auto byte = row % kSide * 8;
        const std::int64_t from = first / kSide, to = last / kSide;
        const std::uint64_t head = std::uint64_t{0xff} << first % kSide & 0xff;
        const std::uint64_t tail = std::uint64_t{0xff} >> (kSide - 1 - last % kSide);
        if (from == to) {
            line[from] |= (head & tail) << byte;
            return;
        }
        line[from] |= head << byte;
        for (std::int64_t pixel = from + 1; pixel < to; ++pixel) line[pixel] |= std::uint64_t{0xff} << byte;
        line[to] |= tail << byte;
    }

    std::uint64_t* row_of_pixels(std::int64_t y) { return words_.data() + y * width_; }

    void clear_row(int y) { std::fill_n(row_of_pixels(y), width_, 0); }

    /// How many samples of each of a row's pixels are ink.
    void count(int y, std::span<std::uint16_t> counts) const;

 private:
    int width_, height_;
    std::vector<std::uint64_t> words_;
};

/// Discs of one radius, worked out once for many places of their middles in a pixel. They lie within an
/// eighth of a pixel of where they should, small ones within a sixty-fourth; on their average they have as
/// many samples as their area.
class DiscStamps {
 public:
    /// Whether there are stamps of that radius, in samples. Smaller discs meet a sample now and then; larger
    /// ones would take longer to work out than they save.
    static bool are_there_of(double radius) { return radius >= 1 && radius <= 80; }

    explicit DiscStamps(double radius);

    /// The same as SampledShapes::add_disc(), but for its place. Of a middle that lies no further than the
    /// radius beyond the limits.
    void add(SampledPixels& pixels, double x, double y, const SampleWindow& limits) const;

 private:
    double radius_;
    int places_ = 0;                    // along a pixel's side
    std::vector<int> low_;              // for each of them: the pixel of a stamp's upper left corner
    int side_ = 0;                      // of a stamp, pixels
    std::vector<std::uint64_t> words_;  // stamp after stamp, row after row
};

}  // namespace dapple
