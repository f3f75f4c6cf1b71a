#include <doctest/doctest.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(DAPPLE_LINUX)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <csignal>
#include <cstddef>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "io/files/atomic_file.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

using namespace dapple;
namespace fs = std::filesystem;

namespace {

std::string sentence_of(const fs::path& target, const std::function<void(std::ostream&)>& write) {
    try {
        save_atomically(target, write);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

void write_new(std::ostream& out) {
    out << "new";
}

// More than any buffer holds back.
void write_much(std::ostream& out) {
    const std::string line(1000, 'x');
    for (int i = 0; i < 2000; ++i) out << line << '\n';
}

}  // namespace

TEST_CASE("a file is saved, and saved anew") {
    const TemporaryFolder folder;
    save_atomically(folder / "a.txt", write_new);
    CHECK(text_of(folder / "a.txt") == "new");
    save_atomically(folder / "a.txt", [](std::ostream& out) { out << "newer"; });
    CHECK(text_of(folder / "a.txt") == "newer");
    save_atomically(folder / "much.txt", write_much);
    CHECK(fs::file_size(folder / "much.txt") == 2000 * 1001);
    CHECK(folder.entries() == 2);
}

TEST_CASE("until all is written, the old file is there") {
    const TemporaryFolder folder;
    put_text(folder / "a.txt", "old");
    save_atomically(folder / "a.txt", [&](std::ostream& out) {
        out << "new" << std::flush;
        CHECK(text_of(folder / "a.txt") == "old");
    });
    CHECK(text_of(folder / "a.txt") == "new");
}

TEST_CASE("what goes wrong while writing leaves the old file and no litter") {
    const TemporaryFolder folder;
    put_text(folder / "a.txt", "old");
    CHECK_THROWS_WITH(save_atomically(folder / "a.txt",
                                      [](std::ostream& out) {
                                          write_much(out);
                                          throw std::runtime_error("my own trouble");
                                      }),
                      "my own trouble");
    CHECK(text_of(folder / "a.txt") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk is said in words, the old file stays, and there is no litter") {
    const TemporaryFolder folder;
    put_text(folder / "a.txt", "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 100'000;
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string limited = sentence_of(folder / "a.txt", write_much);
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(limited == (folder / "a.txt").string() +
                         ": cannot be written: the file grew beyond the size that is allowed here");
    CHECK(text_of(folder / "a.txt") == "old");
    CHECK(folder.entries() == 1);

    fs::create_symlink("/dev/full", folder / "full.txt");
    const std::string full = sentence_of(folder / "full.txt", write_new);
    CAPTURE(full);
    CHECK(full.find("the disk is full") != full.npos);
    CHECK(fs::is_symlink(folder / "full.txt"));
}

TEST_CASE("a signal that ends the program leaves the old file and no litter") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGALRM, SIGXCPU, SIGKILL}) {
        CAPTURE(signal);
        const TemporaryFolder folder;
        put_text(folder / "a.txt", "old");
        const pid_t child = fork();
        if (child == 0) {
            std::signal(signal, SIG_DFL);  // doctest has a handler of its own
            save_atomically(folder / "a.txt", [signal](std::ostream& out) {
                write_much(out);
                raise(signal);
            });
            _exit(0);
        }
        int status = 0;
        REQUIRE(waitpid(child, &status, 0) == child);
        REQUIRE(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(text_of(folder / "a.txt") == "old");
        CHECK(folder.entries() == 1);
    }
}

#if defined(DAPPLE_LINUX)
TEST_CASE("where a file needs a name from the beginning it has one of its own, which does not stay") {
    const TemporaryFolder folder;
    put_text(folder / "a.txt", "old");
    const pid_t child = fork();
    if (child == 0) {
        // Nothing opens with O_TMPFILE any more, as on file systems that have none.
        sock_filter steps[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                               BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 3),
                               BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
                               BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, O_TMPFILE & ~O_DIRECTORY, 0, 1),
                               BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
                               BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
        const sock_fprog program{std::size(steps), steps};
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(1);
        std::size_t meanwhile = 0;
        save_atomically(folder / "a.txt", [&](std::ostream& out) {
            write_new(out);
            meanwhile = folder.entries();
        });
        save_atomically(folder / "b.txt", write_new);
        const std::string said =
            sentence_of(folder / "a.txt", [](std::ostream&) { throw std::runtime_error("my own trouble"); });
        _exit(meanwhile == 2 && said == "my own trouble" ? 0 : 2);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
    CHECK(text_of(folder / "a.txt") == "new");
    CHECK(text_of(folder / "b.txt") == "new");
    CHECK(folder.entries() == 2);
}
#endif

TEST_CASE("many savers beside each other lose none of their files") {
    const TemporaryFolder folder;
    std::vector<std::jthread> savers;
    for (int s = 0; s < 4; ++s)
        savers.emplace_back([&folder, s] {
            for (int i = 0; i < 50; ++i)
                save_atomically(folder / (std::to_string(s % 2) + ".txt"), write_much);
        });
    savers.clear();
    for (int s = 0; s < 2; ++s) CHECK(fs::file_size(folder / (std::to_string(s) + ".txt")) == 2000 * 1001);
    CHECK(folder.entries() == 2);
}

TEST_CASE("targets that cannot be are refused before anything is written") {
    const TemporaryFolder folder;
    put_text(folder / "file", "");
    const auto check = [&](const fs::path& target, const char* words) {
        bool written = false;
        const std::string sentence = sentence_of(target, [&](std::ostream&) { written = true; });
        CAPTURE(sentence);
        CHECK(!written);
        CHECK(sentence.starts_with(target.string() + ": "));
        CHECK(sentence.find(words) != sentence.npos);
    };
    check(folder.path(), "is a folder");
    check(folder / "missing" / "a.svg", "does not exist");
    check(folder / "file" / "a.svg", "is a file, not a folder");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a link is followed, and permissions stay") {
    const TemporaryFolder folder;
    put_text(folder / "real.txt", "old");
    chmod((folder / "real.txt").c_str(), 0640);
    fs::create_symlink("real.txt", folder / "link.txt");
    save_atomically(folder / "link.txt", write_new);
    CHECK(fs::is_symlink(folder / "link.txt"));
    CHECK(text_of(folder / "real.txt") == "new");
    CHECK((fs::status(folder / "real.txt").permissions() & fs::perms::mask) == static_cast<fs::perms>(0640));
}

TEST_CASE("a file stays its owner's, and what is written never runs with somebody's rights") {
    const TemporaryFolder folder;
    put_text(folder / "tool", "old");
    const bool root = geteuid() == 0;  // who alone gives files away
    if (root) REQUIRE(chown((folder / "tool").c_str(), 1234, 4321) == 0);
    chmod((folder / "tool").c_str(), 06755);
    save_atomically(folder / "tool", write_new);
    struct stat status {};
    REQUIRE(stat((folder / "tool").c_str(), &status) == 0);
    CHECK((status.st_mode & 07777) == 0755);
    if (root) CHECK(status.st_uid == 1234);
    if (root) CHECK(status.st_gid == 4321);
}

TEST_CASE("a link to a file that is not there yet is followed, and stays a link") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "elsewhere");
    fs::create_symlink("elsewhere/new.txt", folder / "second.txt");
    fs::create_symlink(folder / "second.txt", folder / "first.txt");
    save_atomically(folder / "first.txt", write_new);
    CHECK(fs::is_symlink(folder / "first.txt"));
    CHECK(fs::is_symlink(folder / "second.txt"));
    CHECK(text_of(folder / "elsewhere/new.txt") == "new");
    // Its folder is the one that counts.
    fs::create_symlink("nowhere/new.txt", folder / "lost.txt");
    CHECK(sentence_of(folder / "lost.txt", write_new) ==
          fmt::format("{}: the folder {} does not exist; make it first", (folder / "lost.txt").string(),
                      (folder / "nowhere").string()));
    CHECK(fs::is_symlink(folder / "lost.txt"));
}

TEST_CASE("a link that leads to itself is refused, and stays") {
    const TemporaryFolder folder;
    fs::create_symlink("b.txt", folder / "a.txt");
    fs::create_symlink("a.txt", folder / "b.txt");
    CHECK(sentence_of(folder / "a.txt", write_new) ==
          (folder / "a.txt").string() + ": is a link that leads to itself; remove it or choose another name");
    CHECK(fs::is_symlink(folder / "a.txt"));
    CHECK(folder.entries() == 2);
}

TEST_CASE("a pipe whose reader has left is an error in words, and no signal") {
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder / "fifo").c_str(), 0600) == 0);
    std::string sentence;
    {
        // Reads a little, then is gone.
        const std::jthread reader([&] {
            const int file = open((folder / "fifo").c_str(), O_RDONLY);
            char some[100];
            CHECK(read(file, some, sizeof some) > 0);
            close(file);
        });
        sentence = sentence_of(folder / "fifo", write_much);
    }
    CHECK(sentence == (folder / "fifo").string() +
                          ": cannot be written: the program that read it has ended or stopped reading");
    CHECK(fs::is_fifo(folder / "fifo"));
}

TEST_CASE("an output is kept apart from other files, however their names are written") {
    const TemporaryFolder folder;
    put_text(folder / "cat.png", "a cat");
    fs::create_directory(folder / "sub");
    fs::create_symlink("cat.png", folder / "link.png");
    fs::create_hard_link(folder / "cat.png", folder / "hard.png");
    const auto apart = [&](const fs::path& output, const fs::path& other) {
        try {
            check_apart({{output, "the drawing"}}, {{other, "the picture"}});
        } catch (const std::runtime_error& error) {
            CHECK(error.what() ==
                  output.string() + ": would be written over the picture; choose another name");
            return false;
        }
        return true;
    };
    for (const char* name : {"cat.png", "./cat.png", "sub/../cat.png", "link.png", "hard.png"}) {
        CAPTURE(std::string(name));
        CHECK_FALSE(apart(folder / name, folder / "cat.png"));
    }
    // Two outputs that do not exist yet, and names from where the program runs.
    CHECK_FALSE(apart(folder / "./new.svg", folder / "new.svg"));
    fs::create_symlink("new.svg", folder / "new_link.svg");
    CHECK_FALSE(apart(folder / "new_link.svg", folder / "new.svg"));
    CHECK_FALSE(apart("./new.svg", "new.svg"));
    CHECK_FALSE(apart(fs::current_path() / "new.svg", "new.svg"));
    CHECK(apart(folder / "dog.png", folder / "cat.png"));
    CHECK(apart(folder / "sub/new.svg", folder / "new.svg"));
    CHECK(apart("/dev/null", "/dev/null"));
}
TEST_CASE("a pipe that nobody reads is not waited for without an end") {
    const TemporaryFolder folder;
    REQUIRE(mkfifo((folder / "fifo").c_str(), 0600) == 0);
    const std::string sentence = sentence_of(folder / "fifo", [](std::ostream& out) { out << "text"; });
    CHECK(sentence ==
          (folder / "fifo").string() + ": cannot be written: it is a pipe, and no program reads from it");
    CHECK(fs::is_fifo(folder / "fifo"));
}
