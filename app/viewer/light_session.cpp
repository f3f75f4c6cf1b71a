#include "app/viewer/light_session.h"

#include <chrono>
#include <exception>
#include <utility>

#include "app/files/environment.h"
#include "app/files/save_lights.h"
#include "app/files/tile_library.h"
#include "app/printable.h"
#include "app/viewer/window.h"
#include "core/image/sky.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

// Wakes the window's loop when it is done, well or badly.
struct Waker {
    ~Waker() { Window::wake(); }
};

std::unique_ptr<const LitMap> read_map(const fs::path& path) {
    const Waker waker;
    return std::make_unique<LitMap>(read_environment(path));
}

std::unique_ptr<const LitMap> make_sky() {
    const Waker waker;
    return std::make_unique<LitMap>(sky_map());
}

}  // namespace

LightSession::LightSession(const LightsSettings& first)
    : settings(first), history_(first), tiles_(first.tile), saving_(&Window::wake) {}

void LightSession::open(const fs::path& map) {
    if (reading_.valid()) reading_.wait();
    name_read_ = printable(map.filename().native());
    path_read_ = map;
    reading_ = std::async(std::launch::async, [map] { return read_map(map); });
}

void LightSession::open_sky() {
    name_read_ = "Sky";
    reading_ = std::async(std::launch::async, make_sky);
}

void LightSession::open_tile(const fs::path& file) {
    try {
        settings.tile = tiles_.open(file);
        banner = {};
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
}

void LightSession::take_dropped(const fs::path& file) {
    if (ends_as_tile(file))
        open_tile(file);
    else
        open(file);
}

void LightSession::save(const fs::path& file) {
    if (!scene_ || saving()) return;
    const LightSaving style{settings.convention, settings.turn_degrees, name_, settings.stops};
    saving_.begin([file, style, lit = scene_->lit(), asked = settings](const std::stop_token&) {
        Saved saved{file, {}};
        try {
            RankedTile tile = tile_named(asked.tile, RankingOrder::energy);
            save_lights(file, lit->map, light_samples(lit->map, tile, asked.request), style);
        } catch (const std::exception& error) {
            saved.error = error.what();
        }
        return std::optional(std::move(saved));
    });
}

void LightSession::take_news() {
    take_map();
    take_saved();
    if (!scene_) return;
    if (std::string error = scene_->update(settings); !error.empty())
        banner = {BannerKind::error, std::move(error)};
}

void LightSession::take_map() {
    // The wake may come before the future is ready, so look again soon.
    if (!reading_.valid()) return;
    const auto patience = std::chrono::milliseconds(20);
    if (reading_.wait_for(patience) != std::future_status::ready) return;
    try {
        scene_ = std::make_unique<LightScene>(reading_.get(), &Window::wake);
        name_ = name_read_;
        map_path_ = path_read_;
        saved_path_.clear();
        ++maps_shown_;
        banner = {};
    } catch (const std::exception& error) {
        if (!scene_) throw;
        banner = {BannerKind::error, error.what()};
    }
}

void LightSession::take_saved() {
    const std::optional<Saved> saved = saving_.result();
    if (!saved) return;
    if (!saved->error.empty()) {
        banner = {BannerKind::error, saved->error};
        return;
    }
    saved_path_ = saved->file;
    banner = {BannerKind::notice, "Saved " + saved->file.string()};
}

}  // namespace dapple
