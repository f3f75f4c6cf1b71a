// The window's state without the window: both sides of the split view, at any zoom.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "app/files/file_size.h"
#include "app/files/sample.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "app/viewer/model/change_words.h"
#include "app/viewer/model/export_estimate.h"
#include "app/viewer/model/session.h"
#include "core/drawing/pipeline.h"
#include "core/output/stroke_figures.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr glm::dvec2 kCanvas{800, 600};

/// A grey beside the paper's tile on the same grey.
struct SplitSession {
    Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    Session session;

    explicit SplitSession(std::uint64_t dots, std::uint64_t most_dots = kMostDots)
        : session(
              DrawingSettings{}, [] {}, most_dots) {
        session.settings.density.source = DensitySource::grey;
        session.settings.drawing.placing.count = dots;
        session.settings.drawing.relax = 0;
        session.settings.comparison.on = true;
        session.open_sample();
        REQUIRE(brings([&] { return session.right() != nullptr; }));
    }

    /// Goes on as the window does, frame by frame.
    template <class Done>
    bool brings(Done done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    }

    void zoom_in(ZoomMode mode, double times) {
        const Camera fit = fitted(kCanvas, {1, 1});
        // Not about the middle, and not about a corner of a tile.
        zoom = {mode, zoomed_at(fit, kCanvas * glm::dvec2(0.37, 0.61), times), times};
        REQUIRE(brings([&] {
            const Pane* right = session.right();
            const PageWindow window = window_in_view(zoom.camera, 0.3);
            if (!session.pane().shows_close() || session.pane().shown().window != window) return false;
            if (!session.settings.comparison.on) return true;
            return right && right->shows_close() && right->shown().window == window;
        }));
    }
};

/// Of a close view's dots, on the page; in order.
std::vector<glm::dvec2> places_of(const PlacedDrawing& shown) {
    const glm::dvec2 corner = in_page_units({shown.window.x, shown.window.y});
    std::vector<glm::dvec2> places;
    for_each_position(shown.dots, [&](float x, float y) { places.push_back(corner + glm::dvec2(x, y)); });
    return places;
}

/// Those of the whole page at a scale that lie in a window, on the page; in the same order.
std::vector<glm::dvec2> places_in_window(const std::string& tile, double scale, const PageWindow& window) {
    Workbench bench;
    bench.set_picture({.light = Grid<float>(8, 8, 0.5f)});
    DotsRequest request;
    request.tile = tile;
    request.density.source = DensitySource::grey;
    request.drawing.placing.scale = scale;
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

void check_same(const std::vector<glm::dvec2>& found, const std::vector<glm::dvec2>& expected) {
    REQUIRE(found.size() == expected.size());
    double furthest = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        furthest =
            std::max({furthest, std::abs(found[i].x - expected[i].x), std::abs(found[i].y - expected[i].y)});
    CHECK(furthest < 1e-6);
}

}  // namespace

TEST_CASE("zooming in with more dots, both sides show the dots that the page has at the larger scale") {
    SplitSession split(2000);
    const Session& session = split.session;
    const double scale = session.pane().page().scale;
    split.zoom_in(ZoomMode::constant_density, 12);
    for (const Pane* pane : {&session.pane(), session.right()}) {
        const PlacedDrawing& shown = pane->shown();
        // 7 per cent more than in proportion, as the newest of them fade in.
        CHECK(shown.scale == doctest::Approx(scale * 144 * 1.07).epsilon(1e-4));
        CHECK(shown.dots.size() > 1000);
        check_same(places_of(shown), places_in_window(pane->tile().name, shown.scale, shown.window));
    }
    CHECK(session.pane().tile().name == kDefaultTile);
    CHECK(session.right()->tile().name == "paper16");
}

TEST_CASE("dots that a close view stopped from settling settle once the page is shown again") {
    SplitSession split(20'000);
    Session& session = split.session;
    session.settings.comparison.on = false;
    session.settings.drawing.relax = 20;
    REQUIRE(split.brings([&] { return session.pane().page().steps == 20; }));
    split.zoom_in(ZoomMode::constant_density, 12);
    session.settings.drawing.tone.gamma = 1.25f;
    REQUIRE(split.brings([&] { return session.pane().page_request()->drawing.tone.gamma == 1.25f; }));
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
    split.zoom_in(ZoomMode::drawing, 64);
    for (const Pane* pane : {&session.pane(), session.right()}) {
        const PlacedDrawing& shown = pane->shown();
        CHECK(shown.scale == doctest::Approx(pane->page().scale).epsilon(1e-6));
        CHECK(shown.dots.size() > 50);
        check_same(places_of(shown), places_in_window(pane->tile().name, shown.scale, shown.window));
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
        request.drawing.most_dots = 5000;
        REQUIRE(wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return session.pane().page_request() == request;
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
    const auto placings = session.pane().placings();
    split.zoom = {.mode = ZoomMode::drawing, .camera = fitted(kCanvas, {1, 1})};
    split.session.request_dots(split.zoom);
    CHECK_FALSE(session.pane().shows_close());
    CHECK_FALSE(session.right()->shows_close());
    CHECK(session.pane().shown().dots.size() == 2000);
    CHECK(session.pane().placings() == placings);
}

TEST_CASE("a split view that is switched off keeps nothing of its right side, and shows it anew when asked") {
    SplitSession split(2000);
    Session& session = split.session;
    const std::size_t dots = session.right()->shown().dots.size();
    const auto version = session.right()->version();
    session.settings.comparison.on = false;
    session.request_dots(split.zoom);
    CHECK(session.right() == nullptr);
    session.settings.comparison.on = true;
    CHECK(session.right() == nullptr);
    REQUIRE(split.brings([&] { return session.right() != nullptr; }));
    CHECK(session.right()->shown().dots.size() == dots);
    // Whoever goes by the number sees that these are other dots.
    CHECK(session.right()->version() > version);
    CHECK(session.pane().shown().dots.size() == 2000);
}

TEST_CASE("a split view switched on and off without waiting ends as it was asked for last") {
    SplitSession split(2000);
    Session& session = split.session;
    for (int i = 0; i < 8; ++i) {
        session.settings.comparison.on = i % 2 == 1;
        session.take_events(std::chrono::milliseconds(0));
        session.request_dots(split.zoom);
    }
    session.settings.comparison.tile = "28433,5791/16";
    REQUIRE(split.brings([&] { return session.right() && session.right()->tile().name == "28433,5791/16"; }));
    const double dots = static_cast<double>(session.right()->shown().dots.size());
    CHECK(dots == doctest::Approx(2000).epsilon(0.05));
}

TEST_CASE("the time told before a drawing is saved is about the one that its dots or strokes take") {
    Pipeline pipeline;
    pipeline.set_light(sample_picture(PictureColours::left_out).light);
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    DrawingSettings settings;
    settings.placing.count = 8000;
    DrawingPlan plan = pipeline.plan(request_of(settings));
    const DotStream stream = pipeline.stream(plan);
    const DotPieces dots{{sorted_dots(stream, DotOrder::shortest)}};
    const PageSize page = plan.layout(stream.scale).page;
    const double radius = plan.radius(stream.scale) * page.mm_per_page_unit;
    for (const Machine machine : {Machine::axidraw_v3, Machine::grbl_laser}) {
        const MachineSpeeds speeds = speeds_of(machine);
        const DrawingToSave drawing{
            .dots = stream_of(dots, stream.scale), .page = page, .dot_radius_mm = radius};
        const auto told = [&] {
            return estimated_plotting(settings, drawing, DrawingFormat::svg, DotOrder::shortest, speeds)
                .time.total_s();
        };
        settings.style = DrawingStyle::dots;
        settings.mark.shape = DotShape::circle;
        CHECK(told() ==
              doctest::Approx(
                  plotting_time_of_rings(dots.pieces[0], page.mm_per_page_unit, radius, speeds).total_s())
                  .epsilon(0.1));
        const auto taken = [&] {
            const auto strokes =
                strokes_of(settings, {.dots = stream_of(dots), .page = page, .dot_radius_mm = radius},
                           DrawingFormat::svg);
            return figures_of(*strokes, speeds).time.total_s();
        };
        settings.mark.shape = DotShape::spiral;
        CHECK(told() == doctest::Approx(taken()).epsilon(0.1));
        settings.style = DrawingStyle::line;
        CHECK(told() == doctest::Approx(taken()).epsilon(0.15));
        settings.style =
            DrawingStyle::nearest;  // some of the dots are less even than all, and have other near ones
        CHECK(told() == doctest::Approx(taken()).epsilon(0.2));
    }
}

TEST_CASE("the time told before saving is that of the dot order chosen, and its way that of the pen") {
    Pipeline pipeline;
    pipeline.set_light(sample_picture(PictureColours::left_out).light);
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    DrawingSettings settings;
    settings.placing.count = 8000;
    settings.placing.thresholds = true;
    DrawingPlan plan = pipeline.plan(request_of(settings));
    const DotStream stream = pipeline.stream(plan);
    const PageSize page = plan.layout(stream.scale).page;
    const DotPieces placed{{sorted_dots(stream, DotOrder::recursion)}};
    const DrawingToSave drawing{.dots = stream_of(placed, stream.scale),
                                .page = page,
                                .dot_radius_mm = plan.radius(stream.scale) * page.mm_per_page_unit};
    const MachineSpeeds speeds = speeds_of(Machine::axidraw_v3);
    for (const DotOrder order :
         {DotOrder::recursion, DotOrder::space, DotOrder::shortest, DotOrder::priority}) {
        CAPTURE(name_of(order));
        const Dots dots = sorted_dots(stream, order);
        const PlottingEstimate told =
            estimated_plotting(settings, drawing, DrawingFormat::hpgl, order, speeds);
        CHECK(told.time.moving_s ==
              doctest::Approx(plotting_time(dots, page.mm_per_page_unit, speeds).moving_s).epsilon(0.15));
        CHECK(told.way_m ==
              doctest::Approx(way_length(dots.x, dots.y) * page.mm_per_page_unit / 1000).epsilon(0.2));
        CHECK(told.time.drawing_s == 0);
        // Circles are followed round in an SVG.
        const PlottingTime rings =
            estimated_plotting(settings, drawing, DrawingFormat::svg, order, speeds).time;
        CHECK(
            rings.drawing_s ==
            doctest::Approx(
                plotting_time_of_rings(dots, page.mm_per_page_unit, drawing.dot_radius_mm, speeds).drawing_s)
                .epsilon(0.02));
        CHECK(rings.drawing_s > 100);
    }
}

TEST_CASE("the time told for several pens is that of each one's own way") {
    Pipeline pipeline;
    Picture picture = sample_picture(PictureColours::kept);
    pipeline.set_light(std::move(picture.light));
    pipeline.set_colours(std::move(picture.colours));
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    DrawingSettings settings;
    settings.placing.count = 8000;
    settings.pens = parse_pens("cmyk:0.4");
    DrawingPlan plan = pipeline.plan(request_of(settings));
    const DotStream stream = pipeline.stream(plan);
    const DotPieces dots = sorted_by_pen(stream, DotOrder::shortest);
    REQUIRE(dots.pieces.size() == 4);
    const PageSize page = plan.layout(stream.scale).page;
    const MachineSpeeds speeds = speeds_of(Machine::axidraw_v3);
    const DrawingToSave drawing{.dots = stream_of(dots, stream.scale),
                                .page = page,
                                .pens = plan.pens,
                                .dot_radius_mm = plan.radius(stream.scale) * page.mm_per_page_unit};
    const auto estimate = [&] {
        return estimated_plotting(settings, drawing, DrawingFormat::svg, DotOrder::shortest, speeds).time;
    };
    const PlottingTime told = estimate();
    PlottingTime taken;
    for (const Dots& own : dots.pieces)
        taken.moving_s += plotting_time(own, page.mm_per_page_unit, speeds).moving_s;
    CHECK(told.moving_s == doctest::Approx(taken.moving_s).epsilon(0.1));
    settings.mark.shape = DotShape::hatch;
    const auto strokes = strokes_of(settings, drawing, DrawingFormat::svg);
    CHECK(estimate().total_s() == doctest::Approx(figures_of(*strokes, speeds).time.total_s()).epsilon(0.1));
}

TEST_CASE("the size told of a PNG looks at few of many dots, and is the same as if it looked at all") {
    PlacedDrawing drawing;
    drawing.layout.page = {200, 150, 200};
    Dots& dots = drawing.dots.pieces.emplace_back();
    // Small squares one after another, as the recursion has them.
    constexpr int kSquares = 80, kAlong = 10;
    for (int square = 0; square < kSquares * kSquares; ++square) {
        DotBlock block{.first = dots.size(), .count = kAlong * kAlong};
        const glm::vec2 low(square % kSquares, 0.75f * static_cast<float>(square / kSquares));
        for (int i = 0; i < kAlong * kAlong; ++i) {
            dots.x.push_back((low.x + static_cast<float>(i % kAlong) / kAlong) / kSquares);
            dots.y.push_back((low.y + static_cast<float>(i / kAlong) * 0.75f / kAlong) / kSquares);
        }
        block.low = low / static_cast<float>(kSquares);
        block.high = (low + glm::vec2(1, 0.75f)) / static_cast<float>(kSquares);
        drawing.blocks.push_back(block);
    }
    DrawingToSave all{.dots = stream_of(drawing.dots, 1000),
                      .page = drawing.layout.page,
                      .dot_radius_mm = 0.1,
                      .saving = {.dpi = 300}};
    const DotPieces some = dots_on_patches(drawing, all.saving.dpi);
    CHECK(some.size() < dots.size() / 2);
    CHECK(some.size() > 0);
    DrawingToSave near = all;
    near.dots = stream_of(some, 1000);
    CHECK(estimated_bytes(DrawingFormat::png, DrawingSettings{}, near) ==
          estimated_bytes(DrawingFormat::png, DrawingSettings{}, all));
}

TEST_CASE("a change is told by the row that makes it") {
    const ViewerSettings before;
    const auto words = [&](auto change) {
        ViewerSettings after = before;
        change(after);
        return change_in_words(before, after);
    };
    CHECK(words([](ViewerSettings& s) { s.drawing.page.quarter_turns = 1; }) == "Rotate");
    CHECK(words([](ViewerSettings& s) { s.picture_opacity = 0.5f; }) == "Photograph");
    CHECK(words([](ViewerSettings& s) { s.drawing.page.paper = Paper::a4; }) == "Paper size");
    CHECK(words([](ViewerSettings& s) { s.drawing.paper = kBlack; }) == "Paper");
    CHECK(words([](ViewerSettings& s) { s.drawing.placing.count = 5; }) == "Dots");
    CHECK(words([](ViewerSettings& s) { s.drawing.tone.black_point = 0.1f; }) == "Black point");
    CHECK(words([](ViewerSettings& s) { s.drawing.page.margins = {1, 1, 1, 1}; }) == "Margins");
    CHECK(words([](ViewerSettings& s) { s.drawing.pen_width_mm = 1; }) == "Pen width");
    CHECK(words([](ViewerSettings&) {}).empty());
}

TEST_CASE("a change of several pens is told by its own row") {
    ViewerSettings before;
    before.drawing.pens = parse_pens("Sky:#3aa0d8:0.3,Ochre:#805010:0.5,Ink:#101010:0.2");
    const auto words = [&](auto change) {
        ViewerSettings after = before;
        change(after.drawing.pens);
        return change_in_words(before, after);
    };
    CHECK(words([](PenChoice& pens) { pens.set = PenSet::cmyk; }) == "Which pens");
    CHECK(words([](PenChoice& pens) { pens.own[1].name = "Sand"; }) == "Pen 2");
    CHECK(words([](PenChoice& pens) { pens.own[0].colour = kBlack; }) == "Colour 1");
    CHECK(words([](PenChoice& pens) { pens.own[2].width_mm = 0.4; }) == "Width 3");
    CHECK(words([](PenChoice& pens) { pens.own[2].gap_mm = 0.4; }) == "Gap 3");
    CHECK(words([](PenChoice& pens) { pens.own[2].gain_mm = 0.04; }) == "Gain 3");
    CHECK(words([](PenChoice& pens) { pens.own.push_back({.name = "Red"}); }) == "Add a pen");
    CHECK(words([](PenChoice& pens) { pens.own.erase(pens.own.begin() + 1); }) == "Remove Ochre");
    CHECK(words([](PenChoice& pens) { pens.own.pop_back(); }) == "Remove Ink");
    CHECK(words([](PenChoice& pens) { std::swap(pens.own[0], pens.own[1]); }) == "Draw Ochre earlier");
    CHECK(words([](PenChoice& pens) { pens.own = palette_of({.set = PenSet::cmyk}); }) == "Palette");
    before.drawing.pens = parse_pens("cmyk:0.3");
    CHECK(words([](PenChoice& pens) { pens.width_mm = 0.4; }) == "Tip width");
    CHECK(words([](PenChoice& pens) { pens.gain_mm = 0.04; }) == "Dot gain");
    CHECK(words([](PenChoice& pens) { pens.black = 0.8; }) == "Black ink");
    before.drawing.pens = parse_pens("auto:4");
    CHECK(words([](PenChoice& pens) { pens.automatic = 5; }) == "How many");
    CHECK(words([](PenChoice& pens) { pens.own = palette_of({.set = PenSet::cmyk}), pens.automatic = 3; }) ==
          "Palette");
}

TEST_CASE("a drawing has changes until it is undone, or saved in what holds its settings") {
    const TemporaryFolder folder;
    Session session(DrawingSettings{}, [] {});
    session.settings.drawing.placing.count = 500;
    session.begin_with(session.settings);
    session.open_sample();
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots({.camera = fitted(kCanvas, {1, 1})});
            return done();
        });
    };
    const auto change = [&](float brightness) {
        session.settings.drawing.tone.brightness = brightness;
        session.remember(false);
    };
    REQUIRE(brings([&] { return session.placed_once(); }));
    CHECK_FALSE(session.has_changes());
    change(0.1f);
    CHECK(session.has_changes());
    session.undo();
    CHECK_FALSE(session.has_changes());
    session.redo();
    CHECK(session.has_changes());
    for (const char* const name : {"a.csv", "a.svg"}) {
        session.save(folder / name);
        REQUIRE(brings([&] { return session.saved_path() == folder / name; }));
        CHECK(session.has_changes() == (std::string(name) == "a.csv"));
    }
    change(0.2f);
    CHECK(session.has_changes());
    CHECK(session.would_lose_changes("other.dapple"));
    CHECK_FALSE(session.would_lose_changes("other.png"));  // its settings go on
    session.save_project(folder / "a.dapple");
    CHECK_FALSE(session.has_changes());
    change(0.3f);
    CHECK(session.would_lose_changes("other.png"));
    CHECK_FALSE(session.would_lose_changes("other.tile"));

    session.keep(folder / "kept.dapple");
    CHECK(session.project_path() == folder / "a.dapple");
    CHECK(session.has_changes());
    session.open_project(folder / "a.dapple");
    REQUIRE(brings([&] { return session.pictures() == 2; }));
    CHECK_FALSE(session.has_changes());
    session.bring_back(folder / "kept.dapple");
    REQUIRE(brings([&] { return session.pictures() == 3; }));
    CHECK(session.settings.drawing.tone.brightness == 0.3f);
    CHECK(session.has_changes());
    CHECK(session.project_path().empty());
    session.open_sample();
    REQUIRE(brings([&] { return session.pictures() == 4; }));
    CHECK_FALSE(session.has_changes());

    // One whose picture cannot be read is not taken for unsaved, or what was kept would be given up with it.
    put_text(folder / "broken.png", "no picture");
    put_text(folder / "kept.dapple", R"({"dapple": 1, "picture": {"file": "broken.png"}})");
    session.bring_back(folder / "kept.dapple");
    CHECK_FALSE(session.has_changes());
    REQUIRE(brings([&] { return session.banner.kind == BannerKind::error; }));
    CHECK_FALSE(session.has_changes());
}

TEST_CASE("several pens' files have about the size told before") {
    TemporaryFolder folder;
    const Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    DrawingSettings drawing;
    drawing.placing.count = 4000;
    drawing.pens = parse_pens("cmyk");
    Session session(drawing, [] {});
    session.open_sample();
    session.settings.saving.dpi = 100;
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    };
    REQUIRE(brings([&] { return session.placed_once() && session.pane().page().settled(); }));
    for (const char* const name : {"a.svg", "a.png", "a.csv", "a.pdf", "a.tif", "a.gcode", "a.dxf"}) {
        INFO(std::string(name));
        ExportEstimate estimate;
        const ExportInfo info = estimate.info(session.pane(), session.settings, drawing_format(name));
        REQUIRE(info.bytes);
        session.save(folder / name);
        REQUIRE(brings([&] { return session.saved_path() == folder / name; }));
        CHECK(static_cast<double>(fs::file_size(folder / name)) == doctest::Approx(*info.bytes).epsilon(0.1));
    }
}

TEST_CASE("saved files have the order and resolution chosen, and about the size told before") {
    TemporaryFolder folder;
    const Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    Session session(DrawingSettings{}, [] {});
    session.open_sample();
    session.settings.drawing.show_tiles = true;
    session.settings.saving = {DotOrder::priority, 80};
    DotsRequest request = dots_request(session.settings);
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    };
    REQUIRE(brings([&] { return session.pane().page_request() == request; }));
    for (const char* const name : {"a.svg", "a.png", "a.csv", "a.pdf", "a.tif", "a.gcode"}) {
        CAPTURE(name);
        const DrawingFormat format = drawing_format(name);
        ExportEstimate estimate;
        const ExportInfo info = estimate.info(session.pane(), session.settings, format);
        CHECK(info.dots == 40'000);
        REQUIRE(info.bytes);
        const auto before = session.saved_path();
        session.save(folder / name);
        CHECK(session.saved_path() == before);
        REQUIRE(brings([&] { return session.saved_path() == folder / name; }));
        CHECK(static_cast<double>(fs::file_size(folder / name)) == doctest::Approx(*info.bytes).epsilon(0.1));
    }
    // x_mm,y_mm,radius_mm,level,rank,critical_scale,...: by priority the sixth column ascends.
    std::ifstream table(folder / "a.csv"), svg(folder / "a.svg");
    std::string line, circle;
    std::getline(table, line);
    while (std::getline(svg, circle) && !circle.starts_with("<circle")) continue;
    double last = 0;
    bool ascends = true, same_order = true;
    int lines = 0;
    for (; std::getline(table, line); ++lines) {
        std::size_t comma = line.find(',');
        for (int column = 2; column < 6; ++column) comma = line.find(',', comma + 1);
        const double critical = std::stod(line.substr(comma + 1));
        ascends = ascends && critical >= last;
        last = critical;
        // The SVG has the same dots in the same order, in px.
        const double x = std::stod(circle.substr(circle.find("cx=") + 4)) * 25.4 / 96;
        same_order = same_order && std::abs(x - std::stod(line)) < 0.01;
        std::getline(svg, circle);
    }
    CHECK(same_order);
    CHECK(lines == 40'000);
    CHECK(ascends);
}

TEST_CASE("a dropped tile file is drawn with until undo brings the former tile back") {
    TemporaryFolder folder;
    // The dots of a built-in tile under another name.
    save_tile(folder / "Mine.TILE", load_tile("aperiodic64"));
    SplitSession split(2000);
    Session& session = split.session;
    session.settings.drawing.tile = "aperiodic64";
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == "aperiodic64"; }));
    const std::vector<glm::dvec2> expected = places_of(session.pane().page());
    session.settings.drawing.tile = kDefaultTile;
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == kDefaultTile; }));

    session.take_dropped(folder / "Mine.TILE");
    CHECK(session.banner.message.empty());
    const std::string name = session.settings.drawing.tile;
    CHECK(fs::equivalent(name, folder / "Mine.TILE"));
    session.remember(false);
    REQUIRE(split.brings([&] { return session.pane().tile().name == name; }));
    check_same(places_of(session.pane().page()), expected);
    CHECK(session.pictures() == 1);

    session.undo();
    CHECK(session.settings.drawing.tile == kDefaultTile);
    CHECK(split.brings([&] { return session.pane().tile().name == kDefaultTile; }));
    // It can be chosen again, and stands in the list once however often it is opened.
    session.open_tile(folder / "Mine.TILE");
    CHECK(std::ranges::count(session.tiles(), name) == 1);
}

TEST_CASE("a file that is not a tile is told of with the line that is wrong, and the tile stays") {
    TemporaryFolder folder;
    std::ofstream(folder / "broken.tile") << "dapple tile 1\nrule 9999\n";
    SplitSession split(2000);
    Session& session = split.session;
    const auto tiles = session.tiles().size();
    for (const char* file : {"broken.tile", "missing.tile"}) {
        CAPTURE(file);
        session.banner = {};
        session.take_dropped(folder / file);
        CHECK(session.banner.kind == BannerKind::error);
        std::string sentence;
        try {
            load_tile((folder / file).string());
        } catch (const std::exception& error) {
            sentence = error.what();
        }
        CHECK(session.banner.message == sentence);
        CHECK(session.banner.message.find(file) != std::string::npos);
        CHECK(session.settings.drawing.tile == kDefaultTile);
    }
    CHECK(session.tiles().size() == tiles);
}

TEST_CASE("what is said of a placing that failed goes with the next one that does not") {
    SplitSession split(500);
    split.session.settings.comparison.on = false;
    split.session.settings.drawing.tile = "no such tile";
    REQUIRE(split.brings([&] { return !split.session.banner.message.empty(); }));
    CHECK(split.session.banner.kind == BannerKind::error);
    split.session.settings.drawing.tile = "paper16";
    CHECK(split.brings([&] { return split.session.banner.message.empty(); }));
    CHECK(split.session.pane().tile().name == "paper16");
}

TEST_CASE("another picture is not saved over the one before") {
    TemporaryFolder folder;
    const Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    Session session(DrawingSettings{}, [] {});
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    };
    session.open_sample();
    REQUIRE(brings([&] { return session.placed_once(); }));
    session.save(folder / "a.csv");
    REQUIRE(brings([&] { return session.saved_path() == folder / "a.csv"; }));
    session.open_sample();
    REQUIRE(brings([&] { return session.pictures() == 2; }));
    CHECK(session.saved_path().empty());
}

TEST_CASE("a placing that takes too long can be given up: drawing and settings are as before") {
    Session session(DrawingSettings{}, [] {});
    session.settings.drawing.placing.count = 1000;
    session.settings.drawing.relax = 0;
    session.open_sample();
    const Zoom zoom{.camera = fitted(kCanvas, {1, 1})};
    const auto brings = [&](auto done) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots(zoom);
            return done();
        });
    };
    REQUIRE(brings([&] { return session.pane().page().dots.size() == 1000; }));
    session.settings.drawing.placing.count = 10'000'000;
    REQUIRE(brings([&] { return session.pane().worker().placing_since().has_value(); }));
    session.stop_placing();
    CHECK(session.settings.drawing.placing.count == 1000);
    CHECK(brings([&] {
        return session.pane().page_request() == session.pane().page_requested() &&
               !session.pane().worker().placing_since();
    }));
    CHECK(session.pane().page().dots.size() == 1000);
}

TEST_CASE("what undo and redo would change is said in a word or two") {
    Session session({}, [] {});
    CHECK_FALSE(session.undo_words());
    session.settings.drawing.tone.contrast = 0.5f;
    session.remember(true);
    CHECK_FALSE(session.undo_words());
    session.remember(false);
    CHECK(session.undo_words() == "Contrast");
    session.settings.drawing.page.margins.left = 20;
    session.settings.drawing.dot_size.sizing = DotSizing::fixed;
    session.settings.density.source = DensitySource::grey;
    session.remember(false);
    CHECK(session.undo_words() == "Dot size and 2 more");
    CHECK_FALSE(session.redo_words());
    session.undo();
    CHECK(session.undo_words() == "Contrast");
    CHECK(session.redo_words() == "Dot size and 2 more");
    session.undo();
    CHECK_FALSE(session.undo_words());
    CHECK(session.redo_words() == "Contrast");
}

TEST_CASE("each change has the name of its row") {
    Session session({}, [] {});
    ViewerSettings& settings = session.settings;
    const auto words_after = [&](const std::function<void()>& change) {
        change();
        session.remember(false);
        return session.undo_words().value_or("");
    };
    Comparison& right = settings.comparison;
    CHECK(words_after([&] { right = toggled(right, settings.drawing); }) == "Split view");
    CHECK(words_after([&] { right.placer = PlacerKind::figure8; }) == "Right placer");
    CHECK(words_after([&] { right.tile = "lattice24"; }) == "Right tile");
    CHECK(words_after([&] { right.by = CompareBy::count; }) == "Right side has");
    CHECK(words_after([&] { settings.loupe.step = 2; }) == "Its tiles");
    CHECK(words_after([&] { settings.loupe.on = true; }) == "Loupe");
    CHECK(words_after([&] { settings.density.grey = 0.3f; }) == "Grey");
    CHECK(words_after([&] { settings.density.source = DensitySource::ramp; }) == "Density");
    DrawingSettings& drawing = settings.drawing;
    CHECK(words_after([&] { drawing.dot_size.sizing = DotSizing::by_tone; }) == "Dot size");
    CHECK(words_after([&] { drawing.dot_size.largest_mm = 2; }) == "Largest");
    CHECK(words_after([&] { drawing.page.margins = {10, 10, 10, 10}; }) == "Margins");
    CHECK(words_after([&] { drawing.page.margins.left = 20; }) == "Left");
    CHECK(words_after([&] {
              drawing.page.crop = Crop{{{10, 10}, {90, 90}}, Crop::Unit::percent};
          }) == "Crop");
    CHECK(words_after([&] { drawing.page.crop->box.low.x = 20; }) == "From left");
    CHECK(words_after([&] { drawing.page.crop.reset(); }) == "Crop");
    CHECK(words_after([&] { settings.saving.gcode_template = {"dot {x}", "a.txt"}; }) == "Template");
}

TEST_CASE(
    "the crop's frame is around all of the picture on a page that it fills, whichever way it is turned") {
    Session session(DrawingSettings{}, [] {});
    PageSetup& setup = session.settings.drawing.page;
    setup.paper = Paper::custom;
    setup.width_mm = 100;
    setup.height_mm = 300;
    setup.fit = PageFit::fill;
    setup.quarter_turns = 1;
    session.settings.drawing.placing.count = 100;
    session.open_sample();
    const auto framing_is = [&](auto&& right) {
        return wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots({.camera = fitted(kCanvas, {1, 1})});
            return session.placed_once() && right(session.pane().page().framing);
        });
    };
    const auto is_whole = [&](const Framing& framing) {
        return framing.pixels == Rectangle<int>{{0, 0}, session.pane().page().picture_pixels};
    };
    REQUIRE(framing_is([&](const Framing& framing) { return !is_whole(framing); }));
    session.cropping = true;
    CHECK(
        framing_is([&](const Framing& framing) { return is_whole(framing) && framing.quarter_turns == 1; }));
    session.cropping = false;
    CHECK(framing_is([&](const Framing& framing) { return !is_whole(framing); }));
}

TEST_CASE(
    "a dark .hdr is drawn as the same light would be that is 4096 times brighter, and its exposure moves") {
    const TemporaryFolder folder;
    const auto dots = [&](int exponent, std::optional<float> stops, float& drawn_with) {
        const fs::path file = folder / "light.hdr";
        std::ofstream out(file, std::ios::binary);
        out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 16\n";
        // Light from 2^(exponent - 136) on, in a ramp of seven stops.
        for (int pixel = 0; pixel < 256; ++pixel)
            out << "\x90\x90\x90" << static_cast<char>(exponent + pixel / 37);
        out.close();
        Session session(DrawingSettings{}, [] {});
        session.settings.drawing.placing = {.scale = 100};
        session.settings.drawing.relax = 0;
        if (stops) {
            session.settings.drawing.automatic_exposure = false;
            session.settings.drawing.tone.exposure = *stops;
        }
        session.open(file);
        REQUIRE(wait_until([&] {
            session.take_events(std::chrono::milliseconds(0));
            session.request_dots({.camera = fitted(kCanvas, {1, 1})});
            return session.placed_once() && !session.picture().file.empty();
        }));
        drawn_with = session.pane().page().tone.exposure;
        return session.pane().page().dots.size();
    };
    float dark = 0, bright = 0, moved = 0;
    const std::size_t of_dark = dots(112, {}, dark), of_bright = dots(124, {}, bright);
    CHECK(dark > 5);
    CHECK(dark - bright == doctest::Approx(12).epsilon(0.001));
    CHECK(of_dark == of_bright);
    CHECK(of_dark > 100);
    // What the issue was: without exposure such light is black.
    CHECK(dots(112, 0.0f, moved) > of_dark * 5 / 4);
    CHECK(moved == 0);
    CHECK(dots(112, dark + 3, moved) < of_dark * 4 / 5);
}

}  // namespace dapple
