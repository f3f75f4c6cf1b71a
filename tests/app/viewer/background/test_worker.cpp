#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <functional>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "app/viewer/background/worker.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

Picture grey(int side) {
    return {.light = Grid<float>(side, side, 0.4f),
            .preview = Grid<glm::u8vec4>(side, side, glm::u8vec4(170)),
            .description = "grey"};
}

DotsRequest dots(std::uint64_t count) {
    DotsRequest request;
    request.drawing.tile = "paper16";
    request.drawing.placing.count = count;
    request.drawing.relax = 0;
    return request;
}

/// Some seconds' and more, of which nothing is told on the way.
DotsRequest long_work() {
    DotsRequest request = dots(400'000);
    request.drawing.relax = 100;
    request.settled_only = true;
    return request;
}

/// Everything told until `enough` is content.
std::vector<WorkerEvent> listen(Worker& worker, const std::function<bool(const WorkerEvent&)>& enough) {
    std::vector<WorkerEvent> all;
    const bool content = wait_until([&] {
        for (WorkerEvent& event : worker.events()) {
            all.push_back(std::move(event));
            if (enough(all.back())) return true;
        }
        return false;
    });
    if (!content) FAIL("the worker says nothing");
    return all;
}

const DotsPlaced* placed(const WorkerEvent& event) {
    return std::get_if<DotsPlaced>(&event);
}
const TaskFailed* failed(const WorkerEvent& event) {
    return std::get_if<TaskFailed>(&event);
}

}  // namespace

TEST_CASE("a picture comes together with its first dots") {
    std::atomic<int> woken = 0;
    Worker worker([&] { ++woken; });
    worker.open("grey.png", [] { return grey(64); });
    worker.place(dots(500));
    auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    const DotsPlaced* first = placed(event.back());
    REQUIRE(first->picture);
    CHECK(first->picture->name == "grey.png");
    CHECK(first->picture->longer_side == 64);
    CHECK(first->drawing.dots.size() == 500);
    CHECK(wait_until([&] { return woken > 0; }));
}

TEST_CASE("of many requests that come while the worker is busy the last is placed, and no other") {
    Worker worker([] {});
    std::binary_semaphore all_ordered(0);
    worker.open("grey.png", [&] {
        all_ordered.acquire();
        return grey(64);
    });
    for (std::uint64_t n = 100; n <= 300; ++n) worker.place(dots(n));
    all_ordered.release();
    auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    CHECK(event.size() == 1);
    CHECK(placed(event.back())->drawing.dots.size() == 300);
}

TEST_CASE("a picture that cannot be read leaves the old one") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    worker.place(dots(100));
    listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    worker.open("bad.png", []() -> Picture { throw std::runtime_error("bad.png: not a picture"); });
    auto event = listen(worker, [](const WorkerEvent& n) { return failed(n) != nullptr; });
    CHECK(failed(event.back())->message == "bad.png: not a picture");
    worker.place(dots(200));
    event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    CHECK(placed(event.back())->drawing.dots.size() == 200);
    CHECK_FALSE(placed(event.back())->picture);
}

TEST_CASE("a first look is drawn until the whole picture is there, and only that is saved") {
    Worker worker([] {});
    std::binary_semaphore seen(0);
    const auto look = [](const std::stop_token&) { return std::optional(grey(32)); };
    worker.open("large.jpg", Opening{.whole =
                                         [&](const std::stop_token&) {
                                             seen.acquire();
                                             return grey(64);
                                         },
                                     .first_look = look});
    worker.place(dots(100));
    auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    REQUIRE(placed(event.back())->picture);
    CHECK_FALSE(placed(event.back())->picture->refines);
    CHECK(placed(event.back())->drawing.plan.opened == glm::ivec2(32));
    REQUIRE(worker.opening());
    CHECK(worker.opening()->name == "large.jpg");
    int saved_side = 0;
    worker.save("out.svg", [&](Workbench& bench, const std::stop_token&) -> WriteFile {
        saved_side = bench.pipeline().light().width;
        return [](const Watch&) { return true; };
    });
    // Settings go on being changed meanwhile.
    DotsRequest slow = dots(20'000);
    slow.drawing.relax = 10;
    worker.place(slow);
    event = listen(worker, [](const WorkerEvent& n) { return placed(n) && placed(n)->drawing.settled(); });
    CHECK(placed(event.back())->drawing.dots.size() == 20'000);
    CHECK(saved_side == 0);
    seen.release();
    event = listen(worker, [](const WorkerEvent& n) { return std::holds_alternative<DrawingSaved>(n); });
    CHECK(saved_side == 64);
    if (std::ranges::none_of(event, [](const WorkerEvent& n) { return placed(n) != nullptr; }))
        event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    const auto whole = std::ranges::find_if(event, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    REQUIRE(placed(*whole)->picture);
    CHECK(placed(*whole)->picture->refines);
    CHECK(placed(*whole)->drawing.dots.size() == 20'000);
    CHECK(placed(*whole)->drawing.settled());  // no step back
    CHECK_FALSE(worker.opening());
}

TEST_CASE("of a first look whose whole picture was stopped nothing is saved") {
    Worker worker([] {});
    worker.open("large.jpg",
                Opening{.whole =
                            [](const std::stop_token& stop) {
                                wait_until([&] { return stop.stop_requested(); });
                                if (stop.stop_requested()) throw std::runtime_error("stopped");
                                return grey(64);
                            },
                        .first_look = [](const std::stop_token&) { return std::optional(grey(32)); }});
    worker.place(dots(100));
    listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    worker.stop_opening();
    listen(worker, [](const WorkerEvent& n) { return std::holds_alternative<OpeningStopped>(n); });
    worker.save("out.svg", [](Workbench&, const std::stop_token&) -> WriteFile { return {}; });
    const auto event = listen(worker, [](const WorkerEvent& n) { return failed(n) != nullptr; });
    CHECK(failed(event.back())->message.find("large.jpg: only a preview") == 0);
}

TEST_CASE("another picture is stippled as requested last without being asked") {
    Worker worker([] {});
    worker.open("a", [] { return grey(64); });
    worker.place(dots(100));
    listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    worker.open("b", [] { return grey(32); });
    auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) && placed(n)->picture; });
    CHECK(placed(event.back())->picture->name == "b");
    CHECK(placed(event.back())->drawing.dots.size() == 100);
}

TEST_CASE("a request that cannot be placed says why") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    DotsRequest request = dots(100);
    request.drawing.tile = "no such tile";
    worker.place(request);
    auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    CHECK(placed(event.back())->error.find("no such tile") != std::string::npos);
    CHECK(placed(event.back())->drawing.dots.size() == 0);
}

TEST_CASE("a tile is told with its first dots, and again when another was chosen") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    auto next = [&](const DotsRequest& request) {
        worker.place(request);
        auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
        return placed(event.back())->tile;
    };
    auto first = next(dots(100));
    REQUIRE(first);
    CHECK(first->name == "paper16");
    CHECK(first->points.size() == 16);
    CHECK_FALSE(next(dots(200)));
    DotsRequest other = dots(200);
    other.drawing.tile = "28433,5791/16";
    auto second = next(other);
    REQUIRE(second);
    CHECK(second->name == "28433,5791/16");
    other.drawing.ranking = RankingMethod::farthest;
    CHECK(next(other));
}

TEST_CASE("saving runs with the picture's bench, and tells how it went") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    worker.place(dots(100));
    std::size_t saved = 0;
    worker.save("a.svg", [&](Workbench& bench, std::stop_token) -> WriteFile {
        PlacedDrawing drawing;
        bench.place(dots(77), drawing);
        return [&saved, drawing](const Watch&) {
            saved = drawing.dots.size();
            return true;
        };
    });
    listen(worker, [](const WorkerEvent& n) { return std::holds_alternative<DrawingSaved>(n); });
    CHECK(saved == 77);
    worker.save("b.svg", [](Workbench&, std::stop_token) -> WriteFile {
        throw std::runtime_error("there is nothing to draw");
    });
    auto event = listen(worker, [](const WorkerEvent& n) { return failed(n) != nullptr; });
    CHECK(failed(event.back())->message == "there is nothing to draw");
    worker.save("c.svg", [](Workbench&, std::stop_token) -> WriteFile {
        return [](const Watch&) -> bool { throw std::runtime_error("the disk is full"); };
    });
    event = listen(worker, [](const WorkerEvent& n) { return failed(n) != nullptr; });
    CHECK(failed(event.back())->message == "the disk is full");
    CHECK_FALSE(worker.saving());
}

TEST_CASE("dots are placed while a file is written, until that is done or cancelled") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    worker.place(dots(100));
    std::atomic<bool> half_way = false;
    worker.save("a.svg", [&](Workbench&, std::stop_token) -> WriteFile {
        return [&](const Watch& watch) {
            watch.progress(0.5);
            half_way = true;
            while (!watch.stop.stop_requested()) std::this_thread::yield();
            return false;
        };
    });
    REQUIRE(wait_until([&] {
        worker.events();
        return half_way.load();
    }));
    REQUIRE(worker.saving());
    CHECK(worker.saving()->path == "a.svg");
    CHECK(worker.saving()->share == 0.5);
    worker.place(dots(321));
    listen(worker, [](const WorkerEvent& n) { return placed(n) && placed(n)->drawing.dots.size() == 321; });
    CHECK(worker.saving());
    worker.cancel_saving();
    listen(worker, [](const WorkerEvent& n) { return std::holds_alternative<SavingCancelled>(n); });
    CHECK_FALSE(worker.saving());
}

TEST_CASE("a worker tells since when it places, and that it does no longer") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    std::uint64_t count = 500'000;
    const auto begin = std::chrono::steady_clock::now();
    // One that is over before anyone looks is followed by another.
    REQUIRE(wait_until([&] {
        worker.events();
        if (const auto since = worker.placing_since()) return *since >= begin;
        worker.place(dots(++count));
        return false;
    }));
    CHECK(wait_until([&] {
        worker.events();
        return !worker.placing_since();
    }));
}

TEST_CASE("a worker tells which share of the dots is placed, which grows") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    CHECK_FALSE(worker.placed_share());
    // On a busy machine all of a drawing may be placed between two looks: of several one is seen half way.
    std::ptrdiff_t inside = 0;
    for (std::uint64_t drawing = 0; drawing < 20 && inside == 0; ++drawing) {
        DotsRequest request = dots(8'000'000 + drawing);
        request.drawing.relax = 0;
        request.drawing.placing.threads = 4;  // many pieces, however few processors there are
        worker.place(request);
        // As often as can be: between two looks another try may have come far.
        std::vector<float> seen;
        REQUIRE(wait_until([&] {
            for (int look = 0; look < 100'000; ++look) {
                const auto share = worker.placed_share();
                if (share && (seen.empty() || *share != seen.back())) seen.push_back(*share);
                if (!worker.events().empty()) return true;
            }
            return false;
        }));
        // Less than before is the beginning of another try.
        int tries = 1;
        for (std::size_t i = 1; i < seen.size(); ++i) {
            if (seen[i] >= seen[i - 1]) continue;
            ++tries;
            CHECK(seen[i] < 0.2f);
        }
        CHECK(tries <= 3);
        CHECK(std::ranges::all_of(seen, [](float share) { return share <= 1; }));
        inside = std::ranges::count_if(seen, [](float share) { return share > 0.1f && share < 0.9f; });
    }
    CHECK(inside > 0);
    CHECK(wait_until([&] { return !worker.placed_share(); }));
}

TEST_CASE("the memory of a drawing far larger than those after it goes back to the system") {
    const auto resident_megabytes = [] {
        std::ifstream file("/proc/self/statm");
        double all = 0, resident = 0;
        file >> all >> resident;
        return resident * 4096 / (1 << 20);
    };
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(64); });
    const auto place = [&](std::uint64_t count) {
        worker.place(dots(count));
        auto event = listen(worker, [&](const WorkerEvent& n) {
            return placed(n) && placed(n)->drawing.dots.size() == count;
        });
        return std::move(std::get<DotsPlaced>(event.back()).drawing);
    };
    constexpr std::uint64_t kMany = 8'000'000;  // 64 megabytes
    PlacedDrawing large = place(kMany);
    CHECK(large.blocks.size() >= kMany / kDotsPerBlock);
    worker.recycle(std::move(large));
    // Once more, into the memory of the first.
    large = place(kMany + 1);
    [[maybe_unused]] const double held = resident_megabytes();
    worker.recycle(std::move(large));
    PlacedDrawing small = place(500);
    worker.recycle(std::move(small));
// The sanitizers keep freed memory.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    CHECK(wait_until([&] { return resident_megabytes() < held - 50; }));
#endif
}

TEST_CASE("a worker that ends does not finish what is still to do") {
    std::atomic<bool> begun = false, stopped = false, next_begun = false;
    {
        Worker worker([] {});
        worker.save("a.svg", [&](Workbench&, std::stop_token stop) -> WriteFile {
            begun = true;
            stopped = wait_until([&] { return stop.stop_requested(); });
            return {};
        });
        worker.save("b.svg", [&](Workbench&, std::stop_token) -> WriteFile {
            next_begun = true;
            return {};
        });
        REQUIRE(wait_until([&] { return begun.load(); }));
    }
    CHECK(stopped);
    CHECK_FALSE(next_begun);
}

TEST_CASE("of pictures that are forgotten before they are read none is read") {
    Worker worker([] {});
    std::atomic<int> read = 0;
    std::atomic<bool> others_asked_for = false;
    const auto open = [&](int side) {
        worker.open("grey.png", [&, side] {
            ++read;
            others_asked_for.wait(false);
            return grey(side);
        });
    };
    for (int i = 0; i < 5; ++i) {
        open(16);
        worker.clear();
    }
    open(64);
    others_asked_for = true;
    others_asked_for.notify_all();
    worker.place(dots(500));
    listen(worker, [](const WorkerEvent& n) {
        return placed(n) && placed(n)->picture && placed(n)->picture->longer_side == 64;
    });
    CHECK(read == 2);  // the first had begun
}

TEST_CASE(
    "cancelled, neither the file that is written nor one that waits for it is, but one asked for later") {
    Worker worker([] {});
    std::atomic<bool> writes = false;
    std::atomic<int> written = 0;
    const auto endless = [&](Workbench&, std::stop_token) -> WriteFile {
        return [&](const Watch& watch) {
            writes = true;
            if (!wait_until([&] { return watch.stop.stop_requested(); })) ++written;
            return false;
        };
    };
    worker.save("a.svg", endless);
    worker.save("b.svg", endless);
    REQUIRE(wait_until([&] {
        worker.events();
        return writes.load();
    }));
    worker.cancel_saving();
    worker.save("c.svg",
                [](Workbench&, std::stop_token) -> WriteFile { return [](const Watch&) { return true; }; });
    std::vector<std::string> cancelled, saved;
    listen(worker, [&](const WorkerEvent& event) {
        if (const auto* one = std::get_if<SavingCancelled>(&event)) cancelled.push_back(one->path);
        if (const auto* one = std::get_if<DrawingSaved>(&event)) saved.push_back(one->path);
        return cancelled.size() + saved.size() == 3;
    });
    std::ranges::sort(cancelled);
    CHECK(cancelled == std::vector<std::string>{"a.svg", "b.svg"});
    CHECK(written == 0);
    CHECK(saved == std::vector<std::string>{"c.svg"});
    CHECK_FALSE(worker.saving());
}

TEST_CASE("a placing that takes long is given up for a new request, and nothing is told of it") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(512); });
    worker.place(long_work());
    REQUIRE(wait_until([&] {
        worker.events();
        const auto since = worker.placing_since();
        return since && std::chrono::steady_clock::now() - *since > std::chrono::milliseconds(400);
    }));
    worker.place(dots(300));
    const auto event = listen(worker, [](const WorkerEvent& n) { return placed(n) != nullptr; });
    CHECK(placed(event.back())->drawing.dots.size() == 300);
}

TEST_CASE("a drawing that was shown on its way settles no further when another is asked for") {
    Worker worker([] {});
    worker.open("grey.png", [] { return grey(512); });
    DotsRequest slow = dots(200'000);
    slow.drawing.relax = 100;
    worker.place(slow);
    listen(worker, [](const WorkerEvent& event) { return placed(event) != nullptr; });
    worker.place(dots(300));
    for (const WorkerEvent& event : listen(worker, [](const WorkerEvent& one) {
             return placed(one) && placed(one)->drawing.dots.size() == 300;
         }))
        CHECK((placed(event)->drawing.dots.size() == 300 || !placed(event)->drawing.settled()));
}

TEST_CASE("another order of a tile's points draws other dots, those that it draws by itself") {
    const auto places = [](Workbench& bench, RankingMethod ranking) {
        DotsRequest request = dots(700);
        request.drawing.ranking = ranking;
        PlacedDrawing drawing;
        REQUIRE(bench.place(request, drawing));
        std::vector<std::pair<float, float>> found;
        for_each_position(drawing.dots, [&](float x, float y) { found.emplace_back(x, y); });
        std::ranges::sort(found);
        return found;
    };
    Workbench bench;
    bench.set_picture({.light = Grid<float>(8, 8, 0.5f)});
    std::vector<std::pair<float, float>> before;
    for (const RankingMethod ranking :
         {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy, RankingMethod::paper}) {
        CAPTURE(static_cast<int>(ranking));
        Workbench alone;
        alone.set_picture({.light = Grid<float>(8, 8, 0.5f)});
        const auto found = places(bench, ranking);
        CHECK(found == places(alone, ranking));
        CHECK(found != before);
        before = found;
    }
}

}  // namespace dapple
