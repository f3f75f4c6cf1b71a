// Contours and solid blacks in a drawing: where they and the dots beside them lie, and what files show of
// them.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "core/drawing/stippler.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

// A black disc with a grey one beside it, on a light ground.
LightPicture two_discs() {
    Grid<float> light(300, 200);
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            const double black = std::hypot(x - 90, y - 100), grey = std::hypot(x - 210, y - 100);
            light.at(x, y) = srgb_to_linear(black < 50 ? 0.02F : grey < 50 ? 0.5F : 0.85F);
        }
    }
    return {.light = std::move(light)};
}

Settings inked_settings(std::uint64_t dots = 3000) {
    Settings settings;
    settings.drawing.placing.count = dots;
    settings.drawing.automatic_tone = false;
    settings.drawing.tone = {};
    settings.drawing.contours = 0.8;
    settings.drawing.solid = 0.9;
    return settings;
}

Drawing drawn(const Settings& settings, int threads = 0) {
    Stippler stippler(threads);
    stippler.set_picture(two_discs());
    return *stippler.draw(settings);
}

std::string written(const Drawing& drawing, DrawingFormat format) {
    std::ostringstream out;
    CHECK(drawing.write(out, format));
    return out.str();
}

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++count;
    return count;
}

}  // namespace

TEST_CASE("what looks black is one solid shape, and what has an edge a line around it") {
    const Drawing drawing = drawn(inked_settings());
    REQUIRE(drawing.plan.inking);
    REQUIRE(drawing.plan.inking->areas.size() == 1);
    CHECK(drawing.plan.inking->areas[0].rings.size() == 1);
    CHECK(!drawing.plan.inking->lines.empty());
    for (const InkLine& line : drawing.plan.inking->lines)
        for (const glm::dvec2 p : line.points)
            CHECK(std::hypot(p.x * 300 - 210, p.y * 300 - 100) == doctest::Approx(50).epsilon(0.06));
}

TEST_CASE("no dot lies in a solid black, and exactly as many dots are drawn as are asked for") {
    const Drawing drawing = drawn(inked_settings());
    CHECK(drawing.count == 3000);
    const double mm = drawing.page.layout.page.mm_per_page_unit / 300;
    const glm::dvec2 corner = drawing.page.layout.picture.low;
    int inside = 0;
    drawing.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const glm::dvec2 at = (glm::dvec2(piece.x[i], piece.y[i]) - corner) / mm;
            inside += std::hypot(at.x - 90, at.y - 100) < 48;
        }
        return true;
    });
    CHECK(inside == 0);
}

TEST_CASE("without contours and solid black a drawing has neither") {
    Settings settings = inked_settings();
    settings.drawing.contours = 0;
    settings.drawing.solid = 1;
    CHECK(!drawn(settings).plan.inking);
}

TEST_CASE("a mask that leaves a part bare takes its lines and blacks away too") {
    Settings settings = inked_settings();
    Grid<std::uint8_t> levels(300, 200, kNeutralLevel);
    for (int y = 0; y < levels.height; ++y) std::fill_n(levels.row(y), 150, std::uint8_t{0});
    settings.drawing.mask = Mask(levels);
    const Drawing drawing = drawn(settings);
    REQUIRE(drawing.plan.inking);
    CHECK(drawing.plan.inking->areas.empty());
    CHECK(!drawing.plan.inking->lines.empty());
    for (const InkLine& line : drawing.plan.inking->lines)
        for (const glm::dvec2 p : line.points) CHECK(p.x > 0.5);
}

TEST_CASE("the same lines and dots come of any number of threads") {
    CHECK(written(drawn(inked_settings(), 1), DrawingFormat::svg) ==
          written(drawn(inked_settings(), 4), DrawingFormat::svg));
}

TEST_CASE("light ink is drawn where the picture is light") {
    Settings settings = inked_settings();
    settings.drawing.tone.invert = true;
    settings.drawing.solid = 0.7;
    const Drawing drawing = drawn(settings);
    REQUIRE(drawing.plan.inking);
    REQUIRE(drawing.plan.inking->areas.size() == 1);
    CHECK(drawing.plan.inking->areas[0].rings.size() == 3);  // the ground, around both discs
}

TEST_CASE("files have the shapes filled, or drawn by the pen that draws the dots") {
    Settings settings = inked_settings(500);
    const std::string filled = written(drawn(settings), DrawingFormat::svg);
    CHECK(count_of(filled, "<circle") == 500);
    CHECK(count_of(filled, "<path") >= 2);
    CHECK(count_of(filled, "stroke=\"#") == 0);
    const std::string dots_alone = [&] {
        Settings plain = settings;
        plain.drawing.contours = 0;
        plain.drawing.solid = 1;
        return written(drawn(plain), DrawingFormat::gcode);
    }();
    CHECK(count_of(written(drawn(settings), DrawingFormat::gcode), "\n") > count_of(dots_alone, "\n") + 100);
    CHECK(count_of(written(drawn(settings), DrawingFormat::dxf), "LWPOLYLINE") > 10);
    settings.drawing.mark = {DotShape::spiral, {}};
    const std::string drawn_by_pen = written(drawn(settings), DrawingFormat::svg);
    CHECK(count_of(drawn_by_pen, "<circle") == 0);
    CHECK(count_of(drawn_by_pen, "<path") > 500);
}

TEST_CASE("the darkest of several pens draws lines and blacks") {
    Settings settings = inked_settings(600);
    settings.drawing.pens = parse_pens("Ochre:#e0a000,Soot:#202020,Sky:#0080d0");
    const Drawing drawing = drawn(settings);
    const std::string svg = written(drawing, DrawingFormat::svg);
    const std::size_t path = svg.find("<path");
    REQUIRE(path != svg.npos);
    const std::string before = svg.substr(0, path);
    CHECK(before.substr(before.rfind("<g ")).find("#202020") != std::string::npos);
}

TEST_CASE("a picture of pixels is black where a solid black is") {
    const Grid<glm::u8vec3> pixels = drawn(inked_settings()).pixels(100);
    const int x = static_cast<int>(90.0 / 300 * pixels.width), y = pixels.height / 2;
    int black = 0;
    for (int v = y - 50; v < y + 50; ++v)
        for (int u = x - 50; u < x + 50; ++u) black += pixels.at(u, v) == glm::u8vec3(0);
    CHECK(black == 100 * 100);
}
