#include "app/viewer/background/dots_request.h"

#include <cassert>

namespace dapple {

namespace {

constexpr int kRampWidth = 512;

Grid<float> ramp() {
    Grid<float> values(kRampWidth, kRampWidth / 2);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x)
            values.at(x, y) = (static_cast<float>(x) + 0.5f) / static_cast<float>(values.width);
    return values;
}

}  // namespace

Density plain_density(const DensityChoice& choice) {
    assert(choice.source != DensitySource::photograph);
    if (choice.source == DensitySource::ramp) return Density(ramp());
    return Density(Grid<float>(1, 1, static_cast<float>(choice.grey)));
}

DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density) {
    DotsRequest request{.drawing = settings, .density = density};
    DrawingSettings& drawing = request.drawing;
    drawing.tile = tile_in_use(settings);
    // No dot depends on these: another ink places none anew.
    const DrawingSettings usual;
    drawing.sheets = usual.sheets;
    drawing.registration = usual.registration;
    drawing.ink = usual.ink;
    drawing.background = usual.background;
    return request;
}

}  // namespace dapple
