#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "io/decoding/picture_format.h"

using namespace dapple;
using namespace std::string_view_literals;

namespace {

std::optional<PictureFormat> told(std::string_view bytes) {
    return format_of({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

}  // namespace

TEST_CASE("formats that end badly or are no pictures are not taken for one that is read") {
    // IFF corrupts the heap in a library; SGI, Cineon, DPX, ICO, Zfile; text, playlists, scripts, programs.
    for (const std::string_view bytes :
         {"FOR4\0\0\x0e\x54"
          "CIMGTBHD\0\0\0\x20\0\0\0\0\0\0\0\0"sv,
          "\x01\xda\0\x01\0\x03\x26\0\0\x28\0\x1e\0\x03\0\0\0\0\0\0"sv, "\x80\x2a\x5f\xd7\0\0\0\0\0\0\0\0"sv,
          "SDPX\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"sv, "\0\0\x01\0\x01\0\x10\x10\0\0\x01\0\x20\0\0\0\0\0\0\0"sv,
          "This is a sentence of some length."sv, "#!/bin/sh\nexec convert a b\n"sv, "#EXTM3U\na.png\n"sv,
          "\x7f"
          "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0\x3e\0"sv,
          "RIFF\0\0\0\0AVI LIST\0\0\0\0\0\0\0\0"sv, "P9 3 3 255 and so on"sv,
          "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"sv, "%PDF-1.7\n%\xe2\xe3\xcf\xd3\n1 0 obj"sv,
          "<svg xmlns=\"http://www.w3.org/2000/svg\">"sv, ""sv, "P"sv}) {
        CAPTURE(std::string(bytes));
        CHECK_FALSE(told(bytes));
    }
}

TEST_CASE("a format is told by the marks that its standard gives it") {
    CHECK(told("\x89PNG\r\n\x1a\n\0\0\0\rIHDR"sv) == PictureFormat::png);
    CHECK(told("\xff\xd8\xff\xe0\0\x10JFIF"sv) == PictureFormat::jpeg);
    CHECK(told("MM\0*\0\0\0\x08"sv) == PictureFormat::tiff);
    CHECK(told("II+\0\x08\0\0\0"sv) == PictureFormat::tiff);
    CHECK(told("#?RGBE\nFORMAT="sv) == PictureFormat::radiance);
    CHECK(told("\0\0\0\x18"
               "ftypheic\0\0\0\0"sv) == PictureFormat::heif);
    CHECK(told("\xff\x0a\xfa\x1f\x01"sv) == PictureFormat::jxl);
    CHECK(told("\0\0\0\x0c"
               "JXL \r\n\x87\n\0\0\0\x14"sv) == PictureFormat::jxl);
    CHECK(told("P5\n3 3\n255\n"sv) == PictureFormat::pnm);
    CHECK(told("II*\0\x10\0\0\0CR\x02\0"sv) == PictureFormat::raw);
    CHECK(told("\0\0\0\x18"
               "ftypcrx \0\0\0\x01"sv) == PictureFormat::raw);
    CHECK(told("FUJIFILMCCD-RAW 0201FF"sv) == PictureFormat::raw);
    CHECK(told("IIU\0\x18\0\0\0"sv) == PictureFormat::raw);
    CHECK(told("8BPS\0\x01\0\0\0\0\0\0"sv) == PictureFormat::psd);
}

TEST_CASE("each reader's name leads back to its format, and all are in the sentence") {
    for (int i = 0; i <= static_cast<int>(PictureFormat::raw); ++i) {
        const auto format = static_cast<PictureFormat>(i);
        CHECK(format_with_reader(reader_of(format)) == format);
    }
    CHECK_FALSE(format_with_reader("null"));
    CHECK_FALSE(format_with_reader(""));
    CHECK(picture_formats().starts_with("PNG, JPEG, TIFF"));
    CHECK(picture_formats().ends_with("ARW, RAF and others)"));
}
