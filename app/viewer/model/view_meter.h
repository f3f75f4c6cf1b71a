#pragma once
// Measures the dots on screen in the background, again whenever they are others.

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "app/viewer/background/background.h"
#include "app/viewer/model/pane.h"
#include "app/viewer/view/view_analysis.h"

namespace dapple {

class ViewMeter {
 public:
    ViewMeter(Measure measure, std::function<void()> wake)
        : measure_(measure), background_(std::move(wake)) {}

    /// To be called each frame while somebody looks. Measures the dots on screen when they are others than
    /// before and the last measuring is over.
    void update(const Pane& pane, const Camera& camera, std::size_t tile_size);
    /// Nobody looks any more: gives up what is under way.
    void stop();

    /// None before the first.
    const std::optional<ViewAnalysis>& analysis() const { return analysis_; }
    /// ViewAnalysis::periodicity's value.
    std::optional<double> periodicity() const;
    /// How many there have been.
    int analyses() const { return analyses_; }

 private:
    void take_result();

    Measure measure_;
    Background<ViewAnalysis> background_;
    std::optional<std::pair<std::uint64_t, Camera>> measured_;  // of Pane::placings()
    std::optional<ViewAnalysis> analysis_;
    int analyses_ = 0;
};

}  // namespace dapple
