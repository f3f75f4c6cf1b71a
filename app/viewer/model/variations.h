#pragma once
// A drawing's settings and eight that differ a little from them, to choose from by eye.

#include <array>

#include "app/viewer/model/viewer_settings.h"
#include "core/drawing/settings.h"

namespace dapple {

struct Variation {
    const char* name = "";  // "lighter"
    DrawingSettings drawing = {};
};

/// Row by row, three in each; in the middle the settings as they are. Other tones and sizes begin with what
/// was drawn.
std::array<Variation, 9> variations_of(const DrawingSettings& now, const DrawnInfo& drawn);

}  // namespace dapple
