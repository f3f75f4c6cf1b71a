#include "io/decoding/tiff_page.h"

#include <unistd.h>

#include <array>
#include <cstddef>

namespace dapple {

TiffPage::TiffPage(int file) : file_(file) {
    constexpr std::uint64_t kBigTiff = 43;
    big_endian_ = number_at(0, 1) == 'M';
    const bool big = number_at(2, 2) == kBigTiff;
    if (big) {
        place_bytes_ = 8;
        entry_bytes_ = 20;
    }
    const int count_bytes = big ? 8 : 2;
    const std::uint64_t page = number_at(big ? 8 : 4, place_bytes_);
    entries_ = number_at(page, count_bytes) & 0xffff;
    first_ = page + static_cast<std::uint64_t>(count_bytes);
}

// Some bytes of the file as a whole number; 0 where it ends before.
std::uint64_t TiffPage::number_at(std::uint64_t at, int bytes) const {
    std::array<unsigned char, 8> read{};
    if (at > INT64_MAX ||
        ::pread(file_, read.data(), static_cast<std::size_t>(bytes), static_cast<off_t>(at)) != bytes)
        return 0;
    std::uint64_t number = 0;
    for (int i = 0; i < bytes; ++i)
        number = number << 8 | read[static_cast<std::size_t>(big_endian_ ? i : bytes - 1 - i)];
    return number;
}

std::optional<std::uint64_t> TiffPage::entry(std::uint64_t tag) const {
    constexpr std::uint64_t kByte = 1, kShort = 3;
    for (std::uint64_t i = 0; i < entries_; ++i) {
        const std::uint64_t at = first_ + i * static_cast<std::uint64_t>(entry_bytes_);
        if (number_at(at, 2) != tag) continue;
        const std::uint64_t type = number_at(at + 2, 2);
        const int bytes = type == kByte ? 1 : type == kShort ? 2 : 4;
        return number_at(at + 4 + static_cast<std::uint64_t>(place_bytes_), bytes);
    }
    return std::nullopt;
}

bool TiffPage::is_followed() const {
    return number_at(first_ + entries_ * static_cast<std::uint64_t>(entry_bytes_), place_bytes_) != 0;
}

bool is_camera_raw(const TiffPage& page) {
    constexpr std::uint64_t kSubfileType = 254, kPhotometric = 262, kPagesWithin = 330, kDngVersion = 50706;
    constexpr std::uint64_t kReduced = 1, kColourFilters = 32803, kLinearRaw = 34892;
    const std::uint64_t photometric = page.entry(kPhotometric).value_or(0);
    return page.entry(kDngVersion) || photometric == kColourFilters || photometric == kLinearRaw ||
           ((page.entry(kSubfileType).value_or(0) & kReduced) != 0 && page.entry(kPagesWithin));
}

}  // namespace dapple
