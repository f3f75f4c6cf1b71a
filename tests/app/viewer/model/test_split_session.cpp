// Both sides of the split view, at any zoom, without the window.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/drawing/pipeline.h"
#include "tests/split_session.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

/// Those of the whole page at a scale that lie in a window, on the page; in the same order.
std::vector<glm::dvec2> places_in_window(const std::string& tile, double scale, const PageWindow& window) {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(8, 8, 0.5f)});
    DotsRequest request;
    request.drawing.tile = tile;
    request.density.source = DensitySource::grey;
    request.drawing.placing = {.scale = scale};
    request.drawing.relax = 0;
    PlacedDrawing page;
    bench.place(request, page);
    const glm::dvec2 low = in_page_units({window.x, window.y});
    const glm::dvec2 high = low + glm::dvec2(window.width, window.height);
    std::vector<glm::dvec2> places = places_of(page);
    std::erase_if(places,
                  [&](glm::dvec2 p) { return p.x < low.x || p.y < low.y || p.x >= high.x || p.y >= high.y; });
    return places;
}

}  // namespace

TEST_CASE("the drawing as it was is the one that its picture was opened with, or the one that was kept") {
    SplitSession split(500);
    Session& session = split.session;
    ComparedPanes& compared = split.compared;
    DrawingSettings& drawing = session.settings.drawing;
    const DrawingSettings opened = drawing;
    const std::vector<glm::dvec2> dots = places_of(session.pane().page());
    const Pane& now = session.pane();
    compared.hold(SeenInstead::as_it_was);
    REQUIRE(split.brings([&] { return now.page().settled(); }));
    CHECK(&compared.seen() == &now);  // nothing has changed
    drawing.placing.count = 800;
    drawing.page.paper = Paper::a4;
    REQUIRE(split.brings([&] { return &compared.seen() != &now && now.page().dots.size() == 800; }));
    CHECK(compared.as_it_was() == opened);
    CHECK(compared.settings_of(compared.seen()) == opened);
    CHECK(compared.settings_of(now) == drawing);
    CHECK(places_of(compared.seen().page()) == dots);
    CHECK(compared.right()->page().layout.page.width_mm == now.page().layout.page.width_mm);
    // The next look finds it placed.
    compared.hold({});
    CHECK(&compared.seen() == &now);
    compared.hold(SeenInstead::as_it_was);
    CHECK(places_of(compared.seen().page()) == dots);
    session.play(FilmKind::growth);
    CHECK(&compared.seen() == &now);
    session.film.reset();

    compared.keep();
    CHECK(&compared.seen() == &now);
    drawing.placing.count = 900;
    CHECK(split.brings([&] { return compared.seen().page().dots.size() == 800; }));
    REQUIRE(split.brings([&] { return now.page().dots.size() == 900; }));
    session.open_sample();
    REQUIRE(split.brings([&] { return session.pictures() == 2; }));
    CHECK(compared.as_it_was() == drawing);
    CHECK(&compared.seen() == &now);
}

TEST_CASE(
    "what is seen in the drawing's place stays without a key until it is asked for again or settings "
    "change") {
    SplitSession split(500);
    Session& session = split.session;
    ComparedPanes& compared = split.compared;
    compared.toggle(SeenInstead::photograph);
    compared.hold({});
    CHECK(compared.instead() == SeenInstead::photograph);
    compared.toggle(SeenInstead::photograph);
    CHECK_FALSE(compared.instead());
    CHECK_FALSE(compared.end_toggled());

    compared.toggle(SeenInstead::as_it_was);
    CHECK_FALSE(compared.instead());  // it is so
    session.settings.drawing.placing.count = 800;
    compared.toggle(SeenInstead::as_it_was);
    CHECK(compared.instead() == SeenInstead::as_it_was);
    compared.toggle(SeenInstead::photograph);  // in its place
    CHECK(compared.instead() == SeenInstead::photograph);
    session.settings.drawing.placing.count = 900;
    compared.hold({});
    CHECK_FALSE(compared.instead());

    compared.toggle(SeenInstead::photograph);
    compared.hold(SeenInstead::as_it_was);  // a key takes its place, and ends it
    CHECK(compared.instead() == SeenInstead::as_it_was);
    compared.hold({});
    CHECK_FALSE(compared.instead());
}

TEST_CASE("zooming in with more dots, both sides show the dots that the page has at the larger scale") {
    SplitSession split(2000);
    const Session& session = split.session;
    const ComparedPanes& compared = split.compared;
    const double scale = session.pane().page().scale;
    split.zoom_in(ZoomMode::constant_density, 12);
    for (const Pane* pane : {&session.pane(), compared.right()}) {
        const PlacedDrawing& shown = pane->shown();
        // 7 per cent more than in proportion, as the newest of them fade in.
        CHECK(shown.scale == doctest::Approx(scale * 144 * 1.07).epsilon(1e-4));
        CHECK(shown.dots.size() > 1000);
        check_same(places_of(shown), places_in_window(pane->tile().name, shown.scale, shown.window()));
    }
    CHECK(session.pane().tile().name == kDefaultTile);
    CHECK(compared.right()->tile().name == "paper16");
}

TEST_CASE("dots that a close view stopped from settling settle once the page is shown again") {
    SplitSession split(20'000);
    Session& session = split.session;
    session.settings.comparison.on = false;
    session.settings.drawing.relax = 20;
    REQUIRE(split.brings([&] { return session.pane().page().steps == 20; }));
    split.zoom_in(ZoomMode::constant_density, 12);
    session.settings.drawing.tone.gamma = 1.25f;
    REQUIRE(split.brings([&] { return session.pane().page().request->drawing.tone.gamma == 1.25f; }));
    CHECK(session.pane().page().steps < 20);
    REQUIRE(split.brings([&] { return session.pane().shows_close(); }));
    split.zoom.mode = ZoomMode::drawing;
    CHECK(split.brings([&] { return session.pane().page().steps == 20; }));
    CHECK_FALSE(session.pane().shows_close());
}

TEST_CASE("however deep one zooms in with more dots, there are as many in view") {
    SplitSession split(2000);
    split.zoom_in(ZoomMode::constant_density, 12);
    const auto in_view = static_cast<double>(split.session.pane().shown().dots.size());
    for (const double factor : {0x1p20, 0x1p30, 0x1p40}) {
        split.zoom_in(ZoomMode::constant_density, factor);
        const Stippling& shown = split.session.pane().shown();
        CHECK(static_cast<double>(shown.dots.size()) == doctest::Approx(in_view).epsilon(0.05));
    }
}

TEST_CASE("deep in the page with larger dots, both sides show the dots that the page has there") {
    SplitSession split(200'000);
    const Session& session = split.session;
    const ComparedPanes& compared = split.compared;
    split.zoom_in(ZoomMode::drawing, 64);
    for (const Pane* pane : {&session.pane(), compared.right()}) {
        const PlacedDrawing& shown = pane->shown();
        CHECK(shown.scale == doctest::Approx(pane->page().scale).epsilon(1e-6));
        CHECK(shown.dots.size() > 50);
        check_same(places_of(shown), places_in_window(pane->tile().name, shown.scale, shown.window()));
    }
}

TEST_CASE("a drawing never has more dots than the window takes on, whatever count or scale is asked for") {
    const Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    Session session(
        DrawingSettings{}, [] {}, 5000);
    session.open_sample();
    const auto dots = [&](const DrawingSettings& drawing) {
        session.settings.drawing = drawing;
        DotsRequest request = dots_request(session.settings);
        request.most_dots = 5000;
        REQUIRE(wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return session.pane().page().request == request;
        }));
        return session.pane().page().dots.size();
    };
    DrawingSettings drawing;
    drawing.placing.count = 99'999'999'999;
    CHECK(dots(drawing) == 5000);
    drawing.placing.count.reset();
    drawing.placing.scale = 1e8;
    CHECK(dots(drawing) == doctest::Approx(5000).epsilon(0.02));
    drawing.tone.invert = true;  // another mean
    CHECK(dots(drawing) == doctest::Approx(5000).epsilon(0.02));
    drawing.placer = PlacerKind::figure8;
    drawing.tile = "paper16";
    const auto figure8 = dots(drawing);
    CHECK(figure8 < 5000);
    CHECK(figure8 > 3000);
    // A scale that needs no bound is left as it is.
    drawing = {};
    drawing.placing.count.reset();
    drawing.placing.scale = 300;
    dots(drawing);
    CHECK(session.pane().page().scale == 300);
}

TEST_CASE("zooming in with more dots from a drawing at the window's bound stays within it") {
    SplitSession split(2000, 2000);
    split.session.settings.comparison.on = false;
    split.zoom_in(ZoomMode::constant_density, 3);
    CHECK(split.session.pane().shown().dots.size() > 1000);
    CHECK(split.session.pane().shown().dots.size() < 2100);
}

TEST_CASE("zoomed out again, both sides show the whole page as it was") {
    SplitSession split(2000);
    split.zoom_in(ZoomMode::constant_density, 12);
    const Session& session = split.session;
    const ComparedPanes& compared = split.compared;
    const auto placings = session.pane().placings();
    split.zoom = {.mode = ZoomMode::drawing, .camera = fitted(kCanvas, {1, 1})};
    split.frame();
    CHECK_FALSE(session.pane().shows_close());
    CHECK_FALSE(compared.right()->shows_close());
    CHECK(session.pane().shown().dots.size() == 2000);
    CHECK(session.pane().placings() == placings);
}

TEST_CASE("a split view that is switched off keeps nothing of its right side, and shows it anew when asked") {
    SplitSession split(2000);
    Session& session = split.session;
    ComparedPanes& compared = split.compared;
    const std::size_t dots = compared.right()->shown().dots.size();
    const auto version = compared.right()->version();
    session.settings.comparison.on = false;
    split.frame();
    CHECK(compared.right() == nullptr);
    session.settings.comparison.on = true;
    CHECK(compared.right() == nullptr);
    REQUIRE(split.brings([&] { return compared.right() != nullptr; }));
    CHECK(compared.right()->shown().dots.size() == dots);
    // Whoever goes by the number sees that these are other dots.
    CHECK(compared.right()->version() > version);
    CHECK(session.pane().shown().dots.size() == 2000);
}

TEST_CASE("a split view switched on and off without waiting ends as it was asked for last") {
    SplitSession split(2000);
    Session& session = split.session;
    ComparedPanes& compared = split.compared;
    for (int i = 0; i < 8; ++i) {
        session.settings.comparison.on = i % 2 == 1;
        split.frame();
    }
    session.settings.comparison.tile = "28433,5791/16";
    REQUIRE(
        split.brings([&] { return compared.right() && compared.right()->tile().name == "28433,5791/16"; }));
    const double dots = static_cast<double>(compared.right()->shown().dots.size());
    CHECK(dots == doctest::Approx(2000).epsilon(0.05));
}

}  // namespace dapple
