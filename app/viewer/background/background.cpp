#include "app/viewer/background/background.h"

#include <tbb/task_scheduler_observer.h>

#if defined(DAPPLE_LINUX)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace dapple {

namespace {

void lower_own_priority() {
#if defined(DAPPLE_LINUX)
    // On Linux that is the calling thread's. Whether it succeeds decides nothing. A third of the share of a
    // core that the window's thread has: lower ones starve the drawing where other programs keep the machine
    // busy.
    constexpr int kNicer = 5;
    static_cast<void>(setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, getpid()) + kNicer));
#endif
}

struct HelpersBehindWindow : tbb::task_scheduler_observer {
    HelpersBehindWindow() { observe(true); }
    ~HelpersBehindWindow() override { observe(false); }
    void on_scheduler_entry(bool is_worker) override {
        if (is_worker) lower_own_priority();
    }
};

}  // namespace

void behind_window(const std::function<void()>& work) {
    lower_own_priority();
    const HelpersBehindWindow helpers;
    work();
}

}  // namespace dapple
