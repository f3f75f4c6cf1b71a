#include "io/film/film.h"

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

constexpr double kFirstDots = 30;  // before that there is little to see

double done(double share) {
    return std::clamp(share / kFilmEnd, 0.0, 1.0);
}

}  // namespace

std::uint64_t grown_dots(double share, std::uint64_t dots) {
    if (done(share) == 1) return dots;
    const double first = std::min(kFirstDots, static_cast<double>(dots));
    const double now = first * std::pow(static_cast<double>(dots) / std::max(first, 1.0), done(share));
    return std::min(static_cast<std::uint64_t>(std::lround(now)), dots);
}

int settling_steps(double share, int steps) {
    const double settled = (share - kFilmEnd) / (0.5 * (1 - kFilmEnd));
    return static_cast<int>(std::lround(std::clamp(settled, 0.0, 1.0) * steps));
}

int level_shown(double share, int deepest) {
    return std::min(static_cast<int>(done(share) * (deepest + 1)), deepest);
}

double film_zoom(double share, double depth) {
    return std::pow(depth, done(share));
}

double plotted_seconds(double share, double seconds) {
    return done(share) * seconds;
}

int frames_of(const FilmChoice& choice) {
    return std::max(static_cast<int>(std::lround(choice.seconds * choice.frames_per_second)), 1);
}

}  // namespace dapple
