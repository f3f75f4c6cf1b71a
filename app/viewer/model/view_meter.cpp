#include "app/viewer/model/view_meter.h"

#include <exception>
#include <glm/common.hpp>

namespace dapple {
namespace {

PointsInView points_on_screen(const PlacedDrawing& shown, const Camera& camera) {
    const PageWindow view = window_in_view(camera, 0);
    // Relative to the dots' origin, which may lie deep within the page.
    const PagePoint origin{shown.window.x, shown.window.y};
    const glm::dvec2 low = in_page_units(PagePoint{view.x, view.y} - origin);
    const glm::dvec2 page_end = shown.page_size - in_page_units(origin);
    const glm::dvec2 high = glm::min(low + glm::dvec2(view.width, view.height), page_end);
    return points_in_view(shown.dots, {low, high}, kMostAnalysed, shown.blocks);
}

}  // namespace

void ViewMeter::update(const Pane& pane, const Camera& camera, std::size_t tile_size) {
    take_result();
    const std::pair key(pane.placings(), camera);
    if (measured_ == key || background_.busy()) return;
    background_.begin(analysis_work({.view = points_on_screen(pane.shown(), camera),
                                     .tile_size = tile_size,
                                     .has_duplicates = pane.page().duplicates > 0,
                                     .measure = measure_}));
    measured_ = key;
}

void ViewMeter::take_result() {
    try {
        std::optional<ViewAnalysis> result = background_.result();
        if (!result) return;
        analysis_ = std::move(result);
    } catch (const std::exception& error) {
        analysis_.emplace().error = error.what();
    }
    ++analyses_;
}

void ViewMeter::stop() {
    background_.stop();
    measured_.reset();
}

std::optional<double> ViewMeter::periodicity() const {
    if (!analysis_ || !analysis_->periodicity) return std::nullopt;
    return analysis_->periodicity->value;
}

}  // namespace dapple
