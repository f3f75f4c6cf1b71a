#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include "io/files/atomic_file.h"
#include "io/signals.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

using namespace dapple;

namespace {

// Does it in a process of its own, where signals do as usual. Its exit status, or 128 + the signal.
int status_of(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
        // An exception must not make a second run of all tests of this process.
        try {
            work();
        } catch (...) {
            _exit(100);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool stops(const StopOnInterrupt& stop) {
    return wait_until([&] { return stop.token().stop_requested(); });
}

}  // namespace

TEST_CASE("Ctrl+C in the middle of a search's saving stops the search, and the saving comes to its end") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const TemporaryFolder folder;
        put_text(folder / "best.txt", "old");
        const int status = status_of([&] {
            const StopOnInterrupt stop;
            save_atomically(folder / "best.txt", [signal](std::ostream& out) {
                out << "new" << std::flush;
                raise(signal);
            });
            _exit(stops(stop) && StopOnInterrupt::interrupted() ? 0 : 1);
        });
        CHECK(status == 0);
        CHECK(text_of(folder / "best.txt") == "new");
        CHECK(folder.entries() == 1);
    }
}

TEST_CASE("a Ctrl+C that ends a command says that files are as before, and another signal does not") {
    for (const int signal : {SIGINT, SIGTERM}) {
        CAPTURE(signal);
        const TemporaryFolder folder;
        put_text(folder / "a.txt", "old");
        const int status = status_of([&] {
            const int errors = ::open((folder / "errors").c_str(), O_CREAT | O_WRONLY, 0600);
            ::dup2(errors, STDERR_FILENO);
            const ToldWhenStopped told;
            save_atomically(folder / "a.txt", [signal](std::ostream& out) {
                out << "half" << std::flush;
                raise(signal);
            });
        });
        CHECK(status == 128 + signal);
        CHECK(text_of(folder / "a.txt") == "old");
        CHECK(text_of(folder / "errors") ==
              (signal == SIGINT ? "dapple: stopped; unfinished files are as before\n" : ""));
    }
}

TEST_CASE("the second Ctrl+C ends at once, with no litter, also when the first came amid a saving") {
    const TemporaryFolder folder;
    const int status = status_of([&] {
        const StopOnInterrupt stop;
        save_atomically(folder / "a.txt", [](std::ostream& out) {
            raise(SIGINT);
            out << "half" << std::flush;
            raise(SIGINT);
        });
        _exit(0);
    });
    CHECK(status == 128 + SIGINT);
    CHECK(folder.entries() == 0);
    // The first came before the saving began.
    CHECK(status_of([&] {
              const StopOnInterrupt stop;
              raise(SIGTERM);
              save_atomically(folder / "a.txt", [](std::ostream&) { raise(SIGINT); });
              _exit(0);
          }) == 128 + SIGINT);
    CHECK(folder.entries() == 0);
}

TEST_CASE("a closed terminal, which says so twice, doesn't keep a search from saving what it has") {
    const TemporaryFolder folder;
    CHECK(status_of([&] {
              {
                  const StopOnInterrupt stop;
                  raise(SIGHUP);
                  raise(SIGHUP);
              }
              save_atomically(folder / "a.txt", [](std::ostream& out) {
                  raise(SIGHUP);
                  out << "all";
              });
          }) == 0);
    CHECK(text_of(folder / "a.txt") == "all");
}

TEST_CASE("under nohup a terminal that closes neither ends a saving nor stops a search") {
    const TemporaryFolder folder;
    CHECK(status_of([&] {
              std::signal(SIGHUP, SIG_IGN);
              const StopOnInterrupt stop;
              save_atomically(folder / "a.txt", [](std::ostream& out) {
                  out << "all";
                  raise(SIGHUP);
              });
              std::this_thread::sleep_for(std::chrono::milliseconds(60));
              _exit(stop.token().stop_requested() ? 1 : 0);
          }) == 0);
    CHECK(text_of(folder / "a.txt") == "all");
}

TEST_CASE("after a search and a saving, Ctrl+C ends the program as always") {
    const TemporaryFolder folder;
    CHECK(status_of([&] {
              { const StopOnInterrupt stop; }
              save_atomically(folder / "a.txt", [](std::ostream& out) { out << "all"; });
              raise(SIGINT);
          }) == 128 + SIGINT);
    CHECK(text_of(folder / "a.txt") == "all");
}

TEST_CASE("a time limit stops too, and is no signal") {
    const StopOnInterrupt stop(std::chrono::duration<double>(0.01));
    CHECK(stops(stop));
    CHECK_FALSE(StopOnInterrupt::interrupted());
}
