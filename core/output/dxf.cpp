#include "core/output/dxf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/output/plotted_dots.h"
#include "core/output/plotted_strokes.h"
#include "core/text/text_buffer.h"

namespace dapple {
namespace {

constexpr int kDxfDecimals = 3;
constexpr double kLeastDxfRadiusMm = 0.001;

// Each value stands on a line of its own, below the number of its group, which says what it is.
constexpr const char* kDxfTablesBegin =
    "  0\nSECTION\n  2\nTABLES\n"
    "  0\nTABLE\n  2\nLTYPE\n 70\n1\n"
    "  0\nLTYPE\n  2\nCONTINUOUS\n 70\n0\n  3\nSolid line\n 72\n65\n 73\n0\n 40\n0.0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nLAYER\n 70\n";  // the number of layers
constexpr const char* kDxfTablesEnd =
    "  0\nENDTAB\n"
    "  0\nENDSEC\n";

struct DxfLayer {
    std::string name;
    int colour = 7;  // black on white, white on black
};

// The colour of that number, sRGB-encoded: nine by themselves, then rings of 24 hues, five dark steps each
// with a pale sister, and six greys.
glm::vec3 dxf_colour(int number) {
    constexpr std::array<glm::vec3, 10> kFirst{{{},
                                                {1, 0, 0},
                                                {1, 1, 0},
                                                {0, 1, 0},
                                                {0, 1, 1},
                                                {0, 0, 1},
                                                {1, 0, 1},
                                                {0, 0, 0},
                                                glm::vec3(0.5f),
                                                glm::vec3(0.75f)}};
    constexpr std::array<float, 5> kValues{1, 0.8f, 0.6f, 0.5f, 0.3f};
    if (number < 10) return kFirst[static_cast<std::size_t>(number)];
    if (number >= 250) return glm::vec3(static_cast<float>(number - 250) / 5);
    const auto hue = static_cast<float>(number / 10 - 1) * 15;
    const float value = kValues[static_cast<std::size_t>(number % 10 / 2)];
    glm::vec3 colour;
    for (int i = 0; i < 3; ++i) {
        const float away = std::abs(std::remainder(hue - 120 * static_cast<float>(i), 360.0f));
        colour[i] = std::clamp(2 - away / 60, 0.0f, 1.0f);
    }
    if (number % 2 == 1) colour = 0.5f + 0.5f * colour;
    return value * colour;
}

int nearest_dxf_colour(glm::vec3 colour) {
    int nearest = 7;
    const auto distance = [&](int number) { return glm::distance(colour, dxf_colour(number)); };
    for (int number = 1; number < 256; ++number)
        if (distance(number) < distance(nearest)) nearest = number;
    return nearest;
}

// Names of layers have letters, digits, - and _ in that release, 31 at most.
DxfLayer layer_of(std::size_t number, const Pen& pen) {
    std::string name = std::to_string(number + 1) + '_' + pen.name.substr(0, 28);
    const auto is_allowed = [](char c) { return std::string_view(" .()").find(c) == std::string_view::npos; };
    std::ranges::replace_if(name, std::not_fn(is_allowed), '_');
    return {std::move(name), nearest_dxf_colour(pen.colour)};
}

// `single`: what the only one is called.
std::vector<DxfLayer> layers_of(std::span<const Pen> pens, const char* single) {
    if (pens.empty()) return {{single}};
    std::vector<DxfLayer> layers;
    for (std::size_t i = 0; i < pens.size(); ++i) layers.push_back(layer_of(i, pens[i]));
    return layers;
}

void write_layer(TextBuffer& text, const DxfLayer& layer) {
    text << "  0\nLAYER\n  2\n"
         << std::string_view(layer.name) << "\n 70\n0\n 62\n"
         << std::int64_t{layer.colour} << "\n  6\nCONTINUOUS\n";
}

// Up to the first of the entities, which are on those layers.
void begin_dxf(TextBuffer& text, const PageSize& page, std::span<const DxfLayer> layers) {
    text << "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n"
         << "  9\n$EXTMIN\n 10\n0.0\n 20\n0.0\n 30\n0.0\n"
         << "  9\n$EXTMAX\n 10\n";
    text.fixed(page.width_mm, kDxfDecimals) << "\n 20\n";
    text.fixed(page.height_mm, kDxfDecimals) << "\n 30\n0.0\n  0\nENDSEC\n";
    text << kDxfTablesBegin << static_cast<std::int64_t>(layers.size() + 1) << '\n';
    write_layer(text, {"0"});
    for (const DxfLayer& layer : layers) write_layer(text, layer);
    text << kDxfTablesEnd << "  0\nSECTION\n  2\nENTITIES\n";
}

void begin_entity(TextBuffer& text, const char* kind, const DxfLayer& layer) {
    text << "  0\n" << std::string_view(kind) << "\n  8\n" << std::string_view(layer.name) << '\n';
}

void write_place(TextBuffer& text, glm::dvec2 p) {
    text << " 10\n";
    text.fixed(p.x, kDxfDecimals) << "\n 20\n";
    text.fixed(p.y, kDxfDecimals) << "\n 30\n0.0\n";
}

void write_polyline(TextBuffer& text, std::span<const glm::dvec2> points, const DxfLayer& layer) {
    begin_entity(text, "POLYLINE", layer);
    text << " 66\n1\n";
    write_place(text, {0, 0});
    for (const glm::dvec2 p : points) {
        begin_entity(text, "VERTEX", layer);
        write_place(text, p);
    }
    begin_entity(text, "SEQEND", layer);
}

// On each pen's layer.
void write_marks_of(TextBuffer& text, const PageSize& page, std::span<const DxfLayer> layers,
                    std::span<const CutMark> marks) {
    const auto turned = [&](glm::dvec2 p) { return glm::dvec2(p.x, page.height_mm - p.y); };
    for (const DxfLayer& layer : layers)
        for (const CutMark& mark : marks)
            write_polyline(text, std::array{turned(mark.from), turned(mark.to)}, layer);
}

void end_dxf(TextBuffer& text) {
    text << "  0\nENDSEC\n  0\nEOF\n";
    text.flush();
}

}  // namespace

void write_dxf(std::ostream& out, const DotStream& dots, const PageSize& page, double dot_radius_mm,
               std::span<const Pen> pens, const WritingProgress& progress,
               std::span<const CutMark> registration) {
    TextBuffer text(out);
    const std::vector<DxfLayer> layers = layers_of(pens, "Dots");
    begin_dxf(text, page, layers);
    if (!pens.empty()) write_marks_of(text, page, layers, registration);
    for_each_plotted_dot(dots, page, dot_radius_mm, progress, [&](const PlottedDot& dot) {
        const std::size_t pen = pens.empty() ? 0 : static_cast<std::size_t>(dot.pen);
        text << "  0\nCIRCLE\n  8\n" << std::string_view(layers[pen].name) << "\n 10\n";
        text.fixed(dot.x_mm, kDxfDecimals) << "\n 20\n";
        text.fixed(dot.y_mm, kDxfDecimals) << "\n 30\n0.0\n 40\n";
        text.fixed(std::max(dot.radius_mm, kLeastDxfRadiusMm), kDxfDecimals) << '\n';
    });
    end_dxf(text);
}

void write_dxf(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
               std::span<const Pen> pens, const WritingProgress& progress,
               std::span<const CutMark> registration) {
    TextBuffer text(out);
    const std::vector<DxfLayer> layers = layers_of(pens, "Lines");
    begin_dxf(text, page, layers);
    if (!pens.empty()) write_marks_of(text, page, layers, registration);
    for_each_plotted_stroke(strokes, page, progress, [&](std::span<const glm::dvec2> points, int pen) {
        const DxfLayer& layer = layers[pens.empty() ? 0 : static_cast<std::size_t>(pen)];
        if (points.size() == 1) {
            begin_entity(text, "POINT", layer);
            return write_place(text, points[0]);
        }
        write_polyline(text, points, layer);
    });
    end_dxf(text);
}

}  // namespace dapple
