// The window's state without the window: both sides of the split view, at any zoom.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "app/viewer/model/export_estimate.h"
#include "app/viewer/model/session.h"
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
    for_each_position(shown.stippling.dots,
                      [&](float x, float y) { places.push_back(corner + glm::dvec2(x, y)); });
    return places;
}

/// Those of the whole page at a scale that lie in a window, on the page; in the same order.
std::vector<glm::dvec2> places_in_window(const std::string& tile, double scale, const PageWindow& window) {
    Workbench bench;
    bench.set_picture(Grid<float>(8, 8, 0.5f));
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
    const double scale = session.pane().page().stippling.scale;
    split.zoom_in(ZoomMode::constant_density, 12);
    for (const Pane* pane : {&session.pane(), session.right()}) {
        const PlacedDrawing& shown = pane->shown();
        // 7 per cent more than in proportion, as the newest of them fade in.
        CHECK(shown.stippling.scale == doctest::Approx(scale * 144 * 1.07).epsilon(1e-4));
        CHECK(shown.stippling.dots.size() > 1000);
        check_same(places_of(shown),
                   places_in_window(pane->tile().name, shown.stippling.scale, shown.window));
    }
    CHECK(session.pane().tile().name == kDefaultTile);
    CHECK(session.right()->tile().name == "paper16");
}

TEST_CASE("however deep one zooms in with more dots, there are as many in view") {
    SplitSession split(2000);
    split.zoom_in(ZoomMode::constant_density, 12);
    const auto in_view = static_cast<double>(split.session.pane().shown().stippling.dots.size());
    for (const double factor : {0x1p20, 0x1p30, 0x1p40}) {
        split.zoom_in(ZoomMode::constant_density, factor);
        const Stippling& shown = split.session.pane().shown().stippling;
        CHECK(static_cast<double>(shown.dots.size()) == doctest::Approx(in_view).epsilon(0.05));
    }
}

TEST_CASE("deep in the page with larger dots, both sides show the dots that the page has there") {
    SplitSession split(200'000);
    const Session& session = split.session;
    split.zoom_in(ZoomMode::drawing, 64);
    for (const Pane* pane : {&session.pane(), session.right()}) {
        const PlacedDrawing& shown = pane->shown();
        CHECK(shown.stippling.scale == doctest::Approx(pane->page().stippling.scale).epsilon(1e-6));
        CHECK(shown.stippling.dots.size() > 50);
        check_same(places_of(shown),
                   places_in_window(pane->tile().name, shown.stippling.scale, shown.window));
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
        return session.pane().page().stippling.dots.size();
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
    CHECK(session.pane().page().stippling.scale == 300);
}

TEST_CASE("zooming in with more dots from a drawing at the window's bound stays within it") {
    SplitSession split(2000, 2000);
    split.session.settings.comparison.on = false;
    split.zoom_in(ZoomMode::constant_density, 3);
    CHECK(split.session.pane().shown().stippling.dots.size() > 1000);
    CHECK(split.session.pane().shown().stippling.dots.size() < 2100);
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
    CHECK(session.pane().shown().stippling.dots.size() == 2000);
    CHECK(session.pane().placings() == placings);
}

TEST_CASE("a split view that is switched off keeps nothing of its right side, and shows it anew when asked") {
    SplitSession split(2000);
    Session& session = split.session;
    const std::size_t dots = session.right()->shown().stippling.dots.size();
    const auto version = session.right()->version();
    session.settings.comparison.on = false;
    session.request_dots(split.zoom);
    CHECK(session.right() == nullptr);
    session.settings.comparison.on = true;
    CHECK(session.right() == nullptr);
    REQUIRE(split.brings([&] { return session.right() != nullptr; }));
    CHECK(session.right()->shown().stippling.dots.size() == dots);
    // Whoever goes by the number sees that these are other dots.
    CHECK(session.right()->version() > version);
    CHECK(session.pane().shown().stippling.dots.size() == 2000);
}

TEST_CASE("a split view switched on and off without waiting ends as it was asked for last") {
    SplitSession split(2000);
    Session& session = split.session;
    for (int i = 0; i < 20; ++i) {
        session.settings.comparison.on = i % 2 == 1;
        session.take_events(std::chrono::milliseconds(0));
        session.request_dots(split.zoom);
    }
    session.settings.comparison.tile = "28433,5791/16";
    REQUIRE(split.brings([&] { return session.right() && session.right()->tile().name == "28433,5791/16"; }));
    const double dots = static_cast<double>(session.right()->shown().stippling.dots.size());
    CHECK(dots == doctest::Approx(2000).epsilon(0.05));
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
    // x_mm,y_mm,radius_mm,level,rank,critical_scale: by priority the last column ascends.
    std::ifstream table(folder / "a.csv"), svg(folder / "a.svg");
    std::string line, circle;
    std::getline(table, line);
    while (std::getline(svg, circle) && !circle.starts_with("<circle")) continue;
    double last = 0;
    bool ascends = true, same_order = true;
    int lines = 0;
    for (; std::getline(table, line); ++lines) {
        const double critical = std::stod(line.substr(line.rfind(',') + 1));
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
    REQUIRE(brings([&] { return session.pane().page().stippling.dots.size() == 1000; }));
    session.settings.drawing.placing.count = 30'000'000;
    REQUIRE(brings([&] {
        const auto since = session.pane().worker().placing_since();
        return since && std::chrono::steady_clock::now() - *since > std::chrono::milliseconds(300);
    }));
    session.stop_placing();
    CHECK(session.settings.drawing.placing.count == 1000);
    CHECK(brings([&] {
        return session.pane().page_request() == session.pane().page_requested() &&
               !session.pane().worker().placing_since();
    }));
    CHECK(session.pane().page().stippling.dots.size() == 1000);
}

TEST_CASE("what undo and redo would change is said in a word or two") {
    Session session({}, [] {});
    CHECK_FALSE(session.undo_words());
    session.settings.drawing.tone.contrast = 0.5f;
    session.remember(true);
    CHECK_FALSE(session.undo_words());
    session.remember(false);
    CHECK(session.undo_words() == "contrast");
    session.settings.drawing.page.margins.left = 20;
    session.settings.drawing.dot_size.sizing = DotSizing::fixed;
    session.settings.density.source = DensitySource::grey;
    session.remember(false);
    CHECK(session.undo_words() == "dot size and 2 more");
    CHECK_FALSE(session.redo_words());
    session.undo();
    CHECK(session.undo_words() == "contrast");
    CHECK(session.redo_words() == "dot size and 2 more");
    session.undo();
    CHECK_FALSE(session.undo_words());
    CHECK(session.redo_words() == "contrast");
}

}  // namespace dapple
