#include "app/viewer/light_viewer.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "app/files/tile_library.h"
#include "app/viewer/light_session.h"
#include "app/viewer/map_camera.h"
#include "app/viewer/panels/action_buttons.h"
#include "app/viewer/panels/file_dialog.h"
#include "app/viewer/panels/help_panel.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/status_log.h"
#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"
#include "app/viewer/window.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr float kPanelWidth = 340;
constexpr int kFramesAfterEvent = 3;
constexpr double kStopsAPress = 0.5;
constexpr double kCursorBlinks = 0.3, kLooksForMap = 0.25;  // seconds
// How far one can zoom in: to pixels of the map that are so many of ImGui's points, and so often enlarged.
constexpr double kLargestPixel = 32, kLeastLargest = 4;

class LightViewer {
 public:
    explicit LightViewer(const LightViewerOptions& options)
        : log_status_(options.log_status), window_("Dapple"), session_(options.settings) {
        ImGui::GetIO().UserData = &widgets_;
        if (options.map)
            session_.open(*options.map);
        else
            session_.open_sky();
    }

    int run() {
        int frames_left = kFramesAfterEvent;
        while (!window_.should_close()) {
            double rest = rest_of(session_.banner);
            if (ImGui::GetIO().WantTextInput) rest = std::min(rest, kCursorBlinks);
            if (session_.reading()) rest = std::min(rest, kLooksForMap);
            if (window_.wait_for_events(frames_left > 0 ? 0 : rest)) frames_left = kFramesAfterEvent;
            const auto begin = std::chrono::steady_clock::now();
            const bool was_ready = ready_;  // the first frame makes everything ready
            frame();
            const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
            if (was_ready) health_.longest_frame_ms = std::max(health_.longest_frame_ms, passed.count());
            --frames_left;
            const ImGuiIO& io = ImGui::GetIO();
            if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || window_.input_waits())
                frames_left = kFramesAfterEvent;
        }
        return 0;
    }

 private:
    void frame() {
        window_.begin_frame();
        widgets_.clear();
        for (const fs::path& path : window_.take_dropped()) session_.take_dropped(path);
        for (const Action action : pressed_actions()) act(action);
        session_.take_news();

        const float scale = ImGui::GetFontSize() / 15;
        const glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
        const float panel = panel_shown_ ? std::min(kPanelWidth * scale, screen.x * 0.6f) : 0;
        const glm::vec2 canvas{std::max(screen.x - panel, 1.0f), std::max(screen.y, 1.0f)};
        if (panel_shown_) draw_panel({canvas.x, 0}, {panel, screen.y});
        draw_dialogs();
        draw_banner(session_.banner, {0, 0}, canvas);
        session_.remember(ImGui::IsAnyItemActive());
        show_canvas(canvas);
        window_.end_frame();
        report_outside();
    }

    void act(Action action) {
        switch (action) {
            case Action::open:
                asks_for_tile_ = false;
                return dialog_.ask_what_to_open({"Open an environment map", {".hdr", ".exr"}, map_folder()});
            case Action::open_tile:
                asks_for_tile_ = true;
                return dialog_.ask_what_to_open(
                    {"Open a tile", {kTileEnding}, folder_of_tiles(session_.settings.tile)});
            case Action::save:
                if (session_.saved_path().empty()) return ask_where_to_save();
                return session_.save(session_.saved_path());
            case Action::save_as:
                return ask_where_to_save();
            case Action::undo:
                return session_.undo();
            case Action::redo:
                return session_.redo();
            case Action::fit:
                camera_ = fitted_to_map(camera_.canvas);
                return;
            case Action::one_to_one:
                if (session_.scene()) zoom_to(session_.scene()->map().width() / window_.pixels_per_point().x);
                return;
            case Action::zoom_in:
                return zoom_to(camera_.pixels_per_unit * 1.25);
            case Action::zoom_out:
                return zoom_to(camera_.pixels_per_unit * 0.8);
            case Action::lighter:
                session_.settings.stops += kStopsAPress;
                return;
            case Action::darker:
                session_.settings.stops -= kStopsAPress;
                return;
            case Action::toggle_panels:
                panel_shown_ = !panel_shown_;
                return;
            case Action::full_screen:
                return window_.toggle_full_screen();
            case Action::help:
                help_ = !help_;
                return;
            case Action::quit:
                return window_.close();
            case Action::toggle_tiles:
            case Action::compare:
            case Action::loupe:
            case Action::photograph:
                return;  // of drawings
        }
    }

    fs::path map_folder() const {
        return session_.map_path().empty() ? fs::current_path() : session_.map_path();
    }

    void ask_where_to_save() {
        if (!session_.scene()) return;
        const fs::path name = fs::path(session_.name()).stem().concat(".json");
        const fs::path& saved = session_.saved_path();
        // In the order of LightFile.
        dialog_.ask_where_to_save({.title = "Export the samples",
                                   .formats = {{"JSON", ".json"},
                                               {"CSV", ".csv"},
                                               {"pbrt", ".pbrt"},
                                               {"Mitsuba", ".xml"},
                                               {"PNG", ".png"}},
                                   .start = saved.empty() ? fs::current_path() / name : saved,
                                   .own_file = saved,
                                   .option_rows = kLightExportRows});
    }

    void draw_dialogs() {
        draw_help_panel(help_, light_shortcuts());
        const auto options = [this](std::size_t format) {
            draw_light_export_panel(session_.settings, static_cast<LightFile>(format));
        };
        if (const auto path = dialog_.draw(options)) {
            if (dialog_.saves())
                session_.save(*path);
            else if (asks_for_tile_)
                session_.open_tile(*path);
            else
                session_.open(*path);
        }
    }

    void zoom_to(double pixels_per_unit) {
        camera_ = zoomed_at(camera_, camera_.canvas / 2.0, pixels_per_unit / camera_.pixels_per_unit);
    }

    void show_canvas(glm::vec2 size) {
        const LightScene* const scene = session_.scene();
        if (!scene) {
            ImGui::GetBackgroundDrawList()->AddText({16, 16}, colour_of(ThemeColour::quiet),
                                                    "Reading the map...");
            return;
        }
        const LightLayout layout = light_layout({0, 0}, size);
        if (std::exchange(map_fitted_, session_.maps_shown()) != session_.maps_shown()) {
            camera_ = fitted_to_map(layout.map.size);
            window_.set_title(session_.name() + " - Dapple");
        }
        camera_ = resized_on_map(camera_, layout.map.size);
        mouse_.move(camera_, layout.map);
        camera_ = kept_on_map(
            camera_, std::max(kLargestPixel * scene->map().width(), kLeastLargest * camera_.canvas.x));
        widgets_["Map"] = {layout.map.corner, layout.map.corner + layout.map.size};
        if (window_.frame_is_unseen()) return;
        scene->show(layout, camera_, session_.settings);
    }

    void report_outside() {
        const LightScene* const scene = session_.scene();
        if (!scene || scene->samplings() == 0) return;
        if (!std::exchange(ready_, true)) std::puts("ready");
        if (log_status_) {
            health_.gl_errors += Window::gl_errors();
            const ImGuiIO& io = ImGui::GetIO();
            const MouseFacts mouse{{io.MousePos.x, io.MousePos.y}, io.MouseDown[ImGuiMouseButton_Left]};
            std::string line = light_status_json({.samples = scene->samples(),
                                                  .samplings = scene->samplings(),
                                                  .sampling = scene->sampling(),
                                                  .stops = session_.settings.stops,
                                                  .difference = scene->facts().difference,
                                                  .zoom = camera_.pixels_per_unit / camera_.canvas.x,
                                                  .saving = session_.saving()},
                                                 mouse, health_, widgets_);
            if (line != logged_) std::puts(line.c_str());
            logged_ = std::move(line);
        }
        std::fflush(stdout);
    }

    static constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                               ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                               ImGuiWindowFlags_NoBringToFrontOnFocus;

    void draw_panel(glm::vec2 corner, glm::vec2 size) {
        ImGui::SetNextWindowPos({corner.x, corner.y});
        ImGui::SetNextWindowSize({std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
        ImGui::Begin("##panels", nullptr, kNeverAsksForFocus | ImGuiWindowFlags_NoNavInputs | kFixed);
        const LightScene* const scene = session_.scene();
        push_title_font();
        ImGui::TextUnformatted(session_.name().c_str());
        pop_title_font();
        if (scene) {
            const EnvironmentMap& map = scene->map();
            hint((std::to_string(map.width()) + " x " + std::to_string(map.height()) + " pixels").c_str());
        }
        ImGui::Dummy({0, 0});
        draw_action_buttons([this](Action action) { act(action); });
        std::optional<LightsFacts> facts;
        if (scene && scene->samplings() > 0) facts = scene->facts();
        draw_lights_panel(session_.settings, facts, {session_.tiles(), [this] { act(Action::open_tile); }});
        ImGui::End();
        ImGui::PopStyleVar();
    }

    bool log_status_;
    WidgetPlaces widgets_;
    Window window_;
    LightSession session_;
    Camera camera_;
    CameraMouse mouse_;
    int map_fitted_ = 0;  // the number of the map that the camera was fitted to
    FileDialog dialog_;
    bool asks_for_tile_ = false;
    bool help_ = false, panel_shown_ = true;
    std::string logged_;
    HealthFacts health_;
    bool ready_ = false;
};

}  // namespace

int run_light_viewer(const LightViewerOptions& options) {
    load_tile(options.settings.tile);
    return LightViewer(options).run();
}

}  // namespace dapple
