#include "app/viewer/model/light_session.h"

#include <chrono>
#include <exception>
#include <utility>

#include "core/image/environment.h"
#include "core/text/shown_text.h"
#include "io/files/environment_file.h"
#include "io/files/tile_library.h"

namespace dapple {

namespace fs = std::filesystem;

namespace {

// Who waits for longer wants to know for what.
constexpr std::chrono::milliseconds kLong(500);

template <class Result>
bool is_long(const Background<Result>& work) {
    const auto since = work.since();
    return since && std::chrono::steady_clock::now() - *since > kLong;
}

template <class Task>
Watch watch_of(const Task& todo) {
    return {todo.stop(), [&todo](double share) { todo.report_share(share); }};
}

std::string shown(const fs::path& map) {
    return map.empty() ? "the sky" : printable(map.filename().native());
}

bool same_samples(const std::optional<LightsSettings>& a, const LightsSettings& b) {
    return a && a->request == b.request && a->tile == b.tile;
}

}  // namespace

LightSession::LightSession(const LightsSettings& first, std::function<void()> wake)
    : settings(first), history_(first), tiles_(first.tile), reading_(wake), sampling_(wake), saving_(wake) {}

void LightSession::open(const fs::path& map) {
    to_read_ = map;
    reading_.stop();
    read_next();
}

void LightSession::read_next() {
    if (!to_read_ || reading_.busy()) return;
    reading_path_ = *to_read_;
    reading_.begin([path = *to_read_](const auto& todo) -> std::optional<ReadMap> {
        const std::stop_token& stop = todo.stop();
        try {
            EnvironmentFile read = path.empty() ? EnvironmentFile{.map = sky_map()}
                                                : read_environment(path, LightBelowZero::refused, stop);
            if (stop.stop_requested()) return std::nullopt;
            return ReadMap{path, std::make_shared<const LitMap>(std::move(read.map)), std::move(read.remark)};
        } catch (const std::exception&) {
            if (stop.stop_requested()) return std::nullopt;
            throw;
        }
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
    if (!lit_) return;
    to_save_.push_back(
        {file, {settings.convention, settings.turn_degrees, name_, settings.stops}, lit_, settings});
    save_next();
}

void LightSession::save_next() {
    if (saving_.busy() || to_save_.empty()) return;
    ToSave next = std::move(to_save_.front());
    to_save_.pop_front();
    saving_path_ = next.file;
    saving_.begin([next = std::move(next)](const auto& todo) -> std::optional<fs::path> {
        RankedTile tile = tile_named(next.settings.tile, RankingMethod::energy);
        const LightSamples lights = light_samples(next.lit->map, tile, next.settings.request, watch_of(todo));
        if (lights.samples.empty()) return std::nullopt;
        save_lights(next.file, next.lit->map, lights, next.style);
        return next.file;
    });
}

std::optional<LongLightWork> LightSession::long_work() const {
    if (!lit_) return std::nullopt;
    if (is_long(reading_)) return LongLightWork{LightWork::reading, reading_path_, std::nullopt};
    if (is_long(saving_)) return LongLightWork{LightWork::saving, saving_path_, saving_.share()};
    if (is_long(sampling_)) return LongLightWork{LightWork::sampling, {}, sampling_.share()};
    return std::nullopt;
}

void LightSession::stop(LightWork work) {
    switch (work) {
        case LightWork::reading:
            to_read_.reset();
            banner = {BannerKind::notice, "Cancelled: " + shown(reading_path_) + " was not read completely"};
            return reading_.stop();
        case LightWork::sampling:
            return stop_sampling();
        case LightWork::saving:
            // If that is too late, it says so instead.
            banner = {BannerKind::notice, "Cancelled: " + saving_path_.string() + " was not written"};
            to_save_.clear();
            return saving_.stop();
    }
}

void LightSession::stop_sampling() {
    if (!shown_with_) return;  // nothing to go back to
    settings.request = shown_with_->request;
    settings.tile = shown_with_->tile;
    asked_with_ = shown_with_;
    sampling_.stop();
    banner = {BannerKind::notice, "Cancelled. The previous samples are back"};
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
            asked_with_.reset();
            shown_with_.reset();
            sampling_.stop();
            samples_ = {};
            ++maps_;
            banner = {BannerKind::notice, read->remark.empty() ? "" : name_ + ": " + read->remark};
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
        std::optional<Sampling> result = sampling_.result();
        // Otherwise they are of the map before, or were given up when they were as good as taken.
        if (result && same_samples(asked_with_, result->with)) {
            samples_ = std::move(result->samples);
            shown_with_ = std::move(result->with);
            ++samplings_;
        }
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
    if (same_samples(asked_with_, settings)) return;
    if (is_long(sampling_)) sampling_.stop();
    if (sampling_.busy()) return;
    sampling_.begin([lit = lit_, with = settings](const auto& todo) -> std::optional<Sampling> {
        std::optional<SampledMap> samples = sampled(*lit, with, watch_of(todo));
        if (!samples) return std::nullopt;
        return Sampling{with, std::move(*samples)};
    });
    asked_with_ = settings;
}

void LightSession::take_saved() {
    const bool over = !saving_.busy();  // asked first: there may be a result between the two
    try {
        if (const std::optional<fs::path> saved = saving_.result()) {
            saved_path_ = *saved;
            banner = {BannerKind::notice, "Saved " + saved->string()};
        }
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
    if (over) save_next();
}

}  // namespace dapple
