#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/small_pictures.h"
#include "core/drawing/page_setup.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

const glm::u8vec4 kRed(255, 0, 0, 255), kBlue(0, 0, 255, 255);

SmallPicture one_pixel(glm::u8vec4 colour) {
    SmallPicture picture(1, 1);
    picture.at(0, 0) = colour;
    return picture;
}

// Black at the left, white at the right.
SmallPicture half_black(int width, int height) {
    SmallPicture picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = x < width / 2 ? glm::u8vec4(0, 0, 0, 255) : glm::u8vec4(255);
    return picture;
}

}  // namespace

TEST_CASE("what is asked for is there after a while, and is made once") {
    SmallPictures pictures([] {});
    int made = 0;
    const auto red = [&](const std::stop_token&) { return ++made, one_pixel(kRed); };
    const auto blue = [](const std::stop_token&) { return one_pixel(kBlue); };
    CHECK(pictures.of("red", red) == nullptr);
    REQUIRE(wait_until([&] { return pictures.of("red", red) && pictures.of("blue", blue); }));
    CHECK(pictures.of("red", red)->at(0, 0) == kRed);
    CHECK(pictures.of("blue", blue)->at(0, 0) == kBlue);
    CHECK(made == 1);
    pictures.forget();
    CHECK(pictures.of("red", red) == nullptr);
    REQUIRE(wait_until([&] { return pictures.of("red", red); }));
    CHECK(made == 2);
}

TEST_CASE("an entry without a picture is empty, and keeps no other from its own") {
    SmallPictures pictures([] {});
    const SmallPictures::Make none = [](const std::stop_token&) -> SmallPicture {
        throw std::runtime_error("no picture");
    };
    const auto red = [](const std::stop_token&) { return one_pixel(kRed); };
    REQUIRE(wait_until([&] { return pictures.of("none", none) && pictures.of("red", red); }));
    CHECK(pictures.of("none", none)->empty());
}

TEST_CASE("the preview of settings is their page: ink where the picture is dark, paper around it") {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.placing.count = 5000;
    settings.ink = {1, 0, 0};
    settings.paper = {0, 0, 1};
    settings.page.paper = Paper::a4;
    settings.page.margins = Margins{20, 20, 20, 20};
    const auto inked = [&] {
        const SmallPicture page =
            small_drawing(half_black(60, 60), settings, 297, {});  // a pixel a millimetre
        REQUIRE(page.height == 297);
        CHECK(page.width == 210);
        const glm::u8vec4 paper(glm::u8vec3(settings.paper * 255.0f), 255);
        CHECK(page.at(10, 10) == paper);
        CHECK(page.at(170, 148) == paper);
        int ink = 0;
        for (int y = 130; y < 170; ++y)
            for (int x = 40; x < 80; ++x) ink += page.at(x, y).b < 128;
        return ink / 1600.0;
    };
    SUBCASE("dots") {
        CHECK(inked() > 0.8);
    }
    SUBCASE("lines of a pen") {
        settings.style = DrawingStyle::line;
        settings.pen_width_mm = 2;
        CHECK(inked() > 0.8);
    }
    SUBCASE("several pens") {
        settings.pens.set = PenSet::own;
        settings.pens.own = {{.name = "Red", .colour = {1, 0, 0}, .width_mm = 2},
                             {.name = "Black", .colour = kBlack, .width_mm = 2}};
        settings.paper = kWhite;
        CHECK(inked() > 0.8);
    }
}

}  // namespace dapple
