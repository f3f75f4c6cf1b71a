#include "app/viewer/light_viewer.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/files/environment.h"
#include "app/viewer/light_scene.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/status_log.h"
#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"
#include "app/viewer/window.h"
#include "core/image/sky.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr float kPanelWidth = 340;
constexpr int kFramesAfterEvent = 3;
constexpr double kStopsAPress = 0.5;

class LightViewer {
 public:
    explicit LightViewer(const LightViewerOptions& options)
        : settings_(options.settings), log_status_(options.log_status), window_("Dapple"), name_("Sky") {
        ImGui::GetIO().UserData = &widgets_;
        if (options.map)
            open(*options.map);
        else
            reading_ = std::async(std::launch::async, [] { return made(sky_map()); });
    }

    int run() {
        int frames_left = kFramesAfterEvent;
        while (!window_.should_close()) {
            window_.wait_for_events(frames_left > 0 ? 0 : 60);
            if (frames_left <= 0) frames_left = kFramesAfterEvent;
            frame();
            --frames_left;
            const ImGuiIO& io = ImGui::GetIO();
            if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseDown[0])
                frames_left = kFramesAfterEvent;
        }
        return 0;
    }

 private:
    // Wakes the window's loop when it is done, well or badly.
    struct Waker {
        ~Waker() { Window::wake(); }
    };

    static std::unique_ptr<LitMap> made(EnvironmentMap map) {
        const Waker waker;
        return std::make_unique<LitMap>(std::move(map));
    }

    void open(const fs::path& path) {
        if (reading_.valid()) reading_.wait();
        name_ = path.filename().string();
        reading_ = std::async(std::launch::async, [path] {
            const Waker waker;
            return made(read_environment(path));
        });
    }

    void take_map() {
        // The wake may come before the future is ready, so look again soon.
        if (!reading_.valid()) return;
        const auto patience = std::chrono::milliseconds(20);
        if (reading_.wait_for(patience) != std::future_status::ready) return;
        try {
            scene_ = std::make_unique<LightScene>(reading_.get(), &Window::wake);
            window_.set_title(name_ + " - Dapple");
            banner_ = {};
        } catch (const std::exception& error) {
            if (!scene_) throw;
            banner_ = {BannerKind::error, error.what()};
        }
    }

    void press_keys() {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantTextInput) return;
        for (const ImWchar letter : io.InputQueueCharacters) {
            if (letter == 'e') settings_.stops += kStopsAPress;
            if (letter == 'E') settings_.stops -= kStopsAPress;
        }
        for (const Action action : pressed_actions()) {
            if (action == Action::full_screen) window_.toggle_full_screen();
            if (action == Action::quit) window_.close();
        }
    }

    void frame() {
        window_.begin_frame();
        widgets_.clear();
        for (const fs::path& path : window_.take_dropped()) open(path);
        take_map();
        press_keys();

        const float scale = ImGui::GetFontSize() / 15;
        const glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
        const float panel = std::min(kPanelWidth * scale, screen.x * 0.6f);
        draw_canvas({screen.x - panel, screen.y});
        draw_panel({screen.x - panel, 0}, {panel, screen.y});
        draw_banner(banner_, {0, 0}, {screen.x - panel, screen.y});
        window_.end_frame();
        report_outside();
    }

    void report_outside() {
        if (!scene_ || scene_->samplings() == 0) return;
        if (!std::exchange(ready_, true)) std::puts("ready");
        if (log_status_) {
            const ImGuiIO& io = ImGui::GetIO();
            const MouseFacts mouse{{io.MousePos.x, io.MousePos.y}, io.MouseDown[ImGuiMouseButton_Left]};
            std::string line = light_status_json({.samples = scene_->samples(),
                                                  .samplings = scene_->samplings(),
                                                  .sampling = scene_->sampling(),
                                                  .stops = settings_.stops,
                                                  .difference = scene_->facts().difference},
                                                 mouse, widgets_);
            if (line != logged_) std::puts(line.c_str());
            logged_ = std::move(line);
        }
        std::fflush(stdout);
    }

    static constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                               ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                               ImGuiWindowFlags_NoBringToFrontOnFocus;

    void draw_canvas(glm::vec2 size) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({size.x, size.y});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
        ImGui::PushStyleColor(ImGuiCol_WindowBg, colour_of(ThemeColour::surround));
        ImGui::Begin("##canvas", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
        if (scene_) {
            if (std::string error = scene_->update(settings_); !error.empty())
                banner_ = {BannerKind::error, std::move(error)};
            scene_->show({0, 0}, size, settings_);
        } else {
            ImGui::TextUnformatted("Reading the map...");
        }
        ImGui::End();
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
    }

    void draw_panel(glm::vec2 corner, glm::vec2 size) {
        ImGui::SetNextWindowPos({corner.x, corner.y});
        ImGui::SetNextWindowSize({size.x, size.y});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
        ImGui::Begin("##panels", nullptr, kFixed);
        push_title_font();
        ImGui::TextUnformatted(name_.c_str());
        pop_title_font();
        if (scene_) {
            const EnvironmentMap& map = scene_->map();
            hint((std::to_string(map.width()) + " x " + std::to_string(map.height()) + " pixels").c_str());
        }
        std::optional<LightsFacts> facts;
        if (scene_ && scene_->samplings() > 0) facts = scene_->facts();
        draw_lights_panel(settings_, facts);
        ImGui::End();
        ImGui::PopStyleVar();
    }

    LightsSettings settings_;
    bool log_status_;
    WidgetPlaces widgets_;
    Window window_;
    std::string name_;
    std::future<std::unique_ptr<LitMap>> reading_;
    std::unique_ptr<LightScene> scene_;
    Banner banner_;
    std::string logged_;
    bool ready_ = false;
};

}  // namespace

int run_light_viewer(const LightViewerOptions& options) {
    return LightViewer(options).run();
}

}  // namespace dapple
