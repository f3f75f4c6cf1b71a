#pragma once
// Does a point set repeat itself? The share of points that meet another point when the set is moved.

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"
#include "core/export.h"
#include "core/image/grid.h"

namespace dapple {

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

// How many points lie at each distance from a point, over how many there would be in white noise.

/// Distances are in units of the mean spacing sqrt(area / n).
struct PairCorrelationOptions {
    double highest_distance = 5;
    double bin_width = 0.05;
};

struct PairCorrelation {
    double bin_width = 0.05;
    std::vector<double> g;  // bin b is for distances of b to b + 1 bin widths; 1 = white noise
};

/// The pair correlation g(r) of a point set (Illian et al. 2008, "Statistical Analysis and Modelling of
/// Spatial Point Patterns", chapter 4): ordered pairs of different points at the distances of a bin, over n
/// (n - 1) / area times the area of the bin's ring. On a torus all images of the other points count. In a
/// window a pair (dx, dy) weighs area / ((width - |dx|) (height - |dy|)), which makes good for the partners
/// beyond the edge (Ohser's translation correction); distances beyond the window get 0.
/// All 0 for fewer than two points. Points as points_inside() gives them. The same to the bit for any number
/// of threads. Unfinished when a stop was requested.
PairCorrelation pair_correlation(std::span<const glm::dvec2> points, const Domain& domain,
                                 const PairCorrelationOptions& options = {}, std::stop_token stop = {});

/// Tolerance is in units of the mean spacing sqrt(area / n): 0.1 finds what the eye takes for the same place.
inline constexpr double kMeetingTolerance = 0.1;

/// Autocorrelation of the set at a lag (in the unit of the domain): s, the share of the points p that have a
/// point within the tolerance t of p + lag, freed of chance: (s - c) / (1 - c), where c = 1 - exp(-pi t^2) is
/// the share in white noise. 1 for a set that repeats itself after the lag, 0 (a little below or above) for
/// unrelated points, down to -c / (1 - c) at lags that a set avoids. In a window only points whose p + lag
/// lies inside count; 0 if there are none. Points as points_inside() gives them.
double autocorrelation(std::span<const glm::dvec2> points, const Domain& domain, glm::dvec2 lag,
                       double tolerance = kMeetingTolerance);

struct PeriodicityOptions {
    double tolerance = kMeetingTolerance;
    int furthest = 8;           // lags of up to so many periods in each direction
    std::size_t sample = 4096;  // so many of the points are asked for each lag, evenly chosen
};

struct Periodicity {
    double value = 0;          // the highest autocorrelation; 1 = the set repeats itself
    int lag_x = 0, lag_y = 0;  // where: in periods; of equal ones the first found, nearest in y, then in x
};

/// The highest autocorrelation over all lags (a period.x, b period.y), |a|, |b| <= furthest, that do not
/// bring a torus back onto itself and leave at least a quarter of the points inside a window (of fewer, some
/// would meet a point by chance). 1 for a periodic set. Not exactly 0 for others: the highest of some hundred
/// lags is about 0.01 for unrelated points and a sample of 4096. 0 if there is no such lag, or no point. The
/// same to the bit for any number of threads. Unfinished when a stop was requested.
DAPPLE_API Periodicity periodicity(std::span<const glm::dvec2> points, const Domain& domain,
                                   glm::dvec2 period, const PeriodicityOptions& options = {},
                                   std::stop_token stop = {});

/// The period to look for in dots of a tile, in page units, with so many tiles' points (> 0) on a square
/// unit: the side of the last level's tiles that are all there.
double tile_period(double tiles);

}  // namespace dapple
