#include "io/decoding/window_sink.h"

#include <algorithm>

namespace dapple {
namespace {

std::string size_in_words(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

// How many of `side` things from `begin` on are among the first `most`.
std::int64_t within(std::int64_t begin, std::int64_t side, std::int64_t most) {
    return std::max<std::int64_t>(std::min(begin + side, most) - std::max<std::int64_t>(begin, 0), 0);
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

}  // namespace dapple
