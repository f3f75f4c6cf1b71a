#include <doctest/doctest.h>
#include <stb_image.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "dapple_assets_embedded/assets.h"

namespace {

struct Decoded {
    int width = 0, height = 0, channels = 0;
    std::vector<unsigned char> bytes;
};

Decoded decode(std::string_view file) {
    Decoded out;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()),
                              &out.width, &out.height, &out.channels, 0),
        &stbi_image_free);
    REQUIRE(pixels);
    out.bytes.assign(pixels.get(), pixels.get() + out.width * out.height * out.channels);
    return out;
}

}  // namespace

TEST_CASE("the embedded sample picture is a square of 1024 from black to white") {
    CHECK(assets::still_life_png().size() < 900'000);
    Decoded picture = decode(assets::still_life_png());
    CHECK(picture.width == 1024);
    CHECK(picture.height == 1024);
    REQUIRE(picture.channels == 1);

    // Paper white in both upper corners: no dots, so the drawing has no frame.
    for (int x : {0, 1023}) CHECK(picture.bytes[x] >= 252);

    std::ranges::sort(picture.bytes);
    const size_t percent = picture.bytes.size() / 100;
    CHECK(picture.bytes[percent] < 5);
    CHECK(picture.bytes[99 * percent] > 245);
    // Not only the two ends: every grey occurs.
    CHECK(std::unique(picture.bytes.begin(), picture.bytes.end()) - picture.bytes.begin() == 256);
}

TEST_CASE("the embedded icons are opaque in the middle and clear in the corners") {
    struct Icon {
        std::string_view file;
        int size;
    };
    for (const Icon& embedded : {Icon{assets::icon_16_png(), 16}, Icon{assets::icon_32_png(), 32},
                                 Icon{assets::icon_64_png(), 64}}) {
        const int size = embedded.size;
        CAPTURE(size);
        const Decoded icon = decode(embedded.file);
        CHECK(icon.width == size);
        CHECK(icon.height == size);
        REQUIRE(icon.channels == 4);
        auto alpha = [&](int x, int y) { return icon.bytes[4 * (y * size + x) + 3]; };
        CHECK(alpha(size / 2, size / 2) == 255);
        for (int x : {0, size - 1})
            for (int y : {0, size - 1}) CHECK(alpha(x, y) == 0);
    }
}
