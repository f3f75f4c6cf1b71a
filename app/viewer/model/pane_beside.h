#pragma once
// Another drawing of the picture that a session shows: the split view's right side, or the drawing as it was.
// Its worker has a picture of its own, so that neither drawing ever waits for the other.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/viewer/model/pane.h"

namespace dapple {

class PaneBeside {
 public:
    /// `wake`: as Pane has it.
    explicit PaneBeside(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// Requests it as Pane::request(), of the picture of that number, which is at least 1.
    void request(const OpenedPicture& picture, int number, DotsRequest page, const Zoom& zoom,
                 RequestAgain again);
    /// Keeps neither picture nor dots until it is requested again.
    void forget();

    /// What its worker has done, but for dots that come too late; those are to be given to take().
    std::vector<WorkerEvent> events();
    void take(DotsPlaced& event);

    /// None before a request.
    const Pane* in_use() const { return asked_ > 0 ? &*pane_ : nullptr; }
    /// None before the first dots of the picture of that number.
    const Pane* of_picture(int number) const;

 private:
    std::function<void()> wake_;
    std::optional<Pane> pane_;   // once it was asked for
    int asked_ = 0, there_ = 0;  // the numbers of its picture; 0: none
};

}  // namespace dapple
