// Anything that a person can do with mouse and keyboard, and with files dropped on the window, at random: the
// program has to go on.
//
// What is done depends on a seed alone. It is fed to `xdotool -`, but for what that cannot do, and written to
// a file line by line, which does the same again: one for a drawing, and one with .lights behind its name for
// an environment map. By hand, for as long as one likes:
//
//     DAPPLE_SECONDS=600 DAPPLE_SEED=7 DAPPLE_EVENTS=events.txt build/dev/tests/random_events
//     DAPPLE_REPLAY=events.txt build/dev/tests/random_events

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/window/running_viewer.h"
#include "tests/window/window_messages.h"

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds for an answer: of its own work, which says the same on a machine that is busy with other things,
// and of waiting, for one that does nothing.
constexpr double kPatience = 10, kLongestWait = 120;
constexpr double kMostMemory = 2000;  // megabytes; the counts that are typed need far less
// By which memory may be above that after a quarter of the time, both with the same small drawing: nothing is
// left behind.
constexpr double kMostGrowth = 100;
constexpr int kEventsBetweenProbes = 25;

std::string from_environment(const char* name, const char* otherwise) {
    const char* value = std::getenv(name);
    return value ? value : otherwise;
}

/// In the window, pixels.
struct Place {
    int x, y;
};

/// A program that reads xdotool's commands, and the file that keeps them. Two are our own: `drop NAME X Y`,
/// of a file in the folder, and `close`.
class Hands {
 public:
    Hands(const fs::path& log, fs::path folder, const RunningViewer& viewer)
        : log_(log), folder_(std::move(folder)), viewer_(viewer), pipe_(popen("xdotool - 2>/dev/null", "w")) {
        REQUIRE(pipe_ != nullptr);
    }
    ~Hands() { pclose(pipe_); }
    Hands(const Hands&) = delete;
    Hands& operator=(const Hands&) = delete;

    /// Waits until all of it is done, or the program has ended; false if that takes a minute.
    bool are_done() {
        TemporaryFolder folder;
        const fs::path file = folder / "done";
        (*this)("exec --sync touch " + file.string());
        return wait_until([&] { return fs::exists(file) || viewer_.has_ended(); });
    }

    void operator()(const std::string& command) {
        if (!command.starts_with("exec")) log_ << command << std::endl;
        std::istringstream words(command);
        std::string first, name;
        int x = 0, y = 0;
        words >> first;
        if (first == "drop" || first == "close") REQUIRE(are_done());
        if (first == "close") return ask_to_close("Dapple");
        if (first == "drop" && words >> name >> x >> y) return drop_file("Dapple", folder_ / name, x, y);
        std::fputs((command + "\n").c_str(), pipe_);
        std::fflush(pipe_);
    }

 private:
    std::ofstream log_;
    fs::path folder_;
    const RunningViewer& viewer_;
    std::FILE* pipe_;
};

class Person {
 public:
    explicit Person(unsigned seed) : random_(seed) {}

    int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    bool perhaps(double share) { return std::bernoulli_distribution(share)(random_); }

    void do_something(Hands& hands) {
        switch (number(0, 13)) {
            case 0:
            case 1:
                return hands("key --delay " + std::to_string(number(0, 30)) + " " + key());
            case 2:  // a modifier that changes while keys go up and down
                hands("key --delay 0 " + key() + " keydown shift");
                return hands("keyup shift");
            case 3:
                hands("keydown ctrl");
                go(hands);
                hands("click 1");
                hands("keyup ctrl");
                return type(hands, typed_number());
            case 4:
            case 5:
                go(hands);
                return hands("click --repeat " + std::to_string(number(1, 2)) + " 1");
            case 6:
            case 7:
                return drag(hands);
            case 8:
                go(hands);
                return hands("click --delay 0 --repeat " + std::to_string(number(1, 8)) +
                             (perhaps(0.5) ? " 4" : " 5"));
            case 9:
                return resize(hands);
            case 10:
                go(hands);
                hands("click 1");
                return type(hands, typed_number());
            case 11:
                if (perhaps(0.5)) return open_file(hands);
                hands("key ctrl+e");
                return hands("key Return");
            case 12:
                if (perhaps(0.5)) return;  // it takes longer than the others
                return hands(std::string("drop ") + file() + " " + std::to_string(number(0, 1279)) + " " +
                             std::to_string(number(0, 799)));
            default:
                return hands("sleep 0." + std::to_string(number(0, 4)));
        }
    }

    /// Nothing is held down and nothing is asked; the pointer is where nobody else would put it.
    Place come_to_rest(Hands& hands) {
        hands("mouseup 1");
        hands("keyup ctrl keyup shift");
        whole(hands);
        const Place place{number(20, 600), number(20, 500)};
        hands("mousemove " + std::to_string(number(700, 900)) + " " + std::to_string(number(20, 700)));
        for (int i = 0; i < 5; ++i) hands("key Escape");  // from a row, a film, a column, ...
        hands("mousemove " + std::to_string(place.x) + " " + std::to_string(place.y));
        return place;
    }

 private:
    void go(Hands& hands) {
        // Half of the time to the panels.
        const int x = perhaps(0.5) ? number(940, 1279) : number(0, 939);
        hands("mousemove " + std::to_string(x) + " " + std::to_string(number(0, 799)));
    }
    void drag(Hands& hands) {
        go(hands);
        hands("mousedown 1");
        for (int i = number(1, 6); i > 0; --i)
            hands("mousemove_relative -- " + std::to_string(number(-200, 200)) + " " +
                  std::to_string(number(-80, 80)));
        if (perhaps(0.3)) hands("key " + key());
        hands("mouseup 1");
    }
    static void size(Hands& hands, int width, int height) {
        hands("search --onlyvisible --name Dapple$ windowsize " + std::to_string(width) + " " +
              std::to_string(height));
    }
    static void whole(Hands& hands) { size(hands, 1280, 800); }
    void resize(Hands& hands) {
        constexpr std::array kLargest{1, 60, 400, 1280};
        const int largest = kLargest[static_cast<std::size_t>(number(0, 3))];
        size(hands, number(1, largest), number(1, std::min(largest, 800)));
        hands("sleep 0.05");
        if (perhaps(0.7)) whole(hands);
    }
    std::string key() {
        // Not F11 nor Ctrl+Q: without a window manager nothing is full screen, and the end comes at the end.
        constexpr std::array kKeys{
            "ctrl+z", "ctrl+y", "ctrl+shift+z", "ctrl+0", "ctrl+b", "ctrl+s", "ctrl+t",   "f",
            "t",      "c",      "shift+c",      "l",      "m",      "p",      "e",        "E",
            "plus",   "minus",  "Tab",          "F1",     "Escape", "Escape", "Return",   "Up",
            "Down",   "Left",   "BackSpace",    "Delete", "Home",   "space",  "question", "a"};
        return kKeys[static_cast<std::size_t>(number(0, static_cast<int>(kKeys.size()) - 1))];
    }
    std::string typed_number() {
        constexpr std::array kOdd{"0",       "-1",          "1e300",  "nan",  "inf",
                                  "0.00001", "99999999999", "1e-300", "12,5", "%s%n"};
        if (perhaps(0.3)) return kOdd[static_cast<std::size_t>(number(0, static_cast<int>(kOdd.size()) - 1))];
        std::string digits;
        for (int i = number(1, 6); i > 0; --i) digits += static_cast<char>('0' + number(0, 9));
        return digits;
    }
    void type(Hands& hands, const std::string& text) {
        hands("type --delay 5 -- '" + text + "'");
        hands(perhaps(0.7) ? "key Return" : "key Escape");
    }
    // In the folder that the program works in.
    const char* file() {
        constexpr std::array kFiles{"small.pgm", "wide.pgm", "tall.pgm", "one.pgm",       "broken.png",
                                    "none.png",  "even.hdr", "pipe.png", "broken.dapple", "even.tile"};
        return kFiles[static_cast<std::size_t>(number(0, static_cast<int>(kFiles.size()) - 1))];
    }
    void open_file(Hands& hands) {
        hands("key ctrl+o");
        hands("key ctrl+a");
        type(hands, perhaps(0.1) ? "" : file());
    }

    std::mt19937 random_;
};

void write_pictures(const fs::path& folder) {
    const auto write = [&](const char* name, int width, int height) {
        std::ofstream out(folder / name, std::ios::binary);
        out << "P5\n" << width << " " << height << "\n255\n";
        for (int i = 0; i < width * height; ++i) out.put(static_cast<char>(i * 7 % 251));
    };
    write("small.pgm", 60, 40);
    write("wide.pgm", 800, 2);
    write("tall.pgm", 3, 500);
    write("one.pgm", 1, 1);
    std::ofstream(folder / "rest.dapple") << R"({"dapple": 1, "drawing": {"count": 1000}})";
    std::ofstream(folder / "broken.png") << "not a picture";
    std::ofstream(folder / "broken.dapple") << "{";
    std::ofstream(folder / "even.tile") << "not a tile";
    REQUIRE(mkfifo((folder / "pipe.png").c_str(), 0600) == 0);  // nobody writes to it
    std::ofstream map(folder / "even.hdr", std::ios::binary);
    map << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int pixel = 0; pixel < 8 * 16; ++pixel) map << "\x80\x80\x80\x81";
}

struct Answer {
    double work = 0, wait = 0;  // seconds

    bool in_time() const { return work <= kPatience && wait <= kLongestWait; }
};

/// What it takes until it knows that the pointer is there.
Answer answer_to(const RunningViewer& viewer, Place pointer) {
    const auto begin = Clock::now();
    const double work_before = viewer.interface_seconds();
    const auto so_far = [&] {
        return Answer{viewer.interface_seconds() - work_before,
                      std::chrono::duration<double>(Clock::now() - begin).count()};
    };
    while (!viewer.has_ended() && so_far().in_time() &&
           viewer.status()["mouse"] != json{pointer.x, pointer.y})
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return so_far();
}

void check_health(const RunningViewer& viewer) {
    REQUIRE_FALSE(viewer.has_ended());
    CHECK(viewer.status()["gl_errors"] == 0);
#if !defined(__SANITIZE_ADDRESS__)
    CHECK(viewer.memory() < kMostMemory);
#endif
}

/// Megabytes, once it shows something small and works no more.
double memory_at_rest(const RunningViewer& viewer, Hands& hands, const std::string& small_file) {
    hands("drop " + small_file + " 300 300");
    REQUIRE(hands.are_done());
    double before = -1;
    CHECK(wait_until([&] {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        const double now = viewer.processor_seconds();
        return now - std::exchange(before, now) < 0.3;  // something may blink
    }));
    return viewer.memory();
}

}  // namespace

TEST_CASE("whatever keyboard and mouse do at random, the window answers and ends well") {
    const double seconds = std::stod(from_environment("DAPPLE_SECONDS", "20"));
    const auto seed = static_cast<unsigned>(std::stoul(from_environment("DAPPLE_SEED", "1")));
    const std::string replay = from_environment("DAPPLE_REPLAY", "");
    // Leaks of Mesa's are none of ours. What is freed counts as free soon, so that growth can be seen.
    setenv("ASAN_OPTIONS", "detect_leaks=0:quarantine_size_mb=8:allocator_release_to_os_interval_ms=500", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const auto begin = Clock::now();
    TemporaryFolder folder;
    write_pictures(folder.path());
    const fs::path log = from_environment("DAPPLE_EVENTS", (folder / "events.txt").c_str());
    int events = 0;
    Answer slowest;
    double longest_frame = 0, longest_work = 0;
    std::vector<std::string> arguments;
    for (unsigned round = 0; round < 2; ++round, arguments = {"lights"}) {
        const std::string kind = round == 0 ? "" : ".lights";
        const fs::path round_log = log.string() + kind;
        CAPTURE(seed);
        CAPTURE(round_log);
        Display display;
        RunningViewer viewer(folder.path(), arguments);
        Hands hands(round_log, folder.path(), viewer);
        Person person(seed + 1000 * round);
        std::optional<double> memory_before;
        const auto measure_memory = [&] {
            person.come_to_rest(hands);
            return memory_at_rest(viewer, hands, round == 0 ? "rest.dapple" : "even.hdr");
        };
        if (!replay.empty()) {
            std::ifstream commands(replay + kind);
            for (std::string line; std::getline(commands, line) && !viewer.has_ended();) hands(line);
        }
        // How much of this round's time has passed.
        const auto share = [&] {
            const double passed = std::chrono::duration<double>(Clock::now() - begin).count();
            return passed / (seconds / 2) - round;
        };
        while (replay.empty() && share() < 1) {
            if (!memory_before && share() > 0.25) memory_before = measure_memory();
            for (int i = 0; i < kEventsBetweenProbes; ++i, ++events) person.do_something(hands);
            const Place pointer = person.come_to_rest(hands);
            REQUIRE(hands.are_done());
            const Answer answer = answer_to(viewer, pointer);
            slowest = {std::max(slowest.work, answer.work), std::max(slowest.wait, answer.wait)};
            if (viewer.has_ended()) {
                CHECK(viewer.wait_for_end() == 0);
                FAIL("it ended: see the events");
            }
            CAPTURE(answer.work);
            CAPTURE(answer.wait);
            REQUIRE(answer.in_time());
            check_health(viewer);
            longest_frame = std::max(longest_frame, viewer.status()["longest_frame_ms"].get<double>());
            longest_work = std::max(longest_work, viewer.status()["longest_work_ms"].get<double>());
        }
        if (memory_before) {
            const double after = measure_memory();
            MESSAGE("memory at rest: ", *memory_before, " MB, then ", after, " MB");
            CHECK(after < *memory_before + kMostGrowth);
        }
        const Place pointer = person.come_to_rest(hands);
        REQUIRE(hands.are_done());
        REQUIRE(answer_to(viewer, pointer).in_time());  // a question of before is gone
        hands(round == 0 ? "close" : "key ctrl+q");
        viewer.shows([&] { return viewer.has("Discard"); });
        if (!viewer.has_ended()) hands("key d");
        CHECK(viewer.wait_for_end() == 0);
    }
    MESSAGE(events, " events, slowest answer ", slowest.work, " s of work in ", slowest.wait,
            " s, longest frame ", longest_work, " ms of work in ", longest_frame, " ms");
}

}  // namespace dapple
