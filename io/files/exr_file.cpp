#include "io/files/exr_file.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace dapple {
namespace {

template <class Number>
void put(std::string& bytes, Number number) {
    static_assert(std::endian::native == std::endian::little);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put_name(std::string& bytes, std::string_view name) {
    bytes.append(name).push_back('\0');
}

// One of the header's attributes.
void put_attribute(std::string& bytes, std::string_view name, std::string_view type, auto... values) {
    put_name(bytes, name);
    put_name(bytes, type);
    std::string value;
    (put(value, values), ...);
    put(bytes, static_cast<std::int32_t>(value.size()));
    bytes += value;
}

}  // namespace

// OpenEXR File Layout, https://openexr.com/en/latest/OpenEXRFileLayout.html: version 2, scan lines.
void write_exr(std::ostream& out, const Grid<float>& values) {
    constexpr std::int32_t kMagic = 20000630, kVersion = 2, kFloat = 2, kOne = 1;
    const std::int32_t right = values.width - 1, bottom = values.height - 1;
    const auto row_bytes = static_cast<std::int32_t>(sizeof(float)) * values.width;
    std::string header;
    put(header, kMagic);
    put(header, kVersion);
    // A channel "Y", its numbers' type, four bytes of no use here, one number a pixel each way; and no other.
    put_attribute(header, "channels", "chlist", 'Y', '\0', kFloat, std::int32_t{0}, kOne, kOne, '\0');
    put_attribute(header, "compression", "compression", '\0');
    for (const std::string_view window : {"dataWindow", "displayWindow"})
        put_attribute(header, window, "box2i", std::int32_t{0}, std::int32_t{0}, right, bottom);
    put_attribute(header, "lineOrder", "lineOrder", '\0');
    put_attribute(header, "pixelAspectRatio", "float", 1.0f);
    put_attribute(header, "screenWindowCenter", "v2f", 0.0f, 0.0f);
    put_attribute(header, "screenWindowWidth", "float", 1.0f);
    header.push_back('\0');
    // Where each row begins, then the rows: its number, its size, its values.
    const std::uint64_t rows =
        header.size() + sizeof(std::uint64_t) * static_cast<std::uint64_t>(values.height);
    for (int y = 0; y < values.height; ++y)
        put(header, rows + static_cast<std::uint64_t>(y) * (8 + static_cast<std::uint64_t>(row_bytes)));
    out << header;
    for (int y = 0; y < values.height; ++y) {
        std::string row;
        put(row, std::int32_t{y});
        put(row, row_bytes);
        out << row;
        out.write(reinterpret_cast<const char*>(values.row(y)), row_bytes);
    }
}

}  // namespace dapple
