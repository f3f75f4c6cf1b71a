#pragma once
// The film that is played in the drawing's place: what the canvas shows of it, and the bar below.

#include <chrono>
#include <functional>
#include <string>

#include "app/viewer/canvas/canvas.h"
#include "app/viewer/model/session.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/view/shown_plot.h"

namespace dapple {

class FilmPlayer {
 public:
    /// Both must live as long.
    FilmPlayer(Session& session, Canvas& canvas);

    void play(FilmKind kind);
    /// Begins one if there is none.
    void play_or_pause();
    void stop();

    /// Lets the film go on to what it shows now.
    void show();
    /// Whether the canvas shows a plot's strokes and not the session's dots.
    bool shows_plot() const;

    /// `act` is asked to save the film.
    void draw_bar(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act);
    /// Where a plotter's pen has just been.
    void draw_trail(const CanvasPlace& place) const;

    /// What is shown of the film, in words. There must be one.
    std::string moment() const;

 private:
    bool is(FilmKind kind) const { return session_.film && session_.film->kind == kind; }
    void look_as_before();
    void show_plot();

    Session& session_;
    Canvas& canvas_;
    Camera camera_before_;
    bool fitted_before_ = true;
    std::chrono::steady_clock::time_point shown_;  // last
    ShownPlot plot_;
    PlacedDrawing plotted_;         // what the canvas shows of it,
    std::size_t plotted_dots_ = 0;  // so many dots, or points of strokes
    int plots_seen_ = 0;
};

}  // namespace dapple
