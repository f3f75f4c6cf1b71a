#include "core/output/hpgl.h"

#include <cmath>
#include <cstdint>

#include "core/output/plotted_dots.h"
#include "core/text/text_buffer.h"

namespace dapple {
namespace {

std::int64_t plotter_units(double mm) {
    return std::llround(mm * kHpglUnitsPerMm);
}

}  // namespace

void write_hpgl(std::ostream& out, const DotStream& dots, const PageSize& page,
                const WritingProgress& progress) {
    TextBuffer text(out);
    text << "IN;SP1;\n";
    for_each_plotted_dot(dots, page, 0, progress, [&](const PlottedDot& dot) {
        const std::int64_t x = plotter_units(dot.x_mm), y = plotter_units(dot.y_mm);
        text << "PU" << x << ',' << y << ";PD" << x << ',' << y << ";\n";
    });
    text << "PU;SP0;\n";
    text.flush();
}

}  // namespace dapple
