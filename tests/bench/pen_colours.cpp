// What flat colours drawn with several pens look like from afar: a table of docs/pens.md.
// `pen_colours 4000 20000` draws them with so many dots.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>

#include "core/drawing/pipeline.h"
#include "core/drawing/write_drawing.h"
#include "core/image/colour.h"
#include "core/pens/separation.h"
#include "io/files/tile_library.h"

namespace {

using namespace dapple;

constexpr int kSide = 40;                      // pixels of the flat picture
constexpr int kDrawnSide = 1500, kEdge = 150;  // paper is bare along a page's edges

// As photographs have them, from light to dark.
constexpr std::array<glm::u8vec3, 12> kColours{{{230, 215, 195},
                                                {204, 204, 204},
                                                {213, 149, 94},
                                                {190, 190, 90},
                                                {120, 160, 200},
                                                {128, 128, 128},
                                                {170, 110, 160},
                                                {80, 120, 60},
                                                {150, 60, 50},
                                                {94, 70, 58},
                                                {40, 60, 120},
                                                {60, 60, 60}}};

struct Seen {
    glm::vec3 asked, drawn;  // OKLab
};

Seen seen(Pipeline& pipeline, glm::vec3 colour, const PenChoice& pens, std::uint64_t dots) {
    pipeline.set_light(Grid<float>(kSide, kSide, luminance(colour)));
    ColourGrid colours(kSide, kSide);
    std::ranges::fill(colours.values, packed(colour));
    pipeline.set_colours(std::move(colours));
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.tone = {};
    settings.pens = pens;
    settings.placing.count = dots;
    const DrawingFile file{.format = DrawingFormat::png, .settings = settings};
    const auto placed = pipeline.drawing(pipeline.plan(settings));
    DrawingToSave drawing = drawing_on(drawn_page(placed->layout()), *placed, file);
    drawing.file.saving.dpi = dpi_for(drawing.page, kDrawnSide);
    const Grid<glm::u8vec3> pixels = page_pixels(drawing);
    glm::dvec3 sum(0);
    int count = 0;
    for (int y = kEdge; y < pixels.height - kEdge; ++y)
        for (int x = kEdge; x < pixels.width - kEdge; ++x, ++count)
            sum += glm::dvec3(linear_of(glm::vec3(pixels.at(x, y)) / 255.0f));
    const Separation separation(placed->plan.pens, kWhite, pens.black);
    return {oklab_of(separation.mixer().seen(separation.shares(colour))),
            oklab_of(glm::vec3(sum / static_cast<double>(count)))};
}

// The mean and the largest of some differences.
struct Differences {
    float sum = 0, largest = 0;
    void add(float difference) {
        sum += difference;
        largest = std::max(largest, difference);
    }
    std::string text() const { return fmt::format("{:.3f} / {:.3f}", sum / kColours.size(), largest); }
};

void print_row(Pipeline& pipeline, std::string_view name, std::string_view text, PenInk ink,
               std::uint64_t dots) {
    PenChoice pens = parse_pens(text);
    pens.ink = ink;
    Differences lightness, colour;
    for (const glm::u8vec3 flat : kColours) {
        const auto [asked, drawn] = seen(pipeline, linear_of(glm::vec3(flat) / 255.0f), pens, dots);
        lightness.add(std::abs(drawn.x - asked.x));
        colour.add(std::hypot(drawn.y - asked.y, drawn.z - asked.z));
    }
    fmt::print("| {} | {} | {} | {} | {} |\n", name_of(ink), name, dots, lightness.text(), colour.text());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        Pipeline pipeline;
        pipeline.set_tile(tile_named(kDefaultTile, {}));
        fmt::print("| ink | pens | dots | lightness | a and b |\n|---|---|---|---|---|\n");
        const auto print_rows = [&](std::string_view name, std::string_view text, PenInk ink) {
            for (int i = 1; i < argc; ++i)
                print_row(pipeline, name, text, ink, std::strtoull(argv[i], nullptr, 10));
        };
        print_rows("CMYK", "cmyk", PenInk::transparent);
        print_rows("CMYK, black=0", "cmyk:black=0", PenInk::transparent);
        print_rows("CMYK, black=1", "cmyk:black=1", PenInk::transparent);
        print_rows("CMYK", "cmyk", PenInk::opaque);
        print_rows("CMYK, black=1", "cmyk:black=1", PenInk::opaque);
        print_rows("three greys", "greys", PenInk::transparent);
        print_rows("black and red", "Black:#000000,Red:#c1121f", PenInk::transparent);
        print_rows("the best four for each colour", "auto:4", PenInk::transparent);
    } catch (const std::exception& error) {
        fmt::print(stderr, "pen_colours: {}\n", error.what());
        return 1;
    }
}
