#include "app/film/plot_film.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "core/output/stroke_figures.h"

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

PlotFilm plot_film(DotPieces dots, double mm_per_page_unit, const MachineSpeeds& speeds) {
    PlotFilm film;
    film.seconds.reserve(dots.size());
    double now = 0;
    std::optional<glm::dvec2> last;
    for_each_position(dots, [&](double x, double y) {
        const glm::dvec2 here(x, y);
        if (last) now += speeds.raise_s + move_time(glm::distance(*last, here) * mm_per_page_unit, speeds);
        now += speeds.lower_s + speeds.dot_s;
        film.seconds.push_back(now);
        last = here;
    });
    film.total_seconds = last ? now + speeds.raise_s : 0;
    film.dots = std::move(dots);
    return film;
}

PlotFilm plot_film(Strokes strokes, const MachineSpeeds& speeds) {
    PlotFilm film;
    film.seconds.reserve(strokes.points.size());
    double now = 0;
    std::optional<glm::dvec2> last;
    std::size_t first = 0;
    for (const std::size_t end : strokes.ends) {
        const std::span points(strokes.points.data() + first, end - first);
        if (last) now += speeds.raise_s + move_time(glm::distance(*last, points.front()), speeds);
        now += speeds.lower_s;
        if (points.size() == 1) now += speeds.dot_s;
        double way = 0;
        for (std::size_t i = 1; i < points.size(); ++i) way += glm::distance(points[i - 1], points[i]);
        const double takes = points.size() > 1 ? drawing_time(points, speeds) : 0;
        double gone = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) gone += glm::distance(points[i - 1], points[i]);
            film.seconds.push_back(now + (way > 0 ? takes * gone / way : 0));
        }
        now += takes;
        last = points.back();
        first = end;
    }
    film.total_seconds = last ? now + speeds.raise_s : 0;
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
