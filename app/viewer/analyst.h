#pragma once
// Measures the dots on screen in a thread of its own, one view at a time: whoever has newer dots waits until
// it is free and gives it the newest, so that nothing piles up while a slider moves.

#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "app/viewer/view_analysis.h"

namespace dapple {

class Analyst {
 public:
    /// `wake` is called from the thread when there is a result.
    explicit Analyst(std::function<void()> wake) : wake_(std::move(wake)) {}

    bool busy() const;
    /// Not while busy.
    void begin(ViewAnalysisRequest request);
    /// Gives up what is under way; it has no result.
    void stop() { thread_.request_stop(); }
    /// The result, once. It carries an error if the measuring threw one.
    std::optional<ViewAnalysis> result();

 private:
    void run(ViewAnalysisRequest request, const std::stop_token& stop);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    bool busy_ = false;
    std::optional<ViewAnalysis> result_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace dapple
