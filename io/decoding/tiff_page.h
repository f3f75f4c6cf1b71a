#pragma once
// What the first page of a TIFF file says of itself, read without a library.

#include <cstdint>
#include <optional>

namespace dapple {

class TiffPage {
 public:
    /// The page of an open file, whose descriptor keeps its place. For a file that is no TIFF, or is broken,
    /// it says something, but harms nobody.
    explicit TiffPage(int file);

    /// The first of the numbers, or the place of them, that an entry has. Nothing: there is no such entry.
    std::optional<std::uint64_t> entry(std::uint64_t tag) const;

    /// Whether the page after it is there.
    bool is_followed() const;

 private:
    std::uint64_t number_at(std::uint64_t at, int bytes) const;

    int file_;
    bool big_endian_ = false;
    // In files over 4 gigabytes, all of these are longer.
    int place_bytes_ = 4, entry_bytes_ = 12;
    std::uint64_t first_ = 0, entries_ = 0;
};

/// Whether a TIFF is a camera's raw file: the page with the sensor's values is the first one, or lies behind
/// a small picture of it.
bool is_camera_raw(const TiffPage& page);

}  // namespace dapple
