#include "app/viewer/model/pane_beside.h"

#include <variant>

namespace dapple {

void PaneBeside::request(const OpenedPicture& picture, int number, DotsRequest page, const Zoom& zoom,
                         RequestAgain again) {
    if (!pane_) pane_.emplace(wake_);
    if (std::exchange(asked_, number) != number) pane_->worker().open(picture.name, picture.read);
    pane_->request(std::move(page), zoom, again);
}

void PaneBeside::forget() {
    if (asked_ == 0) return;
    pane_->clear();
    asked_ = there_ = 0;
}

std::vector<WorkerEvent> PaneBeside::events() {
    if (!pane_) return {};
    std::vector<WorkerEvent> events = pane_->worker().events();
    if (asked_ == 0)
        std::erase_if(events, [](const auto& event) { return std::holds_alternative<DotsPlaced>(event); });
    return events;
}

void PaneBeside::take(DotsPlaced& event) {
    if (event.picture) there_ = asked_;
    pane_->take(event);
}

const Pane* PaneBeside::of_picture(int number) const {
    return pane_ && there_ == number ? &*pane_ : nullptr;
}

}  // namespace dapple
