#include "io/decoding/decoded_image.h"

#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/text/number_words.h"

namespace dapple {

glm::ivec2 ExifOrientation::upright(int x, int y, int width, int height) const {
    const bool mirrored_x = value == 2 || value == 3 || value == 7 || value == 8,
               mirrored_y = value == 3 || value == 4 || value == 6 || value == 7;
    const glm::ivec2 to(mirrored_x ? width - 1 - x : x, mirrored_y ? height - 1 - y : y);
    return swaps_sides() ? glm::ivec2(to.y, to.x) : to;
}

std::uint64_t number_in_file(int file, std::uint64_t at, int bytes, bool big_endian) {
    std::array<unsigned char, 8> read{};
    if (at > INT64_MAX ||
        ::pread(file, read.data(), static_cast<std::size_t>(bytes), static_cast<off_t>(at)) != bytes)
        return 0;
    std::uint64_t number = 0;
    for (int i = 0; i < bytes; ++i)
        number = number << 8 | read[static_cast<std::size_t>(big_endian ? i : bytes - 1 - i)];
    return number;
}

int orientation_in(std::span<const unsigned char> exif) {
    const bool little = exif.size() >= 8 && exif[0] == 'I' && exif[1] == 'I';
    const bool big = exif.size() >= 8 && exif[0] == 'M' && exif[1] == 'M';
    if (!little && !big) return 1;
    const auto number = [&](std::size_t at, std::size_t bytes) {
        std::size_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | exif[at + (little ? bytes - 1 - i : i)];
        return value;
    };
    constexpr std::size_t kEntry = 12, kOrientation = 274;
    const std::size_t directory = number(4, 4);
    if (directory > exif.size() - 2) return 1;
    const std::size_t entries = number(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t at = directory + 2 + i * kEntry;
        if (at + kEntry > exif.size()) break;
        if (number(at, 2) != kOrientation) continue;
        const std::size_t value = number(at + 8, 2);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
    }
    return 1;
}

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
