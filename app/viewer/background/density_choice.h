#pragma once
// What the window's dots are placed on: the photograph, or a plain density that shows what the tile does.

#include "core/image/density.h"
#include "core/text/names.h"

namespace dapple {

enum class DensitySource { photograph, grey, ramp };
constexpr auto names_of(DensitySource) {
    return names("photograph", "grey", "ramp");
}

struct DensityChoice {
    DensitySource source = DensitySource::photograph;
    double grey = 0.5;  // density of the grey, 0..1

    bool operator==(const DensityChoice&) const = default;
};

/// The grey: a square page of one density. The ramp: twice as wide as high, from bare paper on the left to
/// density 1 on the right. The tone has no part in either. Not for the photograph.
Density plain_density(const DensityChoice& choice);

}  // namespace dapple
