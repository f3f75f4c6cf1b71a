#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/viewer/background/background.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

using Numbers = Background<int>;

std::vector<int> all_of(Numbers& background) {
    std::vector<int> found;
    REQUIRE(wait_until([&] { return !background.busy(); }));
    while (const std::optional<int> one = background.result()) found.push_back(*one);
    return found;
}

}  // namespace

TEST_CASE("results come in their order, those on the way before the last") {
    Numbers background([] {});
    background.begin([](const Numbers::Task& task) {
        task.publish(1);
        task.publish(2);
        return std::optional(3);
    });
    CHECK(all_of(background) == std::vector{1, 2, 3});
    CHECK_FALSE(background.result());
}

TEST_CASE("what the work throws comes after its results, once, and other work can follow") {
    std::atomic<int> woken = 0;
    Numbers background([&] { ++woken; });
    background.begin([](const Numbers::Task& task) -> std::optional<int> {
        task.publish(7);
        throw std::runtime_error("no more");
    });
    REQUIRE(wait_until([&] { return !background.busy() && woken == 2; }));  // for each of them once
    CHECK(background.result() == 7);
    CHECK_THROWS_WITH(background.result(), "no more");
    CHECK_FALSE(background.result());
    background.begin([](const auto&) { return std::optional(8); });
    CHECK(all_of(background) == std::vector{8});
}

TEST_CASE("each hundredth of the way wakes the one who waits, and no less") {
    std::atomic<int> woken = 0;
    Numbers background([&] { ++woken; });
    std::atomic<bool> seen = false;
    background.begin([&](const Numbers::Task& task) -> std::optional<int> {
        for (int i = 0; i <= 2500; ++i) task.report_share(i * 0.0002);
        static_cast<void>(wait_until([&] { return seen.load(); }));
        return {};
    });
    REQUIRE(wait_until([&] { return background.share().value_or(0) > 0.489f; }));
    CHECK(*background.share() <= 0.5f);
    seen = true;
    REQUIRE(wait_until([&] { return !background.busy(); }));
    CHECK(woken >= 49);
    CHECK(woken <= 53);
    CHECK_FALSE(background.share());
}

TEST_CASE("whoever waits goes on at a result, at the end, and at the moment named") {
    using namespace std::chrono_literals;
    Numbers background([] {});
    std::atomic<bool> may_end = false;
    background.begin([&](const Numbers::Task& task) -> std::optional<int> {
        task.publish(1);
        static_cast<void>(wait_until([&] { return may_end.load(); }));
        return {};
    });
    background.wait_until(Numbers::Clock::now() + 60s);
    CHECK(background.result() == 1);
    CHECK(background.has_published());
    background.wait_until(Numbers::Clock::now() + 1ms);
    CHECK(background.busy());
    may_end = true;
    background.wait_until(Numbers::Clock::now() + 60s);
    CHECK_FALSE(background.busy());
    CHECK_FALSE(background.has_published());
}

TEST_CASE("work is stopped when asked, and when nobody is left to wait for it") {
    std::atomic<int> stopped = 0;
    const Numbers::Work until_stopped = [&](const Numbers::Task& task) -> std::optional<int> {
        if (wait_until([&] { return task.stop().stop_requested(); })) ++stopped;
        return {};
    };
    {
        Numbers background([] {});
        background.begin(until_stopped);
        background.stop();
        CHECK(all_of(background).empty());
        CHECK(stopped == 1);
        background.begin(until_stopped);
    }
    CHECK(stopped == 2);
}

TEST_CASE("work that the system has no thread for fails with a sentence, and other work can follow") {
    // In a process of its own: what it does to limits lasts.
    const pid_t child = fork();
    if (child == 0) {
        constexpr uid_t kNobody = 65534;  // root may have as many threads as it likes
        rlimit usual{}, none{};
        if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
        getrlimit(RLIMIT_NPROC, &usual);
        none.rlim_max = usual.rlim_max;
        int woken = 0;
        try {
            Numbers background([&] { ++woken; });
            setrlimit(RLIMIT_NPROC, &none);
            background.begin([](const auto&) { return std::optional(1); });
            if (background.busy() || woken != 1) _exit(3);
            try {
                background.result();
                _exit(4);
            } catch (const std::runtime_error& error) {
                if (!std::string_view(error.what()).starts_with("the system allows no further thread"))
                    _exit(5);
            }
            setrlimit(RLIMIT_NPROC, &usual);
            background.begin([](const auto&) { return std::optional(2); });
            const bool ended = wait_until([&] { return !background.busy(); });
            _exit(ended && background.result() == 2 ? 0 : 6);
        } catch (...) {
            _exit(7);
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

#if defined(DAPPLE_LINUX)
TEST_CASE("work in the background goes behind the window's thread, and so do the threads that share it") {
    const int usual = getpriority(PRIO_PROCESS, 0);
    Numbers background([] {});
    background.begin([usual](const auto&) {
        std::atomic<int> lower{0};
        tbb::parallel_for(0, 100, [&](int) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (getpriority(PRIO_PROCESS, 0) > usual) ++lower;
        });
        return std::optional(lower.load());
    });
    CHECK(all_of(background) == std::vector{100});
    CHECK(getpriority(PRIO_PROCESS, 0) == usual);
}
#endif

}  // namespace dapple
