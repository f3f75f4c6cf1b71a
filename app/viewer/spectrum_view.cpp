#include "app/viewer/spectrum_view.h"

#include "app/viewer/keys.h"
#include "app/viewer/panels/spectrum_panel.h"

namespace dapple {

void SpectrumView::draw() {
    SpectrumFacts facts;
    if (analysis_) {
        facts.analysis = &*analysis_;
        if (!analysis_->picture.empty()) facts.picture = texture_id(picture_.get());
    }
    open_ = draw_spectrum_panel(facts);
}

void SpectrumView::update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request) {
    if (auto result = analyst_.result()) {
        analysis_ = std::move(result);
        if (!analysis_->picture.empty()) picture_.write(analysis_->picture);
    }
    if (!open_) {
        analyst_.stop();
        measured_.reset();
        return;
    }
    if (measured_ == key || analyst_.busy()) return;
    analyst_.begin(analysis_work(request()));
    measured_ = key;
}

}  // namespace dapple
