#pragma once
// How the canvas shows a pane, and which of its dots are in view.

#include <cstdint>
#include <vector>

#include "app/viewer/renderer.h"
#include "app/viewer/session.h"
#include "app/viewer/view_analysis.h"

namespace dapple {

/// `pixel_scale`: see CanvasLook.
CanvasLook look_of(const Session& session, const Pane& pane, const Zoom& zoom, float pixel_scale);

PointsInView points_on_screen(const PlacedDrawing& shown, const Camera& camera);

/// Tells the colours of one drawing's dots from another's.
struct DotColoursKey {
    std::uint64_t version = 0;  // of the pane
    DotColouring colouring = DotColouring::ink;
    int deepest_level = kDeepestStep;
    glm::vec3 ink = kBlack;
    bool operator==(const DotColoursKey&) const = default;
};
DotColoursKey colours_key(const Session& session, const Pane& pane);
std::vector<glm::u8vec4> colours_of(const Session& session, const Pane& pane);

}  // namespace dapple
