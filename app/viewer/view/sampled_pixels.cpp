#include "app/viewer/view/sampled_pixels.h"

#include <cmath>

namespace dapple {
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

}  // namespace dapple
