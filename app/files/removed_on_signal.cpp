#include "app/files/removed_on_signal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <mutex>
#include <random>
#include <stdexcept>

namespace dapple {
namespace {

// A signal handler is given nothing but the signal's number, so what it has to remove is kept here.
struct Slot {
    std::atomic<bool> taken{false};
    std::atomic<bool> armed{false};
    std::array<char, PATH_MAX> path{};
};
std::array<Slot, 16> slots;
static_assert(std::atomic<bool>::is_always_lock_free, "the handler may not wait");

constexpr std::array kEndings{SIGINT, SIGTERM, SIGHUP};
std::mutex watch_mutex;
int watchers = 0;
std::array<struct sigaction, kEndings.size()> former_actions;
struct sigaction former_size_limit_action;

void remove_all_and_end(int signal) {
    for (Slot& slot : slots) {
        if (slot.armed.exchange(false)) ::unlink(slot.path.data());
    }
    for (std::size_t i = 0; i < kEndings.size(); ++i) {
        if (kEndings[i] == signal) ::sigaction(signal, &former_actions[i], nullptr);
    }
    ::raise(signal);
}

void watch_signals() {
    const std::lock_guard lock(watch_mutex);
    if (watchers++ > 0) return;
    struct sigaction action {};
    action.sa_handler = remove_all_and_end;
    for (std::size_t i = 0; i < kEndings.size(); ++i) {
        ::sigaction(kEndings[i], nullptr, &former_actions[i]);
        // What nohup switched off stays off.
        if (former_actions[i].sa_handler != SIG_IGN) ::sigaction(kEndings[i], &action, nullptr);
    }
    // Over the size limit, write() shall say so rather than end the program.
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGXFSZ, &ignore, &former_size_limit_action);
}

void unwatch_signals() {
    const std::lock_guard lock(watch_mutex);
    if (--watchers > 0) return;
    for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &former_actions[i], nullptr);
    ::sigaction(SIGXFSZ, &former_size_limit_action, nullptr);
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
    watch_signals();
    slots[slot_].armed = true;
}

RemovedOnSignal::~RemovedOnSignal() {
    Slot& slot = slots[slot_];
    if (slot.armed.exchange(false)) ::unlink(slot.path.data());
    unwatch_signals();
    slot.taken = false;
}

const char* RemovedOnSignal::path() const {
    return slots[slot_].path.data();
}

std::filesystem::path unused_name_beside(const std::filesystem::path& file) {
    std::random_device random;
    for (;;) {
        std::filesystem::path name = file;
        name.replace_filename(fmt::format(".dapple-{:08x}.part", random()));
        std::error_code error;
        if (!std::filesystem::exists(std::filesystem::symlink_status(name, error))) return name;
    }
}

}  // namespace dapple
