// Pictures of which a file has only a part, or more: EXR's data window is not its display window.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/image/mask.h"
#include "io/decoding/stored_pixels.h"
#include "io/files/environment_file.h"
#include "io/files/picture.h"
#include "lab/volume/volume_file.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 64, kHeight = 32;

void run(const std::string& command) {
    REQUIRE_MESSAGE(std::system(command.c_str()) == 0, command);
}

// Light of many values within 31 x 16 pixels from 10, 3 on; `outside` where there is none of it.
PictureFile lit(float outside, int channels = 3) {
    PictureFile file{.width = kWidth, .height = kHeight, .channels = channels, .type = "float"};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const bool inside = x >= 10 && x < 41 && y >= 3 && y < 19;
            for (int c = 0; c < channels; ++c)
                file.values.push_back(c == 3   ? (inside ? 1.0f : 0.0f)
                                      : inside ? static_cast<float>((x * 37 + y * 11 + c) % 50 + 1) / 64
                                               : outside);
        }
    return file;
}

// The same with `around` more pixels on each side, of light that is not of the picture.
PictureFile with_more(const PictureFile& file, int around) {
    PictureFile more = file;
    more.width += 2 * around;
    more.height += 2 * around;
    more.values.clear();
    for (int y = -around; y < kHeight + around; ++y)
        for (int x = -around; x < kWidth + around; ++x)
            for (int c = 0; c < file.channels; ++c) {
                const bool inside = x >= 0 && x < kWidth && y >= 0 && y < kHeight;
                more.values.push_back(
                    inside ? file.values[static_cast<std::size_t>((y * kWidth + x) * file.channels + c)]
                           : 1000.0f);
            }
    return more;
}

}  // namespace

TEST_CASE("a map of light of which a file has only the lit part, or more, is the whole map") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    write_picture(folder / "whole.exr", lit(0));
    write_picture(folder / "more.exr", with_more(lit(0), 8));
    run("oiiotool " + in + "whole.exr --crop 31x16+10+3 -o " + in + "trimmed.exr");
    run("oiiotool " + in + "whole.exr --crop 31x16+10+3 --tile 16 16 -o " + in + "tiles.exr");
    // TIFF has its place in inches, of which there is one pixel to each here, and the size of the whole in
    // tags of Pixar's.
    run("oiiotool " + in + "trimmed.exr --fullpixels -d float -o " + in + "trimmed.tif");
    for (const char* const tag : {"282 1", "283 1", "296 2", "286 10", "287 3", "33300 64", "33301 32"})
        run("tiffset -s " + std::string(tag) + " " + in + "trimmed.tif");
    run("oiiotool " + in + "more.exr --fullsize 64x32+8+8 -o " + in + "over.exr");
    // Less on one side, more on the other.
    run("oiiotool " + in + "more.exr --crop 51x40+18+0 --fullsize 64x32+8+8 -o " + in + "both.exr");
    const EnvironmentFile whole = read_environment(folder / "whole.exr");
    CHECK(whole.remark.empty());
    const std::string part =
        "the file has 31 x 16 of the picture's 64 x 32 pixels; the rest is taken as black";
    struct Expected {
        const char* name;
        std::string remark;
    };
    for (const Expected& expected :
         {Expected{"trimmed.exr", part}, Expected{"tiles.exr", part}, Expected{"trimmed.tif", part},
          Expected{"over.exr", "the file has more pixels around the picture's 64 x 32, which are left out"},
          Expected{"both.exr",
                   "the file has 51 x 32 of the picture's 64 x 32 pixels; the rest is taken as black"}}) {
        CAPTURE(std::string(expected.name));
        const EnvironmentFile read = read_environment(folder / expected.name);
        CHECK(read.map.radiance().values == whole.map.radiance().values);
        CHECK(read.remark == expected.remark);
    }
    // The same lights, and a word about it.
    const auto lights = [&](const char* name) {
        fs::copy_file(folder / name, folder / "map", fs::copy_options::overwrite_existing);
        return run_dapple("lights " + in + "map -n 40 -o " + in + "lights.csv");
    };
    CHECK(lights("whole.exr").err.empty());
    const std::string right = text_of(folder / "lights.csv");
    const Outcome outcome = lights("trimmed.exr");
    CHECK(outcome.err == "dapple: " + in + "map: " + part + "\n");
    CHECK(text_of(folder / "lights.csv") == right);
}

TEST_CASE("what a file has no pixels of is bare paper in a picture and a mask, and nothing in a slice") {
    const TemporaryFolder folder;
    const std::string in = folder.path().string() + "/";
    for (const int channels : {3, 4}) {
        write_picture(folder / "black.exr", lit(0, channels));
        write_picture(folder / "white.exr", lit(channels == 4 ? 0 : 1, channels));
        run("oiiotool " + in + "black.exr --crop 31x16+10+3 -o " + in + "trimmed.exr");
        const Picture right = read_picture(folder / "white.exr"), read = read_picture(folder / "trimmed.exr");
        REQUIRE(read.light.width == kWidth);
        CHECK(read.light.values == right.light.values);
        CHECK(mask_of(read.light) == mask_of(right.light));
        CHECK(read.remark ==
              "the file has 31 x 16 of the picture's 64 x 32 pixels; the rest is taken as bare paper");
        CHECK(read.description.starts_with("64 x 32 pixels, float colour"));
        CHECK(read.description.ends_with(read.remark));
        const auto slices = [&](const char* name) {
            return read_slices(std::vector<fs::path>{folder / "black.exr", folder / name}).density;
        };
        CHECK(slices("trimmed.exr") == slices("black.exr"));
    }
    // Where a TGA is to stand on a screen moves no pixel.
    put_text(folder / "a.tga", std::string("\0\0\3\0\0\0\0\0\1\0\1\0\2\0\1\0\x08\x20\x10\xf0", 20));
    CHECK(read_picture(folder / "a.tga").light.width == 2);
    CHECK(read_picture(folder / "a.tga").remark.empty());
}

TEST_CASE("a window shows what lies in it, wherever it is") {
    struct Rows : ImageSink {
        void begin(const ImageHeader& given) override { header = given; }
        void row(std::span<const glm::vec3> colours) override {
            REQUIRE(static_cast<int>(colours.size()) == header.width);
            for (const glm::vec3& colour : colours) values.push_back(static_cast<int>(colour.x));
        }
        ImageHeader header;
        std::vector<int> values;
    };
    constexpr int width = 3, height = 2;
    for (int x0 = -4; x0 <= 4; ++x0)
        for (int y0 = -3; y0 <= 4; ++y0)
            for (int w = 1; w <= 5; ++w)
                for (int h = 1; h <= 4; ++h) {
                    Rows rows;
                    WindowSink sink(rows, false);
                    ImageHeader header;
                    header.width = width;
                    header.height = height;
                    header.window = DisplayWindow{w, h, x0, y0};
                    sink.begin(header);
                    for (int y = 0; y < height; ++y) {
                        std::vector<glm::vec3> colours;
                        for (int x = 0; x < width; ++x) colours.emplace_back(1 + x + 10 * y);
                        sink.row(colours);
                    }
                    std::vector<int> right;
                    for (int y = 0; y < h; ++y)
                        for (int x = 0; x < w; ++x) {
                            const int sx = x - x0, sy = y - y0;
                            const bool there = sx >= 0 && sx < width && sy >= 0 && sy < height;
                            right.push_back(there ? 1 + sx + 10 * sy : 0);
                        }
                    CHECK(rows.header.width == w);
                    CHECK(rows.header.height == h);
                    CHECK(rows.values == right);
                }
}
