#pragma once
// The film that the window plays, and what it asks to be placed.

#include <cstdint>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/model/viewer_settings.h"
#include "io/film/film.h"

namespace dapple {

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

}  // namespace dapple
