#include "app/viewer/model/view_meter.h"

#include <utility>

namespace dapple {

void ViewMeter::update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request) {
    if (std::optional<ViewAnalysis> result = background_.result()) {
        analysis_ = std::move(result);
        ++analyses_;
    }
    if (measured_ == key || background_.busy()) return;
    ViewAnalysisRequest wanted = request();
    wanted.measure = measure_;
    background_.begin(analysis_work(std::move(wanted)));
    measured_ = key;
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
