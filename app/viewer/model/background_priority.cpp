#include "app/viewer/model/background_priority.h"

#if defined(DAPPLE_LINUX)
#include <sys/resource.h>
#endif

namespace dapple {
namespace {

void lower_own_priority() {
#if defined(DAPPLE_LINUX)
    // On Linux that is the calling thread's. Whether it succeeds decides nothing. A third of the window's
    // share of a core: lower ones starve the drawing where other programs keep the machine busy.
    constexpr int kNice = 5;
    static_cast<void>(setpriority(PRIO_PROCESS, 0, kNice));
#endif
}

}  // namespace

BehindWindow::BehindWindow() {
    lower_own_priority();
    observe(true);
}

void BehindWindow::on_scheduler_entry(bool is_worker) {
    if (is_worker) lower_own_priority();
}

}  // namespace dapple
