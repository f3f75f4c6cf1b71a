#pragma once
// An open file of the system, closed at the end of its scope, and a program, ended there.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <utility>

namespace dapple {

class Descriptor {
 public:
    /// What open() gave; less than 0 if it failed.
    explicit Descriptor(int value = -1) : value_(value) {}
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }

    explicit operator bool() const { return value_ >= 0; }
    int get() const { return value_; }
    /// As close() does: 0 if all went well.
    int close() { return ::close(std::exchange(value_, -1)); }

 private:
    int value_;
};

/// The two ends of a pipe, to be read and to be written, that programs started meanwhile do not have. None if
/// the system has none left: see errno.
inline std::optional<std::array<Descriptor, 2>> own_pipe() {
    std::array<int, 2> ends{};
#if defined(DAPPLE_LINUX)
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
#else
    if (::pipe(ends.data()) != 0) return std::nullopt;
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
#endif
    return std::array{Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A program that was started, and what it writes; ended where it is left.
struct Child {
    pid_t id = -1;  // none: it does not run
    Descriptor output{};

    Child() = default;
    Child& operator=(Child&&) = delete;
    ~Child() {
        if (id <= 0) return;
        end();
        wait();
    }

    /// Its pipe ends soon after.
    void end() const { ::kill(id, SIGKILL); }

    /// Its status, as waitpid() tells it.
    int wait() {
        int status = 0;
        while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
        }
        id = -1;
        return status;
    }
};

}  // namespace dapple
