#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

// IEC 61966-2-1.
double decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<float> ramp(int count) {
    std::vector<float> values(count);
    for (int i = 0; i < count; ++i) values[i] = static_cast<float>(i) / static_cast<float>(count - 1);
    return values;
}

std::string sentence_of(const std::filesystem::path& path) {
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

}  // namespace

TEST_CASE("integer pixels are decoded from sRGB, float ones are light already") {
    const TemporaryFolder folder;
    for (const char* type : {"uint8", "uint16"}) {
        for (const char* name : {"ramp.png", "ramp.tif"}) {
            CAPTURE(std::string(type));
            CAPTURE(std::string(name));
            write_picture(folder / name, {.width = 256, .values = ramp(256), .type = type});
            const Picture picture = read_picture(folder / name);
            REQUIRE(picture.light.width == 256);
            for (int i = 0; i < 256; ++i) {
                CHECK(picture.light.at(i, 0) == doctest::Approx(decoded(i / 255.0)).epsilon(1e-3));
            }
        }
    }
    write_picture(folder / "ramp.exr", {.width = 256, .values = ramp(256), .type = "float"});
    const Picture floats = read_picture(folder / "ramp.exr");
    for (int i = 0; i < 256; ++i) CHECK(floats.light.at(i, 0) == doctest::Approx(i / 255.0).epsilon(1e-5));
}

TEST_CASE("light from in front of a camera is exposed so that it can be seen, but not changed") {
    const TemporaryFolder folder;
    std::vector<float> values = ramp(256);
    for (float& v : values) v = 50 * v + 5;
    write_picture(folder / "sun.exr", {.width = 256, .values = values, .type = "float"});
    const Picture sun = read_picture(folder / "sun.exr");
    CHECK(sun.light.at(255, 0) == doctest::Approx(55).epsilon(1e-4));
    CHECK(sun.exposure < -5);
    CHECK(sun.exposure > -8);
    const double middle = sun.light.at(128, 0) * std::exp2(sun.exposure);
    REQUIRE(middle < 0.9);
    CHECK(decoded(sun.preview.at(128, 0).x / 255.0) == doctest::Approx(middle).epsilon(0.02));

    // The same light in a file whose white is 1.
    write_picture(folder / "night.png", {.width = 2, .values = {0, 0.01f}});
    CHECK(read_picture(folder / "night.png").exposure == 0);
}

TEST_CASE("a first look at a large JPEG is the same picture, smaller") {
    const TemporaryFolder folder;
    constexpr int kWidth = 1600, kHeight = 400;
    PictureFile file{.width = kWidth, .height = kHeight, .channels = 3, .orientation = 6};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (const int value : {x * 255 / kWidth, y * 255 / kHeight, (x / 200 + y / 50) % 2 * 128})
                file.values.push_back(static_cast<float>(value) / 255);
    write_picture(folder / "large.jpg", file);
    const Picture whole = read_picture(folder / "large.jpg", PictureLimit::usual, PictureColours::kept);
    const auto look = read_first_look(folder / "large.jpg", PictureColours::kept);
    REQUIRE(look);
    REQUIRE(look->light.height == kWidth / 2);  // turned, as the whole one is
    REQUIRE(look->light.width == kHeight / 2);
    CHECK(look->colours.width == look->light.width);
    CHECK(look->description == whole.description);
    double worst = 0, sum = 0, whole_sum = 0;
    for (int y = 0; y < look->light.height; ++y)
        for (int x = 0; x < look->light.width; ++x) {
            double mean = 0;
            for (const int i : {0, 1})
                for (const int j : {0, 1}) mean += whole.light.at(2 * x + i, 2 * y + j) / 4;
            worst = std::max(worst, std::abs(look->light.at(x, y) - mean));
            sum += look->light.at(x, y);
            whole_sum += mean;
        }
    CHECK(worst < 0.03);
    CHECK(sum == doctest::Approx(whole_sum).epsilon(0.002));

    std::string bytes = text_of(folder / "large.jpg");
    put_text(folder / "cut.jpg", bytes.substr(0, bytes.size() / 2));
    CHECK_FALSE(read_first_look(folder / "cut.jpg"));
    CHECK(sentence_of(folder / "cut.jpg").find("cut.jpg: the picture is damaged") != std::string::npos);
    write_picture(folder / "small.jpg", {.width = 2, .values = {0, 1}});
    for (const char* name : {"small.jpg", "missing.jpg"}) CHECK_FALSE(read_first_look(folder / name));
}

TEST_CASE("a first look at a file with mipmaps is one of them") {
    const TemporaryFolder folder;
    const std::string to = folder.path().string();
    run("convert -size 3600x2400 gradient:white-black " + to + "/whole.png");
    for (const char* name : {"mip.tif", "mip.exr"})
        run("oiiotool " + to + "/whole.png -d half -otex " + to + "/" + name + " >/dev/null");
    // Pages: the picture, its halves, and one that is another picture.
    run("convert " + to + "/whole.png -depth 8 ptif:" + to + "/pages.tif");
    std::string pages = to + "/pages.tif";
    CHECK_FALSE(read_first_look(folder / "pages.tif"));  // nothing says that they are the same
    for (const char* page : {"1", "2"}) run("tiffset -d " + std::string(page) + " -s 254 1 " + pages);
    for (const char* name : {"mip.tif", "mip.exr", "pages.tif"}) {
        CAPTURE(std::string(name));
        const Picture whole = read_picture(folder / name);
        CHECK(whole.light.width == 3600);
        const auto look = read_first_look(folder / name, PictureColours::kept);
        REQUIRE(look);
        CHECK(look->light.width == 900);
        CHECK(look->light.height == 600);
        CHECK_FALSE(look->colours.empty());
        CHECK(look->description == whole.description);
        for (const int row : {10, 300, 590})
            CHECK(look->light.at(450, row) ==
                  doctest::Approx(whole.light.at(1800, 4 * row + 2)).epsilon(0.03));
    }
    run("oiiotool " + to + "/whole.png --resize 1500x1000 -d half -otex " + to + "/small.exr >/dev/null");
    run("oiiotool " + to + "/whole.png -d half --tile 64 64 -o " + to + "/tiles.exr >/dev/null");
    for (const char* name : {"small.exr", "tiles.exr", "whole.png"})
        CHECK_FALSE(read_first_look(folder / name));
}

TEST_CASE("reading that is stopped ends at once, with a sentence") {
    const TemporaryFolder folder;
    write_picture(folder / "a.jpg", {.width = 100, .height = 100, .values = ramp(10'000)});
    std::stop_source stop;
    stop.request_stop();
    CHECK_THROWS_WITH(
        read_picture(folder / "a.jpg", PictureLimit::usual, PictureColours::left_out, stop.get_token()),
        doctest::Contains("a.jpg: was not read to its end: it was stopped"));
}

TEST_CASE("a file that says its pixels are linear is believed") {
    const TemporaryFolder folder;
    write_picture(folder / "linear.png",
                  {.width = 3, .values = {0, 0.5f, 1}, .type = "uint16", .colour_space = "linear"});
    CHECK(read_picture(folder / "linear.png").light.at(1, 0) == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("luminance has the weights of Rec. 709") {
    const TemporaryFolder folder;
    write_picture(folder / "rgb.png", {.width = 3, .channels = 3, .values = {1, 0, 0, 0, 1, 0, 0, 0, 1}});
    const Picture picture = read_picture(folder / "rgb.png");
    CHECK(picture.light.at(0, 0) == doctest::Approx(0.2126));
    CHECK(picture.light.at(1, 0) == doctest::Approx(0.7152));
    CHECK(picture.light.at(2, 0) == doctest::Approx(0.0722));
    CHECK(picture.preview.at(0, 0) == glm::u8vec4(255, 0, 0, 255));
}

TEST_CASE("transparent parts show white paper") {
    const TemporaryFolder folder;
    // Black at alpha 0, 0.2, 1; the colour under alpha 0 is not seen.
    write_picture(folder / "rgba.png",
                  {.width = 3, .channels = 4, .values = {0, 0, 0, 0, 0, 0, 0, 0.2f, 0, 0, 0, 1}});
    write_picture(folder / "ya.png", {.width = 3, .channels = 2, .values = {0, 0, 0, 0.2f, 0, 1}});
    write_picture(folder / "rgba.tif",
                  {.width = 3, .channels = 4, .values = {0, 0, 0, 0, 0, 0, 0, 0.2f, 0, 0, 0, 1}});
    for (const char* name : {"rgba.png", "ya.png", "rgba.tif"}) {
        CAPTURE(std::string(name));
        const Picture picture = read_picture(folder / name);
        CHECK(picture.light.at(0, 0) == 1);
        CHECK(picture.light.at(1, 0) == doctest::Approx(0.8));
        CHECK(picture.light.at(2, 0) == 0);
    }
    // Grey 0.5 behind glass of alpha 0.4: 0.4 * light(0.5) + 0.6, the colour kept whole in 8 bits.
    write_picture(folder / "glass.png", {.width = 1, .channels = 2, .values = {0.5f, 0.4f}});
    CHECK(read_picture(folder / "glass.png").light.at(0, 0) ==
          doctest::Approx(0.4 * decoded(128 / 255.0) + 0.6).epsilon(1e-4));
    // EXR holds colours multiplied by alpha: light 0.1 of a surface that lets half through.
    write_picture(folder / "glass.exr",
                  {.width = 1, .channels = 4, .values = {0.1f, 0.1f, 0.1f, 0.5f}, .type = "float"});
    CHECK(read_picture(folder / "glass.exr").light.at(0, 0) == doctest::Approx(0.6));
}

TEST_CASE("colours that are stored times alpha are decoded without it and mixed with paper as light") {
    const TemporaryFolder folder;
    // An orange of encoded 0.8, 0.4, 0.2 behind a quarter, a half, all and none of alpha.
    constexpr float orange[] = {0.8f, 0.4f, 0.2f};
    constexpr float alphas[] = {0.25f, 0.5f, 1, 0};
    PictureFile file{.width = 4, .channels = 4, .type = "uint16", .premultiplied = true};
    for (const float alpha : alphas) {
        for (const float colour : orange) file.values.push_back(colour * alpha);
        file.values.push_back(alpha);
    }
    const double light = 0.2126 * decoded(0.8) + 0.7152 * decoded(0.4) + 0.0722 * decoded(0.2);
    for (const char* type : {"uint16", "uint8"}) {
        CAPTURE(std::string(type));
        file.type = type;
        write_picture(folder / "associated.tif", file);
        const Picture picture = read_picture(folder / "associated.tif");
        for (int x = 0; x < 4; ++x) {
            CAPTURE(alphas[x]);
            const double expected = light * alphas[x] + 1 - alphas[x];
            CHECK(std::abs(picture.light.at(x, 0) - expected) < (file.type == "uint8" ? 3e-3 : 1e-4));
        }
        // Each colour by itself: half of decoded 0.8, 0.4, 0.2 and half of the paper.
        const glm::u8vec4 half = picture.preview.at(1, 0);
        CHECK(std::abs(decoded(half.x / 255.0) - (decoded(0.8) + 1) / 2) < 0.01);
        CHECK(std::abs(decoded(half.y / 255.0) - (decoded(0.4) + 1) / 2) < 0.01);
        CHECK(std::abs(decoded(half.z / 255.0) - (decoded(0.2) + 1) / 2) < 0.01);
    }
}

TEST_CASE("a camera held in any of the eight ways gives an upright picture") {
    // Where EXIF says that the stored first pixel and its right-hand neighbour belong, in a 3 x 2 picture.
    struct Expected {
        int orientation, width, height, x0, y0, x1, y1;
    };
    const Expected all[] = {{1, 3, 2, 0, 0, 1, 0}, {2, 3, 2, 2, 0, 1, 0}, {3, 3, 2, 2, 1, 1, 1},
                            {4, 3, 2, 0, 1, 1, 1}, {5, 2, 3, 0, 0, 0, 1}, {6, 2, 3, 1, 0, 1, 1},
                            {7, 2, 3, 1, 2, 1, 1}, {8, 2, 3, 0, 2, 0, 1}};
    const TemporaryFolder folder;
    for (const Expected& e : all) {
        CAPTURE(e.orientation);
        write_picture(
            folder / "turned.tif",
            {.width = 3, .height = 2, .values = {0, 0.5f, 1, 1, 1, 1}, .orientation = e.orientation});
        const Picture picture = read_picture(folder / "turned.tif");
        REQUIRE(picture.light.width == e.width);
        REQUIRE(picture.light.height == e.height);
        CHECK(picture.light.at(e.x0, e.y0) == 0);
        CHECK(picture.light.at(e.x1, e.y1) == doctest::Approx(decoded(128 / 255.0)).epsilon(1e-4));
        CHECK(picture.preview.at(e.x0, e.y0) == glm::u8vec4(0, 0, 0, 255));
    }
}

TEST_CASE("of a picture with more pixels than are kept, each value is the mean of a square of them") {
    // 5 x 3 pixels, of which 2 x 2 become one: at the right and lower edge there are fewer.
    PictureBuilder builder(5, 3, ExifOrientation{6}, PictureColours::kept, 6);
    const std::vector<std::vector<float>> light{{0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}, {10, 11, 12, 13, 14}};
    for (int y = 0; y < 3; ++y) {
        std::vector<glm::vec3> row;
        for (const float value : light[static_cast<std::size_t>(y)]) row.emplace_back(value);
        builder.add_row(y, row);
    }
    const Picture picture = builder.finish("");
    CHECK(picture.pixels_in_one == 2);
    REQUIRE(picture.light.width == 2);  // held on its side
    REQUIRE(picture.light.height == 3);
    const std::vector<float> upright{10.5f, 3, 12.5f, 5, 14, 6.5f};
    for (std::size_t i = 0; i < upright.size(); ++i) {
        CHECK(picture.light.values[i] == doctest::Approx(upright[i]));
        CHECK(unpacked(picture.colours.values[i]).g == doctest::Approx(upright[i]).epsilon(1e-3));
    }
    CHECK(PictureBuilder(5, 3).finish("").pixels_in_one == 1);
}

TEST_CASE("palette, bilevel, CMYK and interlaced pictures are what they look like") {
    const TemporaryFolder folder;
    write_picture(folder / "half.png",
                  {.width = 40, .height = 40, .channels = 3, .values = std::vector<float>(4800, 1.0f)});
    const std::string from = (folder / "half.png").string(), to = folder.path().string();
    // The left half red: luminance 0.2126, and 0.2126 still after a print's inks and a JPEG, roughly.
    const std::string red = "convert " + from + " -fill '#ff0000' -draw 'rectangle 0,0 19,39' ";
    run(red + "-type Palette PNG8:" + to + "/palette.png");
    run(red + "-interlace PNG " + to + "/interlaced.png");
    run(red + to + "/animated.gif");
    run(red + "-colorspace CMYK -quality 100 " + to + "/cmyk.jpg");
    run(red + "-alpha off -colorspace CMYK " + to + "/cmyk.tif");
    for (const char* name : {"palette.png", "interlaced.png", "animated.gif", "cmyk.jpg", "cmyk.tif"}) {
        CAPTURE(std::string(name));
        const Picture picture = read_picture(folder / name);
        CHECK(picture.light.at(5, 20) == doctest::Approx(0.2126).epsilon(0.05));
        CHECK(picture.light.at(34, 20) == doctest::Approx(1).epsilon(0.02));
    }
    run(red + "-alpha set -colorspace CMYK " + to + "/inks.tif");
    CHECK(sentence_of(folder / "inks.tif").find("inks") != std::string::npos);
    run("convert " + from + " -fill black -draw 'rectangle 0,0 19,39' -type Bilevel -depth 1 " + to +
        "/bilevel.png");
    const Picture bilevel = read_picture(folder / "bilevel.png");
    CHECK(bilevel.light.at(5, 20) == 0);
    CHECK(bilevel.light.at(34, 20) == 1);
}

TEST_CASE("of several pictures in a file the first is read") {
    const TemporaryFolder folder;
    write_picture(folder / "pages.tif", {.width = 2, .values = {0, 1}});
    write_picture(folder / "pages.tif", {.width = 3, .values = {1, 1, 1}, .append = true});
    const Picture picture = read_picture(folder / "pages.tif");
    CHECK(picture.light.width == 2);
    CHECK(picture.light.at(0, 0) == 0);
}

TEST_CASE("a picture stored in tiles is the one stored in lines") {
    const TemporaryFolder folder;
    const std::vector<float> values = ramp(100 * 75 * 3);
    write_picture(folder / "lines.tif", {.width = 100, .height = 75, .channels = 3, .values = values});
    write_picture(folder / "tiles.tif",
                  {.width = 100, .height = 75, .channels = 3, .values = values, .tile = 32});
    write_picture(folder / "tiles.exr",
                  {.width = 100, .height = 75, .channels = 3, .values = values, .type = "float", .tile = 32});
    CHECK(read_picture(folder / "tiles.tif").light.values == read_picture(folder / "lines.tif").light.values);
    const Picture exr = read_picture(folder / "tiles.exr");
    CHECK(exr.light.at(99, 74) == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("the preview is at most 2048 pixels a side and as light as the picture") {
    const TemporaryFolder folder;
    constexpr int width = 5000, height = 301;
    std::vector<float> values(width * height);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = (i % width) / 10 % 2 == 0 ? 0.0f : 1.0f;
    write_picture(folder / "stripes.png", {.width = width, .height = height, .values = values});
    const Picture picture = read_picture(folder / "stripes.png");
    CHECK(picture.light.width == width);
    CHECK(picture.preview.width == 2048);
    CHECK(picture.preview.height == 123);
    double sum = 0;
    for (const glm::u8vec4& pixel : picture.preview.values) sum += decoded(pixel.x / 255.0);
    CHECK(sum / static_cast<double>(picture.preview.values.size()) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("what cannot be read is refused in one sentence that begins with its name") {
    const TemporaryFolder folder;
    const std::string path = folder.path().string();
    put_text(folder / "empty.png", "");
    put_text(folder / "text.jpg", "This is no picture.\n");
    write_picture(folder / "whole.jpg", {.width = 100, .height = 100, .values = ramp(10'000)});
    write_picture(folder / "whole.png", {.width = 100, .height = 100, .values = ramp(10'000)});
    const std::string jpeg = text_of(folder / "whole.jpg"), png = text_of(folder / "whole.png");
    put_text(folder / "half.jpg", jpeg.substr(0, jpeg.size() / 2));
    put_text(folder / "half.png", png.substr(0, png.size() / 2));
    put_text(folder / "head.jpg", jpeg.substr(0, 100));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    infinity = std::numeric_limits<float>::infinity();
    write_picture(folder / "nan.exr",
                  {.width = 3, .height = 2, .values = {0, 0, 0, 0, 0, nan}, .type = "float"});
    write_picture(folder / "infinite.exr",
                  {.width = 2, .channels = 3, .values = {0, 0, 0, 0, -infinity, 0}, .type = "half"});

    struct Expected {
        const char* name;
        const char* words;
    };
    for (const Expected& e :
         {Expected{"none.png", "no such file"}, Expected{"", "is a folder"},
          Expected{"empty.png", "is empty"}, Expected{"text.jpg", "not a picture"},
          Expected{"half.jpg", "damaged"}, Expected{"half.png", "damaged"},
          Expected{"head.jpg", "not a picture"}, Expected{"nan.exr", "pixel 2, 1 is not a number (NaN)"},
          Expected{"infinite.exr", "pixel 1, 0 is infinite"}}) {
        const std::string sentence = sentence_of(folder / e.name);
        CAPTURE(sentence);
        CHECK(sentence.starts_with((folder / e.name).string() + ": "));
        CHECK(sentence.find(e.words) != sentence.npos);
        CHECK(sentence.find('\n') == sentence.npos);
        // The name once, not again in what the codec said.
        CHECK(sentence.find(path, 1) == sentence.npos);
    }
}

TEST_CASE("over 400 megapixels a picture is refused with its size, before its pixels are read") {
    const TemporaryFolder folder;
    // All header, no pixels; but as long as one with pixels, as OpenImageIO 3 refuses what is too short.
    put_text(folder / "large.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 40000\n");
    std::filesystem::resize_file(folder / "large.hdr", std::uintmax_t{4'800'000'000});
    const std::string sentence = sentence_of(folder / "large.hdr");
    CAPTURE(sentence);
    CHECK(sentence.find("40,000 x 30,000 pixels") != sentence.npos);
    CHECK(sentence.find("--huge") != sentence.npos);
}

TEST_CASE("the sample is inside the program, and reads as it does from a file") {
    const Picture sample = sample_picture();
    CHECK(sample.light.width == 1024);
    CHECK(sample.light.height == 1024);
    CHECK_THROWS_AS(decode_png("not a PNG"), std::runtime_error);

    const TemporaryFolder folder;
    write_picture(folder / "rgba.png", {.width = 16, .height = 16, .channels = 4, .values = ramp(1024)});
    const Picture file = read_picture(folder / "rgba.png"), memory = decode_png(text_of(folder / "rgba.png"));
    REQUIRE(memory.light.values.size() == file.light.values.size());
    for (std::size_t i = 0; i < file.light.values.size(); ++i) {
        CHECK(memory.light.values[i] == doctest::Approx(file.light.values[i]).epsilon(1e-5));
    }
    CHECK(memory.preview.values == file.preview.values);
}

TEST_CASE("the less usual formats are read, and half a file is read or refused in one sentence") {
    const TemporaryFolder folder;
    constexpr int width = 64, height = 48;
    // Dark on the left, light on the right, as encoded values or as light.
    PictureFile file{.width = width, .height = height, .channels = 3};
    for (int i = 0; i < width * height * 3; ++i)
        file.values.push_back(i / 3 % width < width / 2 ? 0.25f : 0.75f);
    struct Expected {
        const char* name;
        const char* type;
    };
    for (const Expected& e :
         {Expected{"a.bmp", "uint8"}, Expected{"a.tga", "uint8"}, Expected{"a.ppm", "uint8"},
          Expected{"a.webp", "uint8"}, Expected{"a.hdr", "float"}}) {
        CAPTURE(std::string(e.name));
        file.type = e.type;
        write_picture(folder / e.name, file);
        const Picture picture = read_picture(folder / e.name);
        REQUIRE(picture.light.width == width);
        REQUIRE(picture.light.height == height);
        const bool is_light = file.type == "float";
        for (const auto& [x, stored] : {std::pair{10, 0.25}, {50, 0.75}})
            CHECK(picture.light.at(x, 20) ==
                  doctest::Approx(is_light ? stored : decoded(stored)).epsilon(0.03));

        const std::string whole = text_of(folder / e.name);
        put_text(folder / e.name, whole.substr(0, whole.size() / 2));
        const std::string sentence = sentence_of(folder / e.name);
        CHECK(sentence.find('\n') == sentence.npos);
        CHECK((sentence.empty() || sentence.starts_with((folder / e.name).string() + ": ")));
    }
}
