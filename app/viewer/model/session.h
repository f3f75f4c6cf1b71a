#pragma once
// What the window is about: a picture, the settings, the dots placed for them, and what is saved of it. Knows
// neither panels nor OpenGL.

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/model/banner.h"
#include "app/viewer/model/crop_percent.h"
#include "app/viewer/model/history.h"
#include "app/viewer/model/mask_brush.h"
#include "app/viewer/model/pane.h"
#include "app/viewer/model/tile_choices.h"
#include "app/viewer/model/viewer_settings.h"
#include "io/film/film.h"
#include "io/settings/project.h"

namespace dapple {

// The film that the window plays, and what it asks to be placed.

struct PlayedFilm {
    FilmKind kind = FilmKind::growth;
    double share = 0;  // of it that has passed, 0..1
    bool running = true;
    double seconds = 8;      // that it takes
    std::uint64_t dots = 0;  // growth: of the whole drawing
    int deepest = 7;         // levels: the last one that has dots, as far as is known

    bool operator==(const PlayedFilm&) const = default;
};

/// Goes on by so many seconds; it rests at its end.
void pass(PlayedFilm& film, double seconds);
/// From where it rests, or from the beginning once it has ended.
void run_on(PlayedFilm& film);

/// What is placed at that moment, at most kMostFilmDots. A plot and a zoom need what is placed without them:
/// the plot shows its strokes one by one, the zoom asks by its camera.
DotsRequest film_request(const ViewerSettings& settings, const PlayedFilm& film);

/// The deepest level that has dots; they need their thresholds.
int deepest_level(const DotPieces& dots, std::size_t tile_size);

class Session {
 public:
    /// `wake` is called from other threads whenever there is an event. A drawing has at most `most_dots`
    /// dots, whatever the settings ask for.
    Session(const DrawingSettings& drawing, std::function<void()> wake, std::uint64_t most_dots = kMostDots);

    /// Other settings to begin with, before anything is opened: undo does not go back behind them.
    void begin_with(const ViewerSettings& begin);

    void open_sample();
    void open(const std::filesystem::path& path);
    void save(const std::filesystem::path& path);
    /// Gives up what is being saved: what was at its place stays.
    void stop_saving() { pane_.worker().cancel_saving(); }
    /// The drawing onto the clipboard, as the PNG that would be exported. The banner says how that went.
    void copy_picture();
    /// Begins to play; nothing before the first dots.
    void play(FilmKind kind);
    /// The film that is played, as a file: see save_film().
    void save_film(const std::filesystem::path& path);

    /// Draws with a tile file from now on. If it is not one the banner says why, and nothing changes.
    void open_tile(const std::filesystem::path& file);
    /// The picture and all settings of a project. If they cannot be read the banner says so, and nothing
    /// changes, but that the sample is opened where there is no picture yet. If its picture turns out later
    /// not to be readable, everything is again as it was before. If the picture is not there, the banner says
    /// so and offers to find it; the project keeps its name until then.
    void open_project(const std::filesystem::path& file);
    /// The project's picture is this one.
    void find_picture(const std::filesystem::path& file);
    bool picture_is_missing() const { return !source_.project.why_missing.empty(); }
    /// The picture that was opened last and all settings into a file; the banner says how that went.
    void save_project(const std::filesystem::path& file);

    /// Whether there is something that would be lost: the drawing's settings are others than those that were
    /// saved last, in a project or in a drawing that holds them, or that its picture was opened with. As far
    /// as remember() knows.
    bool has_changes() const { return has_changes_; }
    /// Whether this file, opened, would take the place of some of them that are a project's, a mask or edits.
    bool would_lose_changes(const std::filesystem::path& file) const;
    /// The picture and all settings into a file, in case the program ends before they are saved. Throws as
    /// save_atomically().
    void keep(const std::filesystem::path& file);
    /// What was kept there: it has still to be saved, once its picture is read. The banner says what is
    /// wrong.
    void bring_back(const std::filesystem::path& file);
    /// A number that changes with every change of the settings.
    int changes() const { return history_.changes(); }

    /// The settings of a preset, but for what is the picture's own.
    void take_preset(const SavedSettings& preset);

    /// A tile or a project, if the file's name ends as theirs do; the settings of an SVG or PNG that Dapple
    /// made; or else a picture.
    void take_dropped(const std::filesystem::path& file);
    /// The tiles to choose from.
    std::span<const std::string> tiles() const { return tiles_.names(); }

    /// What goes wrong in it is said by the banner; then false.
    bool attempt(const std::function<void()>& work);

    /// Takes the events of the workers, waiting up to `patience` for a placing under way. Throws
    /// std::runtime_error if the first picture could not be read.
    void take_events(std::chrono::milliseconds patience);

    /// Requests what the settings ask for and waits a moment for it, so that dots and slider move in the same
    /// frame. Where a hand holds what changes, dots are relaxed to the end once it lets go.
    void request_dots(const Zoom& zoom, bool held = false);
    /// Such a request within the session's bound, and with all of the picture while it is being cropped.
    DotsRequest as_shown(DotsRequest request) const;

    /// Gives up the reading of a picture: the one before stays, or what there is of a first look.
    void stop_opening() { pane_.worker().stop_opening(); }

    /// Gives up the work under way: the settings are again the shown drawing's, with the steps it has so far.
    void stop_placing();

    /// Remembers the settings for undo, unless they are still being edited. To open a picture is one step,
    /// with all that comes with it: nothing is remembered while it is being read.
    void remember(bool editing);
    /// Across that step they open the picture that was there before or after it again, with its settings.
    /// While a picture is being read they do nothing.
    void undo();
    void redo();
    /// What those would change, in words; none: there is nothing to undo or to redo.
    const std::optional<std::string>& undo_words() const { return undo_words_; }
    const std::optional<std::string>& redo_words() const { return redo_words_; }

    ViewerSettings settings;  // the panels edit them
    // Tools, and so neither saved nor undone.
    CropTool cropping;
    bool as_placed = false;  // the dots are shown before they relax, for the method
    /// The page's room within its margins, as wide and high as the picture was opened.
    glm::dvec2 room_for_crop() const;
    MaskBrush brush;
    RetouchTool retouch;
    ShownPens shown_pens;
    std::optional<PlayedFilm> film;  // shown in the drawing's place
    Banner banner;
    /// Into the banner: what went wrong. Where the project's picture is missing it goes on offering to find
    /// it.
    void say(const std::string& sentence);

    /// The drawing: what is edited and saved.
    const Pane& pane() const { return pane_; }
    bool placed_once() const { return pane_.placings() > 0; }

    const OpenedPicture& picture() const { return picture_; }
    /// How many were opened, and how many there were to see: a first look is another.
    int pictures() const { return pictures_; }
    int previews() const { return previews_; }
    const std::filesystem::path& picture_path() const { return source_.picture; }  // empty: none yet
    /// The file that this picture was saved in last; empty: none yet.
    const std::filesystem::path& saved_path() const { return saved_path_; }
    /// What was written then.
    const std::vector<std::filesystem::path>& saved_files() const { return saved_files_; }
    /// What saving under that name would write, of the pens that draw at present.
    std::vector<std::filesystem::path> files_to_save(const std::filesystem::path& path) const;

    /// The project that was opened or saved last, and not left for another picture; empty: none.
    const std::filesystem::path& project_path() const { return source_.project_path; }

    DrawnInfo drawn() const;

 private:
    /// What is drawn, as it was asked for.
    struct Source {
        std::filesystem::path picture = {};  // empty: the sample
        Project project = {};                // whose picture may be missing: then another is shown
        std::filesystem::path project_path = {};
        bool brought_back = false;  // and not saved since
    };
    /// What undo goes back to.
    struct Step {
        ViewerSettings settings;
        int opened = 0;  // of what was opened, which one they were of
        bool operator==(const Step&) const = default;
    };
    /// What was opened, as it was left for another.
    struct Left {
        Source source;
        std::optional<DrawingSettings> safe;
    };
    /// A picture that is being read, and what there was before: that comes back if it cannot be.
    struct SettingsBefore {
        ViewerSettings settings;
        std::optional<DrawingSettings> safe;
    };
    struct Reading {
        std::filesystem::path picture;
        int opened = 0;  // its number, which undo knows it by
        Source before;
        std::optional<SettingsBefore> settings_before = {};
        Mask mask_before = {};  // where the settings stay
        std::string edits_before = {};
    };

    void read(const std::filesystem::path& picture);
    void read_sample();
    void begin_reading(Source next, int opened);
    std::optional<Reading> end_reading(const std::filesystem::path& picture);
    PrepareFile file_to_write(const std::filesystem::path& path, const DrawingSettings& drawing,
                              const SavingChoice& saving) const;
    void read_source();
    bool open_again(const Step& step);
    void come_to(int opened, Left before);
    const Source& source_of(const Step& step) const;
    void go_back_before(const std::filesystem::path& picture);
    void name_changes();
    void know_safe(std::optional<DrawingSettings> drawing);
    /// Throws std::runtime_error if it cannot be read, and nothing changes.
    void load_project(const std::filesystem::path& file);
    /// Where it is in a file, it is one of tiles() from then on.
    void open_tile_of(DrawingSettings& drawing);
    void take(SavedSettings taken);
    void take(DotsPlaced& event);
    void take(TaskFailed& event);
    void take(DrawingSaved& event);
    void take(SavingCancelled& event);
    void take(OpeningStopped& event);

    // The settings of the page requested last, and of the one placed last.
    std::optional<ViewerSettings> requested_settings_, placed_settings_;
    int all_opened_ = 0, opened_ = 0;  // so many; the number of the one that is shown, from 0 on
    std::map<int, Left> left_;         // by their numbers
    History<Step> history_;
    int changes_named_ = 0;                // of the history, by the words
    std::optional<DrawingSettings> safe_;  // nothing is lost with these; none: whatever they are
    bool has_changes_ = false;
    std::optional<std::string> undo_words_, redo_words_;
    std::uint64_t most_dots_;
    TileChoices tiles_;
    Pane pane_;
    bool placing_failed_ =
        false;  // the last one: what the banner says of it goes with the next that does not
    OpenedPicture picture_;
    int pictures_ = 0, previews_ = 0;
    std::filesystem::path saved_path_;
    std::vector<std::filesystem::path> saved_files_;
    std::map<std::filesystem::path, SavedSettings> saves_;  // under way
    std::filesystem::path film_path_;                       // saved last
    std::filesystem::path copied_path_;                     // copied last
    Source source_;
    std::deque<Reading> readings_;  // in the order in which they were asked for
};

}  // namespace dapple
