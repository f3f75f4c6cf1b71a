#include "io/film/plot_film.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace dapple {

std::size_t PlotFilm::drawn_after(double passed) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(seconds, passed) - seconds.begin());
}

std::optional<glm::dvec2> PlotFilm::pen_at(std::size_t drawn) const {
    if (drawn == 0) return std::nullopt;
    if (!strokes.points.empty()) return strokes.points[drawn - 1];
    std::size_t before = 0;
    for (const Dots& piece : dots.pieces) {
        const std::size_t here = drawn - 1 - before;
        if (here < piece.size()) return glm::dvec2(piece.x[here], piece.y[here]);
        before += piece.size();
    }
    return std::nullopt;
}

namespace {

// When the pen comes to the paper and when it leaves, if it takes as long for both.
std::pair<double, double> touched(const PlottingTime& before, const PlottingTime& after) {
    const double lift_s = (after.lifting_s - before.lifting_s) / 2;
    return {before.total_s() + after.moving_s - before.moving_s + lift_s, after.total_s() - lift_s};
}

}  // namespace

PlotFilm plot_film(DotPieces dots, double mm_per_page_unit, const MachineProgram& program) {
    PlotFilm film;
    film.seconds.reserve(dots.size());
    MachineClock clock(program);
    for_each_position(dots, [&](double x, double y) {
        const PlottingTime before = clock.time();
        clock.dot(glm::dvec2(x, y) * mm_per_page_unit);
        film.seconds.push_back(touched(before, clock.time()).second);
    });
    film.total_seconds = clock.finish().total_s();
    film.dots = std::move(dots);
    return film;
}

PlotFilm plot_film(Strokes strokes, const MachineProgram& program) {
    PlotFilm film;
    film.seconds.reserve(strokes.points.size());
    MachineClock clock(program);
    std::size_t first = 0;
    for (const std::size_t end : strokes.ends) {
        const std::span points(strokes.points.data() + first, end - first);
        const PlottingTime before = clock.time();
        clock.stroke(points);
        const auto [begun, ended] = touched(before, clock.time());
        double way = 0;
        for (std::size_t i = 1; i < points.size(); ++i) way += glm::distance(points[i - 1], points[i]);
        double gone = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) gone += glm::distance(points[i - 1], points[i]);
            film.seconds.push_back(way > 0 ? begun + (ended - begun) * gone / way : ended);
        }
        first = end;
    }
    film.total_seconds = clock.finish().total_s();
    film.strokes = std::move(strokes);
    return film;
}

DotPieces first_dots(const DotPieces& dots, std::size_t count) {
    DotPieces first;
    for (const Dots& piece : dots.pieces) {
        if (count == 0) break;
        const std::size_t here = std::min(count, piece.size());
        Dots part;
        part.pen = piece.pen;
        const auto take = [here](const FloatBuffer& from, FloatBuffer& to) {
            to.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(std::min(here, from.size())));
        };
        take(piece.x, part.x);
        take(piece.y, part.y);
        take(piece.threshold, part.threshold);
        take(piece.critical, part.critical);
        take(piece.radius, part.radius);
        first.pieces.push_back(std::move(part));
        count -= here;
    }
    return first;
}

Strokes first_points(const Strokes& strokes, std::size_t count) {
    Strokes first;
    first.points.assign(strokes.points.begin(), strokes.points.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                             count, strokes.points.size())));
    std::size_t stroke = 0;
    for (; stroke < strokes.ends.size() && strokes.ends[stroke] < first.points.size(); ++stroke) {
        first.ends.push_back(strokes.ends[stroke]);
        if (!strokes.pens.empty()) first.pens.push_back(strokes.pens[stroke]);
    }
    if (stroke < strokes.ends.size()) end_stroke(first, pen_of(strokes, stroke));
    return first;
}

}  // namespace dapple
