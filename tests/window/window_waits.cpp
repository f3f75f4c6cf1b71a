// How long somebody at the window waits:
//
//     build/release/tests/window_waits
//
// How long its thread is at work without looking at mouse and keyboard, whatever the number of dots, is told
// by its processor time, which says the same on a machine that is busy with other things; how soon a large
// photograph shows dots, by the clock. OpenGL is drawn by software within that thread, so that nothing of it
// is left out: on a graphics card, or with threads of their own for it, all is shorter.

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/picture_files.h"
#include "tests/temporary_folder.h"
#include "tests/window/running_viewer.h"
#include "tests/window/screen.h"
#include "tests/window/window_messages.h"

namespace dapple {
namespace {

constexpr double kX = 470, kY = 385;  // in the canvas's middle

struct Person {
    RunningViewer& viewer;

    // Until nothing is placed or drawn any more, but for what blinks.
    void rest() const {
        double before = -1;
        const auto at_rest = [&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(1500));
            const double now = viewer.processor_seconds();
            return now - std::exchange(before, now) < 0.6;
        };
        for (int tries = 0; tries < 200 && !at_rest(); ++tries) {
        }
    }
    void type_into(const std::string& row, const std::string& text) const {
        viewer.point_at(row, 0.8);
        viewer.xdotool("keydown ctrl click 1 keyup ctrl");
        viewer.xdotool("type --delay 40 " + text);
        viewer.key("Return");
    }
    void type_dots(std::uint64_t count) const {
        type_into("Dots", std::to_string(count));
        // Fewer where memory would not do.
        CHECK(viewer.shows([&] { return viewer.dots() > count / 2; }));
    }
    void pan() const {
        viewer.move(kX, kY);
        std::string way = "mousedown 1";
        for (int i = 0; i < 30; ++i)
            way += " mousemove_relative -- " + std::to_string(i < 15 ? 8 : -8) + " 4 sleep 0.03";
        viewer.xdotool(way + " mouseup 1");
    }
    void zoom() const {
        viewer.move(kX, kY);
        viewer.xdotool("click --repeat 12 --delay 60 4");
        viewer.xdotool("click --repeat 12 --delay 60 5");
        viewer.key("f");
    }
    void export_dialog() const {
        viewer.key("ctrl+e");
        rest();
        viewer.key("Escape");
    }
};

void draw_in_software() {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("LP_NUM_THREADS", "0", 1);  // Mesa draws in the thread that asks for it
}

// Waves in three colours with the noise that a camera adds, so that a JPEG of it is about as large as theirs.
PictureFile like_a_photograph(int width, int height) {
    PictureFile picture{.width = width, .height = height, .channels = 3};
    picture.values.reserve(static_cast<std::size_t>(width) * height * 3);
    std::uint32_t random = 1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                random = random * 1664525 + 1013904223;
                const float noise = static_cast<float>(random >> 8) / (1 << 24) - 0.5f;
                const float wave = std::sin(0.004f * static_cast<float>(x) * static_cast<float>(c + 1)) *
                                   std::sin(0.005f * static_cast<float>(y));
                picture.values.push_back(std::clamp(0.5f + 0.35f * wave + 0.08f * noise, 0.0f, 1.0f));
            }
    return picture;
}

}  // namespace

TEST_CASE("how soon a photograph of 36 megapixels shows dots") {
    draw_in_software();
    const TemporaryFolder folder;
    const fs::path photograph = folder / "large.jpg";
    write_picture(photograph, like_a_photograph(7360, 4912));
    Display display;
    RunningViewer viewer;
    const Person person{viewer};
    std::puts(
        "| Dots | File | First dots | Of the whole picture | Window's longest work |\n|---|---|---|---|---|");
    for (int times = 0; times < 5; ++times) {
        person.rest();
        const auto placings = [&] { return viewer.status()["placings"].get<int>(); };
        const int before = placings();
        const auto begin = std::chrono::steady_clock::now();
        const auto passed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        drop_file("Dapple", photograph, static_cast<int>(kX), static_cast<int>(kY));
        const double dropped = passed();
        while (placings() == before && passed() < 60)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const double first = passed();
        // The whole picture is placed last, after which nothing more comes.
        double last = first;
        for (int seen = placings(); passed() - last < 3;)
            if (const int now = placings(); now != seen) {
                seen = now;
                last = passed();
            }
        std::printf("| %d | %.1f MB | %.2f s (file handed over after %.2f s) | %.2f s, settled | %.0f ms |\n",
                    static_cast<int>(viewer.dots()), static_cast<double>(fs::file_size(photograph)) / 1e6,
                    first, dropped, last, viewer.status()["longest_work_ms"].get<double>());
        std::fflush(stdout);
    }
}

TEST_CASE("the longest that the window's thread works without looking at its input") {
    draw_in_software();
    std::puts(
        "| Dots | Placed | Panned | Zoomed | Tone typed | Undone | Export asked | By the clock | Memory |");
    std::puts("|---|---|---|---|---|---|---|---|---|");
    for (const std::uint64_t count : {1'000, 1'000'000, 10'000'000, 54'000'000}) {
        Display display;
        RunningViewer viewer;
        const Person person{viewer};
        std::string row;
        const auto measure = [&](const std::function<void()>& what) {
            what();
            person.rest();
            const double longest = viewer.status()["longest_work_ms"].get<double>();
            row += " | " + std::to_string(std::lround(longest)) + " ms";
        };
        measure([&] { person.type_dots(count); });
        measure([&] { person.pan(); });
        measure([&] { person.zoom(); });
        measure([&] { person.type_into("Contrast", "0.2"); });
        measure([&] { viewer.key("ctrl+z"); });
        measure([&] { person.export_dialog(); });
        row += " | " + std::to_string(std::lround(viewer.status()["longest_frame_ms"].get<double>())) + " ms";
        row += " | " + std::to_string(std::lround(viewer.memory())) + " MB |";
        row = "| " + std::to_string(viewer.dots()) + row;
        std::puts(row.c_str());
        std::fflush(stdout);
    }
    std::puts("Each is the longest so far.");
}

namespace {

// The canvas's middle in cells of eight pixels, their mean light.
std::vector<double> cells_on_screen() {
    constexpr int kCell = 8, kX0 = 190, kY0 = 110, kX1 = 750, kY1 = 670;
    const Grid<glm::u8vec3> pixels = screen();
    std::vector<double> cells;
    for (int y = kY0; y < kY1; y += kCell)
        for (int x = kX0; x < kX1; x += kCell) {
            double sum = 0;
            for (int i = 0; i < kCell * kCell; ++i) sum += pixels.at(x + i % kCell, y + i / kCell).g;
            cells.push_back(sum / (255 * kCell * kCell));
        }
    return cells;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(std::max(aa * bb, 1e-12));
}

}  // namespace

TEST_CASE("how much of the drawing is seen while a slider is dragged, on an idle and on a busy machine") {
    draw_in_software();
    std::puts(
        "| Dots | Busy programs | Frames looked at | Correlation: mean, worst | Light: mean, furthest off | "
        "Whole after | Longest frame |\n|---|---|---|---|---|---|---|");
    for (const std::uint64_t count : {40'000, 1'000'000})
        for (const int busy : {0, 2, 6}) {
            Display display;
            RunningViewer viewer;
            const Person person{viewer};
            person.type_dots(count);
            person.rest();
            const std::vector<double> whole = cells_on_screen();
            std::vector<ChildProcess> loops;
            for (int i = 0; i < busy; ++i)
                loops.emplace_back(std::vector<std::string>{"sh", "-c", "while :; do :; done"});
            viewer.point_at("Brightness", 0.5);
            viewer.press();
            // To and fro by little, so that the drawing is about the same all the time.
            std::string way = "sleep 0.1";
            for (int i = 0; i < 100; ++i)
                way += std::string(" mousemove_relative -- ") + (i % 4 < 2 ? "2" : "-2") + " 0 sleep 0.04";
            ChildProcess hand({"sh", "-c", "xdotool " + way});
            double worst = 1, furthest = 0, sum = 0, light = 0;
            int frames = 0;
            for (; !hand.has_ended(); ++frames) {
                const std::vector<double> now = cells_on_screen();
                const double alike = correlation(now, whole), off = mean_of(now) - mean_of(whole);
                worst = std::min(worst, alike);
                sum += alike;
                light += off;
                if (std::abs(off) > std::abs(furthest)) furthest = off;
            }
            viewer.release();
            const auto begin = std::chrono::steady_clock::now();
            viewer.shows([&] {
                return !viewer.status().value("preview", false) &&
                       viewer.status()["steps"] == viewer.status()["all_steps"];
            });
            const std::chrono::duration<double> rested = std::chrono::steady_clock::now() - begin;
            std::printf("| %d | %d | %d | %.3f, %.3f | %+.3f, %+.3f | %.1f s | %.0f ms |\n",
                        static_cast<int>(viewer.dots()), busy, frames, sum / frames, worst, light / frames,
                        furthest, rested.count(), viewer.status()["longest_frame_ms"].get<double>());
            std::fflush(stdout);
        }
}

}  // namespace dapple
