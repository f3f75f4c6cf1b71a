#include "io/decoding/stored_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>

namespace dapple {

namespace {

std::string size_in_words(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

// How many of `side` things from `begin` on are among the first `most`.
std::int64_t within(std::int64_t begin, std::int64_t side, std::int64_t most) {
    return std::max<std::int64_t>(std::min(begin + side, most) - std::max<std::int64_t>(begin, 0), 0);
}

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

// False for what is not a number, too.
bool is_light(float value) {
    return std::abs(value) <= kMostLightOfAPixel;
}

[[noreturn]] void fail_at(std::size_t x, int y, std::span<const float> pixel) {
    const auto bad = std::ranges::find_if(pixel, [](float v) { return !std::isfinite(v); });
    const std::string place = "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is ";
    if (bad == pixel.end())
        throw DecodeError(place + "brighter than any light can be; scale the picture's values down first");
    throw DecodeError(place + (std::isnan(*bad) ? "not a number (NaN)" : "infinite") +
                      "; repair the picture first, for example with oiiotool --fixnan box3");
}

}  // namespace

void WindowSink::begin(const ImageHeader& header) {
    window_ = header.window;
    if (!window_) return to_.begin(header);
    const std::int64_t width = within(window_->x, header.width, window_->width),
                       height = within(window_->y, header.height, window_->height),
                       there = width == 0 || height == 0 ? 0 : width * height;
    stored_rows_ = header.height;
    first_column_ = std::clamp<std::int64_t>(window_->x, 0, window_->width);
    end_column_ = first_column_ + width;
    const std::string whole = size_in_words(window_->width, window_->height);
    ImageHeader shown = header;
    shown.window.reset();
    shown.width = window_->width;
    shown.height = window_->height;
    if (there < std::int64_t{shown.width} * shown.height)
        shown.remark = "the file has " + (there == 0 ? "none" : size_in_words(width, height)) +
                       " of the picture's " + whole + " pixels; the rest is taken as " +
                       (over_paper_ ? "bare paper" : "black");
    else
        shown.remark = "the file has more pixels around the picture's " + whole + ", which are left out";
    shown.description += "; " + shown.remark;
    to_.begin(shown);
    shown_.resize(static_cast<std::size_t>(window_->width));
}

void WindowSink::row(std::span<const glm::vec3> colours) {
    if (!window_) return to_.row(colours);
    const std::int64_t y = window_->y + row_++;
    empty_rows_until(std::min<std::int64_t>(y, window_->height));
    if (y == next_ && y < window_->height) {
        const auto first = static_cast<std::size_t>(first_column_ - window_->x),
                   count = static_cast<std::size_t>(end_column_ - first_column_);
        std::ranges::fill(shown_, glm::vec3(over_paper_ ? 1.0f : 0.0f));
        if (count > 0) std::ranges::copy(colours.subspan(first, count), shown_.begin() + first_column_);
        to_.row(shown_);
        ++next_;
    }
    if (row_ == stored_rows_) empty_rows_until(window_->height);
}

void WindowSink::empty_rows_until(std::int64_t y) {
    if (next_ < y) std::ranges::fill(shown_, glm::vec3(over_paper_ ? 1.0f : 0.0f));
    for (; next_ < y; ++next_) to_.row(shown_);
}

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

StoredPixels::StoredPixels(const PixelLayout& layout)
    : layout_(layout),
      behind_(layout.over_paper ? 1.0f : 0.0f),
      profile_(layout.profile, layout.channels.grey() ? 1 : 3, layout.encoding) {
    for (std::size_t i = 0; i < eight_bit_.size(); ++i)
        eight_bit_[i] = layout.encoding.light(static_cast<float>(i) / 255.0f);
}

void StoredPixels::decode(std::span<const float> stored, int y, std::span<glm::vec3> light) {
    if (profile_) return decode_by_profile(stored, light);
    const auto count = static_cast<std::size_t>(layout_.count);
    for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] = over_what_is_behind(stored.data() + i * count);
        if (!is_light(light[i].x) || !is_light(light[i].y) || !is_light(light[i].z))
            fail_at(i, y, stored.subspan(i * count, count));
    }
}

// Integers only have a profile here: all are finite.
void StoredPixels::decode_by_profile(std::span<const float> stored, std::span<glm::vec3> light) {
    const auto count = static_cast<std::size_t>(layout_.count);
    const Channels& channels = layout_.channels;
    const auto alpha_of = [&](std::size_t i) {
        return channels.alpha ? stored[i * count + static_cast<std::size_t>(*channels.alpha)] : 1;
    };
    colours_.clear();
    for (std::size_t i = 0; i < light.size(); ++i) {
        const float factor = layout_.premultiplied && alpha_of(i) > 0 ? 1 / alpha_of(i) : 1;
        for (int k = 0; k < (channels.grey() ? 1 : 3); ++k) {
            const auto channel = static_cast<std::size_t>(channels.colour[static_cast<std::size_t>(k)]);
            colours_.push_back(stored[i * count + channel] * factor);
        }
    }
    profile_.to_light(colours_, light);
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (channels.grey()) light[i] = glm::vec3(light[i].y);  // not only nearly so
        light[i] = light[i] * alpha_of(i) + behind_ * (1 - alpha_of(i));
    }
}

glm::vec3 StoredPixels::over_what_is_behind(const float* pixel) const {
    if (!layout_.channels.alpha) return light_of(pixel, 1);
    const float alpha = std::clamp(pixel[*layout_.channels.alpha], 0.0f, 1.0f);
    const float shown = behind_ * (1 - alpha);
    if (!layout_.premultiplied) return light_of(pixel, 1) * alpha + shown;
    // Linear light is multiplied as light, and may glow where alpha is 0; encoded values as they are.
    if (layout_.encoding.kind == Encoding::Kind::linear) return light_of(pixel, 1) + shown;
    return alpha > 0 ? light_of(pixel, 1 / alpha) * alpha + shown : glm::vec3(shown);
}

glm::vec3 StoredPixels::light_of(const float* pixel, float factor) const {
    const auto light = [&](int channel) {
        const float stored = pixel[channel] * factor;
        if (layout_.eight_bit && factor == 1)
            return eight_bit_[static_cast<std::size_t>(stored * 255.0f + 0.5f) & 255];
        return layout_.encoding.light(stored);
    };
    const std::array<int, 3>& colour = layout_.channels.colour;
    glm::vec3 seen(light(colour[0]));
    if (!layout_.channels.grey()) seen = {seen.x, light(colour[1]), light(colour[2])};
    if (layout_.to_srgb && !layout_.channels.grey()) seen = glm::max(*layout_.to_srgb * seen, 0.0f);
    return layout_.encoding.kind == Encoding::Kind::hlg ? shown_hlg(seen) : seen;
}

std::string describe(int width, int height, const std::string& kind, const Channels& channels,
                     const std::string& format) {
    return std::to_string(width) + " x " + std::to_string(height) + " pixels, " + kind +
           (channels.grey() ? " grey" : " colour") + (channels.alpha ? " with transparency" : "") + " " +
           format;
}

}  // namespace dapple
