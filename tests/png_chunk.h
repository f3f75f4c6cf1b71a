#pragma once
// Pieces of PNGs, for tests that put one together or something into one.

#include <cstdint>
#include <string>

namespace dapple {

inline std::string big_endian(std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift);
    return bytes;
}

/// The checksum is a remainder of polynomials, as the standard's annex D says.
inline std::string png_chunk(const std::string& name, const std::string& content) {
    std::uint32_t remainder = 0xffffffff;
    for (const char c : name + content) {
        remainder ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) remainder = remainder >> 1 ^ (remainder % 2 ? 0xedb88320 : 0);
    }
    return big_endian(static_cast<std::uint32_t>(content.size())) + name + content + big_endian(~remainder);
}

/// A PNG with one more chunk, right after its header.
inline std::string with_chunk(const std::string& png, const std::string& name, const std::string& content) {
    constexpr std::size_t kHeaderEnds = 33;
    return png.substr(0, kHeaderEnds) + png_chunk(name, content) + png.substr(kHeaderEnds);
}

}  // namespace dapple
