// Films: which dots are there when, against what drawings and plotting times say.

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/drawing/write_drawing.h"
#include "core/output/pen_figures.h"
#include "io/files/tile_library.h"
#include "io/film/film.h"

namespace dapple {
namespace {

Dots scattered(int count, unsigned seed) {
    Dots dots;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place;
    for (int i = 0; i < count; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random));
    }
    return dots;
}

Grid<float> even_grey(float light) {
    return {90, 60, light};
}

// The light of the middle of a picture, 0..1, as the eye adds it up.
double light_of(const Grid<glm::u8vec3>& pixels) {
    double sum = 0;
    int count = 0;
    for (int y = pixels.height / 4; y < pixels.height * 3 / 4; ++y) {
        for (int x = pixels.width / 4; x < pixels.width * 3 / 4; ++x, ++count) {
            const double value = pixels.at(x, y).g / 255.0;
            sum += value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        }
    }
    return sum / count;
}

Pipeline pipeline_of(Grid<float> light) {
    Pipeline pipeline;
    pipeline.set_light(std::move(light));
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    return pipeline;
}

DrawingSettings settings_for(std::uint64_t dots) {
    DrawingSettings settings;
    settings.automatic_tone = false;
    settings.placing.count = dots;
    return settings;
}

}  // namespace

TEST_CASE("a drawing grows by the same factor in each second, from thirty dots to all, and then rests") {
    CHECK(grown_dots(0, 40'000) == 30);
    CHECK(grown_dots(kFilmEnd, 40'000) == 40'000);
    CHECK(grown_dots(1, 40'000) == 40'000);
    const double first = double(grown_dots(0.3, 40'000)) / double(grown_dots(0.2, 40'000)),
                 later = double(grown_dots(0.7, 40'000)) / double(grown_dots(0.6, 40'000));
    CHECK(first == doctest::Approx(later).epsilon(0.01));
    CHECK(grown_dots(0.5, 7) == 7);
    CHECK(grown_dots(0.5, 1) == 1);
}

TEST_CASE("the dots of a film settle when all have come, and rest before its end") {
    CHECK(settling_steps(0.5, 20) == 0);
    CHECK(settling_steps(kFilmEnd, 20) == 0);
    CHECK(settling_steps(0.925, 20) == 10);
    for (const double share : {0.95, 0.99, 1.0}) CHECK(settling_steps(share, 20) == 20);
    CHECK(settling_steps(1, 0) == 0);
}

TEST_CASE("each level is shown for as long, and the zoom grows by the same factor in each second") {
    int shown[4] = {};
    for (int i = 0; i < 900; ++i) ++shown[level_shown(i / 1000.0, 3)];
    for (const int each : shown) CHECK(each == 225);
    CHECK(level_shown(1, 3) == 3);
    CHECK(film_zoom(0, 100) == 1);
    CHECK(film_zoom(kFilmEnd / 2, 100) == doctest::Approx(10));
    CHECK(film_zoom(1, 100) == doctest::Approx(100));
}

TEST_CASE("a plot of dots takes what plotting them takes, and one of strokes what drawing them takes") {
    const Dots dots = scattered(500, 3);
    for (const Machine machine : {Machine::axidraw_v3, Machine::grbl_laser}) {
        const MachineProgram program = program_of(machine);
        const PlotFilm film = plot_film(in_one_piece(dots), 200, program);
        CHECK(film.total_seconds == doctest::Approx(plotting_time(stream_of(dots), 200, program).total_s()));
        REQUIRE(film.seconds.size() == 500);
        CHECK(std::ranges::is_sorted(film.seconds));
        CHECK(film.drawn_after(0) == 0);
        CHECK(film.drawn_after(film.seconds[99]) == 100);
        CHECK(film.drawn_after(film.total_seconds) == 500);
        CHECK(film.pen_at(100) == glm::dvec2(dots.x[99], dots.y[99]));

        Strokes strokes;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            strokes.points.emplace_back(dots.x[i] * 200, dots.y[i] * 200);
            if (i % 7 == 6 || i % 31 == 0) end_stroke(strokes);
        }
        end_stroke(strokes);
        const PlotFilm lines = plot_film(strokes, program);
        CHECK(lines.total_seconds ==
              doctest::Approx(figures_of(stream_of(strokes, 0.3), program).time.total_s()));
        CHECK(std::ranges::is_sorted(lines.seconds));
        CHECK(lines.drawn_after(lines.total_seconds) == strokes.points.size());
    }
}

TEST_CASE("the first dots are those of the first pieces, and the first points end a stroke where they end") {
    DotPieces pieces;
    pieces.pieces = {scattered(5, 1), scattered(7, 2)};
    pieces.pieces[1].pen = 3;
    pieces.pieces[1].radius.assign(7, 0.5f);
    const DotPieces first = first_dots(pieces, 8);
    CHECK(first.size() == 8);
    CHECK(first.pieces[0].x == pieces.pieces[0].x);
    CHECK(first.pieces[1].pen == 3);
    CHECK(first.pieces[1].radius.size() == 3);
    CHECK(first.pieces[1].y[2] == pieces.pieces[1].y[2]);
    CHECK(first_dots(pieces, 99).size() == 12);

    const Strokes strokes{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, {2, 5}};
    CHECK(first_points(strokes, 4) == Strokes{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {2, 4}});
    CHECK(first_points(strokes, 2) == Strokes{{{0, 0}, {1, 0}}, {2}});
    CHECK(first_points(strokes, 9) == strokes);
    CHECK(first_points(strokes, 0) == Strokes{});
}

TEST_CASE("a zoom stays as light and as finely dotted, however far it goes") {
    Pipeline pipeline = pipeline_of(even_grey(0.5f));
    DrawingSettings settings = settings_for(3000);
    for (const std::uint8_t fineness : {std::uint8_t{0}, std::uint8_t{255}}) {
        settings.mask = Mask(Grid<std::uint8_t>(4, 4, kNeutralLevel), Grid<std::uint8_t>(4, 4, fineness));
        const FilmFrame frame =
            film_frames(pipeline, settings, {.kind = FilmKind::zoom, .longer_side = 240, .depth = 1e4});
        const double begin = light_of(frame(0));
        CHECK(begin == doctest::Approx(0.5).epsilon(0.04));
        for (const double share : {0.3, 0.6, 1.0})
            CHECK(light_of(frame(share)) == doctest::Approx(begin).epsilon(0.05));
    }
}

TEST_CASE(
    "films end with the drawing as placed; a plot begins with bare paper and ends with the drawing as it "
    "is") {
    Grid<float> ramp(96, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) ramp.at(x, y) = static_cast<float>(x) / 95.0f;
    Pipeline pipeline = pipeline_of(ramp);
    for (const FilmKind kind : {FilmKind::growth, FilmKind::plot}) {
        CAPTURE(name_of(kind));
        DrawingSettings asked = settings_for(2000);
        asked.page.margins = Margins{};
        const DrawingSettings settings = film_settings(asked, kind);
        DrawingPlan plan = pipeline.plan(settings);
        const DotStream dots = pipeline.stream(plan);
        const PageSize page = plan.layout(dots.scale).page;
        const Grid<glm::u8vec3> whole =
            page_pixels({.file = {.format = DrawingFormat::png,
                                  .settings = settings,
                                  .saving = {.dpi = dpi_for(page, 300)}},
                         .dots = dots,
                         .page = page,
                         .dot_radius_mm = plan.radius(dots.scale) * page.mm_per_page_unit});
        const FilmFrame frame = film_frames(pipeline, asked, {.kind = kind, .longer_side = 300});
        CHECK(frame(1).values == whole.values);
        CHECK(frame(0.5).values != whole.values);
        if (kind == FilmKind::plot) {
            CHECK(light_of(frame(0)) == 1);
            continue;
        }
        // All dots, then how they settle, and the settled ones until its end.
        const std::vector<glm::u8vec3> all = frame(kFilmEnd).values, some_steps = frame(0.92).values;
        CHECK(all != some_steps);
        CHECK(some_steps != whole.values);
        CHECK(frame(0.95).values == whole.values);
    }
}

TEST_CASE("the film of a plot goes in the order that the drawing is saved in") {
    Pipeline pipeline = pipeline_of(even_grey(0.6f));
    const auto half = [&](std::optional<DotOrder> order) {
        const FilmFrame frame = film_frames(pipeline, settings_for(2000),
                                            {.kind = FilmKind::plot, .longer_side = 200, .order = order});
        return frame(0.45).values;
    };
    CHECK((half({}) == half(DotOrder::shortest)));
    for (const DotOrder other : {DotOrder::priority, DotOrder::recursion, DotOrder::space})
        CHECK((half(other) != half(DotOrder::shortest)));
}

TEST_CASE("in the film of levels each level adds its dots in a colour of its own and takes none away") {
    Pipeline pipeline = pipeline_of(even_grey(0.6f));
    DrawingSettings settings = settings_for(4000);
    settings.tile = "paper16";
    pipeline.set_tile(tile_named("paper16", {}));
    const FilmFrame frame = film_frames(pipeline, settings, {.kind = FilmKind::levels, .longer_side = 300});
    double last = 1;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double light = light_of(frame(share));
        CHECK(light <= last);
        last = light;
    }
    const Grid<glm::u8vec3> all = frame(1);
    std::set<std::tuple<int, int, int>> colours;
    for (const glm::u8vec3 pixel : all.values) colours.insert({pixel.r, pixel.g, pixel.b});
    const glm::vec3 third = level_colour(2) * 255.0f;
    CHECK(colours.contains({std::lround(third.r), std::lround(third.g), std::lround(third.b)}));
}

}  // namespace dapple
