// Anything that a person can do with mouse and keyboard, at random: the program has to go on.
//
// What is done depends on a seed alone. It is fed to `xdotool -` and written to a file line by line, which
// does the same again. By hand, for as long as one likes:
//
//     DAPPLE_SECONDS=600 DAPPLE_SEED=7 DAPPLE_EVENTS=events.txt build/dev/tests/random_events
//     DAPPLE_REPLAY=events.txt build/dev/tests/random_events

#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "tests/running_viewer.h"

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPatience = 10;      // seconds for an answer
constexpr double kMostMemory = 2000;  // megabytes; the counts that are typed need far less
constexpr int kEventsBetweenProbes = 25;

std::string from_environment(const char* name, const char* otherwise) {
    const char* value = std::getenv(name);
    return value ? value : otherwise;
}

/// In the window, pixels.
struct Place {
    int x, y;
};

/// A program that reads xdotool's commands, and the file that keeps them.
class Hands {
 public:
    explicit Hands(const fs::path& log) : log_(log), pipe_(popen("xdotool - 2>/dev/null", "w")) {
        REQUIRE(pipe_ != nullptr);
    }
    ~Hands() { pclose(pipe_); }
    Hands(const Hands&) = delete;
    Hands& operator=(const Hands&) = delete;

    /// Waits until all of it is done; false if that takes a minute.
    bool are_done() {
        TemporaryFolder folder;
        const fs::path file = folder / "done";
        (*this)("exec --sync touch " + file.string());
        return wait_until([&] { return fs::exists(file); });
    }

    void operator()(const std::string& command) {
        if (!command.starts_with("exec")) log_ << command << std::endl;
        std::fputs((command + "\n").c_str(), pipe_);
        std::fflush(pipe_);
    }

 private:
    std::ofstream log_;
    std::FILE* pipe_;
};

class Person {
 public:
    Person(unsigned seed, fs::path folder) : random_(seed), folder_(std::move(folder)) {}

    int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    bool perhaps(double share) { return std::bernoulli_distribution(share)(random_); }

    void do_something(Hands& hands) {
        switch (number(0, 12)) {
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
        hands("key Escape");
        hands("key Escape");
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
        constexpr std::array kKeys{"ctrl+z",    "ctrl+y",   "ctrl+shift+z",
                                   "ctrl+0",    "ctrl+b",   "ctrl+s",
                                   "ctrl+t",    "f",        "t",
                                   "c",         "l",        "p",
                                   "e",         "E",        "plus",
                                   "minus",     "Tab",      "F1",
                                   "Escape",    "Escape",   "Return",
                                   "Up",        "Down",     "Left",
                                   "BackSpace", "Delete",   "Home",
                                   "space",     "question", "a"};
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
    void open_file(Hands& hands) {
        hands("key ctrl+o");
        hands("key ctrl+a");
        constexpr std::array kFiles{"small.pgm",  "wide.pgm", "tall.pgm", "one.pgm",
                                    "broken.png", "none.png", "even.hdr", ""};
        type(hands,
             (folder_ / kFiles[static_cast<std::size_t>(number(0, static_cast<int>(kFiles.size()) - 1))])
                 .string());
    }

    std::mt19937 random_;
    fs::path folder_;
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
    std::ofstream(folder / "broken.png") << "not a picture";
    std::ofstream map(folder / "even.hdr", std::ios::binary);
    map << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int pixel = 0; pixel < 8 * 16; ++pixel) map << "\x80\x80\x80\x81";
}

/// Seconds until it knows that the pointer is there; more than kPatience: it doesn't answer.
double seconds_to_answer(const RunningViewer& viewer, Place pointer) {
    const auto begin = Clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    while (!viewer.has_ended() && passed() <= kPatience &&
           viewer.status()["mouse"] != json{pointer.x, pointer.y})
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return passed();
}

void check_health(const RunningViewer& viewer) {
    REQUIRE_FALSE(viewer.has_ended());
    CHECK(viewer.status()["gl_errors"] == 0);
#if !defined(__SANITIZE_ADDRESS__)
    CHECK(viewer.memory() < kMostMemory);
#endif
}

}  // namespace

TEST_CASE("whatever keyboard and mouse do at random, the window answers and ends well") {
    const double seconds = std::stod(from_environment("DAPPLE_SECONDS", "50"));
    const auto seed = static_cast<unsigned>(std::stoul(from_environment("DAPPLE_SEED", "1")));
    const std::string replay = from_environment("DAPPLE_REPLAY", "");
    const auto begin = Clock::now();
    TemporaryFolder folder;
    write_pictures(folder.path());
    const fs::path log = from_environment("DAPPLE_EVENTS", (folder / "events.txt").c_str());
    int events = 0;
    double slowest = 0;
    std::vector<std::string> arguments;
    for (unsigned round = 0; round < 2; ++round, arguments = {"lights"}) {
        const fs::path round_log = log.string() + (round == 0 ? "" : ".lights");
        CAPTURE(seed);
        CAPTURE(round_log);
        Display display;
        RunningViewer viewer(folder.path(), arguments);
        Hands hands(round_log);
        Person person(seed + 1000 * round, folder.path());
        if (!replay.empty()) {
            std::ifstream commands(replay);
            for (std::string line; std::getline(commands, line) && !viewer.has_ended();) hands(line);
        }
        const auto is_over = [&] {
            const double share = (round + 1) / 2.0;
            return !replay.empty() ||
                   std::chrono::duration<double>(Clock::now() - begin).count() > seconds * share;
        };
        while (!is_over()) {
            for (int i = 0; i < kEventsBetweenProbes; ++i, ++events) person.do_something(hands);
            const Place pointer = person.come_to_rest(hands);
            REQUIRE(hands.are_done());
            const double answer = seconds_to_answer(viewer, pointer);
            slowest = std::max(slowest, answer);
            if (viewer.has_ended()) {
                CHECK(viewer.wait_for_end() == 0);
                FAIL("it ended: see the events");
            }
            REQUIRE(answer <= kPatience);
            check_health(viewer);
        }
        person.come_to_rest(hands);
        hands("key ctrl+q");
        CHECK(viewer.wait_for_end() == 0);
    }
    MESSAGE(events, " events, slowest answer ", slowest, " s");
}

}  // namespace dapple
