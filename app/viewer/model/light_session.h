#pragma once
// What the window of an environment map is about: a map, the settings, the samples taken with them, and what
// is saved of them.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "app/viewer/background/background.h"
#include "app/viewer/model/banner.h"
#include "app/viewer/model/history.h"
#include "app/viewer/model/lit_map.h"
#include "app/viewer/model/tile_choices.h"
#include "io/files/save_lights.h"

namespace dapple {

/// What an environment map's window does in the background.
enum class LightWork { reading, sampling, saving };

/// Work that someone may tire of waiting for.
struct LongLightWork {
    LightWork work;
    std::filesystem::path file;   // read or saved; empty: the sky, or none
    std::optional<double> share;  // 0..1; none: nobody knows
};

class LightSession {
 public:
    /// `wake` is called from other threads whenever there is an event.
    LightSession(const LightsSettings& first, std::function<void()> wake);

    /// Reads a map in the background; the one shown stays until then, or if it fails. If several are opened,
    /// the last one counts, and reading those before it is given up. Without a name it is a sky of our own.
    void open(const std::filesystem::path& map);

    /// As in Session.
    void open_tile(const std::filesystem::path& file);
    void take_dropped(const std::filesystem::path& file);
    std::span<const std::string> tiles() const { return tiles_.names(); }

    /// Writes the samples that the settings ask for now, in the background; the name's ending says as what.
    /// One file after the other, in the order in which they were asked for.
    void save(const std::filesystem::path& file);
    bool saving() const { return saving_.busy() || !to_save_.empty(); }

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

    /// The samples of this map; those of earlier settings until newer ones are there.
    const SampledMap& samples() const { return samples_; }
    /// How many times samples were taken.
    std::uint64_t samplings() const { return samplings_; }
    /// They are being taken anew.
    bool sampling() const { return sampling_.busy(); }

    bool at_work() const { return reading_.busy() || sampling() || saving(); }
    /// Once there is a map: what takes longer than half a second, and is to be told.
    std::optional<LongLightWork> long_work() const;
    /// Gives that up: the map before stays, the settings are again those of the samples that are shown, or
    /// the file stays as it was, and so do those that wait for it.
    void stop(LightWork work);

    /// Where the samples were saved last; empty: nowhere.
    const std::filesystem::path& saved_path() const { return saved_path_; }

    LightsSettings settings;
    Banner banner;

 private:
    struct ReadMap {
        std::filesystem::path path;  // empty: the sky
        std::shared_ptr<const LitMap> lit;
        std::string remark;  // on how it was read
    };

    struct Sampling {
        LightsSettings with;
        SampledMap samples;
    };

    struct ToSave {
        std::filesystem::path file;
        LightSaving style;
        std::shared_ptr<const LitMap> lit;
        LightsSettings settings;
    };

    void stop_sampling();
    void read_next();
    void save_next();
    void take_map();
    void take_samples();
    void take_saved();

    std::shared_ptr<const LitMap> lit_;  // what is sampled or saved in the background keeps it too
    std::string name_;
    std::filesystem::path map_path_, saved_path_;
    int maps_ = 0;
    std::optional<std::filesystem::path> to_read_;
    std::deque<ToSave> to_save_;
    std::filesystem::path reading_path_, saving_path_;
    // What samples of this map were last asked for with, and what those that are shown were taken with.
    std::optional<LightsSettings> asked_with_, shown_with_;
    SampledMap samples_;
    std::uint64_t samplings_ = 0;
    History<LightsSettings> history_;
    TileChoices tiles_;
    Background<ReadMap> reading_;
    Background<Sampling> sampling_;
    Background<std::filesystem::path> saving_;
};

}  // namespace dapple
