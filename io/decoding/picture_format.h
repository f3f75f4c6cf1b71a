#pragma once
// Which picture formats are read, told by what a file begins with: its name may say anything.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dapple {

enum class PictureFormat {
    png,
    jpeg,
    tiff,
    openexr,
    radiance,
    webp,
    heif,
    jpeg2000,
    jxl,
    gif,
    bmp,
    targa,
    pnm,
    psd,
    fits,
    raw,  // of a camera
};

/// How many bytes of the beginning tell.
inline constexpr std::size_t kFormatBytes = 32;

/// From the first kFormatBytes of a file, or all where it is shorter. Nothing: none of these formats. Many
/// cameras' raw files begin as a TIFF does: is_camera_raw() tells.
std::optional<PictureFormat> format_of(std::span<const unsigned char> beginning);
/// The same; throws DecodeError where it is none of them.
PictureFormat format_or_refusal(std::span<const unsigned char> beginning);

/// The width and height that a GIF or a BMP begins with. Nothing: another format, or too few bytes.
struct StatedSize {
    std::int64_t width = 0, height = 0;
};
std::optional<StatedSize> stated_size(PictureFormat format, std::span<const unsigned char> beginning);

/// What OpenImageIO calls its reader, or its newer releases do: "png", "openexr".
std::string_view reader_of(PictureFormat format);
std::optional<PictureFormat> format_with_reader(std::string_view reader);

/// For sentences: "PNG, JPEG, ... or camera raw (DNG, CR2, NEF, ...)".
std::string picture_formats();

}  // namespace dapple
