#include "app/viewer/model/view_meter.h"

#include <exception>
#include <utility>

namespace dapple {

void ViewMeter::update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request) {
    take_result();
    if (measured_ == key || background_.busy()) return;
    ViewAnalysisRequest wanted = request();
    wanted.measure = measure_;
    background_.begin(analysis_work(std::move(wanted)));
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
