#include "app/viewer/model/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "app/viewer/desktop/desktop_programs.h"
#include "app/viewer/desktop/pasted_picture.h"
#include "core/drawing/write_drawing.h"
#include "core/settings/fields.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/separations.h"
#include "io/files/sheet_files.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/film/film.h"
#include "io/settings/presets.h"

namespace dapple {

void pass(PlayedFilm& film, double seconds) {
    if (!film.running) return;
    film.share = std::min(film.share + seconds / film.seconds, 1.0);
    film.running = film.share < 1;
}

void run_on(PlayedFilm& film) {
    if (film.share >= 1) film.share = 0;
    film.running = true;
}

DotsRequest film_request(const ViewerSettings& settings, const PlayedFilm& film) {
    ViewerSettings filmed = settings;
    filmed.drawing = film_settings(settings.drawing, film.kind);
    if (film.kind == FilmKind::levels) {
        filmed.colouring = DotColouring::level;
        filmed.deepest_level = level_shown(film.share, film.deepest);
    } else if (film.kind == FilmKind::growth) {
        filmed.drawing.placing.count = grown_dots(film.share, film.dots);
        if (film.share < kFilmEnd) filmed.drawing.relax = 0;  // then they settle, as they do in the window
        filmed.deepest_level = kDeepestStep;
    }
    DotsRequest request = dots_request(filmed);
    request.most_dots = kMostFilmDots;
    return request;
}

int deepest_level(const DotPieces& dots, std::size_t tile_size) {
    float last = 0;
    for (const Dots& piece : dots.pieces)
        for (const float threshold : piece.threshold) last = std::max(last, threshold);
    return tile_rank_of(last, tile_size).level;
}

namespace {

namespace fs = std::filesystem;

// A placing so short is waited for, so that dots and slider move in the same frame.
constexpr std::chrono::milliseconds kPatience(8);
constexpr std::chrono::milliseconds kLongPatience(50);

constexpr const char* kFindPicture = "Find the picture";
constexpr const char* kSampleName = "Still life";

// Either may be empty.
std::string name_of(const fs::path& project, const fs::path& picture) {
    const fs::path& file = project.empty() ? picture : project;
    return file.empty() ? kSampleName : printable(file.filename().native());
}

}  // namespace

Session::Session(const DrawingSettings& drawing, std::function<void()> wake, std::uint64_t most_dots)
    : settings{.drawing = drawing},
      history_({settings, opened_}),
      most_dots_(most_dots),
      tiles_(drawing.tile),
      pane_(std::move(wake)) {
    safe_ = drawing;
}

void Session::begin_with(const ViewerSettings& begin) {
    settings = begin;
    history_ = History<Step>({settings, opened_});
    know_safe(settings.drawing);
}

void Session::remember(bool editing) {
    if (!readings_.empty()) return;
    history_.observe({settings, opened_}, editing);
    name_changes();
}

void Session::undo() {
    if (!readings_.empty() || !history_.can_undo() || open_again(*history_.before())) return;
    settings = history_.undo().settings;
    name_changes();
}

void Session::redo() {
    if (!readings_.empty() || !history_.can_redo() || open_again(*history_.after())) return;
    settings = history_.redo().settings;
    name_changes();
}

// False: it is of what is shown.
bool Session::open_again(const Step& step) {
    if (step.opened == opened_) return false;
    const Source again = left_.at(step.opened).source;
    SettingsBefore before{std::exchange(settings, step.settings), safe_};
    if (!again.project.why_missing.empty()) {  // as where it was opened first
        come_to(step.opened, {std::exchange(source_, again), before.safe});
        say(again.project.why_missing);
        return true;
    }
    begin_reading(again, step.opened);
    readings_.back().settings_before = std::move(before);
    read_source();
    return true;
}

// The step that leads there is the next one or the one before, or else a new one.
void Session::come_to(int opened, Left before) {
    if (opened == opened_) return;
    left_[std::exchange(opened_, opened)] = std::move(before);
    if (const auto known = left_.find(opened); known != left_.end()) {
        const Step* const before_it = history_.before();
        const bool back = before_it && before_it->opened == opened;
        static_cast<void>(back ? history_.undo() : history_.redo());
        know_safe(std::move(known->second.safe));
        left_.erase(known);
    } else {
        history_.observe({settings, opened}, false);
    }
    name_changes();
}

const Session::Source& Session::source_of(const Step& step) const {
    const auto left = left_.find(step.opened);
    return left == left_.end() ? source_ : left->second.source;
}

void Session::name_changes() {
    if (std::exchange(changes_named_, history_.changes()) == history_.changes()) return;
    undo_words_.reset();
    redo_words_.reset();
    const Step &now = history_.now(), *const before = history_.before(), *const after = history_.after();
    const auto words = [this](const Step& from, const Step& to) {
        if (from.opened == to.opened) return change_in_words(from.settings, to.settings);
        return "opening " + name_of(source_of(to).project_path, source_of(to).picture);
    };
    if (before) undo_words_ = words(*before, now);
    if (after) redo_words_ = words(now, *after);
    has_changes_ = now.settings.drawing != safe_;
}

void Session::know_safe(std::optional<DrawingSettings> drawing) {
    safe_ = std::move(drawing);
    has_changes_ = settings.drawing != safe_;
}

bool Session::would_lose_changes(const fs::path& file) const {
    if (!has_changes_ || ends_as_tile(file)) return false;
    if (ends_as_project(file)) return true;
    const auto lost = [&](auto DrawingSettings::*part) {
        const auto& now = settings.drawing.*part;
        return !now.empty() && (!safe_ || (*safe_).*part != now);
    };
    return !project_path().empty() || lost(&DrawingSettings::mask) || lost(&DrawingSettings::edits);
}

DotsRequest Session::as_shown(DotsRequest request) const {
    request.most_dots = std::min(request.most_dots, most_dots_);
    if (cropping.on) {
        // All of the picture: filling the paper would cut its edges off, and the frame's with them.
        request.drawing.page.crop.reset();
        request.drawing.page.fit = PageFit::inside;
    }
    if (as_placed) request.drawing.relax = 0;
    request.settled_only = settings.every_frame;
    return request;
}

void Session::open_sample() {
    begin_reading({}, all_opened_++);
    read_source();
}

void Session::open(const fs::path& path) {
    begin_reading({.picture = path}, all_opened_++);
    // They were made for another picture; undo brings them back.
    readings_.back().mask_before = std::exchange(settings.drawing.mask, {});
    readings_.back().edits_before = std::exchange(settings.drawing.edits, {});
    read(path);
    if (!banner.offer.empty()) banner = {};  // it was about the picture before
}

void Session::find_picture(const fs::path& file) {
    Source found = source_;
    found.picture = file;
    found.project.why_missing.clear();
    begin_reading(std::move(found), readings_.empty() ? opened_ : readings_.back().opened);
    read_source();
}

void Session::begin_reading(Source next, int opened) {
    const fs::path picture = next.picture;
    readings_.push_back({picture, opened, std::exchange(source_, std::move(next))});
}

void Session::read_source() {
    if (source_.picture.empty())
        read_sample();
    else
        read(source_.picture);
}

void Session::read_sample() {
    pane_.worker().open(kSampleName, [] { return sample_picture(PictureColours::kept); });
}

void Session::read(const fs::path& path) {
    Opening opening{.whole = [path](const std::stop_token& stop) {
        return read_picture(path, PictureLimit::usual, PictureColours::kept, stop);
    }};
    // A crop in pixels is one of the whole picture.
    const std::optional<Crop>& crop = settings.drawing.page.crop;
    if (!crop || crop->unit == Crop::Unit::percent)
        opening.first_look = [path](const std::stop_token& stop) {
            return read_first_look(path, PictureColours::kept, stop);
        };
    pane_.worker().open(printable(path.filename().native()), std::move(opening), path);
}

// Those before it were overtaken.
std::optional<Session::Reading> Session::end_reading(const fs::path& picture) {
    const auto read = std::ranges::find(readings_, picture, &Reading::picture);
    if (read == readings_.end()) return std::nullopt;
    std::optional<Reading> ended(std::move(*read));
    readings_.erase(readings_.begin(), read + 1);
    return ended;
}

void Session::go_back_before(const fs::path& picture) {
    const auto failed = std::ranges::find(readings_, picture, &Reading::picture);
    if (failed == readings_.end()) return;
    if (const auto next = failed + 1; next != readings_.end()) {
        next->before = std::move(failed->before);
        if (failed->settings_before) next->settings_before = std::move(failed->settings_before);
    } else {
        source_ = std::move(failed->before);
        if (failed->settings_before) {
            settings = std::move(failed->settings_before->settings);
            know_safe(std::move(failed->settings_before->safe));
        } else {
            if (settings.drawing.mask.empty()) settings.drawing.mask = std::move(failed->mask_before);
            if (settings.drawing.edits.empty()) settings.drawing.edits = std::move(failed->edits_before);
        }
    }
    readings_.erase(failed);
}

bool Session::attempt(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        say(error.what());
        return false;
    }
}

void Session::open_tile_of(DrawingSettings& drawing) {
    if (is_tile_file_name(drawing.tile)) drawing.tile = tiles_.open(drawing.tile);
}

void Session::open_tile(const fs::path& file) {
    attempt([&] {
        settings.drawing.tile = tiles_.open(file);
        banner = {};
    });
}

void Session::load_project(const fs::path& file) {
    ViewerSettings read;
    Project project = read_project(file, [&](Fields& fields) { describe(fields, read); });
    open_tile_of(read.drawing);
    read.every_frame = settings.every_frame;
    SettingsBefore before{std::exchange(settings, read), safe_};
    know_safe(settings.drawing);
    if (!placed_once()) history_ = History<Step>({settings, opened_});  // there is nothing to go back to
    const int opened = all_opened_++;
    banner = {};
    Source source{.picture = project.picture.value_or(fs::path()),
                  .project = std::move(project),
                  .project_path = whole_path(file)};
    if (!source.project.why_missing.empty()) {
        come_to(opened, {std::exchange(source_, std::move(source)), std::move(before.safe)});
        say(source_.project.why_missing);
        readings_.clear();  // what still comes is not gone back from
        if (!placed_once()) read_sample();
        return;
    }
    begin_reading(std::move(source), opened);
    readings_.back().settings_before = std::move(before);
    read_source();
}

void Session::open_project(const fs::path& file) {
    if (!attempt([&] { load_project(file); }) && !placed_once()) read_sample();
}

void Session::take(SavedSettings taken) {
    open_tile_of(taken.drawing);
    settings.drawing = std::move(taken.drawing);
    settings.saving = taken.saving;
}

void Session::take_preset(const SavedSettings& preset) {
    attempt([&] { take({with_preset(preset.drawing, settings.drawing), preset.saving}); });
}

void Session::keep(const fs::path& file) {
    Project project = source_.project;
    project.picture.reset();
    if (!source_.picture.empty()) project.picture = source_.picture;
    dapple::save_project(file, project, [&](Fields& fields) { describe(fields, settings); });
}

void Session::bring_back(const fs::path& file) {
    attempt([&] {
        load_project(file);
        source_.project_path.clear();  // which is not where it belongs
        source_.brought_back = true;
        if (readings_.empty()) know_safe(std::nullopt);  // else once its picture is there
    });
}

void Session::save_project(const fs::path& file) {
    attempt([&] {
        keep(file);
        source_.project_path = whole_path(file);
        source_.brought_back = false;
        know_safe(settings.drawing);
        banner = {BannerKind::notice, "Saved " + file.string()};
    });
}

void Session::take_dropped(const fs::path& file) {
    if (ends_as_tile(file))
        open_tile(file);
    else if (ends_as_project(file))
        open_project(file);
    else if (ending_of(file) == ".svg" || settings_inside(file))
        attempt([&] {
            take(settings_from(file));
            banner = {BannerKind::notice,
                      "Using the settings of " + file.string() + ". Undo restores yours."};
        });
    else
        open(file);
}

PrepareFile Session::file_to_write(const fs::path& path, const DrawingSettings& drawing,
                                   const SavingChoice& saving) const {
    return [path, drawing, saving, choice = settings.density, most = most_dots_](
               Workbench& bench, const std::stop_token& stop) -> WriteFile {
        const DrawingFile file{.path = path,
                               .format = drawing_format(path),
                               .settings = drawing,
                               .saving = saving,
                               .embedded = embedded_settings(path, drawing, saving)};
        DotsRequest request = dots_request(file.settings, choice);
        request.most_dots = most;
        request.drawing.placing.thresholds = needs_thresholds(file);
        const auto placed = bench.pipeline().drawing(bench.plan(request), stop);
        if (!placed) return {};
        return [placed, file](const Watch& watch) { return save_page(*placed, file, watch); };
    };
}

void Session::save(const fs::path& path) {
    saves_[path] = {settings.drawing, settings.saving};
    pane_.worker().save(path, file_to_write(path, settings.drawing, settings.saving));
}

void Session::copy_picture() {
    const fs::path path = dapple::file_to_copy();
    if (path.empty()) return say("The drawing cannot be copied: there is no home folder");
    copied_path_ = path;
    DrawingSettings drawing = settings.drawing;
    SavingChoice saving = settings.saving;
    drawing.sheets = {};
    saving.separations = false;  // one picture
    saving.region.reset();
    const auto prepare = [path, prepared = file_to_write(path, drawing, saving)](
                             Workbench& bench, const std::stop_token& stop) -> WriteFile {
        WriteFile write = prepared(bench, stop);
        if (!write) return {};
        return [path, write = std::move(write)](const Watch& watch) {
            const auto remove = [](const fs::path* file) {
                std::error_code ignored;
                fs::remove(*file, ignored);
            };
            const std::unique_ptr<const fs::path, decltype(remove)> removed(&path, remove);
            make_folder(path.parent_path());
            return write(watch) && dapple::copy_picture(path, watch.stop);
        };
    };
    pane_.worker().save(path, prepare);
}

void Session::play(FilmKind kind) {
    if (!placed_once()) return;
    const std::uint64_t dots = film && film->kind == FilmKind::growth ? film->dots : pane_.page().dots.size();
    film = PlayedFilm{.kind = kind,
                      .seconds = film ? film->seconds : 8,
                      .dots = std::clamp<std::uint64_t>(dots, 1, kMostFilmDots)};
    cropping.on = brush.on = false;
}

void Session::save_film(const fs::path& path) {
    if (!film) return;
    const FilmChoice choice{
        .kind = film->kind,
        .seconds = film->seconds,
        .machine = settings.saving.machine.value_or(usual_machine(DrawingFormat::svg, settings.saving.tool)),
        .order = settings.saving.order};
    film_path_ = path;
    // With a bench of its own, so that films are drawn beside further placing.
    const auto draw = [choice, path, read = picture_.read, drawing = settings.drawing,
                       density = settings.density](const Watch& watch) {
        Workbench bench;
        bench.set_picture(read());
        const DrawingSettings filmed = film_settings(drawing, choice.kind);
        static_cast<void>(bench.plan(dots_request(filmed, density)));
        const FilmFrame frame =
            film_frames(bench.pipeline(), filmed, choice, {.stop = watch.stop, .progress = {}});
        return frame && dapple::save_film(path, frame, choice, watch);
    };
    pane_.worker().save(path, [draw](Workbench&, const std::stop_token&) -> WriteFile { return draw; });
}

void Session::request_dots(const Zoom& zoom, bool held) {
    // In every frame, but not before the last one is there: it would never be.
    const bool waits = settings.every_frame && pane_.worker().placing_since();
    DotsRequest page = as_shown(film ? film_request(settings, *film) : dots_request(settings));
    page.held = held && !settings.every_frame;
    const bool requested = pane_.request(std::move(page), zoom, settings.every_frame && !waits);
    if (requested) requested_settings_ = settings;
    if (requested || waits) take_events(settings.every_frame ? kLongPatience : kPatience);
}

void Session::stop_placing() {
    if (!placed_settings_) return;
    if (*placed_settings_ == settings) {  // its dots are there, and relax
        settings.drawing.relax = pane_.page().steps;
        placed_settings_ = settings;
        banner = {BannerKind::notice, "Relaxing stopped. Move Relax for more steps"};
        return;
    }
    settings = *placed_settings_;
    banner = {BannerKind::notice, "Cancelled. The previous drawing is back"};
}

void Session::take_events(std::chrono::milliseconds patience) {
    for (WorkerEvent& event : pane_.worker().events(patience))
        std::visit([this](auto& n) { take(n); }, event);
}

void Session::take(DotsPlaced& event) {
    if (event.picture) ++previews_;
    if (event.picture && event.picture->refines) {
        picture_ = std::move(*event.picture);
    } else if (event.picture) {
        std::optional<Reading> read = end_reading(event.picture->file);
        picture_ = std::move(*event.picture);
        ++pictures_;
        std::optional<DrawingSettings> safe =
            read && read->settings_before ? read->settings_before->safe : safe_;
        know_safe(source_.brought_back ? std::nullopt : std::optional(settings.drawing));
        if (read) come_to(read->opened, {std::move(read->before), std::move(safe)});
        saved_path_.clear();                             // it shows another picture
        if (read && !picture_is_missing()) banner = {};  // whatever it said was about the one before
        if (picture_.looks_like_environment)
            banner = {.message = picture_.name + " looks like an environment map.",
                      .offer = "Open as lights"};
    }
    if (!event.error.empty())
        say(event.error);
    else if (placing_failed_ && banner.kind == BannerKind::error)
        banner = {};
    placing_failed_ = !event.error.empty();
    if (event.error.empty() && event.drawing.request == pane_.page_requested())
        placed_settings_ = requested_settings_;
    const bool levels = film && film->kind == FilmKind::levels &&
                        event.drawing.request->colours.colouring == DotColouring::level;
    if (levels && event.error.empty())
        film->deepest =
            deepest_level(event.drawing.dots, event.tile ? event.tile->points.size() : pane_.tile_size());
    pane_.take(event);
}

void Session::take(TaskFailed& event) {
    // Without a picture there is nothing to show: in place of the one named on the command line comes the
    // sample.
    const bool named = event.picture && !event.picture->empty();
    if (!placed_once() && !named) throw std::runtime_error(event.message);
    if (event.picture) go_back_before(*event.picture);
    say(event.message);
    if (!placed_once()) read_sample();
}

void Session::say(const std::string& sentence) {
    banner = {
        .kind = BannerKind::error, .message = sentence, .offer = picture_is_missing() ? kFindPicture : ""};
}

std::vector<fs::path> Session::files_to_save(const fs::path& path) const {
    return files_of(path, settings.drawing.sheets, settings.saving, pane_.page().plan.pens);
}

void Session::take(DrawingSaved& event) {
    if (event.path == copied_path_) {
        banner = {BannerKind::notice, "Drawing copied"};
        return;
    }
    std::string words = event.path.string();
    if (event.path != film_path_) {
        const auto& [drawing, saving] = saves_[event.path];
        const DrawingFormat format = drawing_format(event.path);
        const bool by_pen = has_pen_files(format, saving, pane_.page().plan.pens);
        saved_path_ = event.path;
        saved_files_ = files_of(event.path, drawing.sheets, saving, pane_.page().plan.pens);
        if (format == DrawingFormat::svg || format == DrawingFormat::png) know_safe(drawing);
        if (is_several(drawing.sheets))
            words =
                sheet_files_in_words(event.path, drawing.sheets) + (by_pen ? ", a file for each pen" : "");
        else if (by_pen)
            words = fmt::format("{} to {}", saved_files_.front().string(),
                                saved_files_.back().filename().string());
    }
    banner = {.message = "Saved " + words,
              .offer = event.path != film_path_ && is_in_path("xdg-open") ? kShowInFolder : ""};
}

void Session::take(SavingCancelled& event) {
    if (event.path == copied_path_) {
        banner = {BannerKind::notice, "Cancelled: the drawing was not copied"};
        return;
    }
    const bool several = event.path != film_path_ && is_several(saves_[event.path].drawing.sheets);
    banner = {BannerKind::notice,
              several ? "Cancelled: not all sheets of " + event.path.string() + " were written"
                      : "Cancelled: " + event.path.string() + " was not written"};
}

void Session::take(OpeningStopped& event) {
    go_back_before(event.picture);
    banner = {BannerKind::notice, "Cancelled: " + event.name + " was not read completely"};
}

DrawnInfo Session::drawn() const {
    const PlacedDrawing& drawing = pane_.page();
    return {.dots = drawing.dots.size() - drawing.duplicates,
            .scale = drawing.scale,
            .dot_radius_mm = drawing.dot_radius_mm(),
            .most_dots = most_dots_,
            .tone = drawing.plan.tone,
            .steps = drawing.plan.steps,
            .usual_steps = drawing.plan.usual_steps,
            .page = drawing.layout.page};
}

glm::dvec2 Session::room_for_crop() const {
    const Rectangle<double>& within = pane_.page().layout.within_margins;
    const glm::dvec2 room = within.high - within.low;
    return settings.drawing.page.quarter_turns % 2 == 1 ? glm::dvec2(room.y, room.x) : room;
}

}  // namespace dapple
