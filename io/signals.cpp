#include "io/signals.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string_view>

namespace dapple {
namespace {

// A signal handler is given nothing but the signal's number, so what it has to know is kept here.
struct Slot {
    std::atomic<bool> taken{false};
    std::atomic<pid_t> owner{
        0};  // whose file it is; 0: nobody's. A forked child inherits the slot, not the file
    std::array<char, PATH_MAX> path{};
};
std::array<Slot, kMostFilesUnderWay> slots;  // the files to be removed
std::atomic<bool> work_stops{false}, tells{false};
std::atomic<bool> ending{false};  // a signal ends the program: other threads make and remove no file any more
std::atomic<int> at_files{0};     // threads that do so at this moment
std::atomic<bool> signalled{false}, hung_up{false};  // since the last StopOnInterrupt began
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free,
              "the handler may not wait");

// What signals did before, kept while any number of users want something else.
template <std::size_t N>
struct Replaced {
    std::array<int, N> signals;
    std::array<struct sigaction, N> former{};
    int users = 0;

    void begin(const struct sigaction& action) {
        if (users++ > 0) return;
        for (std::size_t i = 0; i < N; ++i) {
            ::sigaction(signals[i], nullptr, &former[i]);
            if (former[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);
        }
    }
    void end() {
        if (--users > 0) return;
        for (std::size_t i = 0; i < N; ++i) ::sigaction(signals[i], &former[i], nullptr);
    }
};
std::mutex users_mutex;
constexpr std::size_t kHangup = 2;
// All that end a program unless it says otherwise, but for those of a fault in it.
Replaced<9> endings{{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGXCPU}};
Replaced<2> write_signals{{SIGPIPE, SIGXFSZ}};

struct sigaction ignoring() {
    struct sigaction action {};
    action.sa_handler = SIG_IGN;
    return action;
}

void remove_file(Slot& slot) {
    pid_t mine = ::getpid();
    if (slot.owner.compare_exchange_strong(mine, 0)) ::unlink(slot.path.data());
}

// While one lives, its thread makes or removes a file, and signals come to other threads: a handler would
// wait here for what it interrupts. While a signal ends the program, it is never made.
class AtFile {
 public:
    AtFile() {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_BLOCK, &all, &former_);
        ++at_files;
        if (!ending) return;
        --at_files;
        for (;;) ::pause();
    }
    AtFile(const AtFile&) = delete;
    AtFile& operator=(const AtFile&) = delete;
    ~AtFile() {
        --at_files;
        ::pthread_sigmask(SIG_SETMASK, &former_, nullptr);
    }

 private:
    sigset_t former_;
};

void remove_all_and_end(int signal) {
    ending = true;
    // A file that another thread makes or removes now is removed, too. Not for ever: the folder may be one
    // that does not answer, and a forked child inherits the number without the thread.
    for (int ms = 0; at_files > 0 && ms < 1000; ++ms) ::poll(nullptr, 0, 1);
    for (Slot& slot : slots) remove_file(slot);
    if (signal == SIGINT && tells) {
        // Over the line that shows progress, if there is one.
        constexpr std::string_view kSentence =
            "\r\033[Kdapple: stopped; files that were not finished are as before\n";
        const std::string_view said =
            ::isatty(STDERR_FILENO) == 1 ? kSentence : kSentence.substr(kSentence.find('d'));
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, said.data(), said.size());
    }
    for (std::size_t i = 0; i < endings.signals.size(); ++i) {
        if (endings.signals[i] == signal) ::sigaction(signal, &endings.former[i], nullptr);
    }
    ::raise(signal);  // comes once the handler is left
}

void stop_or_end(int signal) {
    const int error = errno;
    bool ends = true;
    if (work_stops) {
        // A terminal that closes says so twice, the shell and the system one after the other.
        ends = signalled.exchange(true) && signal != SIGHUP;
        if (signal == SIGHUP) hung_up = true;
    }
    if (ends) remove_all_and_end(signal);
    errno = error;
}

void watch_endings() {
    const std::lock_guard lock(users_mutex);
    struct sigaction action {};
    action.sa_handler = stop_or_end;
    action.sa_flags = SA_RESTART;  // what is being saved goes on
    endings.begin(action);
}

void unwatch_endings() {
    const std::lock_guard lock(users_mutex);
    endings.end();
}

}  // namespace

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& path) : slot_(0) {
    const std::string& name = path.native();
    if (name.size() >= PATH_MAX) throw std::runtime_error(fmt::format("{}: the path is too long", name));
    while (slots[slot_].taken.exchange(true)) {
        if (++slot_ == slots.size())
            throw std::runtime_error(fmt::format("{}: too many files are being saved", name));
    }
    std::memcpy(slots[slot_].path.data(), name.c_str(), name.size() + 1);
    watch_endings();
    slots[slot_].owner = ::getpid();
}

RemovedOnSignal::~RemovedOnSignal() {
    {
        const AtFile now;
        remove_file(slots[slot_]);
    }
    unwatch_endings();
    slots[slot_].taken = false;
}

const char* RemovedOnSignal::path() const {
    return slots[slot_].path.data();
}

int RemovedOnSignal::make() const {
    const AtFile now;
    return ::open(path(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

void RemovedOnSignal::keep() {
    slots[slot_].owner = 0;
}

ToldWhenStopped::ToldWhenStopped() {
    tells = true;
    watch_endings();
}

ToldWhenStopped::~ToldWhenStopped() {
    unwatch_endings();
    tells = false;
}

StopOnInterrupt::StopOnInterrupt(std::optional<std::chrono::duration<double>> limit) {
    signalled = hung_up = false;
    work_stops = true;
    watch_endings();
    const auto start = std::chrono::steady_clock::now();
    watch_ = std::jthread([this, limit, start](const std::stop_token& done) {
        while (!done.stop_requested()) {
            const bool late = limit && std::chrono::steady_clock::now() - start >= *limit;
            if (signalled || late) {
                source_.request_stop();
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
}

StopOnInterrupt::~StopOnInterrupt() {
    watch_.request_stop();
    watch_.join();
    if (hung_up) {
        // The second time is not to cut short what is saved now.
        const std::lock_guard lock(users_mutex);
        endings.former[kHangup] = ignoring();
        ::sigaction(SIGHUP, &endings.former[kHangup], nullptr);
    }
    work_stops = false;
    unwatch_endings();
}

bool StopOnInterrupt::interrupted() {
    return signalled;
}

WriteErrorsInsteadOfSignals::WriteErrorsInsteadOfSignals() {
    const std::lock_guard lock(users_mutex);
    write_signals.begin(ignoring());
}

WriteErrorsInsteadOfSignals::~WriteErrorsInsteadOfSignals() {
    const std::lock_guard lock(users_mutex);
    write_signals.end();
}

}  // namespace dapple
