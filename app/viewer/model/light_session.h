#pragma once
// What the window of an environment map is about: a map, the settings, the samples taken with them, and what
// is saved of them.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/viewer/model/background.h"
#include "app/viewer/model/banner.h"
#include "app/viewer/model/history.h"
#include "app/viewer/model/lit_map.h"
#include "app/viewer/model/tile_choices.h"

namespace dapple {

class LightSession {
 public:
    /// `wake` is called from other threads whenever there is an event.
    LightSession(const LightsSettings& first, std::function<void()> wake);

    /// Reads a map in the background; the one shown stays until then, or if it fails. Of several that are
    /// opened meanwhile the last one counts.
    void open(const std::filesystem::path& map);
    void open_sky();

    /// As Session's.
    void open_tile(const std::filesystem::path& file);
    void take_dropped(const std::filesystem::path& file);
    std::span<const std::string> tiles() const { return tiles_.names(); }

    /// Writes the samples that the settings ask for, in the background; the name's ending says as what. One
    /// file at a time.
    void save(const std::filesystem::path& file);
    bool saving() const { return saving_.busy(); }

    /// Takes what was read, sampled or saved since the last call, and has samples taken anew where the
    /// settings ask for it. Throws what reading threw if there is no map yet.
    void take_events();

    /// Keeps the settings for undo, once nothing is being edited.
    void remember(bool editing) { history_.observe(settings, editing); }
    void undo() { settings = history_.undo(); }
    void redo() { settings = history_.redo(); }
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }

    /// None until the first map is there.
    const LitMap* lit() const { return lit_.get(); }
    const std::string& name() const { return name_; }  // "hall.hdr"
    const std::filesystem::path& map_path() const { return map_path_; }
    /// How many maps were opened.
    int maps() const { return maps_; }

    /// Of this map; those of earlier settings until newer ones are there.
    const SampledMap& samples() const { return samples_; }
    /// How many times samples were taken.
    std::uint64_t samplings() const { return samplings_; }
    /// They are being taken anew.
    bool sampling() const { return sampling_.busy(); }

    /// Where the samples were saved last; empty: nowhere.
    const std::filesystem::path& saved_path() const { return saved_path_; }

    LightsSettings settings;
    Banner banner;

 private:
    struct ReadMap {
        std::filesystem::path path;  // empty: the sky
        std::shared_ptr<const LitMap> lit;
    };

    void read_next();
    void take_map();
    void take_samples();
    void take_saved();

    std::shared_ptr<const LitMap> lit_;  // what is sampled or saved in the background keeps it too
    std::string name_;
    std::filesystem::path map_path_, saved_path_;
    int maps_ = 0;
    std::optional<std::filesystem::path> to_read_;
    std::optional<LightsSettings> sampled_with_;  // none: nothing of this map
    SampledMap samples_;
    std::uint64_t samplings_ = 0;
    History<LightsSettings> history_;
    TileChoices tiles_;
    Background<ReadMap> reading_;
    Background<SampledMap> sampling_;
    Background<std::filesystem::path> saving_;
};

}  // namespace dapple
