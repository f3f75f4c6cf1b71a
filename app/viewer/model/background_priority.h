#pragma once
// The window's thread goes first: what works in the background has a lower priority, so that a window on a
// busy machine still answers. Linux alone tells threads apart in this; elsewhere nothing changes.

#include <tbb/task_scheduler_observer.h>

namespace dapple {

/// Made in a thread that works in the background: lowers its priority for good, and while it exists that of
/// the threads that oneTBB sends to help it. (Those that are started then have it from the beginning.)
class BehindWindow : tbb::task_scheduler_observer {
 public:
    BehindWindow();
    ~BehindWindow() override { observe(false); }
    BehindWindow(const BehindWindow&) = delete;
    BehindWindow& operator=(const BehindWindow&) = delete;

 private:
    void on_scheduler_entry(bool is_worker) override;
};

}  // namespace dapple
