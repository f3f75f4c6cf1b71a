#include "app/viewer/model/played_film.h"

#include <algorithm>

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

}  // namespace dapple
