#pragma once
// The bar below the canvas while a film is played.

#include <glm/vec2.hpp>
#include <string>

#include "app/viewer/model/played_film.h"

namespace dapple {

/// How high the bar is, in ImGui's points: it grows with the window's text.
float player_bar_height();

/// What a click in the bar asks for beside what it changes in the film.
enum class PlayerWish { none, close, save, other_film };

/// Over the whole width of a rectangle. `words` tell the moment: "1,234 dots". `chosen` becomes the kind of
/// another film, if one is wished.
PlayerWish draw_player_bar(PlayedFilm& film, const std::string& words, FilmKind& chosen, glm::vec2 corner,
                           glm::vec2 size);

}  // namespace dapple
