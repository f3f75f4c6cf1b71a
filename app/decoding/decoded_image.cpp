#include "app/decoding/decoded_image.h"

#include "app/shown_text.h"

namespace dapple {

void check_size(std::int64_t width, std::int64_t height, int channels, const DecodeRequest& request) {
    constexpr int kMostChannels = 64;
    if (width <= 0 || height <= 0 || channels <= 0) throw DecodeError("there is no picture in the file");
    if (channels > kMostChannels) {
        throw DecodeError("has " + grouped(static_cast<std::uint64_t>(channels)) +
                          " channels, where a picture has at most " + std::to_string(kMostChannels));
    }
    if (width > request.most_pixels / height) {
        throw TooManyPixels(grouped(static_cast<std::uint64_t>(width)) + " x " +
                            grouped(static_cast<std::uint64_t>(height)) + " pixels are over " +
                            grouped(static_cast<std::uint64_t>(request.most_pixels / 1'000'000)) +
                            " megapixels");
    }
}

}  // namespace dapple
