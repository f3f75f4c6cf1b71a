#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/lines/ink_lines.h"
#include "core/output/drawing_format.h"
#include "core/text/number_words.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr double kPxPerMm = 96.0 / kMmPerInch;
constexpr double kLeastPx = 0.001;  // of what is not to be dropped
constexpr double kTouchMm = 0.05;
constexpr double kCutMarkMm = 0.4 / kPxPerMm;

// Two decimals, 0.0026 mm, are enough until the dots' mean spacing comes near a pixel.
int decimals_for(const InkPage& page) {
    const std::uint64_t dots = page.strokes ? page.strokes->points : page.dots.count;
    const double area = page.size.width_mm * page.size.height_mm * kPxPerMm * kPxPerMm;
    return static_cast<double>(dots) * 4 < area ? 2 : 3;
}

// The part of the picture that is on the page, in px.
Rectangle<double> drawn_area(const InkPage& page) {
    const double px_per_unit = page.size.mm_per_page_unit * kPxPerMm;
    const Rectangle<double> area{{0, 0}, glm::dvec2(page.size.width_mm, page.size.height_mm) * kPxPerMm};
    if (!page.picture) return area;
    return {glm::max(area.low, page.picture->low * px_per_unit),
            glm::min(area.high, page.picture->high * px_per_unit)};
}

// In px, by level. Tiles cover a square, the picture need not be one and a part of it may be on the page:
// what lies over the edges is cut off, and an outline that lies all around is none.
std::map<int, std::vector<Rectangle<double>>> outlines_of(const InkPage& page) {
    const double px_per_unit = page.size.mm_per_page_unit * kPxPerMm;
    const Rectangle<double> area = drawn_area(page);
    std::map<int, std::vector<Rectangle<double>>> by_level;
    for (const PlacedTile& tile : page.tiles) {
        const glm::dvec2 corner(tile.x, tile.y);
        const Rectangle<double> outline{corner * px_per_unit, (corner + tile.side) * px_per_unit};
        const bool around = outline.low.x < area.low.x && outline.low.y < area.low.y &&
                            outline.high.x > area.high.x && outline.high.y > area.high.y;
        if (overlap(outline, area) && !around)
            by_level[tile.level].push_back(
                {glm::max(outline.low, area.low), glm::min(outline.high, area.high)});
    }
    return by_level;
}

class SvgWriter : public InkWriter {
 public:
    SvgWriter(std::ostream& out, const InkPage& page)
        : text_(out), page_(page), decimals_(decimals_for(page)) {
        text_
            << R"(<?xml version="1.0" encoding="UTF-8"?>)"
            << "\n"
            << R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape")"
            << R"( version="1.1" width=")";
        const glm::dvec2 size(page.size.width_mm, page.size.height_mm);
        text_.fixed(size.x, 4) << R"(mm" height=")";
        text_.fixed(size.y, 4) << R"(mm" viewBox="0 0 )";
        text_.fixed(size.x * kPxPerMm, 4) << ' ';
        text_.fixed(size.y * kPxPerMm, 4) << "\">\n";
        if (!page.settings.empty())
            text_ << "<metadata><" << kSvgSettingsElement << R"( xmlns:dapple="urn:x-dapple:settings">)"
                  << page.settings << "</" << kSvgSettingsElement << "></metadata>\n";
        if (page.background) {
            begin_layer("% Background", "background");
            text_ << R"(><rect width="100%" height="100%" fill=")" << hex_of(*page.background)
                  << "\"/></g>\n";
        }
    }

    void begin_pen(int number, const Pen& pen, double width_mm) override {
        end_layer();
        in_layer_ = true;
        const std::string counted = std::to_string(number + 1);
        begin_layer(counted + ' ' + pen.name, "layer" + counted);
        if (pen.ink == PenInk::transparent) text_ << R"( style="mix-blend-mode:multiply")";
        colour_ = hex_of(pen.colour);
        width_px_ = std::max(width_mm * kPxPerMm, kLeastPx);
        if (page_.strokes) {
            write_line_style();
            text_ << R"( stroke-linecap="round" stroke-linejoin="round">)" << '\n';
        } else {
            text_ << R"( fill=")" << std::string_view(colour_) << R"(" stroke="none">)" << '\n';
        }
    }

    void dot(const InkDot& dot) override {
        text_ << "<circle";
        attribute("cx", dot.at.x * kPxPerMm, decimals_);
        attribute("cy", dot.at.y * kPxPerMm, decimals_);
        attribute("r", std::max(dot.radius_mm * kPxPerMm, kLeastPx), 3);
        text_ << "/>\n";
    }

    void stroke(std::span<const glm::dvec2> points) override {
        text_ << "<path";
        if (!page_.strokes) write_line_style();  // the layer's is of dots
        text_ << R"( d="M)";
        const bool touch = points.size() == 1;
        place(touch ? points[0] - glm::dvec2(kTouchMm / 2, 0) : points[0]);
        if (touch) (text_ << 'h').fixed(kTouchMm * kPxPerMm, 3);
        // A line of text ends now and then, as some readers have a limit.
        for (std::size_t i = 1; i < points.size(); ++i) {
            text_ << (i == 1 ? 'L' : i % 16 == 1 ? '\n' : ' ');
            place(points[i]);
        }
        text_ << "\"/>\n";
    }

    void shape(const InkArea& area) override {
        text_ << R"(<path d=")";
        for (const std::vector<glm::dvec2>& ring : area.rings) {
            text_ << 'M';
            place(ring.front());
            const std::vector<Cubic> curves = smooth_curve(ring);
            for (std::size_t i = 0; i < curves.size(); ++i) {
                text_ << (i % 8 == 7 ? "\nC" : "C");
                place(curves[i][1]);
                text_ << ' ';
                place(curves[i][2]);
                text_ << ' ';
                place(curves[i][3]);
            }
            text_ << 'Z';
        }
        text_ << "\"/>\n";
    }

    void end() override {
        end_layer();
        if (!page_.tiles.empty()) write_tiles();
        if (!page_.cut_marks.empty()) {
            const int layer = std::max<int>(static_cast<int>(page_.pens.size()), 1);
            begin_pen(layer, {.name = "Cut marks", .ink = PenInk::opaque}, kCutMarkMm);
            write_marks(*this, page_.cut_marks);
            end_layer();
        }
        text_ << "</svg>\n";
        text_.flush();
    }

 private:
    void begin_layer(std::string_view label, std::string_view id) {
        text_ << R"(<g inkscape:groupmode="layer" inkscape:label=")" << label << R"(" id=")" << id << '"';
    }

    void end_layer() {
        if (in_layer_) text_ << "</g>\n";
        in_layer_ = false;
    }

    // Finest first: the coarse ones lie on top, so that every line shows the coarsest level that it bounds.
    void write_tiles() {
        begin_layer("% Tiles", "tiles");
        text_ << R"( fill="none" stroke-width="0.3">)" << '\n';
        const auto by_level = outlines_of(page_);
        for (auto level = by_level.rbegin(); level != by_level.rend(); ++level) {
            text_ << R"(<g id="level)" << std::int64_t{level->first} << R"(" stroke=")"
                  << hex_of(level_colour(level->first)) << "\">\n";
            for (const Rectangle<double>& outline : level->second) {
                text_ << "<rect";
                attribute("x", outline.low.x, 3);
                attribute("y", outline.low.y, 3);
                attribute("width", outline.size().x, 3);
                attribute("height", outline.size().y, 3);
                text_ << "/>\n";
            }
            text_ << "</g>\n";
        }
        text_ << "</g>\n";
    }

    void write_line_style() {
        text_ << R"( fill="none" stroke=")" << std::string_view(colour_) << '"';
        attribute("stroke-width", width_px_, 3);
    }

    void attribute(std::string_view name, double value, int decimals) {
        text_ << ' ' << name << "=\"";
        text_.fixed(value, decimals) << '"';
    }

    void place(glm::dvec2 at_mm) {
        text_.fixed(at_mm.x * kPxPerMm, decimals_) << ' ';
        text_.fixed(at_mm.y * kPxPerMm, decimals_);
    }

    TextBuffer text_;
    const InkPage& page_;
    int decimals_;
    bool in_layer_ = false;
    std::string colour_;  // of the pen that draws
    double width_px_ = 0;
};

}  // namespace

void write_svg(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    SvgWriter writer(out, page);
    write_ink(writer, page, progress);
}

}  // namespace dapple
