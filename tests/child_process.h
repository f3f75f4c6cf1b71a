#pragma once
// A program that a test starts, and ends when it is done with it.

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
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
        id_ = fork();
        if (id_ < 0) throw std::runtime_error("no process can be started");
        if (id_ > 0) return;
        redirect(places.output, STDOUT_FILENO);
        redirect(places.errors, STDERR_FILENO);
        if (!places.folder.empty() && chdir(places.folder.c_str()) != 0) _exit(126);
        // They may be switched off for the tests, as a shell does for what runs in the background.
        for (const int stop : {SIGINT, SIGTERM, SIGHUP}) signal(stop, SIG_DFL);
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

    static void redirect(const std::filesystem::path& file, int stream) {
        if (file.empty()) return;
        int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
        if (opened < 0 || dup2(opened, stream) < 0) _exit(126);
    }

    pid_t id_ = -1;
};

}  // namespace dapple
