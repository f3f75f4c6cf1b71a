#include "app/viewer/model/light_session.h"

#include <exception>
#include <utility>

#include "app/files/environment.h"
#include "app/files/save_lights.h"
#include "app/files/tile_library.h"
#include "app/shown_text.h"
#include "core/image/sky.h"

namespace dapple {

namespace fs = std::filesystem;

LightSession::LightSession(const LightsSettings& first, std::function<void()> wake)
    : settings(first), history_(first), tiles_(first.tile), reading_(wake), sampling_(wake), saving_(wake) {}

void LightSession::open(const fs::path& map) {
    to_read_ = map;
    read_next();
}

void LightSession::open_sky() {
    open({});
}

void LightSession::read_next() {
    if (!to_read_ || reading_.busy()) return;
    reading_.begin([path = *to_read_](const auto&) {
        return std::optional(
            ReadMap{path, std::make_shared<const LitMap>(path.empty() ? sky_map() : read_environment(path))});
    });
    to_read_.reset();
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
    if (!lit_ || saving()) return;
    const LightSaving style{settings.convention, settings.turn_degrees, name_, settings.stops};
    saving_.begin([file, style, lit = lit_, asked = settings](const auto&) {
        RankedTile tile = tile_named(asked.tile, RankingMethod::energy);
        save_lights(file, lit->map, light_samples(lit->map, tile, asked.request), style);
        return std::optional(file);
    });
}

void LightSession::take_events() {
    take_map();
    take_samples();
    take_saved();
}

void LightSession::take_map() {
    try {
        if (std::optional<ReadMap> read = reading_.result()) {
            lit_ = std::move(read->lit);
            name_ = read->path.empty() ? "Sky" : printable(read->path.filename().native());
            map_path_ = read->path;
            saved_path_.clear();
            sampled_with_.reset();
            samples_ = {};
            ++maps_;
            banner = {};
        }
    } catch (const std::exception& error) {
        if (!lit_) throw;
        banner = {BannerKind::error, error.what()};
    }
    read_next();
}

void LightSession::take_samples() {
    if (!lit_) return;
    try {
        std::optional<SampledMap> result = sampling_.result();
        if (result && sampled_with_) {  // otherwise they are of the map before
            samples_ = std::move(*result);
            ++samplings_;
        }
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
    const bool asked =
        sampled_with_ && sampled_with_->request == settings.request && sampled_with_->tile == settings.tile;
    if (asked || sampling_.busy()) return;
    sampling_.begin([lit = lit_, asked_with = settings](const auto&) {
        return std::optional(sampled(*lit, asked_with));
    });
    sampled_with_ = settings;
}

void LightSession::take_saved() {
    try {
        if (const std::optional<fs::path> saved = saving_.result()) {
            saved_path_ = *saved;
            banner = {BannerKind::notice, "Saved " + saved->string()};
        }
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
}

}  // namespace dapple
