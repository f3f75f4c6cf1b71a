#include "app/viewer/shell/film_player.h"

#include <fmt/format.h>

#include <utility>

#include "app/viewer/canvas/page_frame.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/shell/window.h"
#include "core/text/number_words.h"

namespace dapple {

FilmPlayer::FilmPlayer(Session& session, Canvas& canvas)
    : session_(session), canvas_(canvas), plot_(&Window::wake) {}

void FilmPlayer::play(FilmKind kind) {
    look_as_before();
    camera_before_ = canvas_.camera();
    fitted_before_ = canvas_.is_fitted();
    session_.play(kind);
    shown_ = std::chrono::steady_clock::now();
    plotted_dots_ = 0;
}

void FilmPlayer::play_or_pause() {
    if (!session_.film) return play(FilmKind::growth);
    if (session_.film->running)
        session_.film->running = false;
    else
        run_on(*session_.film);
}

void FilmPlayer::stop() {
    look_as_before();
    session_.film.reset();
    plot_.forget();
}

void FilmPlayer::look_as_before() {
    if (!is(FilmKind::zoom)) return;
    canvas_.look(camera_before_);
    if (fitted_before_) canvas_.fit();
}

void FilmPlayer::show() {
    if (!session_.film) return;
    PlayedFilm& film = *session_.film;
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(shown_, now);
    const bool waits = film.kind == FilmKind::plot && !plot_.film();
    if (!waits) pass(film, passed.count());
    if (film.kind == FilmKind::zoom) {
        const Camera before = resized(camera_before_, canvas_.camera().canvas);
        canvas_.look(zoomed_at(before, before.canvas * 0.5, film_zoom(film.share, FilmChoice{}.depth)));
    }
    if (film.kind == FilmKind::plot) show_plot();
}

bool FilmPlayer::shows_plot() const {
    return is(FilmKind::plot) && plot_.film();
}

void FilmPlayer::show_plot() {
    const PlacedDrawing& page = session_.pane().page();
    try {
        plot_.prepare(session_.pane().placings(), page, session_.settings.drawing, session_.settings.saving);
    } catch (const std::exception& error) {
        session_.say(error.what());
    }
    const PlotFilm* const film = plot_.film();
    if (!film) return;
    const std::size_t drawn = film->drawn_after(plotted_seconds(session_.film->share, film->total_seconds));
    const bool other = std::exchange(plots_seen_, plot_.films()) != plot_.films();
    if (std::exchange(plotted_dots_, drawn) == drawn && !other) return;
    plotted_ = plot_.drawn(page, drawn);
    canvas_.set_drawing(Side::left, plotted_);
}

void FilmPlayer::draw_bar(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act) {
    if (!session_.film) return;
    FilmKind chosen = session_.film->kind;
    switch (draw_player_bar(*session_.film, moment(), chosen, corner, size)) {
        case PlayerWish::none:
            return;
        case PlayerWish::close:
            return stop();
        case PlayerWish::save:
            return act(Action::save_film);
        case PlayerWish::other_film:
            return play(chosen);
    }
}

void FilmPlayer::draw_trail(const CanvasPlace& place) const {
    if (is(FilmKind::plot)) draw_pen_trail(plot_.trail(plotted_dots_), canvas_.camera(), place);
}

std::string FilmPlayer::moment() const {
    const PlayedFilm& film = *session_.film;
    switch (film.kind) {
        case FilmKind::growth:
            return grouped(grown_dots(film.share, film.dots)) + " dots";
        case FilmKind::levels:
            return fmt::format("level {} of {}", level_shown(film.share, film.deepest) + 1, film.deepest + 1);
        case FilmKind::zoom:
            return fmt::format("{:.3g} times larger", film_zoom(film.share, FilmChoice{}.depth));
        case FilmKind::plot:
            break;
    }
    if (!plot_.film()) return "finding the route ...";
    const double all = plot_.film()->total_seconds;
    const auto clock = [](double seconds) {
        const auto whole = static_cast<long>(seconds);
        return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    };
    return clock(plotted_seconds(film.share, all)) + " of " + clock(all);
}

}  // namespace dapple
