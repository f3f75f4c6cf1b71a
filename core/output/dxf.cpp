#include "core/output/dxf.h"

#include <algorithm>

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
    "  0\nTABLE\n  2\nLAYER\n 70\n2\n"
    "  0\nLAYER\n  2\n0\n 70\n0\n 62\n7\n  6\nCONTINUOUS\n"
    "  0\nLAYER\n  2\n";  // the layer's name
constexpr const char* kDxfTablesEnd =
    "\n 70\n0\n 62\n7\n  6\nCONTINUOUS\n"
    "  0\nENDTAB\n"
    "  0\nENDSEC\n";

// Up to the first of the entities, which are on that layer.
void begin_dxf(TextBuffer& text, const PageSize& page, const char* layer) {
    text << "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n"
         << "  9\n$EXTMIN\n 10\n0.0\n 20\n0.0\n 30\n0.0\n"
         << "  9\n$EXTMAX\n 10\n";
    text.fixed(page.width_mm, kDxfDecimals) << "\n 20\n";
    text.fixed(page.height_mm, kDxfDecimals) << "\n 30\n0.0\n  0\nENDSEC\n";
    text << kDxfTablesBegin << layer << kDxfTablesEnd << "  0\nSECTION\n  2\nENTITIES\n";
}

void begin_entity(TextBuffer& text, const char* kind) {
    text << "  0\n" << std::string_view(kind) << "\n  8\nLines\n";
}

void write_place(TextBuffer& text, glm::dvec2 p) {
    text << " 10\n";
    text.fixed(p.x, kDxfDecimals) << "\n 20\n";
    text.fixed(p.y, kDxfDecimals) << "\n 30\n0.0\n";
}

void write_polyline(TextBuffer& text, std::span<const glm::dvec2> points) {
    begin_entity(text, "POLYLINE");
    text << " 66\n1\n";
    write_place(text, {0, 0});
    for (const glm::dvec2 p : points) {
        begin_entity(text, "VERTEX");
        write_place(text, p);
    }
    begin_entity(text, "SEQEND");
}

void end_dxf(TextBuffer& text) {
    text << "  0\nENDSEC\n  0\nEOF\n";
    text.flush();
}

}  // namespace

void write_dxf(std::ostream& out, const DotStream& dots, const PageSize& page, double dot_radius_mm,
               const WritingProgress& progress) {
    TextBuffer text(out);
    begin_dxf(text, page, "Dots");
    for_each_plotted_dot(dots, page, dot_radius_mm, progress, [&](const PlottedDot& dot) {
        text << "  0\nCIRCLE\n  8\nDots\n 10\n";
        text.fixed(dot.x_mm, kDxfDecimals) << "\n 20\n";
        text.fixed(dot.y_mm, kDxfDecimals) << "\n 30\n0.0\n 40\n";
        text.fixed(std::max(dot.radius_mm, kLeastDxfRadiusMm), kDxfDecimals) << '\n';
    });
    end_dxf(text);
}

void write_dxf(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
               const WritingProgress& progress) {
    TextBuffer text(out);
    begin_dxf(text, page, "Lines");
    for_each_plotted_stroke(strokes, page, progress, [&](std::span<const glm::dvec2> points) {
        if (points.size() == 1) {
            begin_entity(text, "POINT");
            return write_place(text, points[0]);
        }
        write_polyline(text, points);
    });
    end_dxf(text);
}

}  // namespace dapple
