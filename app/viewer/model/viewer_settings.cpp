#include "app/viewer/model/viewer_settings.h"

namespace dapple {

DotsRequest dots_request(const ViewerSettings& settings) {
    DotsRequest request = dots_request(settings.drawing, settings.density);
    if (settings.drawing.style == DrawingStyle::line) request.strokes.order = settings.saving.order;
    request.colours.colouring = settings.colouring;
    request.colours.deepest_level = settings.deepest_level;
    // Another ink places nothing anew as long as all dots are drawn in it.
    if (settings.deepest_level < kDeepestStep) request.colours.ink = settings.drawing.ink;
    // A plot by priority is shown with what says when each dot appears.
    const bool by_priority = settings.saving.order == DotOrder::priority;
    if (settings.origins || by_priority) request.drawing.placing.thresholds = true;
    return request;
}

}  // namespace dapple
