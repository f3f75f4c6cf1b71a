// A placing in pieces: threads, hand-over, and what happens when somebody wants to end it.

#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/placing/placer.h"
#include "core/tile/ranking.h"
#include "tests/counted_allocations.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

Placer placer_of(const Tile& tile) {
    return Placer(make_placing_table(tile, rank(tile, RankingMethod::energy)));
}

bool same(const Dots& a, const Dots& b) {
    return a.x == b.x && a.y == b.y && a.threshold == b.threshold && a.critical == b.critical;
}

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

TEST_CASE("pieces one after another are the drawing, whichever part of it and on any number of threads") {
    Placer placer = placer_of(random_tile(kTurning, 64, 3));
    const Density density(blotches(80, 70, 5));
    const PageWindow part{(std::int64_t{1} << 62) / 3, (std::int64_t{1} << 62) / 5, 0.41, 0.53};
    for (const PageWindow& window : {PageWindow{}, part}) {
        PlacingRequest request{.scale = 40000, .thresholds = true, .window = window};
        DotPieces placed;
        REQUIRE(placer.place(density, request, placed));
        const Dots whole = joined(placed);
        CHECK(whole.size() > 20000);
        for (const int threads : {1, 2, 5}) {
            request.threads = threads;
            Dots together;
            DotPieces at_once;
            std::size_t largest = 0, pieces = 0;
            CHECK(placer.hand_over(density, request, [&](const Dots& piece) {
                append(together, piece);
                largest = std::max(largest, piece.size());
                ++pieces;
                return true;
            }));
            CHECK(same(together, whole));
            CHECK(pieces > 8);
            CHECK(largest < 40000);
            CHECK(placer.place(density, request, at_once));
            CHECK(same(joined(at_once), whole));
        }
    }
}

TEST_CASE("while somebody takes a piece, others go on placing") {
    if (tbb::this_task_arena::max_concurrency() < 2) return;
    Placer placer = placer_of(make_tile(14217, 2895, 16));
    const Density density(Grid<float>(16, 16, 1.0f));
    PlacingRequest request{.scale = 400'000};
    int pieces = 0;
    const double begin = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    REQUIRE(placer.hand_over(density, request, [&](const Dots&) { return ++pieces > 0; }));
    const double one = (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - begin) / pieces;
    REQUIRE(pieces > 16);
    // Processor time of all threads but the one that takes. Each thread may be busy with one piece as the
    // taking begins; the rest of the time is of pieces that are begun after that.
    const auto of_others = [] {
        return seconds_of(CLOCK_PROCESS_CPUTIME_ID) - seconds_of(CLOCK_THREAD_CPUTIME_ID);
    };
    bool first = true, placed = false;
    request.threads = 2;
    CHECK(placer.hand_over(density, request, [&](const Dots&) {
        if (!std::exchange(first, false)) return true;
        const double before = of_others();
        for (int looks = 0; looks < 200 && !placed; ++looks) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            placed = of_others() - before > 3 * one;
        }
        return true;
    }));
    CHECK(placed);
}

TEST_CASE("whoever takes the pieces can end the placing, and what it throws comes out") {
    Placer placer = placer_of(make_tile(14217, 2895, 16));
    const Density density(blotches(80, 70, 5));
    for (const int threads : {1, 2, 3}) {
        const PlacingRequest request{.scale = 40000, .threads = threads};
        int taken = 0;
        CHECK_FALSE(placer.hand_over(density, request, [&](const Dots&) { return ++taken < 3; }));
        CHECK(taken == 3);
        const auto full = [](const Dots&) -> bool { throw std::runtime_error("the disk is full"); };
        CHECK_THROWS_WITH(placer.hand_over(density, request, full), "the disk is full");
        DotPieces dots;
        CHECK(placer.place(density, request, dots));  // nothing is left over
        std::stop_source stop;
        stop.request_stop();
        CHECK_FALSE(placer.place(density, request, dots, stop.get_token()));
    }
}

TEST_CASE("a frame like the last one allocates nothing") {
    Placer placer = placer_of(random_tile(kTurning, 64, 3));
    const Density density(blotches(80, 70, 5));
    DotPieces dots;
    const PageWindow part{(std::int64_t{1} << 62) / 3, (std::int64_t{1} << 62) / 5, 0.41, 0.53};
    const auto frames = [&](int threads) {
        placer.place(density, {.scale = 30000, .threads = threads}, dots);
        placer.place(density, {.scale = 30000, .threads = threads, .window = part}, dots);
        placer.place(density, {.count = 40000, .threads = threads}, dots);
    };
    frames(1);
    const std::size_t before = allocations();
    frames(1);
    CHECK(allocations() == before);
    // With threads, which of them gets which piece is chance; memories grow until each has seen a large one.
    std::size_t allocated = 1;
    for (int i = 0; i < 1000 && allocated > 0; ++i) {
        const std::size_t now = allocations();
        frames(2);
        allocated = allocations() - now;
    }
    CHECK(allocated == 0);
}

TEST_CASE("a drawing of a million dots takes at most 12 bytes a dot") {
    Placer placer = placer_of(random_tile(kTurning, 64, 3));
    const Density density(blotches(80, 70, 5));
    for (const int threads : {1, 2, 5}) {
        DotPieces dots;
        for (const double scale : {200'000.0, 500'000.0, 500'000.0})
            placer.place(density, {.scale = scale, .threads = threads}, dots);
        std::size_t room = 0;
        for (const Dots& piece : dots.pieces) room += piece.x.capacity() + piece.y.capacity();
        CHECK(dots.size() > 1'000'000);
        CHECK(room * sizeof(float) <= 12 * dots.size());
    }
}

TEST_CASE("a drawing of less dots than the last one has none of its dots, late ones neither") {
    Placer placer = placer_of(make_tile(14217, 2895, 16));
    const Density density(blotches(80, 70, 5));
    DotPieces dots;
    placer.place(density, {.count = 200'000, .threads = 2}, dots);
    for (const std::size_t count : {50'000u, 100u}) {
        DotPieces anew;
        placer_of(make_tile(14217, 2895, 16)).place(density, {.count = count, .threads = 2}, anew);
        placer.place(density, {.count = count, .threads = 2}, dots);
        CHECK(same(joined(dots), joined(anew)));
    }
    placer.place(Density(Grid<float>(4, 4)), {.scale = 1000, .threads = 2}, dots);
    CHECK(dots.size() == 0);
}
