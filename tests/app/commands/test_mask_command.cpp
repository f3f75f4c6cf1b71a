// `dapple mask`: the pictures that it writes, and what it refuses.

#include <doctest/doctest.h>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/screening/threshold_mask.h"
#include "tests/render_scene.h"

namespace dapple {
namespace {

struct Greys {
    int width = 0, height = 0, channels = 0, bytes = 0;
    std::vector<std::uint16_t> values;  // as they are in the file
};

Greys greys_in(const std::string& file) {
    const auto in = OIIO::ImageInput::open(file);
    REQUIRE(in);
    const OIIO::ImageSpec& spec = in->spec();
    Greys greys{spec.width, spec.height, spec.nchannels, static_cast<int>(spec.format.size()), {}};
    greys.values.resize(static_cast<std::size_t>(spec.width) * spec.height);
    if (greys.bytes == 2) {
        REQUIRE(in->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT16, greys.values.data()));
    } else {
        std::vector<std::uint8_t> bytes(greys.values.size());
        REQUIRE(in->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT8, bytes.data()));
        std::ranges::copy(bytes, greys.values.begin());
    }
    return greys;
}

}  // namespace

TEST_CASE("a mask of 16 bits has each threshold once, one of 8 each as often") {
    const Scene scene;
    REQUIRE(run_dapple("mask --size 48x32 --bits 16 --seed 5 -o " + scene("deep.png")).status == 0);
    const Greys deep = greys_in(scene("deep.png"));
    CHECK(deep.width == 48);
    CHECK(deep.height == 32);
    CHECK(deep.channels == 1);
    CHECK(deep.bytes == 2);
    const ThresholdMask mask = void_and_cluster({48, 32}, {.seed = 5});
    for (std::size_t i = 0; i < mask.ranks.size(); ++i)
        CHECK(deep.values[i] == static_cast<int>((mask.ranks[i] + 0.5) / (48 * 32) * 65536));
    REQUIRE(run_dapple("mask --size 32 -o " + scene("mask.png")).status == 0);
    const Greys plain = greys_in(scene("mask.png"));
    CHECK(plain.bytes == 1);
    for (int grey = 0; grey < 256; ++grey) CHECK(std::ranges::count(plain.values, grey) == 4);
}

TEST_CASE("a mask for films is as many files as it has slices, and a mask from a tile is a square") {
    const Scene scene;
    REQUIRE(run_dapple("mask --size 16x8x12 -o " + scene("film.png")).status == 0);
    for (int slice = 0; slice < 12; ++slice) {
        const std::string file = scene(fmt::format("film-{:02}.png", slice));
        CAPTURE(file);
        CHECK(greys_in(file).width == 16);
    }
    CHECK_FALSE(std::filesystem::exists(scene("film.png")));
    REQUIRE(run_dapple("mask --size 16 --from tile --tile paper16 -o " + scene("tile.png")).status == 0);
    const Greys greys = greys_in(scene("tile.png"));
    CHECK(std::set(greys.values.begin(), greys.values.end()).size() == 256);
}

TEST_CASE("a picture is screened beside the mask, with black and white alone") {
    const Scene scene;
    REQUIRE(run_dapple("mask --size 16 -o " + scene("mask.png") + " --screen " + scene("cat.png")).status ==
            0);
    const Greys pixels = greys_in(scene("mask-screened.png"));
    const Greys picture = greys_in(scene("cat.png"));
    CHECK(pixels.width == picture.width);
    CHECK(pixels.height == picture.height);
    CHECK(std::set(pixels.values.begin(), pixels.values.end()) == std::set<std::uint16_t>{0, 255});
}

TEST_CASE("masks that cannot be made are refused before anything is written") {
    const Scene scene;
    const std::string to = " -o " + scene("m.png");
    scene.must_fail("mask", "--output is required");
    scene.must_fail("mask -o " + scene("m.svg"), "a mask is a PNG; let its name end in .png");
    scene.must_fail("mask --size 3" + to, "--size: 3 x 3 pixels: a mask's sides are 4 to 8192");
    scene.must_fail("mask --size 64x" + to, "--size: 64x is not a size; give one such as 256, 320x200");
    scene.must_fail("mask --size 64,64" + to, "64,64 is not a size");
    scene.must_fail("mask --size 64x64x64x64" + to, "is not a size");
    scene.must_fail("mask --bits 12" + to, "--bits: 12 is not possible; give 8 or 16");
    scene.must_fail("mask --gain 9" + to, "--gain");
    scene.must_fail("mask --gain nan" + to, "--gain");
    scene.must_fail("mask --from tile --sigma 2" + to, "applies to --from clusters only");
    scene.must_fail("mask --from tile --size 32x64" + to, "a mask from a tile is square");
    scene.must_fail("mask --tile paper16" + to, "applies to --from tile only");
    scene.must_fail("mask --slice-sigma 2" + to, "applies to several slices only");
    scene.must_fail("mask -o " + scene("none/m.png"), "none");
    scene.must_fail("mask --screen " + scene("m-screened.png") + to, "m-screened.png");
    CHECK_FALSE(std::filesystem::exists(scene("m.png")));
}

}  // namespace dapple
