#pragma once
// The program in a window on a display of its own, with a real mouse and keyboard.
//
// Everything waits until what it did is seen in what the program logs.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/child_process.h"
#include "tests/file_text.h"
#include "tests/places.h"
#include "tests/temporary_folder.h"

namespace dapple {

namespace fs = std::filesystem;
using nlohmann::json;

inline void run(std::vector<std::string> command) {
    const std::string program = command.front();  // told if it fails, when the command is gone
    CAPTURE(program);
    REQUIRE(ChildProcess(std::move(command)).wait() == 0);
}

/// A display with nothing on it.
class Display {
 public:
    explicit Display(int width = 1280, int height = 800, int dpi = 96)
        : number_file_(folder_ / "number"), server_(start(width, height)) {
        REQUIRE(server_.brings([&] { return text_of(number_file_).find('\n') != std::string::npos; }));
        std::string name = ":";
        name += text_of(number_file_);
        name.pop_back();
        setenv("DISPLAY", name.c_str(), 1);
        unsetenv("WAYLAND_DISPLAY");
        // As desktops tell programs how large text is to be.
        if (dpi != 96)
            run({"xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER",
                 "Xft.dpi: " + std::to_string(dpi)});
    }

 private:
    ChildProcess start(int width, int height) const {
        const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
        // Xvfb finds a free number itself and writes it to its standard output.
        return ChildProcess({"Xvfb", "-displayfd", "1", "-screen", "0", size, "-noreset", "-nolisten", "tcp"},
                            {.output = number_file_});
    }

    TemporaryFolder folder_;
    fs::path number_file_;
    ChildProcess server_;
};

/// What the window remembers and keeps is in this folder; none: nothing is remembered.
struct WindowMemory {
    fs::path folder = {};
    bool own_dialog = true;  // else the desktop's, unless the folder says otherwise
};

/// The program on it.
class RunningViewer {
 public:
    explicit RunningViewer(const fs::path& working_folder = {}, std::vector<std::string> arguments = {},
                           const WindowMemory& memory = {})
        : log_(folder_ / "log"),
          program_(command(std::move(arguments), memory), {.folder = working_folder, .output = log_}) {
        REQUIRE(
            shows([&] { return end_of_log().find("ready\n") != std::string::npos && !status().is_null(); }));
    }

    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;
    ~RunningViewer() {
        const json last = status();
        if (!last.is_null()) CHECK_MESSAGE(last["gl_errors"] == 0, end_of_log());
    }

    /// Waits until what it says is as looked for.
    bool shows(const std::function<bool()>& wanted) { return program_.brings(wanted); }

    /// What it said last.
    json status() const {
        const std::string log = end_of_log();
        const auto end = log.rfind("}\n");
        if (end == std::string::npos) return nullptr;
        const auto before = log.rfind('\n', end);
        return json::parse(log.substr(before + 1, end - before));
    }
    /// Waits until its window has a title like that.
    bool is_titled(const std::string& pattern) {
        return shows([&] { return ChildProcess({"xdotool", "search", "--name", pattern}).wait() == 0; });
    }
    /// Waits until the dots move no more: each step of relaxing counts as a placing.
    bool is_relaxed() {
        return shows([&] { return status()["steps"] == status()["all_steps"]; });
    }
    std::uint64_t dots() const { return status()["dots"]; }
    bool has(const std::string& widget) const { return status()["widgets"].contains(widget); }

    /// Moves the mouse to a place along a widget, 0 its left end and 1 its right one.
    void point_at(const std::string& widget, double along = 0.5) {
        CAPTURE(widget);
        json place;
        do {  // once more if the widget moved meanwhile
            place = scrolled_into_view(widget);
            const double x0 = place[0], y0 = place[1], x1 = place[2], y1 = place[3];
            move(x0 + 1 + (x1 - x0 - 2) * along, (y0 + y1) / 2);
        } while (status()["widgets"][widget] != place);
    }
    /// Turns the wheel over the panels, or over the lower half of a dialog, until the widget is in the
    /// window, or in the dialog; its corners.
    json scrolled_into_view(const std::string& widget) {
        while (true) {
            REQUIRE(shows([&] { return has(widget); }));
            const json widgets = status()["widgets"], place = widgets.value(widget, json());
            if (place.is_null()) continue;
            const bool in_dialog = widgets.contains("Dialog");
            if (!in_dialog && place[0] < 940) return place;
            const json around = in_dialog ? widgets["Dialog"] : json{0, 10, 0, height_ - 10};
            const double top = around[1], bottom = std::min(around[3].get<double>(), 1.0 * height_);
            const double y = (place[1].get<double>() + place[3].get<double>()) / 2;
            if (y > top && y < bottom) return place;
            in_dialog
                ? move((around[0].get<double>() + around[2].get<double>()) / 2, top + 0.8 * (bottom - top))
                : move(1100, 400);
            y > bottom ? wheel_down() : wheel_up();
            REQUIRE(shows([&] {
                const json now = status()["widgets"];
                return now.value(widget, json()) != place ||
                       now.value("Dialog", json()) != widgets.value("Dialog", json());
            }));
        }
    }
    void move(double x, double y) {
        const long column = std::lround(x), row = std::lround(y);
        run({"xdotool", "mousemove", std::to_string(column), std::to_string(row)});
        REQUIRE(shows([&] { return status()["mouse"] == json{column, row}; }));
    }
    void click(const std::string& widget) {
        point_at(widget);
        press();
        release();
    }
    void press() {
        run({"xdotool", "mousedown", "1"});
        REQUIRE(shows([&] { return status()["mouse_down"] == true; }));
    }
    void release() {
        run({"xdotool", "mouseup", "1"});
        REQUIRE(shows([&] { return status()["mouse_down"] == false; }));
    }
    // The effect of these is for the test to wait for.
    void wheel_up() const { run({"xdotool", "click", "4"}); }
    void wheel_down() const { run({"xdotool", "click", "5"}); }
    void key(const std::string& keys) const { run({"xdotool", "key", keys}); }
    /// Keys and pauses just as xdotool is told, at the speed of its own.
    void xdotool(const std::string& commands) const { run({"sh", "-c", "xdotool " + commands}); }
    void resize(int width, int height) {
        height_ = height;
        xdotool("search --onlyvisible --name 'Dapple$' windowsize " + std::to_string(width) + " " +
                std::to_string(height));
    }
    /// Seconds of processor time that it has used; that the thread has which knows the window.
    double processor_seconds() const { return processor_seconds("/stat"); }
    double interface_seconds() const {
        return processor_seconds("/task/" + std::to_string(program_.id()) + "/stat");
    }
    /// Megabytes of memory that it holds.
    double memory() const {
        std::ifstream file("/proc/" + std::to_string(program_.id()) + "/statm");
        double all = 0, resident = 0;
        file >> all >> resident;
        return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
    }
    bool has_ended() const { return program_.has_ended(); }
    /// Closes it, whatever has changed; its exit status.
    int quit() {
        key("ctrl+q");
        shows([&] { return has("Discard"); });
        if (!has_ended()) key("d");
        return wait_for_end();
    }
    /// Stops it while something is done: all of that arrives at once.
    template <class Do>
    void at_once(Do something) {
        program_.send(SIGSTOP);
        something();
        program_.send(SIGCONT);
    }
    void kill_at_once() { program_.send(SIGKILL); }
    int wait_for_end() { return program_.wait(); }

 private:
    double processor_seconds(const std::string& table) const {
        std::ifstream file("/proc/" + std::to_string(program_.id()) + table);
        std::string word;
        double user = 0, system = 0;
        for (int i = 1; i <= 13; ++i) file >> word;
        file >> user >> system;
        return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    // Many times longer than one line.
    std::string end_of_log() const {
        constexpr std::streamoff kLongest = 1 << 17;
        std::ifstream file(log_, std::ios::binary | std::ios::ate);
        const std::streamoff size = file.tellg(), from = std::max<std::streamoff>(size - kLongest, 0);
        std::string text(static_cast<std::size_t>(std::max<std::streamoff>(size - from, 0)), '\0');
        file.seekg(from);
        file.read(text.data(), static_cast<std::streamsize>(text.size()));
        return text;
    }
    static std::vector<std::string> command(std::vector<std::string> arguments, const WindowMemory& memory) {
        if (memory.own_dialog) arguments.insert(arguments.begin(), "--own-dialog");
        arguments.insert(arguments.begin(), {dapple_program(), "--log-status"});
        if (memory.folder.empty()) {
            // What a person's own windows remember is no test's business.
            arguments.insert(arguments.begin() + 1, "--fresh");
        } else {
            const std::string folder = memory.folder.string();
            arguments.insert(arguments.begin(),
                             {"env", "XDG_CACHE_HOME=" + folder, "XDG_CONFIG_HOME=" + folder,
                              "XDG_STATE_HOME=" + folder, "XDG_DATA_HOME=" + folder});
        }
        return arguments;
    }

    int height_ = 800;
    TemporaryFolder folder_;
    fs::path log_;
    ChildProcess program_;
};

}  // namespace dapple
