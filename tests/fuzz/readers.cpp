#include "tests/fuzz/readers.h"

#include <sstream>
#include <stdexcept>

#include "core/output/drawing_format.h"
#include "core/pens/pen.h"
#include "core/tile/tile_file.h"
#include "lab/analysis/point_table.h"

namespace dapple {

void read_any_tile(const std::string& text) {
    try {
        read_tile(text);
    } catch (const std::runtime_error&) {
    }
}

void read_any_points(const std::string& text) {
    try {
        in_their_own_box(parse_point_table(text), Topology::torus);
    } catch (const std::runtime_error&) {
    }
}

void read_any_gcode_template(const std::string& text) {
    GcodeStyle style;
    try {
        style.lines = parse_gcode_template(text);
        Dots dots;
        dots.x = dots.y = {0.25f, 0.75f};
        std::ostringstream out;
        write_gcode(out, {.size = {100, 100, 100}, .dots = stream_of(dots), .gcode = style});
    } catch (const std::runtime_error&) {
    }
}

void read_any_pens(const std::string& text) {
    try {
        parse_pens(text);
    } catch (const std::runtime_error&) {
    }
}

}  // namespace dapple
