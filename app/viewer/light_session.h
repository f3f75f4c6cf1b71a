#pragma once
// What the window of an environment map shows and edits, apart from how it is drawn.

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/viewer/background.h"
#include "app/viewer/history.h"
#include "app/viewer/light_scene.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/panels/lights_panel.h"
#include "app/viewer/tile_choices.h"

namespace dapple {

class LightSession {
 public:
    explicit LightSession(const LightsSettings& first);

    /// Reads a map in the background; the one shown stays until then, or if it fails.
    void open(const std::filesystem::path& map);
    void open_sky();

    /// As Session's.
    void open_tile(const std::filesystem::path& file);
    void take_dropped(const std::filesystem::path& file);
    std::span<const std::string> tiles() const { return tiles_.names(); }

    /// Writes the samples that the settings ask for, in the background; the name's ending says as what. One
    /// file at a time.
    /// A map is being read; when it is there a wake may come a moment too early.
    bool reading() const { return reading_.valid(); }
    void save(const std::filesystem::path& file);
    bool saving() const { return saving_.busy(); }

    /// Takes what was read, sampled or saved since the last call. Throws what reading threw if there is no
    /// map yet.
    void take_news();

    /// Keeps the settings for undo, once nothing is being edited.
    void remember(bool editing) { history_.observe(settings, editing); }
    void undo() { settings = history_.undo(); }
    void redo() { settings = history_.redo(); }

    /// None until the first map is there.
    const LightScene* scene() const { return scene_.get(); }
    const std::string& name() const { return name_; }  // "hall.hdr"
    const std::filesystem::path& map_path() const { return map_path_; }
    /// Where the samples were saved last; empty: nowhere.
    const std::filesystem::path& saved_path() const { return saved_path_; }
    int maps_shown() const { return maps_shown_; }

    LightsSettings settings;
    Banner banner;

 private:
    using Read = std::future<std::unique_ptr<const LitMap>>;
    struct Saved {
        std::filesystem::path file;
        std::string error;  // why it was not
    };

    void take_map();
    void take_saved();

    std::string name_, name_read_;
    std::filesystem::path map_path_, path_read_, saved_path_;
    Read reading_;
    std::unique_ptr<LightScene> scene_;
    int maps_shown_ = 0;
    History<LightsSettings> history_;
    TileChoices tiles_;
    Background<Saved> saving_;
};

}  // namespace dapple
