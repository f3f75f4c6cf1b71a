// What is transparent shows paper, or in a map of light and in a slice nothing, in whatever format a picture
// comes.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/mask.h"
#include "io/files/environment_file.h"
#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/png_chunk.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 32, kHeight = 16;

// IEC 61966-2-1.
double decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void run(const std::string& command) {
    REQUIRE_MESSAGE(std::system(command.c_str()) == 0, command);
}

// A sticker: colours in the middle, of few kinds, around them nothing. `soft`: between them half of the
// colour.
std::vector<float> sticker(bool soft, bool grey) {
    std::vector<float> values;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const bool inside = x > 7 && x < 24 && y > 3 && y < 12,
                       edge = x == 8 || x == 23 || y == 4 || y == 11;
            const int kind = (x / 4 + y / 4) % 3;
            const float red = inside ? (kind == 0 ? 200 : 40) / 255.0f : 0,
                        green = inside ? (kind == 1 ? 160 : 60) / 255.0f : 0;
            if (grey)
                values.push_back(green);
            else
                values.insert(values.end(), {red, green, 20 / 255.0f});
            values.push_back(!inside ? 0 : soft && edge ? 128 / 255.0f : 1);
        }
    return values;
}

// As Photoshop stores it: "merged" pixels behind a layer packed by ZIP, channel by channel, mixed with white.
std::string psd(const std::vector<float>& pixels, int channels, int bits, bool runs, bool white) {
    const auto two = [](std::uint32_t number) { return big_endian(number).substr(2); };
    std::string planes, lengths, packed;
    for (int channel = 0; channel < channels; ++channel)
        for (int y = 0; y < kHeight; ++y) {
            std::string row;
            for (int x = 0; x < kWidth; ++x) {
                const float* const pixel = pixels.data() + (y * kWidth + x) * channels;
                const float alpha = pixel[channels - 1];
                float value = pixel[channel];
                if (white && channel + 1 < channels) value = value * alpha + 1 - alpha;
                const auto level = static_cast<std::uint32_t>(std::lround(value * (bits == 8 ? 255 : 65535)));
                row += bits == 8 ? std::string(1, static_cast<char>(level)) : two(level);
            }
            planes += row;
            // The first byte as it is, the rest as runs of two and more, or as they are.
            std::string line = std::string(1, '\0') + row[0];
            for (std::size_t at = 1; at < row.size();) {
                std::size_t same = 1;
                while (at + same < row.size() && same < 100 && row[at + same] == row[at]) ++same;
                line +=
                    std::string(1, static_cast<char>(same == 1 ? 0 : 1 - static_cast<int>(same))) + row[at];
                at += same;
            }
            lengths += two(static_cast<std::uint32_t>(line.size()));
            packed += line;
        }
    // Of one layer, of 1 x 1 pixels, with a channel of transparency and one of colour.
    std::string layer = two(0xffff) + big_endian(0) + big_endian(0) + big_endian(1) + big_endian(1) + two(2);
    const std::string zip = two(2) + "nothing that unpacks";
    for (const std::uint32_t channel : {0xffffu, 0u})
        layer += two(channel) + big_endian(static_cast<std::uint32_t>(zip.size()));
    layer += "8BIMnorm" + std::string("\xff\0\0\0", 4) + big_endian(12) + big_endian(0) + big_endian(0) +
             std::string("\1L\0\0", 4) + zip + zip;
    const std::string layers = big_endian(static_cast<std::uint32_t>(layer.size())) + layer;
    return "8BPS" + two(1) + std::string(6, '\0') + two(static_cast<std::uint32_t>(channels)) +
           big_endian(kHeight) + big_endian(kWidth) + two(static_cast<std::uint32_t>(bits)) +
           two(channels == 2 ? 1 : 3) + big_endian(0) + big_endian(0) +
           big_endian(static_cast<std::uint32_t>(layers.size())) + layers + two(runs ? 1 : 0) +
           (runs ? lengths + packed : planes);
}

// A TGA of grey and alpha, from the top down.
std::string grey_targa(const std::vector<float>& pixels) {
    std::string bytes("\0\0\3\0\0\0\0\0\0\0\0\0", 12);
    bytes += std::string{kWidth, 0, kHeight, 0, 16, 0x28};
    for (const float value : pixels) bytes += static_cast<char>(std::lround(value * 255));
    return bytes;
}

struct Like {
    std::string name;
    double within = 1e-4;
};

// That each file is read as the PNG is, for whatever use.
void check_same(const TemporaryFolder& folder, const std::string& png, const std::vector<Like>& files) {
    const Picture right = read_picture(folder / png, PictureLimit::usual, PictureColours::kept);
    const EnvironmentMap right_map = read_environment(folder / png).map;
    const auto differ = [](const std::vector<float>& a, const std::vector<float>& b) {
        REQUIRE(a.size() == b.size());
        double most = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            most = std::max(most, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
        return most;
    };
    for (const Like& file : files) {
        CAPTURE(file.name);
        const Picture read = read_picture(folder / file.name, PictureLimit::usual, PictureColours::kept);
        CHECK(differ(read.light.values, right.light.values) < file.within);
        CHECK(read.description.find(" with transparency") != std::string::npos);
        int shades = 0;
        for (std::size_t i = 0; i < read.preview.values.size(); ++i)
            for (int c = 0; c < 3; ++c)
                shades = std::max(shades, std::abs(read.preview.values[i][c] - right.preview.values[i][c]));
        CHECK(shades <= (file.within > 1e-3 ? 3 : 1));
        if (file.within < 1e-3) CHECK(mask_of(read.light) == mask_of(right.light));
        const auto environment = read_environment(folder / file.name);
        const Grid<glm::vec3>& map = environment.map.radiance();
        double most = 0;
        for (std::size_t i = 0; i < map.values.size(); ++i)
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(static_cast<double>(map.values[i][c]) -
                                               static_cast<double>(right_map.radiance().values[i][c])));
        CHECK(most < file.within);
    }
}

}  // namespace

TEST_CASE("transparent parts are the same in every format that has them, for whatever a picture is read") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    const std::vector<float> soft = sticker(true, false);
    PictureFile file{.width = kWidth, .height = kHeight, .channels = 4, .values = soft};
    write_picture(folder / "soft.png", file);
    // By hand, in the middle of an edge: over paper, and over nothing.
    const int edge = 4 * kWidth + 12, inside = 6 * kWidth + 12;
    const double dark =
        0.2126 * decoded(40 / 255.0) + 0.7152 * decoded(160 / 255.0) + 0.0722 * decoded(20 / 255.0);
    const Picture png = read_picture(folder / "soft.png");
    CHECK(png.light.values[0] == 1);
    CHECK(png.light.values[edge] == doctest::Approx(dark * 128 / 255 + 127 / 255.0).epsilon(1e-4));
    const EnvironmentMap map = read_environment(folder / "soft.png").map;
    CHECK(map.radiance().values[0] == glm::vec3(0));
    CHECK(map.radiance().values[edge].y == doctest::Approx(decoded(160 / 255.0) * 128 / 255).epsilon(1e-4));
    CHECK(png.light.values[inside] < 0.5);

    write_picture(folder / "soft.bmp", file);
    write_picture(folder / "soft.tga", file);
    write_picture(folder / "straight.tif", file);
    file.type = "uint16";
    write_picture(folder / "straight16.tif", file);
    write_picture(folder / "soft16.png", file);
    file.premultiplied = true;
    for (std::size_t i = 0; i < file.values.size(); ++i)
        if (i % 4 != 3) file.values[i] *= file.values[i / 4 * 4 + 3];
    write_picture(folder / "associated16.tif", file);
    file = {.width = kWidth, .height = kHeight, .channels = 4, .values = {}, .type = "float"};
    for (std::size_t i = 0; i < soft.size(); ++i)
        file.values.push_back(i % 4 == 3 ? soft[i]
                                         : static_cast<float>(decoded(static_cast<double>(soft[i]))) *
                                               soft[i / 4 * 4 + 3]);
    write_picture(folder / "soft.exr", file);
    const std::string from = "convert " + in + "soft.png ";
    run(from + "-define webp:lossless=true " + in + "soft.webp");
    run(from + in + "soft.jp2");
    put_text(folder / "runs.psd", psd(soft, 4, 8, true, false));
    put_text(folder / "runs16.psd", psd(soft, 4, 16, true, true));
    put_text(folder / "white.psd", psd(soft, 4, 8, false, true));
    put_text(folder / "white16.psd", psd(soft, 4, 16, false, true));
    // What another program writes.
    run(from + in + "magick.psd");
    check_same(folder, "soft.png",
               {{"soft.bmp"},
                {"soft.tga"},
                {"straight.tif"},
                {"straight16.tif"},
                {"soft16.png"},
                {"associated16.tif"},
                {"soft.exr", 5e-4},
                {"soft.webp", 0.01},
                {"soft.jp2", 0.01},
                {"runs.psd"},
                {"runs16.psd"},
                {"white.psd", 0.01},  // a bit is lost
                {"white16.psd"},
                {"magick.psd"}});
}

TEST_CASE("transparent parts are the same where they are of one colour, and where all is grey") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    const std::vector<float> cut = sticker(false, false), grey = sticker(true, true);
    write_picture(folder / "cut.png", {.width = kWidth, .height = kHeight, .channels = 4, .values = cut});
    const std::string whole = "convert " + in + "cut.png ";
    run(whole + in + "cut.gif");
    run(whole + "-define png:exclude-chunk=gAMA,cHRM PNG8:" + in + "palette.png");
    // The first picture is smaller than its screen.
    run("convert " + in + "cut.png -trim -set page 32x16+8+4 " + in + "small.gif");
    check_same(folder, "cut.png", {{"cut.gif"}, {"palette.png"}, {"small.gif"}});

    write_picture(folder / "grey.png", {.width = kWidth, .height = kHeight, .channels = 2, .values = grey});
    write_picture(folder / "grey.tif", {.width = kWidth, .height = kHeight, .channels = 2, .values = grey});
    put_text(folder / "grey.tga", grey_targa(grey));
    put_text(folder / "grey.psd", psd(grey, 2, 8, true, false));
    put_text(folder / "white.psd", psd(grey, 2, 16, false, true));
    check_same(folder, "grey.png", {{"grey.tif"}, {"grey.tga"}, {"grey.psd"}, {"white.psd"}});
}

TEST_CASE("a PSD that ends within its merged picture is refused, wherever that is") {
    const TemporaryFolder folder;
    const std::string whole = psd(sticker(true, true), 2, 8, true, true);
    for (std::size_t size = 4; size < whole.size(); size += 97) {
        put_text(folder / "a.psd", whole.substr(0, size));
        CHECK_THROWS_AS(read_picture(folder / "a.psd"), std::runtime_error);
    }
}

TEST_CASE("a sticker is drawn, masks and is screened as its PNG is when it is a GIF") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    write_picture(folder / "a.png",
                  {.width = kWidth, .height = kHeight, .channels = 4, .values = sticker(false, false)});
    run("convert " + in + "a.png " + in + "b.gif");
    const auto drawn = [&](const std::string& arguments, const std::string& output) {
        const Outcome outcome = run_either(arguments);
        REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
        return text_of(folder / output);
    };
    std::vector<std::string> first;
    for (const std::string name : {"a.png", "b.gif"}) {
        CAPTURE(name);
        // By one name, which lists of lights have in them.
        fs::rename(folder / name, folder / "sticker");
        const std::string at = in + "sticker";
        const std::vector<std::string> now{
            drawn("render " + at + " --dots 500 -o " + in + "o.csv", "o.csv"),
            drawn("render " + at + " --dots 500 --pens cmyk -o " + in + "o.csv", "o.csv"),
            drawn("render --dots 500 --mask " + at + " -o " + in + "o.csv", "o.csv"),
            drawn("render --dots 500 --finer " + at + " -o " + in + "o.csv", "o.csv"),
            drawn("mask --size 16 --screen " + at + " -o " + in + "m.png", "m-screened.png"),
            drawn("lights " + at + " -n 50 -o " + in + "o.csv", "o.csv"),
            drawn("volume " + at + " -n 50 -o " + in + "o.csv", "o.csv")};
        if (first.empty()) first = now;
        CHECK(now == first);
    }
}
