#include "app/viewer/shell/shell.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/files/tile_library.h"
#include "app/viewer/model/tile_choices.h"
#include "app/viewer/panels/about_panel.h"
#include "app/viewer/panels/help_panel.h"

namespace dapple {
namespace {

// ImGui answers an event over a few frames.
constexpr int kFramesAfterEvent = 3;
constexpr float kPanelWidth = 340;     // at 96 dpi
constexpr double kCursorBlinks = 0.3;  // seconds

bool input_arrived() {
    const ImGuiIO& io = ImGui::GetIO();
    bool arrived = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
        arrived |= io.MouseClicked[button] || io.MouseReleased[button];
    return arrived;
}

void toggle(bool& value) {
    value = !value;
}

}  // namespace

Shell::Shell(bool log_status) : log_status_(log_status), window_("Dapple") {
    ImGui::GetIO().UserData = &widgets_;
}

int Shell::run(std::unique_ptr<Document> document) {
    int frames_left = kFramesAfterEvent;
    while (!window_.should_close()) {
        double rest = frames_left > 0 ? 0 : document->seconds_to_next_frame();
        if (ImGui::GetIO().WantTextInput) rest = std::min(rest, kCursorBlinks);
        if (window_.wait_for_events(rest)) frames_left = kFramesAfterEvent;
        const auto begin = std::chrono::steady_clock::now();
        const bool was_ready = ready_;  // the first frame makes everything ready
        frame(*document);
        if (auto successor = document->take_successor()) document = std::move(successor);
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
        last_seconds_ = passed.count() / 1e3;
        if (was_ready) health_.longest_frame_ms = std::max(health_.longest_frame_ms, passed.count());
        frames_left = input_arrived() || window_.input_waits() ? kFramesAfterEvent : frames_left - 1;
    }
    return 0;
}

void Shell::frame(Document& document) {
    window_.begin_frame();
    widgets_.clear();
    const float scale = ImGui::GetFontSize() / 15;
    const glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
    const float panels = panels_shown_ ? std::min(kPanelWidth * scale, screen.x * 0.6f) : 0;
    std::function<void(Action)> do_this;
    const Frame frame{.window = window_,
                      .canvas = {std::max(screen.x - panels, 1.0f), std::max(screen.y, 1.0f)},
                      .panels = {panels, screen.y},
                      .pixels_per_point = window_.pixels_per_point(),
                      .act = do_this,
                      .last_seconds = last_seconds_};
    do_this = [&](Action action) { act(action, document, frame); };
    for (const auto& path : window_.take_dropped()) document.take_dropped(path);
    for (Action action : pressed_actions()) do_this(action);
    draw_dialogs(document, do_this);
    document.draw(frame);
    window_.end_frame();
    report_outside(document);
}

void Shell::act(Action action, Document& document, const Frame& frame) {
    switch (action) {
        case Action::open:
            asked_ = Asked::picture;
            return dialog_.ask_what_to_open(document.what_to_open());
        case Action::open_tile:
            asked_ = Asked::tile;
            return dialog_.ask_what_to_open({"Open a tile", {kTileEnding}, folder_of_tiles(document.tile())});
        case Action::save:
            if (const auto question = document.where_to_save(); question && !question->own_file.empty())
                return document.save(question->own_file);
            return ask_where_to_save(document.where_to_save(), Asked::drawing);
        case Action::save_as:
            return ask_where_to_save(document.where_to_save(), Asked::drawing);
        case Action::save_project:
            return ask_where_to_save(document.where_to_save_project(), Asked::project);
        case Action::toggle_panels:
            return toggle(panels_shown_);
        case Action::full_screen:
            return window_.toggle_full_screen();
        case Action::help:
            return toggle(help_shown_);
        case Action::palette:
            return palette_.toggle();
        case Action::preferences:
            return toggle(preferences_shown_);
        case Action::about:
            return toggle(about_shown_);
        case Action::quit:
            return window_.close();
        default:
            return document.act(action, frame);
    }
}

void Shell::ask_where_to_save(std::optional<SaveQuestion> question, Asked asked) {
    if (!question) return;
    asked_ = asked;
    dialog_.ask_where_to_save(std::move(*question));
}

void Shell::draw_dialogs(Document& document, const std::function<void(Action)>& act) {
    palette_.draw(document.shortcuts(), act);
    draw_help_panel(help_shown_, document.shortcuts());
    draw_about_panel(about_shown_);
    if (draw_preferences_panel(preferences_shown_, appearance_)) window_.set_appearance(appearance_);
    const auto path = dialog_.draw([&](std::size_t format) { document.draw_saving_options(format); });
    if (!path) return;
    switch (asked_) {
        case Asked::picture:
            return document.open(*path);
        case Asked::tile:
            return document.open_tile(*path);
        case Asked::drawing:
            return document.save(*path);
        case Asked::project:
            return document.save_project(*path);
    }
}

void Shell::report_outside(const Document& document) {
    std::optional<nlohmann::ordered_json> status = document.status();
    if (!status) return;
    if (!std::exchange(ready_, true)) std::puts("ready");
    if (log_status_) {
        health_.gl_errors += Window::gl_errors();
        const ImGuiIO& io = ImGui::GetIO();
        add_input(*status, {{io.MousePos.x, io.MousePos.y}, io.MouseDown[ImGuiMouseButton_Left]}, health_,
                  widgets_);
        std::string line = status->dump();
        if (line != logged_) std::puts(line.c_str());
        logged_ = std::move(line);
    }
    std::fflush(stdout);
}

}  // namespace dapple
