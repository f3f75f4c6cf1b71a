#include "tests/fuzz/watched_runs.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>
#include <utility>

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

// In one process; a new one then forgets what libraries leak.
constexpr std::uint64_t kRunsAtOnce = 500;

// Seen by both processes.
struct Progress {
    std::uint64_t run = 0;  // under way
    double longest_seconds = 0;
};

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Again and again.
void set_timer(__itimer_which_t which, double seconds) {
    itimerval timer{};
    const double whole = std::floor(seconds);
    timer.it_value.tv_sec = static_cast<time_t>(whole);
    timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - whole));
    timer.it_interval = timer.it_value;
    ::setitimer(which, &timer, nullptr);
}

double processor_seconds() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

// Ends the process if it has done nothing since the last call. One that is kept from working by others, on a
// busy machine, has not: it waits for the processor, and not for ever.
extern "C" void end_if_idle(int signal) {
    constexpr double kNothing = 1e-3;
    static double before = -1;
    const double now = processor_seconds();
    if (now - std::exchange(before, now) > kNothing) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

[[noreturn]] void work(Progress& progress, std::uint64_t end, double seconds, double longest,
                       const std::function<void(std::uint64_t)>& run) {
    const auto all = Clock::now();
    std::signal(SIGALRM, end_if_idle);
    for (; progress.run < end && seconds_since(all) < seconds; ++progress.run) {
        const auto begin = Clock::now();
        set_timer(ITIMER_PROF, longest);
        set_timer(ITIMER_REAL, 4 * longest);
        run(progress.run);
        progress.longest_seconds = std::max(progress.longest_seconds, seconds_since(begin));
    }
    ::_exit(0);
}

std::string how_it_ended(int status, double longest) {
    if (WIFEXITED(status)) return "exit " + std::to_string(WEXITSTATUS(status));
    if (WTERMSIG(status) == SIGPROF) return fmt::format("over {} s", longest);
    if (WTERMSIG(status) == SIGALRM) return "waits for ever";
    return ::strsignal(WTERMSIG(status));
}

}  // namespace

WatchedResult watched_runs(const WatchedRequest& request, const std::function<void(std::uint64_t)>& run) {
    void* const shared =
        ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::bad_alloc();
    auto& progress = *new (shared) Progress{request.first, 0};
    const std::uint64_t end = request.first + request.runs;
    const auto begin = Clock::now();
    WatchedResult result;
    while (progress.run < end && seconds_since(begin) < request.seconds) {
        const std::uint64_t pause = std::min(end, progress.run + kRunsAtOnce);
        const pid_t child = ::fork();
        if (child < 0) throw std::runtime_error("no process can be started");
        if (child == 0)
            work(progress, pause, request.seconds - seconds_since(begin), request.longest_run_seconds, run);
        int status = 0;
        rusage usage{};
        while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
        }
        result.most_memory = std::max(result.most_memory, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024);
        if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
            result.ended.push_back({progress.run++, how_it_ended(status, request.longest_run_seconds)});
    }
    result.runs = progress.run - request.first;
    result.longest_seconds = progress.longest_seconds;
    ::munmap(shared, sizeof(Progress));
    return result;
}

}  // namespace dapple
