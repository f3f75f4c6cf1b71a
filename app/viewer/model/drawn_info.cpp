#include "app/viewer/model/drawn_info.h"

#include <algorithm>

#include "core/settings/setting.h"

namespace dapple {

DotSize dot_size_from(DotSizing sizing, double drawn_radius_mm) {
    const double least = setting::radius.range.least, radius = std::max(drawn_radius_mm, least);
    return {.sizing = sizing,
            .radius_mm = radius,
            .smallest_mm = std::max(0.5 * radius, least),
            .largest_mm = 1.2 * radius};
}

}  // namespace dapple
