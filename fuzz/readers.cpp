#include "fuzz/readers.h"

#include <stdexcept>

#include "core/analysis/point_table.h"
#include "core/tile/tile_file.h"

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

}  // namespace dapple
