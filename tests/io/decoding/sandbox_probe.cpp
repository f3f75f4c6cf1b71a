// A program that stands in for a decoder whose file has taken it over: it tries the one thing that its own
// name says, with the picture's folder for somebody's home, and sends what came of it where a picture would
// go. Built twice: shut in as decoders are, and free, to show that what is refused there can be done at all.

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

#include "io/decoding/decoder_limits.h"
#include "io/decoding/decoder_sandbox.h"
#include "io/decoding/image_pipe.h"

namespace {

namespace fs = std::filesystem;

bool opens(const std::string& file, int flags) {
    return ::open(file.c_str(), flags, 0600) >= 0;
}

bool raises(decltype(RLIMIT_NOFILE) resource, rlim_t to) {
    const rlimit more{to, to};
    return ::setrlimit(resource, &more) == 0;
}

// As some libraries have, which start them while they are loaded.
class EarlyThread {
 public:
    ~EarlyThread() { thread_.detach(); }
    /// Whether it can do it.
    bool does(const std::function<bool()>& act) {
        act_ = &act;
        for (act_.notify_one(); !done_; std::this_thread::yield()) {
        }
        errno = error_;
        return error_ == 0;
    }

 private:
    std::atomic<const std::function<bool()>*> act_ = nullptr;
    std::atomic<bool> done_ = false;
    std::atomic<int> error_ = 0;
    std::thread thread_{[this] {
        act_.wait(nullptr);
        if (!(*act_.load())()) error_ = errno;
        done_ = true;
    }};
};
EarlyThread early_thread;

bool connects(const std::string& to) {
    const int end = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    to.copy(address.sun_path, sizeof address.sun_path - 1);
    return end >= 0 && ::connect(end, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool forks() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

// The shell says for it that it is done.
bool becomes_a_shell() {
    ::execl("/bin/sh", "sh", "-c", R"(printf 'e\004\0\0\0done')", nullptr);
    return false;
}

bool has_threads() {
    int value = 0;
    std::thread([&] { value = 1; }).join();
    return value == 1;
}

// Than the standard ones and the picture.
bool has_more_files() {
    for (int file = 4; file < 200; ++file)
        if (::fcntl(file, F_GETFL) >= 0) return true;
    return false;
}

bool tries(std::string_view act, const fs::path& home) {
    const std::string parent = std::to_string(::getppid());
    if (act == "read") return opens(home / "secret", O_RDONLY);
    if (act == "read-early") return early_thread.does([&] { return opens(home / "secret", O_RDONLY); });
    if (act == "list") return opens(home, O_RDONLY | O_DIRECTORY);
    if (act == "write") return opens(home / "new", O_WRONLY | O_CREAT);
    if (act == "write-early")
        return early_thread.does([&] { return opens(home / "new", O_WRONLY | O_CREAT); });
    if (act == "change") return opens(home / "secret", O_RDWR);
    if (act == "empty") return opens(home / "secret", O_RDONLY | O_TRUNC);
    if (act == "remove") return ::unlink((home / "secret").c_str()) == 0;
    if (act == "rename") return ::rename((home / "secret").c_str(), (home / "found").c_str()) == 0;
    if (act == "connect") return connects(home / "socket");
    if (act == "fork") return forks();
    if (act == "shell") return becomes_a_shell();
    if (act == "signal") return ::kill(::getppid(), 0) == 0;
    if (act == "trace") return ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0;
    if (act == "memory") return opens("/proc/" + parent + "/mem", O_RDONLY);
    if (act == "files") return raises(RLIMIT_NOFILE, 100);
    if (act == "files-early") return early_thread.does([] { return raises(RLIMIT_NOFILE, 100); });
    if (act == "time") return raises(RLIMIT_CPU, 10'000);
    if (act == "dump") return ::prctl(PR_SET_DUMPABLE, 1, 0, 0, 0) == 0;
    if (act == "inherit") return has_more_files();
    if (act == "environment") return std::getenv("DAPPLE_TEST_TOKEN") != nullptr;
    // What decoders do.
    if (act == "reopen") return opens("/dev/fd/3", O_RDONLY);
    if (act == "threads") return has_threads();
    if (act == "abort") std::abort();
    if (act == "sleep") {
        for (static_cast<void>(::write(STDOUT_FILENO, "asleep", 6));;)
            std::this_thread::sleep_for(std::chrono::hours(1));
    }
    errno = EINVAL;
    return false;
}

}  // namespace

int main(int, char** argv) {
    using namespace dapple;
    const std::string act = fs::path(argv[0]).filename();
    const fs::path home = fs::path(argv[0]).parent_path();
#if defined(SHUT_IN)
    end_with_parent(STDOUT_FILENO);
    limit_decoder(kUsualPixels);
    limit_decoder_to({});
    enter_sandbox();
#endif
    errno = 0;
    const bool done = tries(act, home);
    ImagePipe(STDOUT_FILENO)
        .fail(done ? "done" : std::string("not done: ") + std::strerror(errno), PictureFailure::file);
    ::_exit(0);
}
