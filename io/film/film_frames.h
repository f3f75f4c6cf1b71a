#pragma once
// The pictures that a film is made of.

#include <functional>
#include <glm/gtc/type_precision.hpp>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"
#include "core/routing/short_way.h"
#include "io/film/film.h"

namespace dapple {

/// How a film changes what is drawn: growth, levels and zoom are the placer's own, so they show dots as
/// placed, round and in one ink, and at most kMostFilmDots of them; those of growth then settle, so that it
/// ends with the drawing. A plot is the drawing as it is saved.
DrawingSettings film_settings(DrawingSettings settings, FilmKind kind);

/// Draws a film's picture at a share of it, 0..1; all are as large.
using FilmFrame = std::function<Grid<glm::u8vec3>(double share)>;

/// A film of the drawing that those settings make. The pipeline needs its picture and tile, and has to
/// outlive the result. What is slow to find (a plotter's way) is found now; if stopped, the result is empty.
/// Throws as Pipeline::plan() does, and std::runtime_error if there is nothing to draw.
FilmFrame film_frames(Pipeline& pipeline, const DrawingSettings& settings, const FilmChoice& choice,
                      const RoutingWatch& watch = {});

}  // namespace dapple
