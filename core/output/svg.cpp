#include "core/output/svg.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/output/plotted.h"
#include "core/text/length.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr double kPxPerMm = 96.0 / kMmPerInch;
constexpr double kUsualMarkMm = 0.3;  // of a pen whose width is not told

// Two decimals, 0.0026 mm, are enough until the dots' mean spacing comes near a pixel.
int decimals_for(std::uint64_t dots, const PageSize& page) {
    const double area = page.width_mm * page.height_mm * kPxPerMm * kPxPerMm;
    return static_cast<double>(dots) * 4 < area ? 2 : 3;
}

// Not to be drawn by a plotter: AxiDraw's software skips layers whose names begin so.
void begin_unplotted_layer(TextBuffer& text, std::string_view name, std::string_view id) {
    text << R"(<g inkscape:groupmode="layer" inkscape:label="% )" << name << R"(" id=")" << id << '"';
}

void begin_layer(TextBuffer& text, int number, std::string_view label, PenInk ink = PenInk::opaque) {
    text << R"(<g inkscape:groupmode="layer" inkscape:label=")" << std::int64_t{number} << ' ' << label
         << R"(" id="layer)" << std::int64_t{number} << '"';
    if (ink == PenInk::transparent) text << R"( style="mix-blend-mode:multiply")";
}

// Above nothing but the paper.
Pen only_pen(glm::vec3 ink) {
    return {.name = pen_name(ink), .colour = ink, .ink = PenInk::opaque};
}

void write_marks(TextBuffer& text, std::span<const CutMark> marks) {
    for (const CutMark& mark : marks) {
        text << R"(<path d="M)";
        text.fixed(mark.from.x * kPxPerMm, 3) << ' ';
        text.fixed(mark.from.y * kPxPerMm, 3) << 'L';
        text.fixed(mark.to.x * kPxPerMm, 3) << ' ';
        text.fixed(mark.to.y * kPxPerMm, 3) << "\"/>\n";
    }
}

void write_dots(TextBuffer& text, const DotStream& dots, const PageSize& page, const SvgStyle& style,
                const WritingProgress& progress) {
    const int decimals = decimals_for(dots.count, page);
    const double px_per_unit = page.mm_per_page_unit * kPxPerMm;
    const auto in_px = [](double radius_mm) { return std::max(radius_mm * kPxPerMm, 0.001); };
    const double radius = in_px(style.dot_radius_mm);
    const auto begin_pen = [&](int number, const Pen& pen) {
        begin_layer(text, number, pen.name, pen.ink);
        text << R"( fill=")" << hex_of(pen.colour) << R"(" stroke="none">)" << '\n';
    };
    int layer = -1;  // the pen whose layer is open
    if (style.pens.empty()) begin_pen(1, only_pen(style.ink));
    DotsReport report(dots.count, page, progress);
    dots.for_each_piece([&](const Dots& piece) {
        if (!style.pens.empty() && piece.pen != layer) {
            if (layer >= 0) text << "</g>\n";
            layer = piece.pen;
            const Pen& pen = style.pens[static_cast<std::size_t>(layer)];
            begin_pen(layer + 1, pen);
            if (!style.registration.empty()) {
                text << R"(<g fill="none" stroke=")" << hex_of(pen.colour) << R"(" stroke-width=")";
                text.fixed((pen.width_mm > 0 ? pen.width_mm : kUsualMarkMm) * kPxPerMm, 3) << "\">\n";
                write_marks(text, style.registration);
                text << "</g>\n";
            }
        }
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double own_mm = piece.radius.empty() ? 0 : piece.radius[i] * page.mm_per_page_unit;
            report.next(piece.x[i] * page.mm_per_page_unit, piece.y[i] * page.mm_per_page_unit, own_mm);
            text << R"(<circle cx=")";
            text.fixed(piece.x[i] * px_per_unit, decimals);
            text << R"(" cy=")";
            text.fixed(piece.y[i] * px_per_unit, decimals);
            text << R"(" r=")";
            text.fixed(piece.radius.empty() ? radius : in_px(own_mm), 3);
            text << "\"/>\n";
        }
        return true;
    });
    if (style.pens.empty() || layer >= 0) text << "</g>\n";
}

void write_strokes(TextBuffer& text, const StrokeStream& strokes, const PageSize& page, const SvgStyle& style,
                   const WritingProgress& progress) {
    constexpr double kTouchMm = 0.05;
    const int decimals = decimals_for(strokes.points, page);
    const auto begin_pen = [&](int number, const Pen& pen) {
        begin_layer(text, number + 1, pen.name, pen.ink);
        text << R"( fill="none" stroke=")" << hex_of(pen.colour) << R"(" stroke-width=")";
        text.fixed(std::max(strokes.width_of(number) * kPxPerMm, 0.001), 3);
        text << R"(" stroke-linecap="round" stroke-linejoin="round">)" << '\n';
        if (!style.pens.empty()) write_marks(text, style.registration);
    };
    int layer = -1;  // the pen whose layer is open
    if (style.pens.empty()) begin_pen(0, only_pen(style.ink));
    const auto number = [&](double mm) { text.fixed(mm * kPxPerMm, decimals); };
    for_each_stroke(strokes, page, progress, [&](std::span<const glm::dvec2> points, int its_pen) {
        if (!style.pens.empty() && its_pen != layer) {
            if (layer >= 0) text << "</g>\n";
            layer = its_pen;
            begin_pen(layer, style.pens[static_cast<std::size_t>(layer)]);
        }
        text << R"(<path d="M)";
        const bool touch = points.size() == 1;
        number(points[0].x - (touch ? kTouchMm / 2 : 0));
        text << ' ';
        number(points[0].y);
        if (touch) {
            text << 'h';
            text.fixed(kTouchMm * kPxPerMm, 3);
        }
        // A line of text ends now and then, as some readers have a limit.
        for (std::size_t i = 1; i < points.size(); ++i) {
            text << (i == 1 ? 'L' : i % 16 == 1 ? '\n' : ' ');
            number(points[i].x);
            text << ' ';
            number(points[i].y);
        }
        text << "\"/>\n";
    });
    if (style.pens.empty() || layer >= 0) text << "</g>\n";
}

// The part of the picture that is on the page, in px.
Rectangle<double> drawn_area(const PageSize& page, const std::optional<Rectangle<double>>& picture) {
    const double px_per_unit = page.mm_per_page_unit * kPxPerMm;
    const Rectangle<double> area{{0, 0}, glm::dvec2(page.width_mm, page.height_mm) * kPxPerMm};
    if (!picture) return area;
    return {glm::max(area.low, picture->low * px_per_unit), glm::min(area.high, picture->high * px_per_unit)};
}

Rectangle<double> outline_of(const PlacedTile& tile, double px_per_unit) {
    const glm::dvec2 corner(tile.x, tile.y);
    return {corner * px_per_unit, (corner + tile.side) * px_per_unit};
}

void write_tiles(TextBuffer& text, std::span<const PlacedTile> tiles, const PageSize& page,
                 const Rectangle<double>& area) {
    const double px_per_unit = page.mm_per_page_unit * kPxPerMm;
    // Tiles cover a square, the picture need not be one and a part of it may be on the page: what lies over
    // the edges is cut off, and an outline that lies all around is none.
    std::map<int, std::vector<Rectangle<double>>> by_level;
    for (const PlacedTile& tile : tiles) {
        const Rectangle<double> outline = outline_of(tile, px_per_unit);
        const bool around = outline.low.x < area.low.x && outline.low.y < area.low.y &&
                            outline.high.x > area.high.x && outline.high.y > area.high.y;
        if (overlap(outline, area) && !around)
            by_level[tile.level].push_back(
                {glm::max(outline.low, area.low), glm::min(outline.high, area.high)});
    }
    begin_unplotted_layer(text, "Tiles", "tiles");
    text << R"( fill="none" stroke-width="0.3">)" << '\n';
    // Finest first: the coarse ones lie on top, so that every line shows the coarsest level that it bounds.
    for (auto level = by_level.rbegin(); level != by_level.rend(); ++level) {
        text << R"(<g id="level)" << std::int64_t{level->first} << R"(" stroke=")"
             << hex_of(level_colour(level->first)) << "\">\n";
        for (const Rectangle<double>& outline : level->second) {
            text << R"(<rect x=")";
            text.fixed(outline.low.x, 3);
            text << R"(" y=")";
            text.fixed(outline.low.y, 3);
            text << R"(" width=")";
            text.fixed(outline.size().x, 3);
            text << R"(" height=")";
            text.fixed(outline.size().y, 3);
            text << "\"/>\n";
        }
        text << "</g>\n";
    }
    text << "</g>\n";
}

void write_cut_marks(TextBuffer& text, std::span<const CutMark> marks, int layer) {
    begin_layer(text, layer, "Cut marks");
    text << R"( fill="none" stroke="#000000" stroke-width="0.4">)" << '\n';
    write_marks(text, marks);
    text << "</g>\n";
}

// The file, with what write_ink() puts into its first layers.
template <class WriteInk>
void write_svg_file(std::ostream& out, const PageSize& page, const SvgStyle& style,
                    const WriteInk& write_ink) {
    TextBuffer text(out);
    text
        << R"(<?xml version="1.0" encoding="UTF-8"?>)"
        << "\n"
        << R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape")"
        << R"( version="1.1" width=")";
    text.fixed(page.width_mm, 4);
    text << R"(mm" height=")";
    text.fixed(page.height_mm, 4);
    text << R"(mm" viewBox="0 0 )";
    text.fixed(page.width_mm * kPxPerMm, 4);
    text << ' ';
    text.fixed(page.height_mm * kPxPerMm, 4);
    text << "\">\n";
    if (!style.settings.empty()) {
        text << "<metadata><" << kSvgSettingsElement << R"( xmlns:dapple="urn:x-dapple:settings">)"
             << style.settings << "</" << kSvgSettingsElement << "></metadata>\n";
    }
    if (style.background) {
        begin_unplotted_layer(text, "Background", "background");
        text << R"(><rect width="100%" height="100%" fill=")" << hex_of(*style.background) << "\"/></g>\n";
    }
    write_ink(text);
    if (!style.tiles.empty()) write_tiles(text, style.tiles, page, drawn_area(page, style.picture));
    const int layer = style.pens.empty() ? 2 : static_cast<int>(style.pens.size()) + 1;
    if (!style.cut_marks.empty()) write_cut_marks(text, style.cut_marks, layer);
    text << "</svg>\n";
    text.flush();
}

}  // namespace

void write_svg(std::ostream& out, const DotStream& dots, const PageSize& page, const SvgStyle& style,
               const WritingProgress& progress) {
    write_svg_file(out, page, style,
                   [&](TextBuffer& text) { write_dots(text, dots, page, style, progress); });
}

void write_svg(std::ostream& out, const StrokeStream& strokes, const PageSize& page, const SvgStyle& style,
               const WritingProgress& progress) {
    write_svg_file(out, page, style,
                   [&](TextBuffer& text) { write_strokes(text, strokes, page, style, progress); });
}

}  // namespace dapple
