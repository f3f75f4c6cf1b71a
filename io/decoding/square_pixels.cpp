#include "io/decoding/square_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/text/shown_text.h"

namespace dapple {
namespace {

// What the i-th of `to` things covers when fewer, `from`, are stretched into them: the first that it covers,
// and how much of the i-th that is; the rest is the next one.
struct Cover {
    std::int64_t first;
    float share;
};

Cover cover(std::int64_t i, std::int64_t from, std::int64_t to) {
    const std::int64_t begin = i * from, end = begin + from, first = begin / to;
    const std::int64_t of_first = std::min(end, (first + 1) * to) - begin;
    return {first, static_cast<float>(of_first) / static_cast<float>(from)};
}

std::int64_t stretched(int side, float by) {
    return std::llround(static_cast<double>(side) * static_cast<double>(by));
}

// "2.08", or "2" for 2.00.
std::string in_words(float ratio) {
    const auto hundredths = static_cast<int>(std::lround(ratio * 100));
    std::string text = std::to_string(hundredths / 100);
    if (hundredths % 100 == 0) return text;
    text += "." + std::to_string(hundredths / 10 % 10);
    return hundredths % 10 == 0 ? text : text + std::to_string(hundredths % 10);
}

}  // namespace

void SquarePixels::begin(const ImageHeader& header) {
    constexpr float kSquare = 1.01f, kLongest = 4;
    const float aspect = header.pixel_aspect, longer = aspect > 0 ? std::max(aspect, 1 / aspect) : 1;
    columns_ = more_columns_ = header.width;
    rows_ = more_rows_ = header.height;
    ImageHeader square = header;
    square.pixel_aspect = 1;
    if (longer > kSquare && longer <= kLongest) {
        const bool wide = aspect > 1;
        (wide ? more_columns_ : more_rows_) = stretched(wide ? header.width : header.height, longer);
        square.width = static_cast<int>(more_columns_);
        square.height = static_cast<int>(more_rows_);
        square.description += ", whose pixels, " + in_words(longer) + " times as " +
                              (wide ? "wide as high" : "high as wide") + ", are made square";
    }
    wider_.resize(static_cast<std::size_t>(more_columns_));
    to_.begin(square);
}

void SquarePixels::row(std::span<const glm::vec3> colours) {
    if (more_columns_ != columns_) {
        for (std::size_t x = 0; x < wider_.size(); ++x) {
            const Cover at = cover(static_cast<std::int64_t>(x), columns_, more_columns_);
            const auto first = static_cast<std::size_t>(at.first);
            const glm::vec3 next = colours[std::min(first + 1, colours.size() - 1)];
            wider_[x] = colours[first] * at.share + next * (1 - at.share);
        }
        return to_.row(wider_);
    }
    if (more_rows_ == rows_) return to_.row(colours);
    for (; next_ < more_rows_ && (next_ + 1) * rows_ <= (row_ + 1) * more_rows_; ++next_) {
        const Cover at = cover(next_, rows_, more_rows_);
        if (at.first == row_) {
            to_.row(colours);
            continue;
        }
        mixed_.resize(colours.size());
        std::ranges::transform(before_, colours, mixed_.begin(), [&](glm::vec3 first, glm::vec3 next) {
            return first * at.share + next * (1 - at.share);
        });
        to_.row(mixed_);
    }
    before_.assign(colours.begin(), colours.end());
    ++row_;
}

}  // namespace dapple
