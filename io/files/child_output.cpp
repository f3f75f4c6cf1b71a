#include "io/files/child_output.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "io/descriptor.h"

extern char** environ;

namespace dapple {
namespace {

using ChildClock = std::chrono::steady_clock;

std::runtime_error child_error(const std::string& program, const std::string& what) {
    return std::runtime_error(program + " " + what);
}

struct StartedProgram : Child {
    explicit StartedProgram(const std::vector<std::string>& words) {
        auto ends = own_pipe();
        if (!ends)
            throw child_error(words[0], "cannot be started: " + std::generic_category().message(errno));
        output = std::move((*ends)[0]);
        const Descriptor input = std::move((*ends)[1]);
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, input.get(), STDOUT_FILENO);
        pid_t started = -1;  // of a failure nothing is to be ended
        const int error =
            ::posix_spawnp(&started, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (error != 0)
            throw child_error(words[0], "cannot be started: " + std::generic_category().message(error));
        id = started;
    }
};

}  // namespace

bool is_in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (!folder.empty() && ::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

std::optional<ChildOutput> output_of(const std::vector<std::string>& words, const ChildLimits& limits,
                                     const std::stop_token& stop) {
    constexpr int kLookEvery = 50;  // ms: for being stopped, and for the time
    StartedProgram child(words);
    const auto begin = ChildClock::now();
    ChildOutput output;
    std::array<char, 1 << 16> buffer;
    for (;;) {
        if (stop.stop_requested()) return std::nullopt;
        if (limits.longest && ChildClock::now() - begin > *limits.longest)
            throw child_error(words[0], "did not answer and was ended");
        pollfd waits{child.output.get(), POLLIN, 0};
        if (::poll(&waits, 1, kLookEvery) <= 0) continue;
        const ssize_t got = ::read(child.output.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        output.bytes.append(buffer.data(), static_cast<std::size_t>(got));
        if (output.bytes.size() > limits.most_bytes)
            throw child_error(words[0], "gave more than can be taken and was stopped");
    }
    const int status = child.wait();
    output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return output;
}

}  // namespace dapple
