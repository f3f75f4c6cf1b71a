#include "io/decoding/decoded_image.h"

#include <algorithm>

#include "core/text/number_words.h"

namespace dapple {

void check_size(std::int64_t width, std::int64_t height, int channels, const DecodeRequest& request) {
    constexpr int kMostChannels = 64, kLongestSide = 1'000'000;
    if (width <= 0 || height <= 0 || channels <= 0) throw DecodeError("there is no picture in the file");
    if (channels > kMostChannels)
        throw DecodeError("has " + grouped(static_cast<std::uint64_t>(channels)) +
                          " channels, where a picture has at most " + std::to_string(kMostChannels));
    const std::string size = grouped(static_cast<std::uint64_t>(width)) + " x " +
                             grouped(static_cast<std::uint64_t>(height)) + " pixels";
    if (width > request.most_pixels / height)
        throw TooManyPixels(size + " are over " +
                            grouped(static_cast<std::uint64_t>(request.most_pixels / 1'000'000)) +
                            " megapixels");
    // A row is decoded at a time.
    if (std::max(width, height) > kLongestSide)
        throw DecodeError("has " + size + ", where a side has at most " + grouped(kLongestSide));
}

}  // namespace dapple
