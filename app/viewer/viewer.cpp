#include "app/viewer/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/drawing_steps.h"
#include "app/files/sample.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "app/viewer/canvas.h"
#include "app/viewer/frame_rate.h"
#include "app/viewer/history.h"
#include "app/viewer/panels/banner.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/file_dialog.h"
#include "app/viewer/panels/help_panel.h"
#include "app/viewer/panels/saving_banner.h"
#include "app/viewer/panels/status_line.h"
#include "app/viewer/panels/tile_panel.h"
#include "app/viewer/panels/tone_panel.h"
#include "app/viewer/panels/view_panel.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/spectrum_view.h"
#include "app/viewer/status_log.h"
#include "app/viewer/theme.h"
#include "app/viewer/viewer_settings.h"
#include "app/viewer/widgets.h"
#include "app/viewer/window.h"
#include "app/viewer/worker.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

// A placing so short is waited for, so that dots and slider move in the same frame.
constexpr std::chrono::milliseconds kPatience(8);
constexpr std::chrono::milliseconds kLongPatience(2000);
// ImGui answers an event over a few frames.
constexpr int kFramesAfterEvent = 3;
// Pixels per page unit from which only what is in view is placed: before, a float on the page is as good as a
// hundredth of a pixel.
constexpr double kCloseZoom = 0x1p15;
// Dots that fade in are paler than they will be; so many more of them make up for it.
constexpr double kFadeHeadStart = 1.07;
constexpr float kPanelWidth = 340, kStatusHeight = 30;

bool input_arrived() {
    const ImGuiIO& io = ImGui::GetIO();
    bool arrived = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
        arrived |= io.MouseClicked[button] || io.MouseReleased[button];
    return arrived;
}

class Viewer {
 public:
    explicit Viewer(const ViewerOptions& options);
    int run();

 private:
    void take_news(std::chrono::milliseconds patience);
    void take(PlacedNews& news);
    void take(FailedNews& news);
    void take(SavedNews& news) { banner_ = {BannerKind::notice, "Saved " + news.path.string()}; }

    void take(CancelledNews& news) {
        banner_ = {BannerKind::notice, "Cancelled: " + news.path.string() + " was not written"};
    }

    void frame();
    void draw_panels(glm::vec2 corner, glm::vec2 size);
    void draw_dialogs();
    void act(Action action);
    void open(const fs::path& path);
    void export_to(const fs::path& path);
    void order_dots();
    std::optional<CloseView> close_view() const;
    CanvasLook look() const;
    DrawnFacts drawn() const;
    StatusFacts status() const;
    PointsInView points_on_screen() const;
    void measure_dots();
    void colour_dots();
    void report_outside();

    ViewerOptions options_;
    ViewerSettings settings_;
    History<ViewerSettings> history_;
    Window window_;
    Canvas canvas_;
    Worker worker_;
    SpectrumView spectrum_;

    std::optional<PlaceOrder> ordered_, placed_order_;  // of the whole page
    PlacedDrawing drawing_;
    std::optional<PlaceOrder> close_ordered_;  // of what is in view
    PlacedDrawing close_drawing_;
    bool shows_close_ = false;
    struct Coloured {
        std::uint64_t drawing = 0;
        DotColouring colouring = DotColouring::ink;
        int deepest_level = kDeepestStep;
        glm::vec3 ink = kBlack;
        bool operator==(const Coloured&) const = default;
    };
    Coloured coloured_;
    bool placed_once_ = false, ready_ = false;
    std::uint64_t placings_ = 0;
    std::string logged_;
    std::string picture_name_, picture_description_;
    int picture_side_ = 1;
    fs::path picture_path_, saved_path_;

    Banner banner_;
    FileDialog dialog_;
    TileView tile_;
    TilePanelState tile_panel_;
    FrameRate frame_rate_;
    WidgetPlaces widgets_;
    bool panels_shown_ = true, help_open_ = false;
};

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      settings_{.drawing = options.settings},
      history_(settings_),
      window_("Dapple"),
      worker_(&Window::wake),
      spectrum_(&Window::wake) {
    ImGui::GetIO().UserData = &widgets_;
    if (options.image)
        open(*options.image);
    else
        worker_.open("Still life", [] { return sample_picture(); });
}

void Viewer::open(const fs::path& path) {
    worker_.open(path.filename().string(), [path] { return read_picture(path); });
    picture_path_ = path;
}

void Viewer::export_to(const fs::path& path) {
    saved_path_ = path;
    DrawingSettings settings = settings_.drawing;
    DensityChoice choice = settings_.density;
    worker_.save(path, [path, settings, choice](Workbench& bench, std::stop_token stop) -> Worker::Write {
        PlacedDrawing drawing;
        if (!bench.place(order_of(settings, choice), drawing, stop)) return {};
        const Density& density = bench.density(settings.tone, choice);
        if (drawing_format(path) == DrawingFormat::csv) fill_critical_scales(drawing.stippling.dots, density);
        PageSize page = page_size(density, settings.width_mm);
        std::size_t tile_size = bench.tile(settings.tile, settings.ranking).tile().size();
        return [path, settings, page, tile_size, drawing = std::move(drawing)](const SavingWatch& watch) {
            return save_drawing(path, settings,
                                {.stippling = drawing.stippling,
                                 .page = page,
                                 .tiles = drawing.outlines,
                                 .tile_size = tile_size},
                                watch);
        };
    });
}

std::optional<CloseView> Viewer::close_view() const {
    const Camera& camera = canvas_.camera();
    const bool constant_density = settings_.zoom_mode == ZoomMode::constant_density;
    if (settings_.drawing.stipple.placer != PlacerKind::exact) return {};
    if (!constant_density && camera.pixels_per_unit < kCloseZoom) return {};
    // A drawing of exactly so many dots ends just on its scale; the last of them lies within the next.
    double scale = std::nextafter(static_cast<float>(drawing_.stippling.scale), INFINITY);
    if (constant_density) scale *= kFadeHeadStart * canvas_.enlargement() * canvas_.enlargement();
    return CloseView{window_in_view(camera, 0.3), scale};
}

void Viewer::order_dots() {
    PlaceOrder order = order_of(settings_.drawing, settings_.density);
    const auto close = close_view();
    if (!close && close_ordered_) {
        close_ordered_.reset();
        shows_close_ = false;
        canvas_.set_drawing(drawing_);
    }
    // The whole drawing comes first: its scale is what a close view starts from.
    if (close && ordered_ == order && placed_order_ == order) {
        order.close = close;
        if (!settings_.every_frame && close_ordered_ == order) return;
        close_ordered_ = order;
    } else {
        if (!settings_.every_frame && ordered_ == order) return;
        ordered_ = order;
    }
    worker_.place(std::move(order));
    take_news(settings_.every_frame ? kLongPatience : kPatience);
}

void Viewer::take_news(std::chrono::milliseconds patience) {
    for (WorkerNews& news : worker_.news(patience)) std::visit([this](auto& n) { take(n); }, news);
}

void Viewer::take(PlacedNews& news) {
    if (news.picture) {
        picture_name_ = news.picture->name;
        picture_description_ = news.picture->description;
        picture_side_ = news.picture->longer_side;
        canvas_.set_picture(news.picture->preview);
        canvas_.fit();
        window_.set_title(picture_name_ + " - Dapple");
        if (banner_.kind == BannerKind::notice) banner_ = {};
    }
    if (news.tile) {
        tile_ = std::move(*news.tile);
        tile_panel_ = {};
    }
    if (!news.error.empty()) banner_ = {BannerKind::error, news.error};
    if (news.order.close) {
        if (close_ordered_) {
            std::swap(close_drawing_, news.drawing);
            canvas_.set_drawing(close_drawing_);
            shows_close_ = true;
        }
    } else {
        if (news.picture) shows_close_ = false;
        std::swap(drawing_, news.drawing);
        placed_order_ = news.order;
        if (!shows_close_) canvas_.set_drawing(drawing_);
        if (close_ordered_) close_ordered_->close = CloseView{};  // to be ordered again
    }
    worker_.recycle(std::move(news.drawing));
    placed_once_ = true;
    ++placings_;
}

void Viewer::take(FailedNews& news) {
    // The picture named on the command line: there is nothing to go on showing.
    if (!placed_once_) throw std::runtime_error(news.message);
    banner_ = {BannerKind::error, news.message};
}

CanvasLook Viewer::look() const {
    const DrawingSettings& settings = settings_.drawing;
    CanvasLook look;
    look.desk = rgb_of(ThemeColour::surround);
    look.paper = settings.paper;
    look.ink = settings.ink;
    look.dot_radius = drawn().dot_radius_mm / settings.width_mm * drawing_.page_size.x;
    if (settings_.density.source == DensitySource::photograph)
        look.picture_opacity = settings_.picture_opacity;
    look.tiles = settings.show_tiles;
    if (shows_close_ && settings_.zoom_mode == ZoomMode::constant_density) {
        const double enlargement = canvas_.enlargement();
        look.dot_radius /= enlargement;
        look.fade_scale = drawing_.stippling.scale * enlargement * enlargement * kFadeHeadStart;
    }
    look.pixel_scale = ImGui::GetFontSize() / 15 * static_cast<float>(window_.pixels_per_point().x);
    return look;
}

DrawnFacts Viewer::drawn() const {
    const DrawingSettings& settings = settings_.drawing;
    PageSize page;
    page.mm_per_page_unit = settings.width_mm / drawing_.page_size.x;
    double scale = drawing_.stippling.scale;
    return {drawing_.stippling.dots.size() - drawing_.stippling.duplicates, scale,
            dot_radius_mm(settings, scale, page)};
}

StatusFacts Viewer::status() const {
    const Stippling& stippling = shows_close_ ? close_drawing_.stippling : drawing_.stippling;
    return {.dots = stippling.dots.size(),
            .duplicates = stippling.duplicates,
            .figure8 = settings_.drawing.stipple.placer == PlacerKind::figure8,
            .scale = stippling.scale,
            .tone_ms = shows_close_ ? 0 : drawing_.tone_ms,
            .place_ms = stippling.place_ms,
            .draw_ms = canvas_.draw_ms(),
            .frames_per_second = frame_rate_.per_second(),
            .zoom = canvas_.camera().pixels_per_unit / picture_side_};
}

PointsInView Viewer::points_on_screen() const {
    const PlacedDrawing& shown = shows_close_ ? close_drawing_ : drawing_;
    const PageWindow view = window_in_view(canvas_.camera(), 0);
    // Relative to the dots' origin, which may lie deep within the page.
    const PagePoint origin{shown.window.x, shown.window.y};
    const glm::dvec2 low = in_page_units(PagePoint{view.x, view.y} - origin);
    const glm::dvec2 page_end = shown.page_size - in_page_units(origin);
    const glm::dvec2 high = glm::min(low + glm::dvec2(view.width, view.height), page_end);
    return points_in_view(shown.stippling.dots, {low, high - low});
}

void Viewer::measure_dots() {
    if (!placed_once_) return;
    spectrum_.update({placings_, canvas_.camera()}, [this] {
        return ViewAnalysisRequest{.view = points_on_screen(),
                                   .tile_size = std::max<std::size_t>(tile_.points.size(), 1),
                                   .has_duplicates = drawing_.stippling.duplicates > 0};
    });
}

void Viewer::colour_dots() {
    const glm::vec3 ink = settings_.drawing.ink;
    const Coloured wanted{canvas_.drawings(), settings_.colouring, settings_.deepest_level, ink};
    if (coloured_ == wanted) return;
    coloured_ = wanted;
    const PlacedDrawing& shown = shows_close_ ? close_drawing_ : drawing_;
    const bool turns = settings_.drawing.stipple.placer == PlacerKind::exact;
    const DotOrigins origins{.tile_size = std::max<std::size_t>(tile_.points.size(), 1),
                             .rule = turns ? tile_.rule : Rule{},
                             .window = shown.window};
    const Dots& dots = shown.stippling.dots;
    canvas_.set_dot_colours(without_deeper_levels(dot_colours(dots, origins, settings_.colouring), dots,
                                                  origins.tile_size, settings_.deepest_level, ink));
}

void Viewer::act(Action action) {
    switch (action) {
        case Action::open: {
            dialog_.show(FileDialog::Purpose::open_picture,
                         picture_path_.empty() ? fs::current_path() : picture_path_);
            break;
        }
        case Action::save:
            if (!saved_path_.empty()) {
                export_to(saved_path_);
                break;
            }
            [[fallthrough]];
        case Action::save_as: {
            fs::path start = saved_path_;
            if (start.empty()) start = fs::current_path() / fs::path(picture_name_).stem().concat(".svg");
            dialog_.show(FileDialog::Purpose::save_drawing, start);
            break;
        }
        case Action::undo:
            settings_ = history_.undo();
            break;
        case Action::redo:
            settings_ = history_.redo();
            break;
        case Action::fit:
            canvas_.fit();
            break;
        case Action::one_to_one:
            canvas_.zoom_to(picture_side_);
            break;
        case Action::zoom_in:
            canvas_.zoom(1.25);
            break;
        case Action::zoom_out:
            canvas_.zoom(0.8);
            break;
        case Action::toggle_tiles:
            settings_.drawing.show_tiles = !settings_.drawing.show_tiles;
            break;
        case Action::toggle_panels:
            panels_shown_ = !panels_shown_;
            break;
        case Action::full_screen:
            window_.toggle_full_screen();
            break;
        case Action::help:
            help_open_ = !help_open_;
            break;
        case Action::quit:
            window_.close();
            break;
    }
}

void Viewer::draw_panels(glm::vec2 corner, glm::vec2 size) {
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("##panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus);
    push_title_font();
    ImGui::TextUnformatted(picture_name_.c_str());
    pop_title_font();
    hint(picture_description_.c_str());
    ImGui::Dummy({0, 0});
    float air = ImGui::GetStyle().ItemSpacing.x;
    float third = (ImGui::GetContentRegionAvail().x - 2 * air) / 3;
    auto button = [&](const char* label, Action action) {
        if (ImGui::Button(label, {third, 0})) act(action);
        note_place(label);
    };
    button("Open...", Action::open);
    ImGui::SameLine();
    button("Export...", Action::save_as);
    ImGui::SameLine();
    button("Keys", Action::help);

    draw_tone_panel(settings_.drawing.tone);
    draw_dots_panel(settings_.drawing, drawn(), built_in_tile_names());
    draw_view_panel(settings_);
    spectrum_.draw(settings_.density);
    draw_tile_panel(tile_, tile_panel_);
    ImGui::End();
    ImGui::PopStyleVar();
}

void Viewer::draw_dialogs() {
    draw_help_panel(help_open_);
    auto purpose = dialog_.purpose();
    if (auto path = dialog_.draw()) {
        if (purpose == FileDialog::Purpose::open_picture)
            open(*path);
        else
            export_to(*path);
    }
}

void Viewer::frame() {
    window_.begin_frame();
    widgets_.clear();
    frame_rate_.frame(FrameRate::Clock::now());
    for (const fs::path& path : window_.take_dropped()) open(path);
    for (Action action : pressed_actions()) act(action);
    take_news(std::chrono::milliseconds(0));

    float scale = ImGui::GetFontSize() / 15;
    glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
    glm::vec2 panel{panels_shown_ ? std::min(kPanelWidth * scale, screen.x * 0.6f) : 0, screen.y};
    float status_height = panels_shown_ ? kStatusHeight * scale : 0;
    CanvasPlace place{{0, 0}, {screen.x - panel.x, screen.y - status_height}, window_.pixels_per_point()};
    if (panels_shown_) draw_panels({place.size.x, 0}, panel);
    draw_dialogs();
    history_.observe(settings_, ImGui::IsAnyItemActive());
    order_dots();
    if (panels_shown_) draw_status_line({0, place.size.y}, {place.size.x, status_height}, status());
    draw_banner(banner_, place.corner, place.size);
    if (auto saving = worker_.saving())
        if (draw_saving_banner(saving->path.filename().string(), saving->share, place.corner, place.size))
            worker_.cancel_saving();
    canvas_.handle_mouse(place);
    colour_dots();
    canvas_.show(place, look(), settings_.every_frame ? Redraw::always : Redraw::when_changed);
    measure_dots();
    window_.end_frame();
    report_outside();
}

void Viewer::report_outside() {
    if (!placed_once_) return;
    if (!ready_) std::puts("ready");
    if (options_.log_status) {
        std::string line = status_json(status(), placings_, widgets_);
        if (line != logged_) std::puts(line.c_str());
        logged_ = std::move(line);
    }
    std::fflush(stdout);
    ready_ = true;
}

int Viewer::run() {
    int frames_left = kFramesAfterEvent;
    while (!window_.should_close()) {
        bool restless = frames_left > 0 || settings_.every_frame || canvas_.measuring();
        double rest = ImGui::GetIO().WantTextInput ? 0.3 : 60;
        window_.wait_for_events(restless ? 0 : rest);
        if (!restless) frames_left = kFramesAfterEvent;
        frame();
        frames_left = input_arrived() ? kFramesAfterEvent : frames_left - 1;
    }
    return 0;
}

}  // namespace

int run_viewer(const ViewerOptions& options) {
    return Viewer(options).run();
}

}  // namespace dapple
