#pragma once
// Measures the dots on screen in the background, again whenever they are others.

#include <cstdint>
#include <functional>
#include <optional>

#include "app/viewer/model/background.h"
#include "app/viewer/model/camera.h"
#include "app/viewer/model/view_analysis.h"

namespace dapple {

/// Tells one view of dots from another.
struct ViewKey {
    std::uint64_t placing = 0;  // a number that changes with the dots
    Camera camera;
    bool operator==(const ViewKey&) const = default;
};

class ViewMeter {
 public:
    ViewMeter(Measure measure, std::function<void()> wake)
        : measure_(measure), background_(std::move(wake)) {}

    /// To be called each frame while somebody looks. `request` is asked for the dots on screen when they are
    /// others than before and the last measuring is over.
    void update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request);
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
    std::optional<ViewKey> measured_;
    std::optional<ViewAnalysis> analysis_;
    int analyses_ = 0;
};

}  // namespace dapple
