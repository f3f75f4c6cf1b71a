#pragma once
// A program that a test starts, and ends when it is done with it.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "tests/wait_until.h"

namespace dapple {

/// Where the program runs, and the files that take what it says; none: where the test does.
struct ChildPlaces {
    std::filesystem::path folder = {}, output = {}, errors = {};
};

class ChildProcess {
 public:
    explicit ChildProcess(std::vector<std::string> command, const ChildPlaces& places = {}) {
        std::vector<char*> arguments;
        for (std::string& word : command) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        // Not by fork(), which takes a test with the sanitizer's memory several milliseconds.
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        const auto redirect = [&](const std::filesystem::path& file, int stream) {
            if (!file.empty())
                posix_spawn_file_actions_addopen(&actions, stream, file.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                                 0600);
        };
        redirect(places.output, STDOUT_FILENO);
        redirect(places.errors, STDERR_FILENO);
        if (!places.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, places.folder.c_str());
        // They may be switched off for the tests, as a shell does for what runs in the background.
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
        sigset_t stops;
        sigemptyset(&stops);
        for (const int stop : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&stops, stop);
        posix_spawnattr_setsigdefault(&attributes, &stops);
        const int error = posix_spawnp(&id_, arguments[0], &actions, &attributes, arguments.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0) throw std::system_error(error, std::generic_category(), command.front());
    }
    ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    ChildProcess& operator=(ChildProcess&&) = delete;
    ~ChildProcess() {
        if (id_ <= 0) return;
        kill(id_, SIGTERM);
        wait();
    }

    /// It has, and wait() will say how.
    bool has_ended() const {
        siginfo_t ended{};
        waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOHANG | WNOWAIT);
        return ended.si_pid == id_;
    }
    pid_t id() const { return id_; }
    void send(int signal) { kill(id_, signal); }

    /// Waits until it has done what `done` looks for; false if it ends without.
    template <class Done>
    bool brings(Done done) {
        return wait_until([&] { return has_ended() || done(); }, patience()) && done();
    }

    /// Its exit status once it has ended; if signal n ended it, 128 + n, as the shell has it. One that
    /// doesn't end is killed.
    int wait() {
        if (!wait_until([&] { return has_ended(); }, patience())) kill(id_, SIGKILL);
        int status = 0;
        waitpid(std::exchange(id_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

 private:
    Patience patience() const {
        Patience patience;
        clock_getcpuclockid(id_, &patience.work);
        return patience;
    }

    pid_t id_ = -1;
};

}  // namespace dapple
