// The real program in a real window, on a display of its own, driven with a real mouse and keyboard.
//
// Everything waits for what it is after, for up to half a minute, so that a slow machine passes too.

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/child_process.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::chrono::seconds kPatience(30);

bool wait_until(const std::function<bool()>& done) {
    const auto begin = std::chrono::steady_clock::now();
    while (!done()) {
        if (std::chrono::steady_clock::now() - begin > kPatience) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    return true;
}

void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void run(std::vector<std::string> command) {
    CAPTURE(command.front());
    REQUIRE(ChildProcess(std::move(command)).wait() == 0);
}

/// A display with nothing on it.
class Display {
 public:
    Display() : number_file_(folder_ / "number"), server_(start()) {
        REQUIRE(wait_until([&] { return text_of(number_file_).find('\n') != std::string::npos; }));
        std::string name = ":" + text_of(number_file_);
        name.pop_back();
        setenv("DISPLAY", name.c_str(), 1);
        unsetenv("WAYLAND_DISPLAY");
    }

 private:
    ChildProcess start() const {
        // Xvfb finds a free number itself and writes it to its standard output.
        return ChildProcess(
            {"Xvfb", "-displayfd", "1", "-screen", "0", "1280x800x24", "-noreset", "-nolisten", "tcp"},
            {.output = number_file_});
    }

    TemporaryFolder folder_;
    fs::path number_file_;
    ChildProcess server_;
};

/// The program on it.
class RunningViewer {
 public:
    explicit RunningViewer(std::vector<std::string> arguments = {})
        : log_(folder_ / "log"), program_(start(std::move(arguments))) {
        REQUIRE(wait_until([&] { return text_of(log_).starts_with("ready\n") && !status().is_null(); }));
    }

    /// What it said last.
    json status() const {
        const std::string log = text_of(log_);
        const auto end = log.rfind("}\n");
        if (end == std::string::npos) return nullptr;
        const auto before = log.rfind('\n', end);
        return json::parse(log.substr(before + 1, end - before));
    }
    std::uint64_t dots() const { return status()["dots"]; }

    /// Moves the mouse to a place along a widget, 0 its left end and 1 its right one.
    void point_at(const std::string& widget, double along = 0.5) const {
        const json place = status()["widgets"][widget];
        CAPTURE(widget);
        REQUIRE(place.is_array());
        const double x0 = place[0], y0 = place[1], x1 = place[2], y1 = place[3];
        move(x0 + 1 + (x1 - x0 - 2) * along, (y0 + y1) / 2);
    }
    void move(double x, double y) const {
        run({"xdotool", "mousemove", std::to_string(std::lround(x)), std::to_string(std::lround(y))});
        pause();
    }
    void click(const std::string& widget) const {
        point_at(widget);
        press();
        release();
    }
    void press() const { button("mousedown", "1"); }
    void release() const { button("mouseup", "1"); }
    void wheel_up() const { button("click", "4"); }
    void key(const std::string& keys) const {
        run({"xdotool", "key", keys});
        pause();
    }
    void type(const std::string& text) const {
        run({"xdotool", "type", "--delay", "30", text});
        pause();
    }
    int wait_for_end() { return program_.wait(); }

 private:
    ChildProcess start(std::vector<std::string> arguments) const {
        std::vector<std::string> command{DAPPLE_PROGRAM, "--log-status"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return ChildProcess(std::move(command), {.output = log_});
    }
    static void button(const std::string& what, const std::string& number) {
        run({"xdotool", what, number});
        pause();
    }

    TemporaryFolder folder_;
    fs::path log_;
    ChildProcess program_;
};

}  // namespace

TEST_CASE("dragging the scale slider with the mouse changes the number of dots, and undo brings it back") {
    Display display;
    RunningViewer viewer;
    CHECK(viewer.dots() == 40'000);
    viewer.click("scale");
    REQUIRE(wait_until([&] { return viewer.status()["widgets"].contains("Scale"); }));
    const double scale = viewer.status()["scale"];

    viewer.point_at("Scale", 0.5);
    viewer.press();
    viewer.point_at("Scale", 0.4);
    viewer.point_at("Scale", 0.3);
    // The dots follow while the button is still down.
    CHECK(wait_until([&] { return viewer.dots() < 10'000; }));
    viewer.release();
    CHECK(viewer.status()["scale"] < scale / 4);

    viewer.move(300, 300);
    viewer.key("ctrl+z");
    CHECK(wait_until([&] { return viewer.status()["scale"] == scale; }));
    // A scale draws the dots above it, so one fewer than the count whose last dot lies just on it.
    CHECK(viewer.dots() >= 39'999);

    viewer.key("ctrl+q");
    CHECK(viewer.wait_for_end() == 0);
}

TEST_CASE("the wheel zooms, F fits again, and neither places a dot anew") {
    Display display;
    RunningViewer viewer;
    const double zoom = viewer.status()["zoom"];
    viewer.move(300, 300);
    viewer.wheel_up();
    CHECK(wait_until([&] { return viewer.status()["zoom"] > zoom * 1.1; }));
    const int placings = viewer.status()["placings"];
    viewer.key("f");
    CHECK(wait_until([&] { return viewer.status()["zoom"] == zoom; }));
    CHECK(viewer.status()["placings"] == placings);
}

TEST_CASE("zooming in with more dots keeps them as dense, and F brings the drawing back") {
    Display display;
    RunningViewer viewer;
    const double scale = viewer.status()["scale"], zoom = viewer.status()["zoom"];
    viewer.click("more dots");
    viewer.move(380, 320);
    for (int i = 0; i < 12; ++i) viewer.wheel_up();
    CHECK(wait_until([&] {
        const double enlarged = viewer.status()["zoom"].get<double>() / zoom;
        const double denser = viewer.status()["scale"].get<double>() / scale;
        return enlarged > 8 && std::abs(denser / (1.07 * enlarged * enlarged) - 1) < 0.01;
    }));
    CHECK(viewer.dots() > 10'000);
    CHECK(viewer.dots() < 400'000);
    viewer.key("f");
    viewer.click("larger dots");
    CHECK(wait_until([&] { return viewer.status()["scale"] == scale; }));
    CHECK(viewer.dots() == 40'000);
}

TEST_CASE("what the window exports is what the command writes, to the byte") {
    TemporaryFolder folder;
    Display display;
    RunningViewer viewer;
    viewer.move(300, 300);
    viewer.key("ctrl+e");
    REQUIRE(wait_until([&] { return viewer.status()["widgets"].contains("Path"); }));
    viewer.key("ctrl+a");
    viewer.type((folder / "window.svg").string());
    viewer.key("Return");
    REQUIRE(wait_until([&] { return fs::exists(folder / "window.svg"); }));
    run({DAPPLE_PROGRAM, "render", "-o", (folder / "command.svg").string()});
    CHECK(text_of(folder / "window.svg") == text_of(folder / "command.svg"));
}

TEST_CASE("a picture that is not there ends the program with a sentence") {
    TemporaryFolder folder;
    Display display;
    ChildProcess program({DAPPLE_PROGRAM, (folder / "missing.png").string()}, {.errors = folder / "errors"});
    CHECK(program.wait() == 1);
    CHECK(text_of(folder / "errors").find("missing.png") != std::string::npos);
}

TEST_CASE("without a display the program says so and what to do") {
    TemporaryFolder folder;
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    ChildProcess program({DAPPLE_PROGRAM}, {.errors = folder / "errors"});
    CHECK(program.wait() == 1);
    CHECK(text_of(folder / "errors").find("dapple render") != std::string::npos);
}

TEST_CASE("the dots on screen are measured once the spectrum's section is opened") {
    Display display;
    RunningViewer viewer;
    viewer.click("Tone");
    viewer.click("View");
    CHECK_FALSE(viewer.status()["widgets"].contains("Radial power"));
    viewer.click("Spectrum");
    CHECK(wait_until([&] { return viewer.status()["widgets"].contains("Radial power"); }));
}

}  // namespace dapple
