#include "app/drawing_settings.h"

#include "core/image/ink.h"

namespace dapple {

std::string tile_in_use(const DrawingSettings& settings) {
    const bool turns = settings.tile == kDefaultTile && settings.stipple.placer == PlacerKind::figure8;
    return turns ? "paper16" : settings.tile;
}

double dot_radius_mm(const DrawingSettings& settings, double scale, const PageSize& page) {
    if (settings.dot_radius_mm) return *settings.dot_radius_mm;
    return radius_for_tone(scale) * page.mm_per_page_unit;
}

}  // namespace dapple
