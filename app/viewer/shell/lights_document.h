#pragma once
// An environment map in the window: its samples over it, and how well they light a sphere.

#include <optional>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/light_scene.h"
#include "app/viewer/model/light_session.h"
#include "app/viewer/shell/document.h"

namespace dapple {

class LightsDocument : public Document {
 public:
    /// Needs the window to be there. Without a map it shows a sky of our own.
    LightsDocument(const std::optional<std::filesystem::path>& map, const LightsSettings& settings);

    std::span<const Shortcut> shortcuts() const override;
    void open_as_picture(const std::filesystem::path& file) override { session_.open(file); }
    void open_tile(const std::filesystem::path& file) override { session_.open_tile(file); }
    void take_dropped(const std::filesystem::path& file) override { session_.take_dropped(file); }
    void save(const std::filesystem::path& file) override { session_.save(file); }
    std::string saving() const override { return session_.saving() ? "the list of samples" : ""; }
    void stop_saving() override { session_.stop(LightWork::saving); }
    bool tells_of_trouble() const override { return is_trouble(session_.banner); }
    std::filesystem::path file() const override { return session_.lit() ? session_.map_path() : ""; }
    void say(const std::string& sentence) override { session_.banner = {BannerKind::error, sentence}; }
    OpenQuestion what_to_open() const override;
    const std::string& tile() const override { return session_.settings.tile; }
    std::optional<SaveQuestion> where_to_save() const override;
    std::string draw_saving_options(std::size_t format) override;
    void act(Action action, const Frame& frame) override;
    void draw(const Frame& frame) override;
    void draw_rows() override;
    double seconds_to_next_frame() const override;
    /// {"samples": .., "samplings": .., "sampling": .., "stops": .., "difference": .., "zoom": .., "saving":
    /// ..}: samplings since the start, whether another is under way, LightsSettings::stops, the mean error of
    /// the irradiance, how many times larger than fitted the map is, whether a file is being written.
    std::optional<nlohmann::ordered_json> status() const override;

 private:
    void zoom_to(double pixels_per_unit);
    void pan(glm::dvec2 sides);  // so many of the canvas's shorter side
    void draw_panels(const Frame& frame);
    void show_canvas(const Frame& frame);
    /// Work that takes long, and whether it is given up.
    void tell_of_work(const Frame& frame);

    LightSession session_;
    LightScene scene_;
    Camera camera_;
    CameraMouse mouse_;
    int map_fitted_ = 0;  // the number of the map that the camera was fitted to
};

}  // namespace dapple
