#include "app/viewer/shell/lights_document.h"

#include <imgui.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "app/viewer/panels/side_panel.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/shell/window.h"
#include "app/viewer/view/camera.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"
#include "io/settings/xdg_folders.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr double kStopsAPress = 0.5;
constexpr double kLookForWork = 0.25;  // seconds
// How far one can zoom in: to pixels of the map that are so many of ImGui's points, and so often enlarged.
constexpr double kLargestPixel = 32, kLeastLargest = 4;

}  // namespace

LightsDocument::LightsDocument(const std::optional<fs::path>& map, const LightsSettings& settings)
    : session_(settings, &Window::wake) {
    session_.open(map.value_or(fs::path()));
}

std::span<const Shortcut> LightsDocument::shortcuts() const {
    return light_shortcuts();
}

OpenQuestion LightsDocument::what_to_open() const {
    const fs::path& path = session_.map_path();
    return {"Open an environment map", {".hdr", ".exr"}, path};
}

std::optional<SaveQuestion> LightsDocument::where_to_save() const {
    if (!session_.lit()) return std::nullopt;
    const fs::path& saved = session_.saved_path();
    const fs::path name = fs::path(session_.name()).stem().concat(".json");
    // In the order of LightFile.
    return SaveQuestion{.title = "Export the samples",
                        .formats = {{"JSON", ".json"},
                                    {"CSV", ".csv"},
                                    {"pbrt", ".pbrt"},
                                    {"Mitsuba", ".xml"},
                                    {"USD", ".usda"},
                                    {"glTF", ".gltf"},
                                    {"Blender", ".py"},
                                    {"PNG", ".png"}},
                        .start = saved.empty() ? working_folder() / name : saved,
                        .own_file = saved,
                        .has_options = true};
}

std::string LightsDocument::draw_saving_options(std::size_t format) {
    draw_light_export_panel(session_.settings, static_cast<LightFile>(format));
    return {};
}

void LightsDocument::act(Action action, const Frame& frame) {
    switch (action) {
        case Action::undo:
            return session_.undo();
        case Action::redo:
            return session_.redo();
        case Action::fit:
            camera_ = fitted_to_map(camera_.canvas);
            return;
        case Action::one_to_one:
            if (const LitMap* lit = session_.lit()) zoom_to(lit->map.width() / frame.pixels_per_point.x);
            return;
        case Action::zoom_in:
            return zoom_to(camera_.pixels_per_unit * 1.25);
        case Action::zoom_out:
            return zoom_to(camera_.pixels_per_unit * 0.8);
        case Action::pan_left:
            return pan({kPanStep, 0});
        case Action::pan_right:
            return pan({-kPanStep, 0});
        case Action::pan_up:
            return pan({0, kPanStep});
        case Action::pan_down:
            return pan({0, -kPanStep});
        case Action::lighter:
            session_.settings.stops += kStopsAPress;
            return;
        case Action::darker:
            session_.settings.stops -= kStopsAPress;
            return;
        default:  // of drawings
            return;
    }
}

void LightsDocument::zoom_to(double pixels_per_unit) {
    camera_ = zoomed_at(camera_, camera_.canvas / 2.0, pixels_per_unit / camera_.pixels_per_unit);
}

void LightsDocument::pan(glm::dvec2 sides) {
    camera_ = dragged(camera_, sides * std::min(camera_.canvas.x, camera_.canvas.y));
}

void LightsDocument::draw(const Frame& frame) {
    session_.take_events();
    if (frame.panels.x > 0) draw_panels(frame);
    draw_banner(session_.banner, {0, 0}, frame.canvas);
    tell_of_work(frame);
    session_.remember(ImGui::IsAnyItemActive());
    show_canvas(frame);
}

void LightsDocument::tell_of_work(const Frame& frame) {
    const std::optional<LongLightWork> long_work = session_.long_work();
    if (!long_work) return;
    const std::string name = long_work->file.filename().string();
    const double share = long_work->share.value_or(0);
    const auto cancelled = [&] {
        switch (long_work->work) {
            case LightWork::reading:
                return draw_opening_banner(name.empty() ? "the sky" : printable(name), {0, 0}, frame.canvas);
            case LightWork::sampling:
                return draw_sampling_banner(share, {0, 0}, frame.canvas);
            case LightWork::saving:
                return draw_saving_banner(name, share, {0, 0}, frame.canvas);
        }
        return false;
    };
    const bool escape = !ImGui::GetIO().WantCaptureKeyboard && escape_pressed();
    if (cancelled() || escape) session_.stop(long_work->work);
}

void LightsDocument::draw_panels(const Frame& frame) {
    std::string size;
    if (const LitMap* lit = session_.lit())
        size = std::to_string(lit->map.width()) + " x " + std::to_string(lit->map.height()) + " pixels";
    const auto whether = [](bool can) { return can ? std::optional<std::string>("") : std::nullopt; };
    begin_side_panel({frame.canvas.x, 0}, frame.panels,
                     {session_.name(), size, {whether(session_.can_undo()), whether(session_.can_redo())}},
                     frame.act);
    if (frame.can_go_back && wide_button("Back to the drawing", "As you left it.")) frame.act(Action::back);
    std::optional<LightsInfo> info;
    if (session_.samples().found) info = session_.samples().info;
    draw_lights_panel(session_.settings, info,
                      {session_.tiles(), [&frame] { frame.act(Action::open_tile); }});
    end_side_panel();
}

void LightsDocument::draw_rows() {
    draw_lights_panel(session_.settings, {}, {session_.tiles()});
}

void LightsDocument::show_canvas(const Frame& frame) {
    const LitMap* const lit = session_.lit();
    if (!lit) {
        ImGui::GetBackgroundDrawList()->AddText({16, 16}, colour_of(ThemeColour::quiet),
                                                "Reading the map...");
        return;
    }
    const LightLayout layout = light_layout({0, 0}, frame.canvas);
    if (std::exchange(map_fitted_, session_.maps()) != session_.maps()) {
        camera_ = fitted_to_map(layout.map.size);
    }
    frame.window.set_title(session_.name() + " - Dapple");
    camera_ = resized_on_map(camera_, layout.map.size);
    mouse_.move(camera_, layout.map);
    camera_ =
        kept_on_map(camera_, std::max(kLargestPixel * lit->map.width(), kLeastLargest * camera_.canvas.x));
    note_place("Map", {layout.map.corner, layout.map.corner + layout.map.size});
    if (frame.window.frame_is_unseen() || !session_.samples().found) return;
    scene_.show(layout, camera_,
                {*lit, session_.samples(), session_.settings, session_.maps(), session_.samplings()});
}

double LightsDocument::seconds_to_next_frame() const {
    const double longest = session_.at_work() ? kLookForWork : 60;
    return std::min<double>(longest, seconds_until_change(session_.banner));
}

std::optional<nlohmann::ordered_json> LightsDocument::status() const {
    if (!session_.samples().found) return std::nullopt;
    return nlohmann::ordered_json{{"samples", session_.samples().places.size()},
                                  {"samplings", session_.samplings()},
                                  {"sampling", session_.sampling()},
                                  {"stops", session_.settings.stops},
                                  {"difference", session_.samples().info.irradiance.mean},
                                  {"zoom", camera_.pixels_per_unit / camera_.canvas.x},
                                  {"saving", session_.saving()}};
}

}  // namespace dapple
