// Flat colours drawn with several pens, and looked at from afar.

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <numeric>
#include <string>

#include "app/viewer/background/small_pictures.h"
#include "core/image/colour.h"
#include "core/pens/separation.h"

namespace dapple {
namespace {

/// The mean light of a drawing with those pens of a picture in one colour, whose tone nothing changes: of the
/// middle of the page, as paper is bare along its edges.
glm::vec3 seen_of(const SmallPicture& picture, const PenChoice& pens, std::uint64_t dots, double black = 1) {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.tone = {.black = black};
    settings.pens = pens;
    settings.placing.count = dots;
    const SmallPicture drawing = small_drawing(picture, settings, 400, {});
    const int edge = drawing.width / 10;
    glm::dvec3 sum(0);
    int pixels = 0;
    for (int y = edge; y < drawing.height - edge; ++y)
        for (int x = edge; x < drawing.width - edge; ++x, ++pixels)
            sum += glm::dvec3(linear_of(glm::vec3(drawing.at(x, y)) / 255.0f));
    return glm::vec3(sum / double(pixels));
}

}  // namespace

TEST_CASE("pens' dots that lie over one another are seen from afar as the colour that was asked for") {
    const Separation separation(palette_of(parse_pens("cmyk")), kWhite);
    // Black in place of coloured inks changes nothing that is seen, and how inks overlap nothing either.
    struct Drawn {
        const char* pens;
        std::uint64_t dots;
        glm::u8vec4 colour;
    };
    constexpr glm::u8vec4 kOlive(190, 190, 90, 255), kBrown(94, 70, 58, 255), kBlue(40, 60, 120, 255);
    for (const PenInk ink : {PenInk::transparent, PenInk::opaque})
        for (const auto& [text, dots, colour] : {Drawn{"cmyk", 3000, kOlive},
                                                 {"cmyk", 3000, kBrown},
                                                 {"cmyk:black=0", 8000, kBlue},
                                                 {"cmyk:black=1", 3000, kBrown},
                                                 {"cmyk:black=1", 8000, kBrown}}) {
            CAPTURE(int(colour.r));
            CAPTURE(std::string(text));
            CAPTURE(dots);
            CAPTURE(name_of(ink));
            PenChoice pens = parse_pens(text);
            pens.ink = ink;
            SmallPicture flat(40, 40);
            for (glm::u8vec4& pixel : flat.values) pixel = colour;
            const glm::vec3 aim = linear_of(glm::vec3(colour) / 255.0f);
            const glm::vec3 asked = oklab_of(separation.mixer().seen(separation.shares(aim)));
            const glm::vec3 seen = oklab_of(seen_of(flat, pens, dots));
            INFO("lightness ", seen.x - asked.x, ", distance ", glm::distance(seen, asked));
            CHECK(std::abs(seen.x - asked.x) < 0.012);
            CHECK(glm::distance(seen, asked) < 0.025);
        }
}

TEST_CASE(
    "where black is not solid, tones that several pens draw become lighter in the same way as a pen's") {
    const PenChoice pens = parse_pens("cmyk");
    const PenMixer mixer(palette_of(pens), kWhite);
    const Separation separation(palette_of(pens), kWhite);
    constexpr double kOpen = 0.9;
    for (const glm::u8vec4 colour : {glm::u8vec4(128, 128, 128, 255), {80, 120, 60, 255}}) {
        CAPTURE(int(colour.r));
        SmallPicture flat(40, 40);
        for (glm::u8vec4& pixel : flat.values) pixel = colour;
        Shares shares = separation.shares(linear_of(glm::vec3(colour) / 255.0f));
        // All paper would be covered, and is as far as a black is.
        REQUIRE(std::accumulate(shares.begin(), shares.end(), 0.0f) > 0.99f);
        for (float& share : shares) share *= float(kOpen);
        const glm::vec3 asked = oklab_of(mixer.seen(shares));
        const glm::vec3 seen = oklab_of(seen_of(flat, pens, 4000, kOpen));
        INFO("lightness ", seen.x - asked.x, ", distance ", glm::distance(seen, asked));
        CHECK(glm::distance(seen, asked) < 0.02);
    }
}

}  // namespace dapple
