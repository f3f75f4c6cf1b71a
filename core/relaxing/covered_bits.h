#pragma once
// Which parts of a page discs cover, in bits: exact where they overlap, and in any order.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace dapple {

/// So many cells across and down, each of kSide x kSide bits.
class CoveredBits {
 public:
    static constexpr int kSide = 8;

    CoveredBits(int cells_across, int cells_down)
        : cells_(cells_across),
          words_(static_cast<std::size_t>((cells_across * kSide + 63) / 64)),
          height_(cells_down * kSide),
          bits_(words_ * static_cast<std::size_t>(height_)) {}

    /// The bits whose middles lie within an ellipse, which may reach beyond. All in bits' sides.
    void cover(glm::vec2 middle, glm::vec2 radius) {
        const int width = cells_ * kSide;
        const int top = std::max(up(middle.y - radius.y - 0.5f), 0);
        const int bottom = std::min(down_to(middle.y + radius.y - 0.5f), height_ - 1);
        for (int y = top; y <= bottom; ++y) {
            const float down = (static_cast<float>(y) + 0.5f - middle.y) / radius.y;
            const float half = radius.x * std::sqrt(std::max(1 - down * down, 0.0f));
            const int first = std::max(up(middle.x - half - 0.5f), 0);
            const int last = std::min(down_to(middle.x + half - 0.5f), width - 1);
            if (first > last) continue;
            std::uint64_t* const row = bits_.data() + static_cast<std::size_t>(y) * words_;
            const int begin = first / 64, end = last / 64;
            const std::uint64_t from = kAll << first % 64, to = kAll >> (63 - last % 64);
            if (begin == end) {
                row[begin] |= from & to;
                continue;
            }
            row[begin] |= from;
            std::fill(row + begin + 1, row + end, kAll);
            row[end] |= to;
        }
    }

    /// The share of each cell of a row that is bare.
    void bare(int row_of_cells, float* to) const {
        for (std::size_t word = 0; word < words_; ++word) {
            std::uint64_t sums = 0;  // of set bits, a byte for each cell
            for (int k = 0; k < kSide; ++k) {
                std::uint64_t v = bits_[static_cast<std::size_t>(row_of_cells * kSide + k) * words_ + word];
                v -= v >> 1 & 0x5555555555555555;
                v = (v & 0x3333333333333333) + (v >> 2 & 0x3333333333333333);
                sums += (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0f;
            }
            const int first = static_cast<int>(word) * (64 / kSide);
            for (int i = 0; i < std::min(64 / kSide, cells_ - first); ++i)
                to[first + i] = 1 - static_cast<float>(sums >> kSide * i & 0xff) / (kSide * kSide);
        }
    }

 private:
    // Whole numbers not below, and not above; std::ceil() and std::floor() would be calls.
    static int up(float value) {
        const int whole = static_cast<int>(value);
        return whole + (static_cast<float>(whole) < value);
    }
    static int down_to(float value) { return -up(-value); }

    static constexpr std::uint64_t kAll = ~std::uint64_t{0};

    int cells_;
    std::size_t words_;  // a row's
    int height_;
    std::vector<std::uint64_t> bits_;
};

}  // namespace dapple
