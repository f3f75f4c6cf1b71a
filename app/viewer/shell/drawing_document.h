#pragma once
// The drawing of a photograph in the window: its canvas, its panels, and what is told about it.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/viewer/background/background.h"
#include "app/viewer/background/small_pictures.h"
#include "app/viewer/canvas/canvas.h"
#include "app/viewer/canvas/crop_frame.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/canvas/loupe.h"
#include "app/viewer/canvas/mask_painter.h"
#include "app/viewer/model/compared_panes.h"
#include "app/viewer/model/export_estimate.h"
#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/side_panel.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/film_player.h"
#include "app/viewer/widgets/picture_entry.h"

namespace dapple {

// The small pictures of a list's entries, as textures.

class EntryPictures {
 public:
    explicit EntryPictures(std::function<void()> wake) : pictures_(std::move(wake)) {}

    /// As SmallPictures::of(); bare while there is none.
    EntryPicture of(const std::string& key, const SmallPictures::Make& make);

    std::size_t size() const { return textures_.size(); }
    /// Gives up what is being made, and all memory. Only before the frame shows any of them.
    void forget();

 private:
    SmallPictures pictures_;
    std::map<std::string, GlTexture> textures_;
};

/// How many dots the window takes on: as many as half of so many bytes of memory hold, both sides of a split
/// view and saving included; at least a million, at most kMostDots.
std::uint64_t most_dots_in(std::uint64_t bytes);

/// Frames per second while frames follow each other; a rest in between does not count.
class FrameRate {
 public:
    using Clock = std::chrono::steady_clock;

    void frame(Clock::time_point now) {
        std::chrono::duration<double> passed = now - last_;
        last_ = now;
        if (passed.count() <= 0 || passed.count() > kRest) return;
        seconds_ = seconds_ > 0 ? seconds_ + 0.1 * (passed.count() - seconds_) : passed.count();
    }
    double per_second() const { return seconds_ > 0 ? 1 / seconds_ : 0; }

 private:
    static constexpr double kRest = 0.5;
    Clock::time_point last_{};
    double seconds_ = 0;
};

class DrawingDocument : public Document {
 public:
    /// Needs the window to be there. The image may be a project; without one it draws the built-in sample. A
    /// tile that is given is drawn with, whatever a project says. Throws std::runtime_error if the project
    /// cannot be read.
    DrawingDocument(const std::optional<std::filesystem::path>& image, const std::optional<std::string>& tile,
                    const KeptView& view = {}, const std::filesystem::path& presets = {},
                    const std::filesystem::path& palettes = {});

    std::span<const Shortcut> shortcuts() const override;
    Session* session() override { return &session_; }
    void open_tile(const std::filesystem::path& file) override { session_.open_tile(file); }
    void open_mask(const std::filesystem::path& file) override;
    void take_dropped(const std::filesystem::path& file) override { session_.take_dropped(file); }
    bool is_picture_with_settings(const std::filesystem::path& file) const override;
    void open_as_picture(const std::filesystem::path& file) override { session_.open(file); }
    void save(const std::filesystem::path& file) override { session_.save(file); }
    std::string saving() const override;
    void stop_saving() override { session_.stop_saving(); }
    bool tells_of_trouble() const override { return is_trouble(session_.banner); }
    std::filesystem::path file() const override;
    void say(const std::string& sentence) override { session_.say(sentence); }
    std::optional<KeptView> kept_view() const override;
    OpenQuestion what_to_open() const override;
    const std::string& tile() const override { return session_.settings.drawing.tile; }
    std::optional<SaveQuestion> where_to_save() const override;
    std::optional<SaveQuestion> where_to_save_project() const override;
    std::optional<SaveQuestion> where_to_save_film() const override;
    std::string unsaved() const override;
    std::string draw_saving_options(std::size_t format) override;
    void draw_saving_rows(std::size_t format) override;
    void act(Action action, const Frame& frame) override;
    void draw(const Frame& frame) override;
    void draw_rows() override { SidePanel::draw_rows(session_); }
    double seconds_to_next_frame() const override;
    std::unique_ptr<Document> take_successor() override { return std::move(successor_); }
    std::optional<nlohmann::ordered_json> status() const override;

 private:
    /// A film's bar lies below the canvas, below it the captions, and below them the status line.
    struct Layout {
        CanvasPlace canvas;
        glm::vec2 player, captions, status;
    };
    Layout layout(const Frame& frame) const;
    void show_lights();
    /// By Escape: what began last.
    void stop_what_takes_long();
    Zoom zoom() const;
    void draw_over_canvas(const CanvasPlace& place, const std::function<void(Action)>& act);
    void draw_loupe(const Pane& pane, const CanvasPlace& place);
    void explain_dot(const Pane& pane, const CanvasPlace& place) const;
    /// The project's name, or else the picture's.
    std::string name() const;
    /// Beside the picture, but for pasted ones, which nobody looks for.
    std::filesystem::path folder_to_save_in() const;
    void take_mask();
    void show_changes(Window& window);
    void show_changes(Side side, const Pane* pane);
    StatusInfo info() const;
    double placing_seconds() const;
    std::optional<double> placed_share() const;
    SpectrumInfo spectrum();
    /// What settings make of the picture shown, its longer side so many pixels.
    EntryPicture preview_of(const DrawingSettings& drawing, int side);
    void choose_variation(const CanvasPlace& place);
    void measure_dots();

    Canvas canvas_;
    Session session_;
    ComparedPanes compared_;
    FilmPlayer film_player_{session_, canvas_};
    const PlacedDrawing nothing_{};
    ViewMeter spectrum_;
    GlTexture spectrum_picture_;
    int spectrum_drawn_ = 0;  // the number of the analysis that it shows
    OpenSections open_ = {};
    SidePanel side_panel_;
    EntryPictures previews_;  // of presets,
    int previewed_ = 0;       // and of the picture of that number
    Loupe loupe_;
    MaskPainter mask_painter_;
    Retoucher retoucher_;
    CropFrame crop_frame_;
    Background<Mask> mask_reading_;
    FrameRate frame_rate_;
    ExportEstimate estimate_;
    double paper_zoom_ = 1;  // see StatusInfo
    PlottingClock plotting_clock_;
    std::string plotting_;  // what it says

    struct SeenSide {
        int pictures = 0;
        const Pane* pane = nullptr;
        std::uint64_t version = 0;
    };
    std::array<SeenSide, 2> seen_;  // by the canvas
    int pictures_fitted_ = 0;
    bool variations_ = false;  // in the canvas's place
    bool compare_pressed_ = false;
    std::unique_ptr<Document> successor_;
};

}  // namespace dapple
