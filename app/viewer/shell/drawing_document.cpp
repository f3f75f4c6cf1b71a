#include "app/viewer/shell/drawing_document.h"

#include <imgui.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/small_pictures.h"
#include "app/viewer/canvas/page_frame.h"
#include "app/viewer/canvas/pane_view.h"
#include "app/viewer/desktop/desktop_programs.h"
#include "app/viewer/desktop/pasted_picture.h"
#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/lights_document.h"
#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/widgets.h"
#include "core/settings/fields.h"
#include "core/text/shown_text.h"
#include "io/available_memory.h"
#include "io/files/picture.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/settings/presets.h"
#include "io/settings/project.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

EntryPicture EntryPictures::of(const std::string& key, const SmallPictures::Make& make) {
    const SmallPicture* const picture = pictures_.of(key, make);
    if (!picture) return {.awaited = true};
    if (picture->empty()) return {};
    auto texture = textures_.find(key);
    if (texture == textures_.end()) {
        texture = textures_.emplace(key, GlTexture()).first;
        texture->second.write(*picture);
    }
    return {texture_id(texture->second.get()),
            {static_cast<float>(picture->width), static_cast<float>(picture->height)}};
}

void EntryPictures::forget() {
    pictures_.forget();
    textures_.clear();
}

namespace {

// A dot is five floats and four bytes of colour in the drawing shown, in the one being placed and in one kept
// for its memory; all that twice in a split view, and once more while it is saved. Relaxing one needs 44
// bytes a dot for the while. The drawing as it was has some of the other half. The graphics driver gets them
// by and by.
constexpr std::uint64_t kBytesPerDot = 250;
constexpr std::uint64_t kShare = 2;  // one part in so many is for dots
constexpr std::uint64_t kFewest = 1'000'000;

}  // namespace

std::uint64_t most_dots_in(std::uint64_t bytes) {
    return std::clamp(bytes / kShare / kBytesPerDot, kFewest, kMostDots);
}

namespace {

namespace fs = std::filesystem;

constexpr double kLongOpening = 0.5;  // seconds: shorter ones are not told
constexpr float kStatusHeight = 30;   // at 96 dpi
// Pixels of presets' previews, and of the copy of the picture that they are made of.
constexpr int kSmallDrawingSide = 220, kVariationSide = 400, kPreviewedSide = 512;
constexpr std::size_t kMostPreviews = 100;

// Endings of files that hold pictures, of projects, and of drawings that hold settings; a file with another
// ending is opened as well if it holds one of these.
const std::vector<std::string> kPictures{kProjectEnding, ".svg", ".png",  ".jpg",  ".jpeg", ".tif",
                                         ".tiff",        ".exr", ".hdr",  ".webp", ".gif",  ".bmp",
                                         ".tga",         ".psd", ".ppm",  ".pgm",  ".pnm",  ".jp2",
                                         ".heic",        ".dpx", ".fits", ".ico",  ".pic"};

double crop_proportion(const Session& session) {
    const glm::ivec2 picture = session.pane().page().plan.opened;
    return percent_proportion(session.cropping.proportion,
                              crop_percent(session.settings.drawing.page.crop, picture), picture,
                              session.room_for_crop());
}

bool is_there(const std::string& tile) {
    try {
        load_tile(tile);
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

// A tile's file may be gone since.
DrawingSettings drawing_to_begin_with(DrawingSettings kept, const std::optional<std::string>& tile) {
    if (tile) {
        kept.tile = *tile;
    } else if (!is_there(kept.tile)) {
        kept.tile = kDefaultTile;
        kept.ranking.reset();
    }
    return kept;
}

}  // namespace

DrawingDocument::DrawingDocument(const std::optional<fs::path>& image, const std::optional<std::string>& tile,
                                 const KeptView& view, const fs::path& presets, const fs::path& palettes)
    : session_(drawing_to_begin_with(view.drawing, tile), &Window::wake, most_dots_in(available_memory())),
      compared_(session_, &Window::wake),
      spectrum_(Measure::everything, &Window::wake),
      side_panel_(presets, palettes),
      previews_(&Window::wake),
      mask_reading_(&Window::wake) {
    ViewerSettings begin = session_.settings;
    begin.zoom_mode = view.zoom_mode;
    begin.unit = view.unit;
    begin.saving = view.saving;
    session_.begin_with(begin);
    if (!image) {
        session_.open_sample();
    } else if (!ends_as_project(*image)) {
        session_.open(*image);
    } else {
        session_.open_project(*image);
        if (tile) session_.settings.drawing.tile = *tile;
    }
}

std::span<const Shortcut> DrawingDocument::shortcuts() const {
    return dapple::shortcuts();
}

OpenQuestion DrawingDocument::what_to_open() const {
    const fs::path& path = session_.picture_path();
    return {"Open a picture", kPictures, path};
}

void DrawingDocument::open_mask(const fs::path& file) {
    if (mask_reading_.busy()) return;
    mask_reading_.begin([file](const auto& todo) -> std::optional<Mask> {
        return mask_of(read_picture(file, PictureLimit::usual, PictureColours::left_out, todo.stop()).light);
    });
}

void DrawingDocument::take_mask() {
    try {
        if (auto mask = mask_reading_.result()) session_.settings.drawing.mask = std::move(*mask);
    } catch (const std::exception& error) {
        say(error.what());
    }
}

// An SVG cannot be opened as a picture.
bool DrawingDocument::is_picture_with_settings(const fs::path& file) const {
    return ending_of(file) == ".png" && settings_inside(file);
}

fs::path DrawingDocument::file() const {
    if (!session_.placed_once()) return {};
    return session_.project_path().empty() ? session_.picture().file : session_.project_path();
}

std::string DrawingDocument::name() const {
    const fs::path& project = session_.project_path();
    return project.empty() ? session_.picture().name : printable(project.filename().native());
}

std::string DrawingDocument::unsaved() const {
    return session_.placed_once() && session_.has_changes() ? name() : std::string();
}

std::optional<KeptView> DrawingDocument::kept_view() const {
    if (!session_.project_path().empty()) return std::nullopt;  // they are the project's own
    const ViewerSettings& settings = session_.settings;
    return KeptView{.zoom_mode = settings.zoom_mode,
                    .unit = settings.unit,
                    .saving = settings.saving,
                    .drawing = with_preset(settings.drawing, DrawingSettings{})};
}

fs::path DrawingDocument::folder_to_save_in() const {
    const fs::path& picture = session_.picture().file;
    const fs::path folder = picture.empty() ? fs::path() : whole_path(picture).parent_path();
    return folder.empty() || folder == pasted_folder() ? working_folder() : folder;
}

std::optional<SaveQuestion> DrawingDocument::where_to_save() const {
    const fs::path& saved = session_.saved_path();
    const std::vector<fs::path>& own = session_.saved_files();
    const fs::path name = fs::path(session_.picture().name).stem().concat(".svg");
    std::vector<FileFormat> formats;
    for (const DrawingFormatName& each : kDrawingFormats)
        formats.push_back({each.shown, each.ending, each.others});
    const auto was_written = [&](const fs::path& file) { return std::ranges::find(own, file) != own.end(); };
    const bool is_own = !saved.empty() && std::ranges::all_of(session_.files_to_save(saved), was_written);
    return SaveQuestion{.title = "Export the drawing",
                        .formats = std::move(formats),
                        .start = saved.empty() ? folder_to_save_in() / name : saved,
                        .own_file = is_own ? saved : fs::path(),
                        .own_files = own,
                        .has_options = true,
                        .files = [this](const fs::path& chosen) { return session_.files_to_save(chosen); }};
}

std::optional<SaveQuestion> DrawingDocument::where_to_save_project() const {
    const fs::path& own = session_.project_path();
    const fs::path name = fs::path(session_.picture().name).stem().concat(kProjectEnding);
    return SaveQuestion{.title = "Save the project",
                        .formats = {{"Project", kProjectEnding}},
                        .start = own.empty() ? folder_to_save_in() / name : own,
                        .own_file = own,
                        .button = "Save"};
}

std::optional<SaveQuestion> DrawingDocument::where_to_save_film() const {
    if (!session_.film) return std::nullopt;
    const fs::path& saved = session_.saved_path();
    const fs::path folder = saved.empty() ? folder_to_save_in() : saved.parent_path();
    return SaveQuestion{.title = "Save the film",
                        .formats = {{"Animated WebP", ".webp"}},
                        .start = folder / fs::path(session_.picture().name).stem().concat(".webp"),
                        .button = "Save"};
}

std::string DrawingDocument::draw_saving_options(std::size_t format) {
    const auto kind = static_cast<DrawingFormat>(format);
    draw_export_panel(session_.settings, kind, estimate_.info(session_.pane(), session_.settings, kind));
    return estimate_.info(session_.pane(), session_.settings, kind).trouble;
}

void DrawingDocument::draw_saving_rows(std::size_t format) {
    draw_export_panel(session_.settings, static_cast<DrawingFormat>(format), {.dots = session_.drawn().dots});
}

void DrawingDocument::act(Action action, const Frame&) {
    ViewerSettings& settings = session_.settings;
    switch (action) {
        case Action::undo:
            return session_.undo();
        case Action::redo:
            return session_.redo();
        case Action::fit:
            return canvas_.fit();
        case Action::one_to_one:
            return canvas_.zoom_to(session_.picture().longer_side);
        case Action::zoom_in:
            return canvas_.zoom(1.25);
        case Action::zoom_out:
            return canvas_.zoom(0.8);
        case Action::pan_left:
            return canvas_.pan({kPanStep, 0});
        case Action::pan_right:
            return canvas_.pan({-kPanStep, 0});
        case Action::pan_up:
            return canvas_.pan({0, kPanStep});
        case Action::pan_down:
            return canvas_.pan({0, -kPanStep});
        case Action::toggle_tiles:
            return toggle(settings.drawing.show_tiles);
        case Action::compare:
            settings.comparison = toggled(settings.comparison, settings.drawing);
            return;
        case Action::loupe:
            return toggle(settings.loupe.on);
        case Action::explain_dots:
            return toggle(settings.origins);
        case Action::play:
            return film_player_.play_or_pause();
        case Action::film_growth:
            return film_player_.play(FilmKind::growth);
        case Action::film_levels:
            return film_player_.play(FilmKind::levels);
        case Action::film_zoom:
            return film_player_.play(FilmKind::zoom);
        case Action::film_plot:
            return film_player_.play(FilmKind::plot);
        case Action::as_lights:
            return show_lights();
        case Action::crop:
            return side_panel_.turn_to(Column::crop, session_);
        case Action::mask:
            return side_panel_.turn_to(Column::mask, session_);
        case Action::retouch:
            return side_panel_.turn_to(Column::retouch, session_);
        case Action::rotate:
            settings.drawing.page.quarter_turns = (settings.drawing.page.quarter_turns + 1) % 4;
            return;
        case Action::variations:
            return toggle(variations_);
        case Action::method:
            return side_panel_.turn_to(Column::method, session_);
        case Action::smaller_brush:
            return resize_brush(session_.brush, -1);
        case Action::larger_brush:
            return resize_brush(session_.brush, 1);
        case Action::copy_picture:
            return session_.copy_picture();
        case Action::photograph:
            return compared_.toggle(SeenInstead::photograph);
        case Action::as_it_was:
            return compared_.toggle(SeenInstead::as_it_was);
        case Action::keep_to_compare:
            return compared_.keep();
        default:  // of environment maps
            return;
    }
}

void DrawingDocument::show_lights() {
    if (session_.picture().looks_like_environment)
        successor_ = std::make_unique<LightsDocument>(session_.picture_path(), LightsSettings{});
    else
        session_.say(session_.picture().name +
                     " is not an environment map; open an HDR picture that is twice as wide as high");
}

void DrawingDocument::stop_what_takes_long() {
    const Worker& worker = session_.pane().worker();
    const bool opening = worker.opening().has_value();
    if (compared_.end_toggled()) return;
    if (variations_) return toggle(variations_);
    if (worker.saving()) return session_.stop_saving();
    if (opening && session_.placed_once()) return session_.stop_opening();
    if (session_.film) return film_player_.stop();  // a moment's placing ends with its film
    if (!opening && placing_seconds() > kLongPlacing) return session_.stop_placing();
    side_panel_.turn_to(Column::drawing, session_);
}

std::string DrawingDocument::saving() const {
    const auto saving = session_.pane().worker().saving();
    return saving ? printable(saving->path.filename().native()) : "";
}

DrawingDocument::Layout DrawingDocument::layout(const Frame& frame) const {
    const float scale = ImGui::GetFontSize() / 15;
    const float status = frame.panels.x > 0 ? kStatusHeight * scale : 0;
    const float captions = session_.settings.comparison.on ? side_captions_height() : 0;
    const float player = session_.film ? player_bar_height() : 0;
    // A window may be smaller than its panels.
    const glm::vec2 canvas{frame.canvas.x, std::max(frame.canvas.y - status - captions - player, 1.0f)};
    return {{{0, 0}, canvas, frame.pixels_per_point},
            {canvas.x, player},
            {canvas.x, captions},
            {canvas.x, status}};
}

void DrawingDocument::draw(const Frame& frame) {
    frame_rate_.frame(FrameRate::Clock::now());
    if (!ImGui::GetIO().WantCaptureKeyboard && escape_pressed()) stop_what_takes_long();
    compared_.hold(std::exchange(compare_pressed_, false) ? SeenInstead::photograph : comparison_held());
    session_.take_events(std::chrono::milliseconds(0));
    compared_.take_events();
    take_mask();
    film_player_.show();
    show_changes(frame.window);

    const auto [place, player, captions, status_size] = layout(frame);
    keep_tips_above(place.size.y);  // a film's bar lies below
    const bool panels = frame.panels.x > 0;
    const bool others = std::exchange(previewed_, session_.previews()) != session_.previews();
    if (others || previews_.size() > kMostPreviews) previews_.forget();
    const auto preview = [this](const DrawingSettings& drawing) {
        return preview_of(drawing, kSmallDrawingSide);
    };
    open_ = panels
                ? side_panel_.draw(session_, spectrum(), preview, frame.act, {place.size.x, 0}, frame.panels)
                : OpenSections{};
    Comparison& comparison = session_.settings.comparison;
    if (comparison.on) draw_split_divider(comparison.divider, place);
    Mask& mask = session_.settings.drawing.mask;
    const bool can_paint =
        panels && session_.placed_once() && session_.settings.density.source == DensitySource::photograph;
    if (!can_paint) session_.cropping.on = false;
    if (!can_paint || session_.cropping.on || session_.film) session_.brush.on = session_.retouch.on = false;
    if (ImGuiIO& io = ImGui::GetIO(); session_.brush.on && io.KeyCtrl && !io.WantCaptureMouse) {
        const float turned = std::exchange(io.MouseWheel, 0.0f);  // which is not to zoom
        if (turned != 0) resize_brush(session_.brush, turned > 0 ? 1 : -1);
    }
    const bool painting =
        mask_painter_.paint(mask, session_.brush, session_.pane().page(), canvas_.camera(), place);
    // The frame is there once all of the picture is.
    const PlacedDrawing& page = session_.pane().page();
    const std::optional<DotsRequest>& placed = session_.pane().page().request;
    const bool framing = session_.cropping.on && placed && !placed->drawing.page.crop &&
                         placed->drawing.page.fit == PageFit::inside;
    std::optional<Crop>& crop = session_.settings.drawing.page.crop;
    const bool cropping = framing && crop_frame_.drag(crop, crop_proportion(session_), page.plan.framing,
                                                      page.plan.opened, canvas_.camera(), place);
    const bool dragging = ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    session_.remember(ImGui::IsAnyItemActive() || painting || cropping);
    session_.request_dots(zoom(), dragging || painting || cropping);
    compared_.request(zoom());
    show_changes(frame.window);
    film_player_.draw_bar({0, place.size.y}, player, frame.act);
    draw_over_canvas(place, frame.act);
    canvas_.handle_mouse(place, session_.brush.on || session_.retouch.on || cropping);
    draw_canvas_menu(place.corner, place.size, frame.act);
    if (variations_ && session_.placed_once() && !session_.film)
        choose_variation(place);
    else if (panels && !session_.film)
        compare_pressed_ = draw_canvas_tools(place.corner, side_panel_.column(), frame.act);
    const Redraw redraw = frame.window.frame_is_unseen()  ? Redraw::later
                          : session_.settings.every_frame ? Redraw::always
                                                          : Redraw::when_changed;
    canvas_.learn(frame.last_seconds);
    const float pixel_scale = ImGui::GetFontSize() / 15 * static_cast<float>(place.pixels_per_point.x);
    frame.window.leave_out(canvas_.show(place, look_of(compared_, zoom(), pixel_scale), redraw));
    const Pane& seen = compared_.seen();
    // What it says of the view is of the one that is seen now.
    paper_zoom_ = !seen.page().is_there()
                      ? 0
                      : canvas_.camera().pixels_per_unit / seen.page().layout.page.mm_per_page_unit *
                            kMmPerInch / frame.window.pixels_per_inch();
    if (panels && session_.placed_once())
        draw_status_line({0, place.size.y + player.y + captions.y}, status_size, info());
    mask_painter_.draw(mask, session_.brush, session_.pane().page(), canvas_.camera(), place);
    session_.attempt([this, &canvas = place] {
        retoucher_.retouch(session_.settings.drawing.edits, session_.retouch, session_.pane().page(),
                           canvas_.camera(), canvas);
    });
    if (framing) crop_frame_.draw(crop, page.plan.framing, page.plan.opened, canvas_.camera(), place);
    draw_margin_lines(seen.page().layout, canvas_.camera(), place);
    draw_sheet_lines(seen.page().layout, compared_.settings_of(seen).sheets, canvas_.camera(), place);
    draw_side_captions(compared_, {0, place.size.y + player.y}, captions);
    film_player_.draw_trail(place);
    const Pane& pointed_at =
        compared_.at((ImGui::GetIO().MousePos.x - place.corner.x) / std::max(place.size.x, 1.0f));
    draw_loupe(pointed_at, place);
    explain_dot(pointed_at, place);
    measure_dots();
}

Zoom DrawingDocument::zoom() const {
    ZoomMode mode = session_.settings.zoom_mode;
    if (session_.retouch.on) mode = ZoomMode::drawing;  // which are the dots that it changes
    if (session_.film)
        mode = session_.film->kind == FilmKind::zoom ? ZoomMode::constant_density : ZoomMode::drawing;
    return {mode, canvas_.camera(), canvas_.enlargement()};
}

void DrawingDocument::draw_over_canvas(const CanvasPlace& place, const std::function<void(Action)>& act) {
    const bool offer_taken = draw_banner(session_.banner, place.corner, place.size);
    try {
        if (offer_taken && session_.banner.offer == kShowInFolder)
            show_in_folder(session_.saved_path());
        else if (offer_taken && session_.picture_is_missing())
            act(Action::find_picture);
        else if (offer_taken)
            show_lights();
    } catch (const std::exception& error) {
        say(error.what());
    }
    const Worker& worker = session_.pane().worker();
    if (const auto saving = worker.saving()) {
        if (draw_saving_banner(saving->path.filename().string(), saving->share, place.corner, place.size))
            session_.stop_saving();
    } else if (const auto opening = worker.opening(); opening && session_.placed_once()) {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - opening->since;
        if (passed.count() > kLongOpening && draw_opening_banner(opening->name, place.corner, place.size))
            session_.stop_opening();
    }
}

void DrawingDocument::explain_dot(const Pane& pane, const CanvasPlace& place) const {
    if (!session_.settings.origins || session_.settings.loupe.on || session_.brush.on ||
        session_.retouch.on || !pane.page().request)
        return;
    const PlacerKind placer = pane.page().request->drawing.placer;
    const TileView& tile = pane.tile();
    draw_dot_card(pane.shown(),
                  {.tile_size = pane.tile_size(),
                   .rule = placer == PlacerKind::exact ? tile.rule : Rule{},
                   .placer = placer,
                   .points = tile.points,
                   .newborn = tile.newborn},
                  canvas_.camera(), place);
}

void DrawingDocument::draw_loupe(const Pane& pane, const CanvasPlace& place) {
    const ViewerSettings& settings = session_.settings;
    if (!settings.loupe.on || !session_.placed_once()) return loupe_.hide();
    loupe_.draw({.shown = pane.shown(),
                 .version = pane.version(),
                 .tile_size = compared_.tile_size(),
                 .step = settings.loupe.step,
                 .ink = compared_.settings_of(pane).ink,
                 .paper = compared_.settings_of(pane).paper,
                 .mm_per_page_unit = pane.page().layout.page.mm_per_page_unit},
                canvas_.camera(), place);
}

void DrawingDocument::show_changes(Window& window) {
    if (std::exchange(pictures_fitted_, session_.pictures()) != session_.pictures()) {
        canvas_.fit();
        variations_ = false;
        const Column column = side_panel_.column();  // a tool is of the picture before
        if (column != Column::method) side_panel_.turn_to(Column::drawing, session_);
    }
    if (pictures_fitted_ > 0) window.set_title((session_.has_changes() ? "*" : "") + name() + " - Dapple");
    show_changes(Side::left, session_.placed_once() ? &compared_.seen() : nullptr);
    show_changes(Side::right, compared_.right());
}

void DrawingDocument::show_changes(Side side, const Pane* pane) {
    SeenSide& seen = seen_[static_cast<int>(side)];
    const std::uint64_t version = pane ? pane->version() : 0;
    if (pane && std::exchange(seen.pictures, session_.previews()) != session_.previews())
        canvas_.set_picture(side, session_.picture().preview);
    if (side == Side::left && film_player_.shows_plot()) {
        seen.version = 0;  // the dots are to be shown after it
        return;
    }
    const bool other = std::exchange(seen.pane, pane) != pane;
    if (std::exchange(seen.version, version) != version || other)
        canvas_.set_drawing(side, pane ? pane->shown() : nothing_);
}

double DrawingDocument::placing_seconds() const {
    std::chrono::duration<double> longest{0};
    for (const Pane* pane : compared_.panes()) {
        if (const auto since = pane->worker().placing_since())
            longest =
                std::max<std::chrono::duration<double>>(longest, std::chrono::steady_clock::now() - *since);
    }
    return longest.count();
}

// The share of the side that is behind.
std::optional<double> DrawingDocument::placed_share() const {
    std::optional<double> least;
    for (const Pane* pane : compared_.panes()) {
        if (const auto share = pane->worker().placed_share())
            least = std::min<double>(least.value_or(1), *share);
    }
    return least;
}

StatusInfo DrawingDocument::info() const {
    const Pane& pane = compared_.seen();
    const Stippling& stippling = pane.shown();
    const PlacedDrawing& page = pane.page();
    const double enlarged = canvas_.enlargement();
    const bool more_dots = pane.shows_close() && zoom().mode == ZoomMode::constant_density && enlarged > 1;
    return {.dots = page.dots.size(),
            .duplicates = page.duplicates,
            .as_dense_as = more_dots ? static_cast<double>(page.dots.size()) * enlarged * enlarged : 0,
            .figure8 = compared_.settings_of(pane).placer == PlacerKind::figure8,
            .scale = stippling.scale,
            .tone_ms = pane.shows_close() ? 0 : pane.page().tone_ms,
            .place_ms = stippling.place_ms,
            .relax_ms = pane.shown().relax_ms,
            .steps = pane.shown().steps,
            .all_steps = pane.shown().plan.steps,
            .draw_ms = canvas_.draw_ms(),
            .preview = canvas_.shows_part(),
            .placing_seconds = placing_seconds(),
            .placed_share = placed_share(),
            .frames_per_second = session_.settings.every_frame ? frame_rate_.per_second() : 0,
            .paper = page.is_there() ? paper_in_words(page.layout.page, session_.settings.unit) : "",
            .zoom = paper_zoom_,
            .method = open_.method,
            .plotting = &pane == &session_.pane() ? plotting_ : "",
            .loupe = loupe_.info()};
}

void DrawingDocument::choose_variation(const CanvasPlace& place) {
    DrawingSettings& drawing = session_.settings.drawing;
    const auto variations = variations_of(drawing, session_.drawn());
    const auto chosen = draw_variations(
        variations, [this](const DrawingSettings& each) { return preview_of(each, kVariationSide); },
        place.corner, place.size);
    if (!chosen) return;
    if (variations[*chosen].drawing == drawing) toggle(variations_);
    drawing = variations[*chosen].drawing;
}

EntryPicture DrawingDocument::preview_of(const DrawingSettings& drawing, int side) {
    const OpenedPicture& picture = session_.picture();
    if (!picture.preview) return {};
    const auto make = [mipmaps = picture.preview, drawing = drawing, exposed = picture.exposure,
                       side](const std::stop_token& stop) mutable {
        if (!drawing.automatic_exposure) drawing.tone.exposure -= exposed;
        return small_drawing(small_copy(*mipmaps, kPreviewedSide), drawing, side, stop);
    };
    return previews_.of(std::to_string(side) + embedded_settings({}, drawing, {}), make);
}

SpectrumInfo DrawingDocument::spectrum() {
    const std::optional<ViewAnalysis>& analysis = spectrum_.analysis();
    if (!analysis) return {};
    const bool has_picture = !analysis->picture.empty();
    if (std::exchange(spectrum_drawn_, spectrum_.analyses()) != spectrum_.analyses() && has_picture)
        spectrum_picture_.write(analysis->picture);
    return {&*analysis, has_picture ? texture_id(spectrum_picture_.get()) : ImTextureID{}};
}

void DrawingDocument::measure_dots() {
    if (!session_.placed_once()) return;
    const Pane& pane = session_.pane();
    const auto plotting = plotting_clock_.time(pane, session_.settings);
    plotting_ = plotting                ? "plotting " + time_in_words(plotting->total_s())
                : pane.page().settled() ? ""
                                        : "plotting \u2026";
    if (open_.spectrum)
        spectrum_.update(pane, canvas_.camera(), pane.tile_size());
    else
        spectrum_.stop();
    compared_.measure(canvas_.camera());
}

std::optional<nlohmann::ordered_json> DrawingDocument::status() const {
    if (!session_.placed_once()) return std::nullopt;
    auto line = status_json(info(), session_.pane().placings());
    const auto number = [](const std::optional<double>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    if (const Pane* right = compared_.right())
        line["right"] = {{"dots", right->shown().dots.size()},
                         {"duplicates", right->shown().duplicates},
                         {"scale", right->shown().scale},
                         {"divider", session_.settings.comparison.divider},
                         {"repetition", number(compared_.periodicity(*right))},
                         {"left_repetition", number(compared_.periodicity(session_.pane()))}};
    if (session_.film)
        line["film"] = {{"kind", name_of(session_.film->kind)},
                        {"share", session_.film->share},
                        {"running", session_.film->running},
                        {"moment", film_player_.moment()}};
    return line;
}

double DrawingDocument::seconds_to_next_frame() const {
    constexpr double kLookForPlacing = 0.25;
    if (session_.settings.every_frame || canvas_.drawing()) return 0;
    constexpr double kFilmFrame = 1.0 / 60;
    if (session_.film && session_.film->running) return kFilmFrame;
    const bool at_work = placing_seconds() > 0 || session_.pane().worker().opening();
    const double longest = at_work ? kLookForPlacing : 60;
    return std::min(
        {longest, seconds_until_change(session_.banner), canvas_.seconds_to_next_frame().value_or(longest)});
}

}  // namespace dapple
