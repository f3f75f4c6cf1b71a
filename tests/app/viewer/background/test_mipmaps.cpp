#include <doctest/doctest.h>

#include "app/viewer/background/small_pictures.h"

using namespace dapple;

TEST_CASE("each copy of a picture has half the sides, to a single pixel, and its mean") {
    Grid<glm::u8vec4> picture(37, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 37; ++x)
            picture.at(x, y) = {(x + y) % 2 == 0 ? 200 : 100, 10, x < 16 ? 0 : 80, 255};
    const auto levels = mipmaps_of(picture);
    REQUIRE(levels.size() == 6);
    CHECK(levels[0].values == picture.values);
    CHECK(levels[1].width == 18);
    CHECK(levels[1].height == 4);
    CHECK(levels[3].width == 4);
    CHECK(levels[3].height == 1);
    CHECK(levels[5].width == 1);
    CHECK(levels[5].height == 1);
    for (const glm::u8vec4 pixel : levels[1].values) CHECK(pixel.r == 150);
    CHECK(levels[3].at(0, 0) == glm::u8vec4(150, 10, 0, 255));
    CHECK(levels[3].at(3, 0) == glm::u8vec4(150, 10, 80, 255));
    CHECK(levels[5].at(0, 0) == glm::u8vec4(150, 10, 40, 255));
}

TEST_CASE("no picture has no copies") {
    CHECK(mipmaps_of({}).empty());
}
