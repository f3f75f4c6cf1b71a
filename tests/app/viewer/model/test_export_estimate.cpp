// What is told of a file before it is saved: its size, and a machine's time and way.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "app/viewer/model/export_estimate.h"
#include "app/viewer/model/session.h"
#include "core/drawing/pipeline.h"
#include "core/output/pen_figures.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/tile_library.h"
#include "tests/split_session.h"
#include "tests/temporary_folder.h"

namespace dapple {

namespace fs = std::filesystem;

TEST_CASE("the time told before a drawing is saved is about the one that its dots or strokes take") {
    Pipeline pipeline;
    pipeline.set_light(sample_picture(PictureColours::left_out).light);
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    DrawingSettings settings;
    settings.placing.count = 8000;
    DrawingPlan plan = pipeline.plan(settings);
    const DotStream stream = pipeline.stream(plan);
    const DotPieces dots{{sorted_dots(stream, DotOrder::shortest)}};
    const PageSize page = plan.layout(stream.scale).page;
    const double radius = plan.radius(stream.scale) * page.mm_per_page_unit;
    for (const Machine machine : {Machine::axidraw_v3, Machine::grbl_laser}) {
        const MachineProgram program = program_of(machine);
        const auto drawing = [&] {
            return DrawingToSave{.file = {.settings = settings},
                                 .dots = stream_of(dots, stream.scale),
                                 .page = page,
                                 .dot_radius_mm = radius};
        };
        const auto told = [&] {
            return estimated_plotting(drawing(), DotOrder::shortest, program).time.total_s();
        };
        settings.style = DrawingStyle::dots;
        settings.mark.shape = DotShape::circle;
        CHECK(told() == doctest::Approx(plotting_time_of_rings(stream_of(dots.pieces[0]),
                                                               page.mm_per_page_unit, radius, program)
                                            .total_s())
                            .epsilon(0.1));
        const auto taken = [&] {
            const DrawingToSave drawn = drawing();  // which the strokes are of
            const auto strokes = strokes_of(drawn);
            return figures_of(*strokes, program).time.total_s();
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
    settings.placing.count = 30'000;  // of which few are looked at
    settings.placing.thresholds = true;
    DrawingPlan plan = pipeline.plan(settings);
    const DotStream stream = pipeline.stream(plan);
    const PageSize page = plan.layout(stream.scale).page;
    const DotPieces placed{{sorted_dots(stream, DotOrder::recursion)}};
    DrawingToSave drawing{.file = {.settings = settings},
                          .dots = stream_of(placed, stream.scale),
                          .page = page,
                          .dot_radius_mm = plan.radius(stream.scale) * page.mm_per_page_unit};
    const MachineProgram program = program_of(Machine::axidraw_v3);
    for (const DotOrder order :
         {DotOrder::recursion, DotOrder::space, DotOrder::shortest, DotOrder::priority}) {
        CAPTURE(name_of(order));
        const Dots dots = sorted_dots(stream, order);
        drawing.file.format = DrawingFormat::hpgl;
        const PlottingEstimate told = estimated_plotting(drawing, order, program);
        CHECK(told.time.moving_s ==
              doctest::Approx(plotting_time(stream_of(dots), page.mm_per_page_unit, program).moving_s)
                  .epsilon(0.08));
        CHECK(told.way_m ==
              doctest::Approx(way_length(dots.x, dots.y) * page.mm_per_page_unit / 1000).epsilon(0.08));
        CHECK(told.time.drawing_s == 0);
        // Circles are followed round in an SVG.
        drawing.file.format = DrawingFormat::svg;
        const PlottingTime rings = estimated_plotting(drawing, order, program).time;
        CHECK(rings.drawing_s ==
              doctest::Approx(plotting_time_of_rings(stream_of(dots), page.mm_per_page_unit,
                                                     drawing.dot_radius_mm, program)
                                  .drawing_s)
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
    DrawingPlan plan = pipeline.plan(settings);
    const DotStream stream = pipeline.stream(plan);
    const DotPieces dots = sorted_by_pen(stream, DotOrder::shortest);
    REQUIRE(dots.pieces.size() == 4);
    const PageSize page = plan.layout(stream.scale).page;
    const MachineProgram program = program_of(Machine::axidraw_v3);
    DrawingToSave drawing{.file = {.settings = settings},
                          .dots = stream_of(dots, stream.scale),
                          .page = page,
                          .pens = plan.pens,
                          .dot_radius_mm = plan.radius(stream.scale) * page.mm_per_page_unit};
    const auto estimate = [&] { return estimated_plotting(drawing, DotOrder::shortest, program).time; };
    const PlottingTime told = estimate();
    PlottingTime taken;
    for (const Dots& own : dots.pieces)
        taken.moving_s += plotting_time(stream_of(own), page.mm_per_page_unit, program).moving_s;
    CHECK(told.moving_s == doctest::Approx(taken.moving_s).epsilon(0.1));
    drawing.file.settings.mark.shape = DotShape::hatch;
    const auto strokes = strokes_of(drawing);
    CHECK(estimate().total_s() == doctest::Approx(figures_of(*strokes, program).time.total_s()).epsilon(0.1));
}

TEST_CASE("several pens' files have about the size told before, and so has a region's") {
    TemporaryFolder folder;
    DrawingSettings drawing;
    drawing.placing.count = 4000;
    drawing.pens = parse_pens("cmyk");
    Session session(drawing, [] {});
    session.open_sample();
    session.settings.saving.dpi = 100;
    const auto brings = [&](auto done) { return comes_to(session, done); };
    REQUIRE(brings([&] { return session.placed_once() && session.pane().page().settled(); }));
    for (const char* const name :
         {"a.svg", "a.png", "a.csv", "a.pdf", "a.tif", "a.gcode", "a.dxf", "r.svg", "r.png", "r.csv"}) {
        INFO(std::string(name));
        if (*name == 'r') session.settings.saving.region = parse_region("20,30,90x80.5");
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
    Session session(DrawingSettings{}, [] {});
    session.open_sample();
    session.settings.drawing.show_tiles = true;
    session.settings.saving = {DotOrder::priority, 80};
    DotsRequest request = dots_request(session.settings);
    const auto brings = [&](auto done) { return comes_to(session, done); };
    REQUIRE(brings([&] { return session.pane().page().request == request; }));
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

}  // namespace dapple
