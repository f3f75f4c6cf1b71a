#include <doctest/doctest.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <set>
#include <string>

#include "tests/fuzz/mutations.h"
#include "tests/fuzz/watched_runs.h"

using namespace dapple;

TEST_CASE("a run that crashes, hangs or leaves is told by its number, and the others go on") {
    const WatchedResult result =
        watched_runs({.first = 10, .runs = 1200, .longest_run_seconds = 0.25}, [](std::uint64_t run) {
            if (run == 17) std::raise(SIGKILL);
            if (run == 600)
                for (volatile int turns = 0;;) turns = turns + 1;
            if (run == 601)
                for (;;) ::pause();
            if (run == 1209) ::_exit(4);
        });
    CHECK(result.runs == 1200);
    REQUIRE(result.ended.size() == 4);
    CHECK(result.ended[0].run == 17);
    CHECK(result.ended[0].how == "Killed");
    CHECK(result.ended[1].run == 600);
    CHECK(result.ended[1].how == "over 0.25 s");
    CHECK(result.ended[2].run == 601);
    CHECK(result.ended[2].how == "waits for ever");
    CHECK(result.ended[3].run == 1209);
    CHECK(result.ended[3].how == "exit 4");
    CHECK(result.most_memory > 0);
}

TEST_CASE("mutations differ from the seed and each other, and are the same for the same random numbers") {
    std::string seed;
    for (int i = 0; i < 200; ++i) seed += static_cast<char>(i * 37 % 251);
    std::set<std::string> files;
    for (std::uint64_t i = 0; i < 100; ++i) {
        std::mt19937_64 once(i), again(i);
        const std::string file = mutated(seed, once);
        CHECK(file == mutated(seed, again));
        if (file != seed) files.insert(file);
    }
    CHECK(files.size() > 80);
    std::mt19937_64 random(1);
    CHECK(mutated("", random).empty());
}
