// Pictures that libraries read wrong, or not at all, or of which they leave out what matters.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/decoding/decoder_process.h"
#include "io/files/environment_file.h"
#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/png_chunk.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

// IEC 61966-2-1.
double decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::string sentence_of(const fs::path& path) {
    try {
        read_picture(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

void run(const std::string& command) {
    REQUIRE_MESSAGE(std::system(command.c_str()) == 0, command);
}

std::string little_endian(std::uint32_t number) {
    const std::string bytes = big_endian(number);
    return {bytes.rbegin(), bytes.rend()};
}

std::string bmp(std::uint32_t width, std::uint32_t height, char bits, std::uint32_t compression,
                const std::string& palette, const std::string& pixels) {
    const auto colours = static_cast<std::uint32_t>(palette.size() / 4),
               begin = static_cast<std::uint32_t>(54 + palette.size()),
               size = static_cast<std::uint32_t>(pixels.size());
    return "BM" + little_endian(begin + size) + little_endian(0) + little_endian(begin) + little_endian(40) +
           little_endian(width) + little_endian(height) + std::string("\1\0", 2) + bits + '\0' +
           little_endian(compression) + little_endian(size) + little_endian(0) + little_endian(0) +
           little_endian(colours) + little_endian(0) + palette + pixels;
}

// The colour of the first pixel of the last row, as decoders give it.
glm::vec3 first_colour(const fs::path& path) {
    struct : ImageSink {
        void begin(const ImageHeader&) override {}
        void row(std::span<const glm::vec3> colours) override { colour = colours[0]; }
        glm::vec3 colour{-1};
    } sink;
    decode_file(path, {}, sink);
    return sink.colour;
}

// A 16-bit PNG of one colour whose colours are what these code points say.
fs::path coded(const TemporaryFolder& folder, const std::string& code_points, std::vector<float> colour) {
    const fs::path file = folder / "coded.png";
    write_picture(file, {.channels = 3, .values = std::move(colour), .type = "uint16"});
    put_text(file, with_chunk(text_of(file), "cICP", code_points));
    return file;
}

}  // namespace

TEST_CASE("a TIFF's numbers are read right however it is cut into strips and tiles, 64-bit floats too") {
    const TemporaryFolder folder;
    constexpr int width = 50, height = 130, channels = 3;
    PictureFile file{.width = width, .height = height, .channels = channels};
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < channels; ++c) file.values.push_back(static_cast<float>(i % 251 + 1) / 255);
    const auto check = [&](const PictureFile& picture) {
        CAPTURE(picture.type);
        CAPTURE(picture.strip);
        CAPTURE(picture.tile);
        CAPTURE(picture.planes);
        write_picture(folder / "a.tif", picture);
        const Picture read = read_picture(folder / "a.tif");
        REQUIRE(read.light.width == width);
        REQUIRE(read.light.height == height);
        const bool is_light = picture.type != "uint8" && picture.type != "uint16";
        double worst = 0;
        for (std::size_t i = 0; i < read.light.values.size(); ++i) {
            const double stored = picture.values[i * channels];
            worst = std::max(worst, std::abs(read.light.values[i] - (is_light ? stored : decoded(stored))));
        }
        CHECK(worst < (picture.type == "half" ? 1e-3 : 1e-5));
    };
    for (const char* const type : {"uint8", "uint16", "half", "float", "double"}) {
        file.type = type;
        file.strip = 20;
        check(file);
    }
    for (const int strip : {1, 32, 40, 130}) {
        file.strip = strip;
        check(file);
    }
    file.planes = true;
    check(file);
    file.strip = 0;
    for (const bool planes : {false, true}) {
        file.planes = planes;
        file.tile = 48;
        check(file);
    }
    // What is not there is not black.
    const std::string whole = text_of(folder / "a.tif");
    put_text(folder / "half.tif", whole.substr(0, whole.size() / 2));
    CHECK(sentence_of(folder / "half.tif") != "");
}

TEST_CASE("the fourth byte of a 32-bit BMP or TGA counts only if it is anywhere over 0") {
    const TemporaryFolder folder;
    for (const int last_alpha : {0, 255}) {
        // Blue, green, red, and what may be alpha.
        std::string pixels;
        for (int i = 0; i < 12; ++i)
            pixels += std::string{90, 90, 90, static_cast<char>(i == 11 ? last_alpha : 0)};
        put_text(folder / "a.bmp", bmp(4, 3, 32, 0, "", pixels));
        put_text(folder / "a.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\4\0\3\0\x20\x08", 18) + pixels);
        for (const char* const name : {"a.bmp", "a.tga"}) {
            CAPTURE(std::string(name));
            const Picture picture = read_picture(folder / name);
            REQUIRE(picture.light.width == 4);
            // Both begin with the bottom row.
            CHECK(picture.light.at(3, 0) == doctest::Approx(decoded(90 / 255.0)).epsilon(1e-4));
            CHECK(picture.light.at(0, 2) ==
                  doctest::Approx(last_alpha == 0 ? decoded(90 / 255.0) : 1).epsilon(1e-4));
        }
    }
}

TEST_CASE("a BMP of runs may end a line after its last row, and lack its end, but no row") {
    const TemporaryFolder folder;
    std::string palette;
    for (int i = 0; i < 256; ++i) palette += std::string(3, static_cast<char>(i)) + '\0';
    const auto light_of = [](int level) { return doctest::Approx(decoded(level / 255.0)).epsilon(1e-4); };
    // Two of 10, two of 200; then three as they are and one of 100. From the bottom up.
    const std::string bottom("\2\12\2\xc8", 4), top("\0\3\12\12\xc8\0\1\x64", 8), line(2, '\0'),
        end("\0\1", 2);
    for (const std::string& runs : {bottom + line + top + end, bottom + line + top + line + end,
                                    bottom + line + top + line + line + end, bottom + line + top + line}) {
        put_text(folder / "a.bmp", bmp(4, 2, 8, 1, palette, runs));
        const Picture picture = read_picture(folder / "a.bmp");
        REQUIRE(picture.light.height == 2);
        CHECK(picture.light.at(1, 1) == light_of(10));
        CHECK(picture.light.at(2, 1) == light_of(200));
        CHECK(picture.light.at(0, 0) == light_of(10));
        CHECK(picture.light.at(2, 0) == light_of(200));
        CHECK(picture.light.at(3, 0) == light_of(100));
    }
    // Four bits a pixel: three pixels, 12, 3 and 12 again, from the palette's beginning.
    put_text(folder / "a.bmp", bmp(3, 1, 4, 2, palette.substr(0, 64), std::string("\3\xc3\0\0\0\1", 6)));
    const Picture four = read_picture(folder / "a.bmp");
    CHECK(four.light.at(0, 0) == light_of(12));
    CHECK(four.light.at(1, 0) == light_of(3));
    for (const std::string& cut : {bottom, bottom + line, bottom + line + top}) {
        put_text(folder / "a.bmp", bmp(4, 2, 8, 1, palette, cut));
        CHECK(sentence_of(folder / "a.bmp") != "");
    }
}

TEST_CASE("what a PNG's cICP says of its colours is light as the standards have it") {
    const TemporaryFolder folder;
    const auto light_of = [&](const char* points, float value) {
        return first_colour(coded(folder, std::string(points, 4), {value, value, value})).y;
    };
    // Rec. BT.2408, table 1: 203 cd/m2, which is white here, is 58 % of PQ and 75 % of HLG.
    CHECK(light_of("\1\x10\0\1", 0.58f) == doctest::Approx(1).epsilon(0.02));
    CHECK(light_of("\1\x12\0\1", 0.75f) == doctest::Approx(1).epsilon(0.01));
    // Rec. BT.2100: the largest value of PQ is 10,000 cd/m2; 100 cd/m2 is 0.508. HLG on a screen of 1000.
    CHECK(light_of("\1\x10\0\1", 1) == doctest::Approx(10'000.0 / 203).epsilon(1e-3));
    CHECK(light_of("\1\x10\0\1", 0.508078f) == doctest::Approx(100.0 / 203).epsilon(2e-3));
    CHECK(light_of("\1\x12\0\1", 1) == doctest::Approx(1000.0 / 203).epsilon(1e-3));
    CHECK(light_of("\1\x10\0\1", 0) == 0);
    CHECK(light_of("\1\x08\0\1", 0.5f) == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(light_of("\1\x0d\0\1", 0.5f) == doctest::Approx(decoded(0.5)).epsilon(1e-3));

    const auto colour_of = [&](const char* points) {
        return first_colour(coded(folder, std::string(points, 4), {0.5f, 0.25f, 0.25f}));
    };
    const auto is = [](glm::vec3 colour, std::array<double, 3> expected) {
        for (int i = 0; i < 3; ++i)
            CHECK(colour[i] == doctest::Approx(expected[static_cast<std::size_t>(i)]).epsilon(2e-3));
    };
    is(colour_of("\1\x08\0\1"), {0.5, 0.25, 0.25});
    // The matrix of Rec. BT.2087, and that of Display P3 in CSS Color 4.
    is(colour_of("\x09\x08\0\1"), {0.66515, 0.21885, 0.24543});
    is(colour_of("\x0c\x08\0\1"), {0.55624, 0.23951, 0.24500});
    // White is white, also where it is another one.
    for (const char* const points : {"\x09\x08\0\1", "\x0b\x08\0\1", "\x0c\x08\0\1"})
        is(first_colour(coded(folder, std::string(points, 4), {0.5f, 0.5f, 0.5f})), {0.5, 0.5, 0.5});
    // Beyond what a screen of sRGB has, nothing is less than no light.
    is(first_colour(coded(folder, std::string("\x09\x08\0\1", 4), {0, 1, 0})), {0, 1.1329, 0});

    CHECK(read_picture(coded(folder, std::string("\x09\x10\0\1", 4), {1, 1, 0.5f})).description ==
          "1 x 1 pixels, 16-bit colour png, PQ, Rec. 2020");
    // What is not known is told, and the file is read as if it had said nothing.
    for (const char* const points : {"\x16\x0d\0\1", "\1\x01\0\1", "\1\x10\1\1", "\1\x10\0\0"}) {
        const Picture picture = read_picture(coded(folder, std::string(points, 4), {0.5f, 0.5f, 0.5f}));
        CHECK(picture.description.find(" is not known here") != std::string::npos);
        CHECK(picture.light.at(0, 0) == doctest::Approx(decoded(0.5)).epsilon(1e-3));
    }
}

TEST_CASE("pixels that are no squares are made so, and it is said") {
    const TemporaryFolder folder;
    const auto with_pixels = [&](std::uint32_t across, std::uint32_t down, int orientation = 1) {
        write_picture(folder / "a.png", {.width = 2,
                                         .height = 2,
                                         .values = {1, 0, 0, 1},
                                         .colour_space = "linear",
                                         .orientation = orientation});
        put_text(folder / "b.png",
                 with_chunk(text_of(folder / "a.png"), "pHYs", big_endian(across) + big_endian(down) + '\0'));
        return read_picture(folder / "b.png");
    };
    // 2 dots across where there are 3 down: pixels are wide.
    const Picture wide = with_pixels(2, 3);
    REQUIRE(wide.light.width == 3);
    REQUIRE(wide.light.height == 2);
    CHECK(wide.light.values == std::vector<float>{1, 0.5, 0, 0, 0.5, 1});
    CHECK(wide.description.ends_with(", whose pixels, 1.5 times as wide as high, are made square"));
    const Picture high = with_pixels(3, 2);
    REQUIRE(high.light.width == 2);
    REQUIRE(high.light.height == 3);
    CHECK(high.light.values == std::vector<float>{1, 0, 0.5, 0.5, 0, 1});
    CHECK(high.description.ends_with(", whose pixels, 1.5 times as high as wide, are made square"));
    const Picture more = with_pixels(1, 4);
    REQUIRE(more.light.width == 8);
    CHECK(more.light.values == std::vector<float>{1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1});
    // Nearly square, or nothing that a picture could have.
    for (const auto& [across, down] : {std::pair{1000, 1009}, {1009, 1000}, {1, 5}, {0, 1}, {1, 0}}) {
        const Picture square =
            with_pixels(static_cast<std::uint32_t>(across), static_cast<std::uint32_t>(down));
        CHECK(square.light.width == 2);
        CHECK(square.light.height == 2);
        CHECK(square.description.find("square") == std::string::npos);
    }

    // A fax, a JPEG with and without a unit, an EXR; and a first look at what is turned.
    const std::string a = folder.path().string() + "/";
    run("convert -size 102x49 gradient: -density 204x98 -units PixelsPerInch -type bilevel -compress "
        "group4 " +
        a + "fax.tif");
    run("convert -size 60x40 gradient: -density 100x200 -units Undefined " + a + "ratio.jpg");
    run("convert -size 60x40 gradient: -density 72x144 -units PixelsPerInch " + a + "inches.jpg");
    run("oiiotool --pattern constant:color=.5,.5,.5 60x40 3 --attrib:type=float PixelAspectRatio 2 -o " + a +
        "film.exr");
    struct Expected {
        const char* name;
        int width, height;
    };
    for (const Expected& expected : {Expected{"fax.tif", 102, 102}, Expected{"ratio.jpg", 120, 40},
                                     Expected{"inches.jpg", 120, 40}, Expected{"film.exr", 120, 40}}) {
        CAPTURE(std::string(expected.name));
        const Picture picture = read_picture(folder / expected.name);
        CHECK(picture.light.width == expected.width);
        CHECK(picture.light.height == expected.height);
        CHECK(picture.description.ends_with("are made square"));
    }
    run("convert -size 1700x850 gradient: -density 1x2 -units Undefined " + a + "large.jpg");
    const auto look = read_first_look(folder / "large.jpg");
    REQUIRE(look);
    CHECK(look->light.width == 4 * look->light.height);
    CHECK(look->description == read_picture(folder / "large.jpg").description);
}

TEST_CASE("a Radiance picture of XYZ is refused by its name, not for a lack of one") {
    const TemporaryFolder folder;
    const auto radiance = [](const std::string& format) {
        return "#?RADIANCE\nFORMAT=32-bit_rle_" + format + "\n\n-Y 1 +X 2\n" +
               "\x80\x80\x80\x81\x80\x80\x80\x81";
    };
    put_text(folder / "xyz.hdr", radiance("xyze"));
    CHECK(sentence_of(folder / "xyz.hdr").find("has colours as XYZ") != std::string::npos);
    put_text(folder / "other.hdr", radiance("cmyke"));
    CHECK(sentence_of(folder / "other.hdr").find("a format that is not Radiance's: 32-bit_rle_cmyke") !=
          std::string::npos);
    put_text(folder / "rgb.hdr", radiance("rgbe"));
    CHECK(sentence_of(folder / "rgb.hdr").empty());
}

TEST_CASE("the rows and columns of a Radiance picture may come in any order, and its pixels be no squares") {
    const TemporaryFolder folder;
    constexpr int width = 4, height = 2;
    const auto light_at = [](int x, int y) { return static_cast<float>(1 + x + 4 * y); };
    const auto number_of = [](int x, int y) {  // mantissas over 2^4
        return std::string(3, static_cast<char>(16 * (1 + x + 4 * y))) + '\x84';
    };
    for (const std::string first : {"-Y", "+Y", "-X", "+X"})
        for (const std::string sign : {"-", "+"}) {
            const bool columns = first[1] == 'X';
            const std::string second = sign + (columns ? "Y" : "X");
            const int rows = columns ? width : height, pixels = columns ? height : width;
            std::string bytes;
            for (int i = 0; i < rows; ++i)
                for (int j = 0; j < pixels; ++j) {
                    // x grows to the right, y up.
                    const auto along = [&](const std::string& axis, int steps, int side) {
                        return (axis[0] == '+') == (axis[1] == 'X') ? steps : side - 1 - steps;
                    };
                    const int a = along(first, i, rows), b = along(second, j, pixels);
                    bytes += columns ? number_of(a, b) : number_of(b, a);
                }
            const auto write = [&](const std::string& lines) {
                put_text(folder / "a.hdr", "#?RADIANCE\n" + lines + "\n" + first + " " +
                                               std::to_string(rows) + " " + second + " " +
                                               std::to_string(pixels) + "\n" + bytes);
            };
            CAPTURE(first);
            CAPTURE(second);
            // It may say nothing of its format either.
            for (const char* const format : {"FORMAT=32-bit_rle_rgbe\n", ""}) {
                write(format);
                const Picture picture = read_picture(folder / "a.hdr");
                const EnvironmentMap map = read_environment(folder / "a.hdr").map;
                REQUIRE(picture.light.width == width);
                REQUIRE(picture.light.height == height);
                REQUIRE(map.width() == width);
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        CHECK(picture.light.at(x, y) == doctest::Approx(light_at(x, y)));
                        CHECK(map.radiance().at(x, y).x == doctest::Approx(light_at(x, y)));
                    }
            }
            // Twice as high as wide, in two steps; of an environment map that says nothing.
            write("PIXASPECT= 4\nPIXASPECT=.5\n");
            const Picture high = read_picture(folder / "a.hdr");
            CHECK(high.light.width == width);
            REQUIRE(high.light.height == 2 * height);
            CHECK(high.light.at(1, 1) == doctest::Approx(light_at(1, 0)));
            CHECK(high.light.at(1, 2) == doctest::Approx(light_at(1, 1)));
            CHECK(read_environment(folder / "a.hdr").map.height() == height);
        }
    for (const char* const size : {"-Y 2 +Y 4", "+Y 2", "-Y 0 +X 4", "2 4", ""}) {
        put_text(folder / "a.hdr", std::string("#?RADIANCE\n\n") + size + "\n" + std::string(32, '\x80'));
        CHECK(sentence_of(folder / "a.hdr").find("its header has no size") != std::string::npos);
    }
}

TEST_CASE("a map of light is turned as its file says, as a picture is") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    for (int orientation = 1; orientation <= 8; ++orientation) {
        CAPTURE(orientation);
        const bool on_its_side = orientation > 4;
        PictureFile file{.width = on_its_side ? 16 : 32,
                         .height = on_its_side ? 32 : 16,
                         .type = "float",
                         .orientation = orientation};
        for (int i = 0; i < 32 * 16; ++i) file.values.push_back(static_cast<float>(i / 64 + 1) / 8);
        write_picture(folder / "a.tif", file);
        write_picture(folder / "a.exr", file);
        file.type = "uint8";
        write_picture(folder / "a.jpg", file);
        for (const char* const name : {"a.tif", "a.exr", "a.jpg"}) {
            CAPTURE(std::string(name));
            const Grid<float> picture = read_picture(folder / name).light;
            const EnvironmentMap map = read_environment(folder / name).map;
            REQUIRE(picture.width == 32);
            REQUIRE(map.width() == 32);
            for (std::size_t i = 0; i < picture.values.size(); ++i)
                CHECK(map.radiance().values[i].x == doctest::Approx(picture.values[i]).epsilon(1e-4));
        }
    }
}

TEST_CASE("the light of a Radiance picture is its values by all that they were multiplied by") {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& lines) {
        put_text(folder / "map.hdr", "#?RADIANCE\n" + lines + "FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" +
                                         "\x80\x80\x80\x81\x80\x80\x80\x81");
    };
    const auto light = [&](const std::string& lines) {
        write(lines);
        return read_environment(folder / "map.hdr").map.radiance().at(0, 0);
    };
    CHECK(light("") == glm::vec3(1));
    CHECK(light("EXPOSURE=4\n") == glm::vec3(0.25));
    CHECK(light("EXPOSURE= 4.0\nGAMMA=1\nEXPOSURE=0.5\n") == glm::vec3(0.5));
    CHECK(light("EXPOSURE=2\nCOLORCORR=1 2 0.25\n") == glm::vec3(0.5, 0.25, 2));
    // Of another picture that this one was made of.
    CHECK(light("\tEXPOSURE=4\n") == glm::vec3(1));
    for (const std::string wrong :
         {"EXPOSURE=0\n", "EXPOSURE=-1\n", "EXPOSURE=light\n", "EXPOSURE=1e-300\n", "COLORCORR=1 1\n"}) {
        write(wrong);
        CHECK(sentence_of(folder / "map.hdr").find("says in its header by which EXPOSURE or COLORCORR") !=
              std::string::npos);
    }
}
