#include "io/decoding/picture_format.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "io/decoding/decoded_image.h"

namespace dapple {
namespace {

struct KnownFormat {
    PictureFormat format;
    std::string_view reader, name;
};

constexpr std::array<KnownFormat, 16> kFormats{{
    {PictureFormat::png, "png", "PNG"},
    {PictureFormat::jpeg, "jpeg", "JPEG"},
    {PictureFormat::tiff, "tiff", "TIFF"},
    {PictureFormat::openexr, "openexr", "OpenEXR"},
    {PictureFormat::radiance, "hdr", "Radiance HDR"},
    {PictureFormat::webp, "webp", "WebP"},
    {PictureFormat::heif, "heif", "HEIC, AVIF"},
    {PictureFormat::jpeg2000, "jpeg2000", "JPEG 2000"},
    {PictureFormat::jxl, "jpegxl", "JPEG XL"},
    {PictureFormat::gif, "gif", "GIF"},
    {PictureFormat::bmp, "bmp", "BMP"},
    {PictureFormat::targa, "targa", "TGA"},
    {PictureFormat::pnm, "pnm", "PBM, PGM, PPM, PFM"},
    {PictureFormat::psd, "psd", "PSD"},
    {PictureFormat::fits, "fits", "FITS"},
    {PictureFormat::raw, "raw", "camera raw (DNG, CR2, CR3, NEF, ARW, RAF and others)"},
}};

// The bytes at an offset.
struct Mark {
    PictureFormat format;
    std::size_t offset;
    std::string_view bytes;
};

using namespace std::string_view_literals;

constexpr auto kMarks = std::to_array<Mark>({
    {PictureFormat::png, 0, "\x89PNG\r\n\x1a\n"sv},
    {PictureFormat::jpeg, 0, "\xff\xd8\xff"sv},
    {PictureFormat::raw, 8, "CR\x02"sv},            // CR2, of Canon
    {PictureFormat::raw, 4, "ftypcrx "sv},          // CR3
    {PictureFormat::raw, 6, "HEAPCCDR"sv},          // CRW
    {PictureFormat::raw, 0, "FUJIFILMCCD-RAW "sv},  // RAF
    {PictureFormat::raw, 0, "IIRO"sv},              // ORF, of Olympus
    {PictureFormat::raw, 0, "IIRS"sv},
    {PictureFormat::raw, 0, "MMOR"sv},
    {PictureFormat::raw, 0, "IIU\0"sv},  // RW2, of Panasonic
    {PictureFormat::raw, 0, "\0MRM"sv},  // MRW, of Minolta
    {PictureFormat::raw, 0, "FOVb"sv},   // X3F, of Sigma
    {PictureFormat::tiff, 0, "II*\0"sv},
    {PictureFormat::tiff, 0, "MM\0*"sv},
    {PictureFormat::tiff, 0, "II+\0"sv},  // of over 4 gigabytes
    {PictureFormat::tiff, 0, "MM\0+"sv},
    {PictureFormat::openexr, 0, "v/1\x01"sv},
    {PictureFormat::radiance, 0, "#?RADIANCE"sv},
    {PictureFormat::radiance, 0, "#?RGBE"sv},
    {PictureFormat::webp, 8, "WEBPVP8"sv},
    {PictureFormat::heif, 4, "ftyphei"sv},
    {PictureFormat::heif, 4, "ftyphev"sv},
    {PictureFormat::heif, 4, "ftypmif1"sv},
    {PictureFormat::heif, 4, "ftypmsf1"sv},
    {PictureFormat::heif, 4, "ftypavif"sv},
    {PictureFormat::jpeg2000, 0, "\0\0\0\x0cjP  \r\n\x87\n"sv},
    {PictureFormat::jpeg2000, 0, "\xff\x4f\xff\x51"sv},
    {PictureFormat::jxl, 0, "\xff\x0a"sv},
    {PictureFormat::jxl, 0, "\0\0\0\x0cJXL \r\n\x87\n"sv},
    {PictureFormat::gif, 0, "GIF87a"sv},
    {PictureFormat::gif, 0, "GIF89a"sv},
    {PictureFormat::psd, 0, "8BPS\0\x01"sv},
    {PictureFormat::psd, 0, "8BPS\0\x02"sv},
    {PictureFormat::fits, 0, "SIMPLE  ="sv},
});

bool is_pnm(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' && "123456Ff"sv.find(bytes[1]) != std::string_view::npos &&
           " \t\r\n"sv.find(bytes[2]) != std::string_view::npos;
}

// "BM", and the size of the second header, which is one of a few.
bool is_bmp(std::string_view bytes) {
    if (bytes.size() < 18 || !bytes.starts_with("BM")) return false;
    const auto size = static_cast<unsigned char>(bytes[14]);
    constexpr std::array<unsigned char, 7> kSizes{12, 40, 52, 56, 64, 108, 124};
    return std::ranges::find(kSizes, size) != kSizes.end() && bytes.substr(15, 3) == "\0\0\0"sv;
}

// TGA begins with no mark of its own: only with numbers that have to fit together.
bool is_targa(std::string_view bytes) {
    if (bytes.size() < 18) return false;
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const int palette = at(1), kind = at(2) & ~8, bits = at(16), width = at(12) + 256 * at(13),
              height = at(14) + 256 * at(15);
    if (at(2) > 11 || palette > 1 || kind < 1 || kind > 3 || width == 0 || height == 0) return false;
    if ((at(17) & 0xc0) != 0) return false;  // interleaved, which nothing writes
    const int palette_bits = at(7);
    if (kind == 1)
        return palette == 1 && (bits == 8 || bits == 16) && palette_bits >= 15 && palette_bits <= 32;
    if (kind == 3) return palette == 0 && (bits == 8 || bits == 16);
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

}  // namespace

std::optional<PictureFormat> format_of(std::span<const unsigned char> beginning) {
    const std::string_view bytes(reinterpret_cast<const char*>(beginning.data()), beginning.size());
    for (const Mark& mark : kMarks)
        if (bytes.size() >= mark.offset + mark.bytes.size() &&
            bytes.substr(mark.offset).starts_with(mark.bytes))
            return mark.format;
    if (is_pnm(bytes)) return PictureFormat::pnm;
    if (is_bmp(bytes)) return PictureFormat::bmp;
    if (is_targa(bytes)) return PictureFormat::targa;
    return std::nullopt;
}

std::optional<StatedSize> stated_size(PictureFormat format, std::span<const unsigned char> beginning) {
    if (beginning.size() < kFormatBytes) return std::nullopt;
    const auto number = [&](std::size_t at, int bytes) {
        std::uint32_t value = 0;
        for (int i = bytes; i-- > 0;) value = value << 8 | beginning[at + i];
        return value;
    };
    if (format == PictureFormat::gif) return StatedSize{number(6, 2), number(8, 2)};
    if (format != PictureFormat::bmp) return std::nullopt;
    if (number(14, 4) == 12) return StatedSize{number(18, 2), number(20, 2)};  // of OS/2
    // Below 0 where the first row is the top one.
    const std::int64_t height = static_cast<std::int32_t>(number(22, 4));
    return StatedSize{static_cast<std::int32_t>(number(18, 4)), std::abs(height)};
}

std::string_view reader_of(PictureFormat format) {
    return std::ranges::find(kFormats, format, &KnownFormat::format)->reader;
}

std::optional<PictureFormat> format_with_reader(std::string_view reader) {
    const auto found = std::ranges::find(kFormats, reader, &KnownFormat::reader);
    return found == kFormats.end() ? std::nullopt : std::optional(found->format);
}

PictureFormat format_or_refusal(std::span<const unsigned char> beginning) {
    if (const auto format = format_of(beginning)) return *format;
    throw DecodeError("not a picture that can be read; it would have to be " + picture_formats());
}

std::string picture_formats() {
    std::string all;
    for (std::size_t i = 0; i < kFormats.size(); ++i) {
        if (i > 0) all += i + 1 == kFormats.size() ? " or " : ", ";
        all += kFormats[i].name;
    }
    return all;
}

}  // namespace dapple
