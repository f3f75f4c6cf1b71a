#pragma once
// A square of whole periods folded into one: what repeats after the period comes to lie on itself, and what
// does not spreads out evenly.
//
//     +--+--+--+
//     |. |. |. |          +------+
//     +--+--+--+          |      |
//     |. |. |. |    ->    | 9 .  |
//     +--+--+--+          |      |
//     |. |. |. |          +------+
//     +--+--+--+

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// Points of layers = k x k periods, moved into one, in units of the period: in [0, 1) x [0, 1).
struct Folding {
    std::vector<glm::dvec2> points;
    int layers = 1;
};

/// Folds the points that lie in the square of k periods from `corner` on, its lower edges included and its
/// upper ones not; others are left away. period > 0, k >= 1.
Folding folded(std::span<const glm::dvec2> points, glm::dvec2 corner, double period, int k);

/// How much the layers lie on one another: with s the mean number of other points within t mean spacings of a
/// point (the spacing is that of one layer; the period is a torus), and c what white noise has there,
/// (n - 1) pi t^2 / layers, it is (s - c) / (layers - 1 - c). 1 if all layers are alike, as long as no two
/// points of one are that near each other; 0 (a little below or above) for unrelated ones. As
/// autocorrelation() is, but over all pairs of layers at once. 0 for one layer or fewer than two points, and
/// where c leaves no room: at t = 0.1 in no folding of more than one layer.
double repetition(const Folding& folding, double tolerance = 0.1);

/// The mean of the layers as a picture: the share of the layers in which a pixel's centre lies under a dot of
/// that radius (in periods, below 1/2), 0..1. Crisp dots where the layers are alike, an even grey where not.
Grid<float> mean_of_layers(const Folding& folding, double radius, int side);

}  // namespace dapple
