#include "app/viewer/background/even_part.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace dapple {
namespace {

constexpr std::size_t kLookedAt = 1 << 15;

}  // namespace

EvenPart::EvenPart(const DotPieces& dots) {
    const std::size_t step = 1 + dots.size() / kLookedAt;
    std::uint32_t random = 1;
    std::size_t stretch = 0;  // of so many dots, in the piece: one of them is looked at
    for (const Dots& piece : dots.pieces) {
        if (piece.critical.size() != piece.size()) {
            sample_.clear();
            return;
        }
        for (; stretch < piece.size(); stretch += step) {
            // Any of them: ranks come in an order that has its own periods.
            random = random * 1664525 + 1013904223;
            const std::size_t place = stretch + (random >> 8) % step;
            if (place < piece.size()) sample_.push_back(piece.critical[place]);
        }
        stretch -= piece.size();
    }
    std::ranges::sort(sample_);
}

float EvenPart::limit(double every) const {
    if (every <= 1) return std::numeric_limits<float>::infinity();
    const auto place = static_cast<std::size_t>(static_cast<double>(sample_.size()) / every);
    return sample_[std::min(place, sample_.size() - 1)];
}

}  // namespace dapple
