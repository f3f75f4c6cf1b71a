#pragma once
// A program that a test starts, and ends when it is done with it.

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace dapple {

/// Files that take what the program says; none: it says it where the test does.
struct ChildOutput {
    std::filesystem::path output = {}, errors = {};
};

class ChildProcess {
 public:
    explicit ChildProcess(std::vector<std::string> command, const ChildOutput& to = {}) {
        std::vector<char*> arguments;
        for (std::string& word : command) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        id_ = fork();
        if (id_ < 0) throw std::runtime_error("no process can be started");
        if (id_ > 0) return;
        redirect(to.output, STDOUT_FILENO);
        redirect(to.errors, STDERR_FILENO);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    ChildProcess& operator=(ChildProcess&&) = delete;
    ~ChildProcess() {
        if (id_ <= 0) return;
        kill(id_, SIGTERM);
        wait();
    }

    void send(int signal) { kill(id_, signal); }

    /// Waits until it has done what `done` looks for; false if that takes minutes or it ends without.
    template <class Done>
    bool brings(Done done) {
        for (int tries = 0; tries < kMostTries && !done(); ++tries) {
            siginfo_t ended{};
            waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOHANG | WNOWAIT);
            if (ended.si_pid == id_) return done();
            std::this_thread::sleep_for(kBetweenTries);
        }
        return done();
    }

    /// Its exit status once it has ended; -1 if a signal ended it, as happens after minutes.
    int wait() {
        int status = 0, tries = 0;
        while (waitpid(id_, &status, WNOHANG) == 0) {
            std::this_thread::sleep_for(kBetweenTries);
            if (++tries == kMostTries) kill(id_, SIGKILL);
        }
        id_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

 private:
    static constexpr std::chrono::milliseconds kBetweenTries{10};
    static constexpr int kMostTries = 12'000;

    static void redirect(const std::filesystem::path& file, int stream) {
        if (file.empty()) return;
        int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        if (opened < 0 || dup2(opened, stream) < 0) _exit(126);
    }

    pid_t id_ = -1;
};

}  // namespace dapple
