#pragma once
// How much the dots on screen repeat, kept up to date in the background: a number for a caption.

#include <functional>
#include <optional>

#include "app/viewer/background.h"
#include "app/viewer/spectrum_view.h"
#include "app/viewer/view_analysis.h"

namespace dapple {

class RepetitionMeter {
 public:
    explicit RepetitionMeter(std::function<void()> wake) : background_(std::move(wake)) {}

    /// To be called each frame while the number is shown. `request` is asked for the dots on screen when they
    /// are others than before and the last measuring is over.
    void update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request);

    /// core/analysis/autocorrelation.h; none before the first, or if there are too few tiles in view.
    std::optional<double> value() const { return value_; }

 private:
    Background<ViewAnalysis> background_;
    std::optional<ViewKey> measured_;
    std::optional<double> value_;
};

}  // namespace dapple
