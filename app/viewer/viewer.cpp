#include "app/viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "app/files/tile_library.h"
#include "app/viewer/actions.h"
#include "app/viewer/canvas.h"
#include "app/viewer/dot_limit.h"
#include "app/viewer/export_estimate.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/loupe.h"
#include "app/viewer/pane_view.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/panels/export_panel.h"
#include "app/viewer/panels/help_panel.h"
#include "app/viewer/panels/saving_banner.h"
#include "app/viewer/panels/side_captions.h"
#include "app/viewer/panels/status_line.h"
#include "app/viewer/repetition_meter.h"
#include "app/viewer/session.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/side_panel.h"
#include "app/viewer/spectrum_view.h"
#include "app/viewer/split_divider.h"
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
        // Sizes: the panel is to the right; below the canvas are the captions and then the status line.
        glm::vec2 panel, captions, status;
    };

    void frame();
    Layout layout() const;
    Zoom zoom() const { return {session_.settings.zoom_mode, canvas_.camera(), canvas_.enlargement()}; }
    void draw_dialogs();
    void draw_over_canvas(const CanvasPlace& place);
    void draw_split(const CanvasPlace& place);
    void draw_loupe(const CanvasPlace& place);
    SplitLook look(const CanvasPlace& place) const;
    /// Both sides are measured by the smaller tile, so that they compare.
    std::size_t compared_tile_size() const;
    SideCaption caption(const Pane& pane, const RepetitionMeter& meter) const;
    void show_news();
    void show_news(Side side, const Pane* pane);
    StatusFacts status() const;
    double placing_seconds() const;
    double longest_rest() const;
    std::optional<StatusFacts::RightSide> right_status() const;
    void measure_dots();
    ViewAnalysisRequest dots_on_screen(const Pane& pane, std::size_t tile_size) const;
    void report_outside();

    ViewerOptions options_;
    WidgetPlaces widgets_;
    Window window_;
    Canvas canvas_;
    Session session_;
    const PlacedDrawing nothing_{};
    SpectrumView spectrum_;
    RepetitionMeter left_repetition_, right_repetition_;
    SidePanel side_panel_;
    Loupe loupe_;
    Shown shown_;
    FrameRate frame_rate_;
    ExportEstimate estimate_;

    struct SeenSide {
        int pictures = 0;
        std::uint64_t version = 0;
    };
    std::array<SeenSide, 2> seen_;  // by the canvas
    int pictures_titled_ = 0;
    bool ready_ = false;
    std::string logged_;
    HealthFacts health_;
};

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      window_("Dapple"),
      session_(options.settings, &Window::wake, most_dots_in(available_memory())),
      spectrum_(&Window::wake),
      left_repetition_(&Window::wake),
      right_repetition_(&Window::wake) {
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
    const float captions = session_.settings.comparison.on ? side_captions_height() : 0;
    // A window may be smaller than its panels.
    const glm::vec2 canvas =
        glm::max(glm::vec2(screen.x - panel.x, screen.y - status - captions), glm::vec2(1));
    return {{{0, 0}, canvas, window_.pixels_per_point()}, panel, {canvas.x, captions}, {canvas.x, status}};
}

void Viewer::frame() {
    window_.begin_frame();
    widgets_.clear();
    frame_rate_.frame(FrameRate::Clock::now());
    const auto do_this = [this](Action action) { act(action, {session_, canvas_, window_, shown_}); };
    for (const auto& path : window_.take_dropped()) session_.take_dropped(path);
    for (Action action : pressed_actions()) do_this(action);
    if (placing_seconds() > kLongPlacing && !ImGui::GetIO().WantCaptureKeyboard && escape_pressed())
        session_.stop_placing();
    session_.take_news(std::chrono::milliseconds(0));
    show_news();

    const auto [place, panel, captions, status_size] = layout();
    if (shown_.panels) side_panel_.draw(session_, spectrum_, do_this, {place.size.x, 0}, panel);
    draw_dialogs();
    draw_split(place);
    session_.remember(ImGui::IsAnyItemActive());
    session_.order_dots(zoom());
    show_news();
    if (shown_.panels) draw_status_line({0, place.size.y + captions.y}, status_size, status());
    draw_over_canvas(place);
    canvas_.handle_mouse(place);
    const Redraw redraw = window_.frame_is_unseen()       ? Redraw::later
                          : session_.settings.every_frame ? Redraw::always
                                                          : Redraw::when_changed;
    canvas_.show(place, look(place), redraw);
    if (const Pane* right = session_.right())
        draw_side_captions({caption(session_.pane(), left_repetition_), caption(*right, right_repetition_)},
                           session_.settings.comparison.divider, {0, place.size.y}, captions);
    draw_loupe(place);
    measure_dots();
    window_.end_frame();
    report_outside();
}

void Viewer::draw_dialogs() {
    draw_help_panel(shown_.help, shortcuts());
    const auto options = [this](std::size_t format) {
        const auto kind = static_cast<DrawingFormat>(format);
        const Pane& pane = session_.pane();
        draw_export_panel(session_.settings, kind, estimate_.facts(pane, session_.settings, kind));
    };
    if (const auto path = shown_.dialog.draw(options)) {
        if (shown_.dialog.saves())
            session_.save(*path);
        else if (shown_.asks_for_tile)
            session_.open_tile(*path);
        else
            session_.open(*path);
    }
}

void Viewer::draw_over_canvas(const CanvasPlace& place) {
    draw_banner(session_.banner, place.corner, place.size);
    Worker& worker = session_.pane().worker();
    if (const auto saving = worker.saving())
        if (draw_saving_banner(saving->path.filename().string(), saving->share, place.corner, place.size))
            worker.cancel_saving();
}

void Viewer::draw_split(const CanvasPlace& place) {
    Comparison& comparison = session_.settings.comparison;
    if (comparison.on) draw_split_divider(comparison.divider, place);
}

std::size_t Viewer::compared_tile_size() const {
    const std::size_t left = session_.pane().tile_size();
    const Pane* right = session_.right();
    return right ? std::min(left, right->tile_size()) : left;
}

void Viewer::draw_loupe(const CanvasPlace& place) {
    const ViewerSettings& settings = session_.settings;
    if (!settings.loupe.on || !session_.placed_once()) return loupe_.hide();
    const Pane *pane = &session_.pane(), *right = session_.right();
    const float divider = place.corner.x + place.size.x * settings.comparison.divider;
    const bool on_right = right && ImGui::GetIO().MousePos.x >= divider;
    const std::size_t size = compared_tile_size();
    if (on_right) pane = right;
    loupe_.draw({.shown = pane->shown(),
                 .side = on_right ? Side::right : Side::left,
                 .version = pane->version(),
                 .tile_size = size,
                 .step = settings.loupe.step,
                 .ink = settings.drawing.ink,
                 .paper = settings.drawing.paper,
                 .mm_per_page_unit = settings.drawing.width_mm / pane->page().page_size.x},
                canvas_.camera(), place);
}

SplitLook Viewer::look(const CanvasPlace& place) const {
    const float pixel_scale = ImGui::GetFontSize() / 15 * static_cast<float>(place.pixels_per_point.x);
    SplitLook look;
    look.sides[0] = look.sides[1] = look_of(session_, session_.pane(), zoom(), pixel_scale);
    if (session_.settings.comparison.on) look.divider = session_.settings.comparison.divider;
    if (const Pane* right = session_.right()) look.sides[1] = look_of(session_, *right, zoom(), pixel_scale);
    if (photograph_key_down()) {
        for (CanvasLook& side : look.sides) {
            side.picture_opacity = 1;
            side.dots = false;
        }
    }
    return look;
}

SideCaption Viewer::caption(const Pane& pane, const RepetitionMeter& meter) const {
    const Stippling& stippling = pane.page().stippling;
    const PlaceOrder order = pane.page_order().value_or(PlaceOrder{});
    SideCaption caption;
    caption.title = drawn_with(order);
    if (&pane == &session_.pane()) caption.title += " - this side is saved";
    caption.facts = {dots_in_words({.dots = stippling.dots.size(),
                                    .duplicates = stippling.duplicates,
                                    .figure8 = order.drawing.stipple.placer == PlacerKind::figure8})};
    if (const auto value = meter.value())
        caption.facts.push_back(fmt::format("periodicity over {}-point tiles {:.2f}", compared_tile_size(),
                                            std::clamp(*value, 0.0, 1.0)));
    return caption;
}

void Viewer::show_news() {
    if (std::exchange(pictures_titled_, session_.pictures()) != session_.pictures()) {
        canvas_.fit();
        window_.set_title(session_.picture().name + " - Dapple");
    }
    show_news(Side::left, session_.placed_once() ? &session_.pane() : nullptr);
    show_news(Side::right, session_.right());
}

void Viewer::show_news(Side side, const Pane* pane) {
    SeenSide& seen = seen_[static_cast<int>(side)];
    const std::uint64_t version = pane ? pane->version() : 0;
    if (pane && std::exchange(seen.pictures, session_.pictures()) != session_.pictures())
        canvas_.set_picture(side, session_.picture().preview);
    if (std::exchange(seen.version, version) != version)
        canvas_.set_drawing(side, pane ? pane->shown() : nothing_);
}

double Viewer::placing_seconds() const {
    std::chrono::duration<double> longest{0};
    for (const Pane* pane : {&session_.pane(), session_.right()}) {
        if (!pane) continue;
        if (const auto since = pane->worker().placing_since())
            longest =
                std::max<std::chrono::duration<double>>(longest, std::chrono::steady_clock::now() - *since);
    }
    return longest.count();
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
            .relax_ms = pane.shown().relax_ms,
            .steps = pane.shown().steps,
            .all_steps = pane.shown().all_steps,
            .draw_ms = canvas_.draw_ms(),
            .placing_seconds = placing_seconds(),
            .frames_per_second = frame_rate_.per_second(),
            .zoom = canvas_.camera().pixels_per_unit / session_.picture().longer_side,
            .right = right_status(),
            .loupe = loupe_.facts()};
}

std::optional<StatusFacts::RightSide> Viewer::right_status() const {
    const Pane* right = session_.right();
    if (!right) return std::nullopt;
    const Stippling& stippling = right->shown().stippling;
    return StatusFacts::RightSide{.dots = stippling.dots.size(),
                                  .duplicates = stippling.duplicates,
                                  .scale = stippling.scale,
                                  .divider = session_.settings.comparison.divider,
                                  .left_repetition = left_repetition_.value(),
                                  .repetition = right_repetition_.value()};
}

ViewAnalysisRequest Viewer::dots_on_screen(const Pane& pane, std::size_t tile_size) const {
    return {.view = points_on_screen(pane.shown(), canvas_.camera()),
            .tile_size = tile_size,
            .has_duplicates = pane.page().stippling.duplicates > 0};
}

void Viewer::measure_dots() {
    if (!session_.placed_once()) return;
    const Pane& pane = session_.pane();
    const Camera& camera = canvas_.camera();
    spectrum_.update({pane.placings(), camera}, [&] { return dots_on_screen(pane, pane.tile_size()); });
    const Pane* right = session_.right();
    if (!right) return;
    const std::size_t size = compared_tile_size();
    left_repetition_.update({pane.placings(), camera}, [&] { return dots_on_screen(pane, size); });
    right_repetition_.update({right->placings(), camera}, [&] { return dots_on_screen(*right, size); });
}

void Viewer::report_outside() {
    if (!session_.placed_once()) return;
    if (!ready_) std::puts("ready");
    if (options_.log_status) {
        health_.gl_errors += Window::gl_errors();
        const ImGuiIO& io = ImGui::GetIO();
        const MouseFacts mouse{{io.MousePos.x, io.MousePos.y}, io.MouseDown[ImGuiMouseButton_Left]};
        std::string line = status_json(status(), session_.pane().placings(), mouse, health_, widgets_);
        if (line != logged_) std::puts(line.c_str());
        logged_ = std::move(line);
    }
    std::fflush(stdout);
    ready_ = true;
}

// Seconds without an event after which a frame is due all the same.
double Viewer::longest_rest() const {
    constexpr double kCursorBlinks = 0.3, kLookForPlacing = 0.25;
    if (ImGui::GetIO().WantTextInput) return kCursorBlinks;
    const double longest = placing_seconds() > 0 ? kLookForPlacing : 60;
    return std::min({longest, rest_of(session_.banner), canvas_.rest().value_or(longest)});
}

int Viewer::run() {
    int frames_left = kFramesAfterEvent;
    while (!window_.should_close()) {
        const bool restless = frames_left > 0 || session_.settings.every_frame || canvas_.drawing();
        const bool happened = window_.wait_for_events(restless ? 0 : longest_rest());
        if (happened) frames_left = kFramesAfterEvent;
        const auto begin = std::chrono::steady_clock::now();
        const bool was_ready = ready_;  // the first frame makes everything ready
        frame();
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
        if (was_ready) health_.longest_frame_ms = std::max(health_.longest_frame_ms, passed.count());
        frames_left = input_arrived() || window_.input_waits() ? kFramesAfterEvent : frames_left - 1;
    }
    return 0;
}

}  // namespace

int run_viewer(const ViewerOptions& options) {
    // Before there is a window: nothing could be drawn in it.
    load_tile(options.settings.tile);
    return Viewer(options).run();
}

}  // namespace dapple
