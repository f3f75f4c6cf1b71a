#if defined(DAPPLE_LINUX)
#include <doctest/doctest.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "io/decoding/decoder_process.h"
#include "io/descriptor.h"
#include "tests/child_process.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

const std::string kEnded =
    "cannot be read: its decoder asked the system for something that no picture needs, and was stopped";

// Somebody's home, and a picture in it.
class Home {
 public:
    Home() {
        put_text(folder_ / "secret", "token");
        put_text(folder_ / "picture", "P5 1 1 255\nx");
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        (folder_ / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
        REQUIRE(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
        REQUIRE(::listen(socket_.get(), 10) == 0);
    }

    /// Begins the probe as a decoder of the picture, to try this.
    std::string said_by(const char* probe, const std::string& act) const {
        fs::remove(folder_ / act);
        fs::create_symlink(probe, folder_ / act);
        struct : ImageSink {
            void begin(const ImageHeader&) override {}
            void row(std::span<const glm::vec3>) override {}
        } nobody;
        try {
            decode_file_by(folder_ / act, folder_ / "picture", {}, nobody);
        } catch (const DecodeError& error) {
            return error.what();
        }
        return "";
    }
    bool has(const std::string& name) const { return fs::exists(folder_ / name); }
    const fs::path& folder() const { return folder_.path(); }

 private:
    TemporaryFolder folder_;
    Descriptor socket_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
};

bool has_landlock() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

}  // namespace

TEST_CASE("a decoder that a file took over is ended at what no picture needs, which else can be done") {
    for (const char* const act : {"write", "write-early", "change", "empty", "remove", "rename", "connect",
                                  "fork", "shell", "signal", "trace", "dump"}) {
        CAPTURE(std::string(act));
        const Home home, other;
        CHECK(home.said_by(SANDBOXED_PROBE, act) == kEnded);
        CHECK(text_of(home.folder() / "secret") == "token");
        CHECK_FALSE(home.has("new"));
        CHECK(other.said_by(FREE_PROBE, act) == "done");
    }
}

TEST_CASE("a decoder reads no file but its picture, not by a thread that was there before it either") {
    if (!has_landlock()) {
        MESSAGE("this kernel has no Landlock");
        return;
    }
    const Home home;
    for (const char* const act : {"read", "read-early", "list", "memory"}) {
        CAPTURE(std::string(act));
        CHECK(home.said_by(SANDBOXED_PROBE, act) == "not done: Permission denied");
        CHECK(home.said_by(FREE_PROBE, act) == "done");
    }
    CHECK(home.said_by(SANDBOXED_PROBE, "reopen") == "done");
}

TEST_CASE("a decoder does not raise its limits, whoever it runs as") {
    const Home home;
    for (const char* const act : {"files", "files-early", "time"}) {
        CAPTURE(std::string(act));
        CHECK(home.said_by(SANDBOXED_PROBE, act) == "not done: Operation not permitted");
        CHECK(home.said_by(FREE_PROBE, act) == "done");
    }
}

TEST_CASE("a decoder has none of the files that were left open for others") {
    const Home home;
    // As a shell leaves them: these are for its children, too.
    int pipe[2] = {};
    REQUIRE(::pipe(pipe) == 0);
    const Descriptor read_end(pipe[0]), write_end(pipe[1]),
        file(::open((home.folder() / "secret").c_str(), O_RDWR));
    const Descriptor far(::fcntl(file.get(), F_DUPFD, 150));
    for (const char* const probe : {SANDBOXED_PROBE, FREE_PROBE})
        CHECK(home.said_by(probe, "inherit").starts_with("not done"));
    // Whoever is begun in another way has them.
    const pid_t child = ::fork();
    if (child == 0) {
        const int out = ::open((home.folder() / "out").c_str(), O_WRONLY | O_CREAT, 0600);
        ::dup2(out, STDOUT_FILENO);
        ::execl((home.folder() / "inherit").c_str(), (home.folder() / "inherit").c_str(), nullptr);
        ::_exit(1);
    }
    REQUIRE(::waitpid(child, nullptr, 0) == child);
    CHECK(text_of(home.folder() / "out").ends_with("done"));
    CHECK_FALSE(text_of(home.folder() / "out").ends_with("not done"));
}

TEST_CASE("where there is no Landlock, root's decoder reads no file that is another's alone") {
    if (::geteuid() != 0) {
        MESSAGE("this needs root");
        return;
    }
    const Home home;
    constexpr uid_t kNobody = 65534;
    REQUIRE(::chown((home.folder() / "secret").c_str(), kNobody, kNobody) == 0);
    REQUIRE(::chmod((home.folder() / "secret").c_str(), 0600) == 0);
    const auto said_without_landlock = [&](const char* probe) {
        fs::remove(home.folder() / "read");
        fs::create_symlink(probe, home.folder() / "read");
        const std::string name = (home.folder() / "read").string();
        auto ends = own_pipe();
        REQUIRE(ends);
        const pid_t child = ::fork();
        if (child == 0) {
            // This system call fails as one that the kernel has not.
            sock_filter calls[] = {
                BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_landlock_create_ruleset, 0, 1),
                BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
                BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
            };
            const sock_fprog program{4, calls};
            ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
            ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
            ::dup2((*ends)[1].get(), STDOUT_FILENO);
            ::execl(name.c_str(), name.c_str(), nullptr);
            ::_exit(1);
        }
        ::waitpid(child, nullptr, 0);
        std::string said(1000, '\0');
        const ssize_t size = ::read((*ends)[0].get(), said.data(), said.size());
        said.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
        return said;
    };
    const std::string shut_in = said_without_landlock(SANDBOXED_PROBE),
                      free = said_without_landlock(FREE_PROBE);
    CAPTURE(shut_in);
    CHECK(shut_in.ends_with("not done: Permission denied"));
    CHECK(free.ends_with("done"));
    CHECK_FALSE(free.ends_with("not done"));
}

TEST_CASE("a decoder is told nothing of what stands in the environment") {
    const Home home;
    ::setenv("DAPPLE_TEST_TOKEN", "token", 1);
    CHECK(home.said_by(SANDBOXED_PROBE, "environment").starts_with("not done"));
    CHECK(home.said_by(FREE_PROBE, "environment").starts_with("not done"));
    // Others have it.
    const fs::path out = home.folder() / "out";
    ChildProcess({(home.folder() / "environment").string()}, {.output = out}).wait();
    ::unsetenv("DAPPLE_TEST_TOKEN");
    CHECK(text_of(out).ends_with("done"));
}

TEST_CASE("what decoders need they have: threads, and to end themselves") {
    const Home home;
    CHECK(home.said_by(SANDBOXED_PROBE, "threads") == "done");
    CHECK(home.said_by(SANDBOXED_PROBE, "abort").find("its decoder crashed (Aborted)") != std::string::npos);
}

TEST_CASE("a decoder ends with whoever wanted the picture") {
    const Home home;
    // Their pipes stay open at the other end: it is not for these that they end.
    const auto begins = [&](const std::string& name) {
        REQUIRE(::mkfifo((home.folder() / name).c_str(), 0600) == 0);
        return Descriptor(::open((home.folder() / name).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    };
    const Descriptor shut_in = begins("shut-in"), free = begins("free");
    for (const char* const folder : {"s", "f"}) fs::create_directory(home.folder() / folder);
    fs::create_symlink(SANDBOXED_PROBE, home.folder() / "s/sleep");
    fs::create_symlink(FREE_PROBE, home.folder() / "f/sleep");
    ChildProcess parent(
        {"/bin/sh", "-c", "s/sleep > shut-in & f/sleep > free & echo $! > id; touch known; wait"},
        {.folder = home.folder()});
    // How much it has said: of "asleep" all, then none, once nobody is left to say more.
    const auto said = [](const Descriptor& end) {
        char bytes[10];
        return ::read(end.get(), bytes, sizeof bytes);
    };
    bool asleep = false;
    parent.brings([&] { return asleep = asleep || said(shut_in) > 0; });
    REQUIRE(asleep);
    REQUIRE(parent.brings([&] { return fs::exists(home.folder() / "known"); }));
    const pid_t id = std::stoi(text_of(home.folder() / "id"));
    parent.send(SIGKILL);
    const bool ended = wait_until([&] { return said(shut_in) == 0; });
    const bool free_lives = ::kill(id, SIGKILL) == 0;
    CHECK(ended);
    CHECK(free_lives);
}

TEST_CASE("a decoder that starts when nobody waits for it any more ends at once") {
    const Home home;
    fs::create_symlink(SANDBOXED_PROBE, home.folder() / "sleep");
    auto ends = own_pipe();
    REQUIRE(ends);
    (*ends)[0].close();
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2((*ends)[1].get(), STDOUT_FILENO);
        ::execl((home.folder() / "sleep").c_str(), (home.folder() / "sleep").c_str(), nullptr);
        ::_exit(1);
    }
    int status = -1;
    const bool ended = wait_until([&] { return ::waitpid(child, &status, WNOHANG) == child; });
    if (!ended) ::kill(child, SIGKILL);
    CHECK(ended);
    CHECK(status == 0);
}
#endif
