#include "app/viewer/model/viewer_settings.h"

namespace dapple {

PlaceOrder order_of(const ViewerSettings& settings) {
    PlaceOrder order = order_of(settings.drawing, settings.density);
    order.colours.colouring = settings.colouring;
    order.colours.deepest_level = settings.deepest_level;
    // Another ink places nothing anew as long as all dots are drawn in it.
    if (settings.deepest_level < kDeepestStep) order.colours.ink = settings.drawing.ink;
    return order;
}

}  // namespace dapple
