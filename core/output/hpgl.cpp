#include "core/output/hpgl.h"

#include <cmath>
#include <cstdint>

#include "core/output/plotted.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

std::int64_t plotter_units(double mm) {
    return std::llround(mm * kHpglUnitsPerMm);
}

// The plotter begins with its first pen.
class HpglPen {
 public:
    HpglPen(TextBuffer& text, const PageSize& page, std::span<const CutMark> registration,
            std::string_view comment)
        : text_(text), page_(page), registration_(registration) {
        if (!comment.empty()) text_ << "CO \"" << comment << "\";";
        text_ << "IN;SP1;\n";
    }

    void take(int pen) {
        if (pen == pen_) return;
        if (pen != 0) text_ << "PU;SP" << std::int64_t{pen + 1} << ";\n";
        pen_ = pen;
        for (const CutMark& mark : registration_) {
            text_ << "PU";
            place(mark.from);
            text_ << ";PD";
            place(mark.to);
            text_ << ";\n";
        }
    }

 private:
    void place(glm::dvec2 p) { text_ << plotter_units(p.x) << ',' << plotter_units(page_.height_mm - p.y); }

    TextBuffer& text_;
    const PageSize& page_;
    std::span<const CutMark> registration_;
    int pen_ = -1;
};

}  // namespace

void write_hpgl(std::ostream& out, const DotStream& dots, const PageSize& page,
                const WritingProgress& progress, std::span<const CutMark> registration,
                std::string_view comment) {
    TextBuffer text(out);
    HpglPen pen(text, page, registration, comment);
    for_each_plotted_dot(dots, page, 0, progress, [&](const PlottedDot& dot) {
        pen.take(dot.pen);
        text << "PU" << plotter_units(dot.x_mm) << ',' << plotter_units(dot.y_mm) << ";PD;\n";
    });
    text << "PU;SP0;\n";
    text.flush();
}

void write_hpgl(std::ostream& out, const StrokeStream& strokes, const PageSize& page,
                const WritingProgress& progress, std::span<const CutMark> registration,
                std::string_view comment) {
    constexpr std::size_t kPointsOfAnInstruction = 50;  // plotters' memory for one is small
    TextBuffer text(out);
    HpglPen pen(text, page, registration, comment);
    for_each_plotted_stroke(strokes, page, progress, [&](std::span<const glm::dvec2> points, int its_pen) {
        pen.take(its_pen);
        const auto place = [&](glm::dvec2 p) { text << plotter_units(p.x) << ',' << plotter_units(p.y); };
        text << "PU";
        place(points[0]);
        text << ";PD";
        if (points.size() > 1) place(points[1]);
        for (std::size_t i = 2; i < points.size(); ++i) {
            text << (i % kPointsOfAnInstruction == 0 ? ";\nPD" : ",");
            place(points[i]);
        }
        text << ";\n";
    });
    text << "PU;SP0;\n";
    text.flush();
}

}  // namespace dapple
