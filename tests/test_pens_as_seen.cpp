// Flat colours drawn with several pens, and looked at from afar.

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/viewer/model/small_drawing.h"
#include "core/image/linear_colour.h"
#include "core/pens/separation.h"

namespace dapple {
namespace {

/// The mean light of a drawing with those pens of a picture in one colour, whose tone nothing changes.
glm::vec3 seen_of(const SmallPicture& picture, const PenChoice& pens) {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.tone = {};
    settings.pens = pens;
    settings.placing.count = 4000;
    const SmallPicture drawing = small_drawing(picture, settings, 400, {});
    glm::dvec3 sum(0);
    for (const glm::u8vec4 pixel : drawing.values) sum += glm::dvec3(linear_of(glm::vec3(pixel) / 255.0f));
    return glm::vec3(sum / static_cast<double>(drawing.values.size()));
}

}  // namespace

TEST_CASE("pens' dots that lie over one another are seen from afar as the colour that was asked for") {
    const Separation separation(palette_of(parse_pens("cmyk")), kWhite);
    // Black in place of coloured inks changes nothing that is seen, and how inks overlap nothing either.
    for (const PenInk ink : {PenInk::transparent, PenInk::opaque})
        for (const char* text : {"cmyk", "cmyk:black=0", "cmyk:black=1"})
            for (const glm::u8vec4 colour : {glm::u8vec4(213, 149, 94, 255),
                                             {190, 190, 90, 255},
                                             {94, 70, 58, 255},
                                             {204, 204, 204, 255},
                                             {40, 60, 120, 255}}) {
                CAPTURE(int(colour.r));
                CAPTURE(std::string(text));
                CAPTURE(name_of(ink));
                PenChoice pens = parse_pens(text);
                pens.ink = ink;
                SmallPicture flat(40, 40);
                for (glm::u8vec4& pixel : flat.values) pixel = colour;
                const glm::vec3 aim = linear_of(glm::vec3(colour) / 255.0f);
                const glm::vec3 asked = oklab_of(separation.mixer().seen(separation.shares(aim)));
                const glm::vec3 seen = oklab_of(seen_of(flat, pens));
                // In opaque ink the dark blue comes out 0.02 too dark or too light.
                const bool close =
                    text == std::string("cmyk") && (ink == PenInk::transparent || colour.r > 40);
                // A dark brown in black ink alone is 0.026 off, and up to 0.04 with other numbers of dots.
                CHECK(std::abs(seen.x - asked.x) < (close ? 0.015 : 0.03));
                CHECK(glm::distance(seen, asked) < (ink == PenInk::transparent ? 0.03 : 0.035));
            }
}

}  // namespace dapple
