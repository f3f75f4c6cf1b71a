#include "app/viewer/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "app/viewer/actions.h"
#include "app/viewer/canvas.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/pane_view.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/panels/help_panel.h"
#include "app/viewer/panels/saving_banner.h"
#include "app/viewer/panels/status_line.h"
#include "app/viewer/session.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/side_panel.h"
#include "app/viewer/spectrum_view.h"
#include "app/viewer/status_log.h"
#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"
#include "app/viewer/window.h"

namespace dapple {
namespace {

// ImGui answers an event over a few frames.
constexpr int kFramesAfterEvent = 3;
constexpr float kPanelWidth = 340, kStatusHeight = 30;

bool input_arrived() {
    const ImGuiIO& io = ImGui::GetIO();
    bool arrived = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
        arrived |= io.MouseClicked[button] || io.MouseReleased[button];
    return arrived;
}

class Viewer {
 public:
    explicit Viewer(const ViewerOptions& options);
    int run();

 private:
    struct Layout {
        CanvasPlace canvas;
        glm::vec2 panel, status;  // sizes; the panel is to the right, the status line below the canvas
    };

    void frame();
    Layout layout() const;
    Zoom zoom() const { return {session_.settings.zoom_mode, canvas_.camera(), canvas_.enlargement()}; }
    void draw_dialogs();
    void draw_over_canvas(const CanvasPlace& place);
    void show_news();
    StatusFacts status() const;
    void measure_dots();
    void report_outside();

    ViewerOptions options_;
    WidgetPlaces widgets_;
    Window window_;
    Canvas canvas_;
    Session session_;
    SpectrumView spectrum_;
    SidePanel side_panel_;
    Shown shown_;
    FrameRate frame_rate_;

    int pictures_shown_ = 0;
    std::uint64_t version_shown_ = 0;
    DotColoursKey coloured_;
    bool ready_ = false;
    std::string logged_;
};

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      window_("Dapple"),
      session_(options.settings, &Window::wake),
      spectrum_(&Window::wake) {
    ImGui::GetIO().UserData = &widgets_;
    if (options.image)
        session_.open(*options.image);
    else
        session_.open_sample();
}

Viewer::Layout Viewer::layout() const {
    const float scale = ImGui::GetFontSize() / 15;
    const glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
    const glm::vec2 panel{shown_.panels ? std::min(kPanelWidth * scale, screen.x * 0.6f) : 0, screen.y};
    const float status = shown_.panels ? kStatusHeight * scale : 0;
    const glm::vec2 canvas{screen.x - panel.x, screen.y - status};
    return {{{0, 0}, canvas, window_.pixels_per_point()}, panel, {canvas.x, status}};
}

void Viewer::frame() {
    window_.begin_frame();
    widgets_.clear();
    frame_rate_.frame(FrameRate::Clock::now());
    const auto do_this = [this](Action action) { act(action, {session_, canvas_, window_, shown_}); };
    for (const auto& path : window_.take_dropped()) session_.open(path);
    for (Action action : pressed_actions()) do_this(action);
    session_.take_news(std::chrono::milliseconds(0));
    show_news();

    const auto [place, panel, status_size] = layout();
    if (shown_.panels) side_panel_.draw(session_, spectrum_, do_this, {place.size.x, 0}, panel);
    draw_dialogs();
    session_.remember(ImGui::IsAnyItemActive());
    session_.order_dots(zoom());
    show_news();
    if (shown_.panels) draw_status_line({0, place.size.y}, status_size, status());
    draw_over_canvas(place);
    canvas_.handle_mouse(place);
    const float pixel_scale = ImGui::GetFontSize() / 15 * static_cast<float>(place.pixels_per_point.x);
    canvas_.show(place, look_of(session_, session_.pane(), zoom(), pixel_scale),
                 session_.settings.every_frame ? Redraw::always : Redraw::when_changed);
    measure_dots();
    window_.end_frame();
    report_outside();
}

void Viewer::draw_dialogs() {
    draw_help_panel(shown_.help);
    const auto purpose = shown_.dialog.purpose();
    if (const auto path = shown_.dialog.draw()) {
        if (purpose == FileDialog::Purpose::open_picture)
            session_.open(*path);
        else
            session_.save(*path);
    }
}

void Viewer::draw_over_canvas(const CanvasPlace& place) {
    draw_banner(session_.banner, place.corner, place.size);
    Worker& worker = session_.pane().worker();
    if (const auto saving = worker.saving())
        if (draw_saving_banner(saving->path.filename().string(), saving->share, place.corner, place.size))
            worker.cancel_saving();
}

void Viewer::show_news() {
    if (pictures_shown_ != session_.pictures()) {
        pictures_shown_ = session_.pictures();
        canvas_.set_picture(session_.picture().preview);
        canvas_.fit();
        window_.set_title(session_.picture().name + " - Dapple");
    }
    const Pane& pane = session_.pane();
    if (std::exchange(version_shown_, pane.version()) != pane.version()) canvas_.set_drawing(pane.shown());
    const DotColoursKey colours = colours_key(session_, pane);
    if (std::exchange(coloured_, colours) != colours) canvas_.set_dot_colours(colours_of(session_, pane));
}

StatusFacts Viewer::status() const {
    const Pane& pane = session_.pane();
    const Stippling& stippling = pane.shown().stippling;
    return {.dots = stippling.dots.size(),
            .duplicates = stippling.duplicates,
            .figure8 = session_.settings.drawing.stipple.placer == PlacerKind::figure8,
            .scale = stippling.scale,
            .tone_ms = pane.shows_close() ? 0 : pane.page().tone_ms,
            .place_ms = stippling.place_ms,
            .draw_ms = canvas_.draw_ms(),
            .frames_per_second = frame_rate_.per_second(),
            .zoom = canvas_.camera().pixels_per_unit / session_.picture().longer_side};
}

void Viewer::measure_dots() {
    if (!session_.placed_once()) return;
    const Pane& pane = session_.pane();
    spectrum_.update({pane.placings(), canvas_.camera()}, [&] {
        return ViewAnalysisRequest{.view = points_on_screen(pane.shown(), canvas_.camera()),
                                   .tile_size = std::max<std::size_t>(session_.tile().points.size(), 1),
                                   .has_duplicates = pane.page().stippling.duplicates > 0};
    });
}

void Viewer::report_outside() {
    if (!session_.placed_once()) return;
    if (!ready_) std::puts("ready");
    if (options_.log_status) {
        const ImGuiIO& io = ImGui::GetIO();
        const MouseFacts mouse{{io.MousePos.x, io.MousePos.y}, io.MouseDown[ImGuiMouseButton_Left]};
        std::string line = status_json(status(), session_.pane().placings(), mouse, widgets_);
        if (line != logged_) std::puts(line.c_str());
        logged_ = std::move(line);
    }
    std::fflush(stdout);
    ready_ = true;
}

int Viewer::run() {
    int frames_left = kFramesAfterEvent;
    while (!window_.should_close()) {
        bool restless = frames_left > 0 || session_.settings.every_frame || canvas_.measuring();
        double rest = ImGui::GetIO().WantTextInput ? 0.3 : 60;
        window_.wait_for_events(restless ? 0 : rest);
        if (!restless) frames_left = kFramesAfterEvent;
        frame();
        frames_left = input_arrived() ? kFramesAfterEvent : frames_left - 1;
    }
    return 0;
}

}  // namespace

int run_viewer(const ViewerOptions& options) {
    return Viewer(options).run();
}

}  // namespace dapple
