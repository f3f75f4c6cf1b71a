#include "app/viewer/repetition_meter.h"

namespace dapple {

void RepetitionMeter::update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request) {
    if (const auto result = background_.result()) {
        value_.reset();
        if (result->periodicity) value_ = result->periodicity->value;
    }
    if (measured_ == key || background_.busy()) return;
    ViewAnalysisRequest wanted = request();
    wanted.measure = Measure::repetition;
    background_.begin(analysis_work(std::move(wanted)));
    measured_ = key;
}

}  // namespace dapple
