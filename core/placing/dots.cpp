#include "core/placing/dots.h"

#include <cmath>

namespace dapple {

Birthplace birthplace_of(float threshold, std::size_t tile_size) {
    double birth = threshold * 16.0;
    const auto n = static_cast<double>(tile_size);
    int level = 0;
    for (; birth >= (level == 0 ? n : 4 * n); ++level) {
        if (level > 0) birth /= 4;
    }
    return {level, static_cast<int>(birth)};
}

}  // namespace dapple
