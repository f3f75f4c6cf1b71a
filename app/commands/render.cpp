#include "app/commands/render.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/options.h"
#include "app/files/atomic_file.h"
#include "app/files/sample.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "app/progress_line.h"
#include "app/shown_text.h"
#include "core/drawing/pipeline.h"
#include "core/image/ink_use.h"
#include "core/output/preflight.h"
#include "core/output/raster.h"
#include "core/tile/tile_file.h"

namespace dapple {
namespace {

class Stopwatch {
 public:
    // Milliseconds since it was made or last read.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string name_of_image(const RenderOptions& options) {
    return options.image ? options.image->string() : "the sample";
}

void check_files(const RenderOptions& options) {
    const FileInUse picture{options.image, "the picture"}, tile{options.drawing.tile, "the tile"};
    check_apart(options.output, {picture, tile});
    check_can_save(options.output);
    if (!options.stats) return;
    check_apart(*options.stats, {picture, tile, {options.output, "the drawing"}});
    check_can_save(*options.stats);
}

// What the command draws, made sure to be possible.
DrawingPlan plan_for(Pipeline& pipeline, const RenderOptions& options) {
    DrawingRequest request = request_of(options.drawing, options.margin_mm);
    request.placing.thresholds =
        drawing_format(options.output) == DrawingFormat::csv || options.order == DotOrder::priority;
    DrawingPlan plan = pipeline.plan(request);
    if (plan.density->mean() == 0 && plan.placing.count) {
        throw std::runtime_error(
            fmt::format("{}: nothing to draw, all of it is as light as the paper", name_of_image(options)));
    }
    if (plan.lowered) {
        const bool by_size = request.size.sizing == DotSizing::by_tone;
        throw std::runtime_error(fmt::format(
            "{} would make more than {} dots of {}; choose {}",
            by_size ? "--dot-radius: radii so small" : fmt::format("--scale: {:g}", request.placing.scale),
            grouped(kMostDots), name_of_image(options), by_size ? "larger ones" : "a smaller scale"));
    }
    return plan;
}

void check_margin(const RenderOptions& options) {
    const double width = options.drawing.width_mm;
    if (width - 2 * options.margin_mm >= kShortestSideMm) return;
    throw std::runtime_error(fmt::format(
        "--margin: {:g} mm on either side leave no room on a page {:g} mm wide", options.margin_mm, width));
}

// The page, its margin included, of a picture of so many pixels.
PageSize page_of(const Grid<float>& light, const RenderOptions& options) {
    const double width = options.drawing.width_mm,
                 mm_per_pixel = (width - 2 * options.margin_mm) / light.width;
    const double longer = std::max(light.width, light.height);
    const PageSize page = with_margin(
        {light.width * mm_per_pixel, light.height * mm_per_pixel, longer * mm_per_pixel}, options.margin_mm);
    if (page.height_mm > kLongestSideMm) {
        throw std::runtime_error(fmt::format(
            "{}: {} x {} pixels would make a page {:g} mm wide and {:.4g} m high, and {:g} m is the most; "
            "choose a --width of {:.2g} or less",
            name_of_image(options), light.width, light.height, width, page.height_mm / 1000,
            kLongestSideMm / 1000, width * kLongestSideMm / page.height_mm * 0.95));
    }
    return page;
}

// The page, or the part of it that is drawn.
Excerpt excerpt_of(const PageSize& page, const RenderOptions& options) {
    if (!options.region) return sheet_of(page, options.sheet, options.margin_mm);
    const glm::dvec2 size = options.region->size();
    if (std::min(size.x, size.y) < kShortestSideMm) {
        throw std::runtime_error(fmt::format("--region: {:g} x {:g} mm is too small; give {:g} mm or more",
                                             size.x, size.y, kShortestSideMm));
    }
    try {
        return region_of(page, *options.region, options.margin_mm);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("--region: {}", error.what()));
    }
}

// Nothing at all on a page that is not white is a slip; nothing on one sheet of it need not be.
void check_not_empty(const DrawingPlan& plan, std::uint64_t dots, const RenderOptions& options) {
    const bool whole_page = !options.region && options.sheet == Sheet{};
    // The paper's own placer is known for losing all of a thin line.
    const bool loses = plan.placer == PlacerKind::figure8;
    if (dots > 0 || loses || !whole_page || plan.density->mean() == 0) return;
    const bool by_size = options.drawing.dot_size.sizing == DotSizing::by_tone;
    throw std::runtime_error(
        by_size ? "--dot-radius: no dots so large come out; choose smaller ones"
                : fmt::format("--scale: no dots come out at {:g}; give a higher one", plan.placing.scale));
}

struct Times {
    double tile = 0, read = 0, tone = 0, place = 0, write = 0;  // milliseconds
};

struct Rendered {
    int width = 0, height = 0;  // of the picture
    double mean_density = 0;
    Tone tone;  // as drawn
    int steps = 0;
    std::uint64_t dots = 0;
    double scale = 0;
    std::optional<std::uint64_t> duplicates;  // among them; none if that is not known
    PageSize page;                            // the sheet, the region or all of it
    double radius_mm = 0;
    DotOrder order = DotOrder::recursion;
    std::optional<double> curve_way_m = {};   // of the pen, before it was shortened
    bool mostly_black = false;                // light ink would draw the picture better
    std::optional<Preflight> preflight = {};  // of an SVG whose dots were in memory
    std::optional<Machine> machine = {};      // that would draw it
    std::optional<PlottingTime> plotting = {};
    Times times = {};
};

// What someone who is about to plot it should know, in a few lines.
void print_summary(const RenderOptions& options, const Rendered& drawn) {
    std::error_code error;
    const auto bytes = static_cast<double>(std::filesystem::file_size(options.output, error));
    const std::string size = error ? "" : fmt::format(", {:.1f} MB", bytes * 1e-6);
    const Preflight& found = *drawn.preflight;
    const std::string saved =
        drawn.curve_way_m ? fmt::format(" ({:.1f} m before its way was shortened)", *drawn.curve_way_m) : "";
    fmt::print(stderr, "{} dots{}; the pen moves {:.1f} m between them{}; the nearest are {:.2g} mm apart\n",
               grouped(drawn.dots), size, found.pen_up_m, saved, found.nearest_mm);
    if (drawn.plotting && drawn.dots > 0) {
        fmt::print(stderr, "{} on {}: {}\n", time_in_words(drawn.plotting->total_s()),
                   words_for(*drawn.machine), what_takes_longest(*drawn.plotting));
    }
    const bool svg = drawing_format(options.output) == DrawingFormat::svg;
    if (svg && found.overlapping > 0) {
        fmt::print(
            stderr,
            "{:.0f} % of the dots overlap others, and a plotter that draws outlines traces {:.1f} m of "
            "rings; --dot-radius with half the pen's width makes points of them\n",
            std::ceil(100.0 * static_cast<double>(found.overlapping) / static_cast<double>(drawn.dots)),
            found.rings_m);
    }
    if (svg && options.drawing.show_tiles) {
        fmt::print(stderr,
                   "the layer \"2 Tiles\" has lines that a plotter draws too; plot layer 1 only, or leave "
                   "--tiles away\n");
    }
    if (svg && 100 * found.nearer_than_saxi > drawn.dots) {
        fmt::print(
            stderr,
            "{} dots are nearer to others than {:g} mm, which saxi joins by a line, and {} nearer than "
            "{:g} mm, which AxiDraw's program does; fewer dots or a wider page part them\n",
            grouped(found.nearer_than_saxi), kSaxiJoins, grouped(found.nearer_than_axidraw), kAxiDrawJoins);
    }
    const bool whole_page = !options.region && options.sheet == Sheet{};
    if (whole_page && found.over_edge > 0) {
        fmt::print(stderr, "{} dots reach over the page's edge; --margin {:.1f} keeps them on it\n",
                   grouped(found.over_edge), std::ceil(drawn.radius_mm * 10) / 10);
    }
}

void write_stats(std::ostream& out, const RenderOptions& options, const Rendered& drawn) {
    const DrawingSettings& settings = options.drawing;
    const int threads = settings.placing.threads;
    nlohmann::ordered_json distinct, duplicates;
    if (drawn.duplicates) {
        distinct = drawn.dots - *drawn.duplicates;
        duplicates = *drawn.duplicates;
    }
    nlohmann::ordered_json preflight;
    if (drawn.preflight) {
        const Preflight& found = *drawn.preflight;
        preflight = {{"pen_up_m", found.pen_up_m},
                     {"pen_up_before_m", drawn.curve_way_m ? nlohmann::ordered_json(*drawn.curve_way_m)
                                                           : nlohmann::ordered_json()},
                     {"nearest_mm", found.nearest_mm},  // null if there are not two
                     {"nearer_than_0.5_mm", found.nearer_than_saxi},
                     {"nearer_than_0.152_mm", found.nearer_than_axidraw},
                     {"over_the_edge", found.over_edge},
                     {"overlapping", found.overlapping},
                     {"rings_m", found.rings_m}};
    }
    nlohmann::ordered_json plotting;
    if (drawn.plotting) {
        plotting = {{"machine", name_of(*drawn.machine)},
                    {"moving_s", drawn.plotting->moving_s},
                    {"lifting_s", drawn.plotting->lifting_s},
                    {"dots_s", drawn.plotting->dots_s},
                    {"total_s", drawn.plotting->total_s()}};
    }
    const nlohmann::ordered_json tone{{"automatic", settings.automatic_tone},
                                      {"exposure", drawn.tone.exposure},
                                      {"black_point", drawn.tone.black_point},
                                      {"white_point", drawn.tone.white_point},
                                      {"contrast", drawn.tone.contrast},
                                      {"brightness", drawn.tone.brightness},
                                      {"gamma", drawn.tone.gamma},
                                      {"blur", drawn.tone.blur},
                                      {"detail", drawn.tone.detail},
                                      {"invert", drawn.tone.invert}};
    std::error_code error;
    const auto bytes = std::filesystem::file_size(options.output, error);
    const nlohmann::ordered_json stats{
        {"image", options.image ? options.image->string() : "sample"},
        {"image_width", drawn.width},
        {"image_height", drawn.height},
        {"output", options.output.string()},
        {"dots", distinct},
        {"emitted", drawn.dots},
        {"duplicates", duplicates},
        {"scale", drawn.scale},
        {"mean_density", drawn.mean_density},
        {"tone", tone},
        {"relaxing_steps", drawn.steps},
        {"placer", name_of(settings.placer)},
        {"tile", tile_in_use(settings)},
        {"ranking", name_of(settings.ranking)},
        {"width_mm", drawn.page.width_mm},
        {"height_mm", drawn.page.height_mm},
        {"dot_radius_mm", drawn.radius_mm},
        {"margin_mm", options.margin_mm},
        {"order", name_of(drawn.order)},
        {"preflight", preflight},
        {"plotting", plotting},
        {"file_bytes", error ? 0 : bytes},
        {"threads", threads > 0 ? threads : tbb::info::default_concurrency()},
        {"tile_ms", drawn.times.tile},
        {"read_ms", drawn.times.read},
        {"tone_ms", drawn.times.tone},
        {"place_ms", drawn.times.place},
        {"write_ms", drawn.times.write},
    };
    // File names need not be UTF-8, JSON has to be.
    out << stats.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void check_that_fit(const CLI::App& command, const RenderOptions& options) {
    const DrawingFormat format = drawing_format(options.output);
    if (options.region && command.count("--sheet") > 0)
        throw CLI::ValidationError("--region", "cannot be given together with --sheet");
    if (format != DrawingFormat::svg)
        refuse(command, {"--tiles"}, "only an SVG has layers; let the drawing's name end in .svg");
    if (format != DrawingFormat::png)
        refuse(command, {"--dpi"}, "only a PNG has pixels; let the drawing's name end in .png");
    if (format == DrawingFormat::png)
        refuse(command, {"--order", "--machine"},
               "the pixels of a PNG have no order in which they are drawn");
    if (format == DrawingFormat::csv)
        refuse(command, {"--ink", "--paper", "--background"},
               "a table has no colours; let the drawing's name end in .svg or .png");
    if (format == DrawingFormat::svg && !options.drawing.background)
        refuse(command, {"--paper"}, "shows in an SVG with --background only; give that too");
    if (options.order == DotOrder::priority && options.drawing.relax.value_or(0) > 0) {
        throw CLI::ValidationError(
            "--order",
            "priority: the first dots of a relaxed drawing are not one with fewer; give --relax 0");
    }
}

}  // namespace

void render(const RenderOptions& options) {
    const DrawingSettings& settings = options.drawing;
    const DrawingFormat format = drawing_format(options.output);
    check_files(options);
    check_margin(options);

    Times times = {};
    Stopwatch watch;
    Pipeline pipeline;
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    times.tile = watch.lap();
    std::optional<ProgressLine> line(std::in_place);
    line->show(0, "reading the picture");
    Picture picture = options.image ? read_picture(*options.image, options.limit) : sample_picture();
    pipeline.set_light(std::move(picture.light), picture.exposure);
    const int width = pipeline.light().width, height = pipeline.light().height;
    times.read = watch.lap();

    const Excerpt excerpt = excerpt_of(page_of(pipeline.light(), options), options);
    // Better now than after the placing.
    if (format == DrawingFormat::png) static_cast<void>(raster_size(excerpt.size, options.dpi));
    DrawingPlan plan = plan_for(pipeline, options);
    times.tone = watch.lap();

    line->restart(0);
    line->show(0, plan.steps > 0 ? "placing and relaxing the dots" : "placing the dots");
    const DotStream dots = pipeline.stream(plan, excerpt.part);
    check_not_empty(plan, dots.count, options);
    const double radius_mm = plan.radius(dots.scale) * plan.page.mm_per_page_unit;
    DotStream drawn_dots = dots;
    if (format == DrawingFormat::png && excerpt.part != PagePart{}) {
        // Pixels show the part of a dot that reaches over from the next sheet.
        drawn_dots = pipeline.stream(plan, widened(excerpt.part, radius_mm / excerpt.size.mm_per_page_unit));
    }
    std::vector<PlacedTile> tiles;
    if (settings.show_tiles) tiles = pipeline.outlines(plan, dots.scale);
    move_to(excerpt.part, tiles);
    const double left = -excerpt.part.across.offset, top = -excerpt.part.down.offset;
    const double longer = std::max(width, height);
    const Rectangle<double> picture_box{{left, top}, {left + width / longer, top + height / longer}};
    const DotOrder order = options.order.value_or(usual_order(format, dots.count));
    Rendered rendered{.width = width,
                      .height = height,
                      .mean_density = plan.density->mean(),
                      .tone = plan.tone,
                      .steps = plan.steps,
                      .dots = dots.count,
                      .scale = dots.scale,
                      .duplicates = dots.duplicates,
                      .page = excerpt.size,
                      .radius_mm = radius_mm,
                      .order = order,
                      .mostly_black = mostly_black(*plan.histogram, plan.tone)};
    Dots sorted;
    const bool is_plot = format != DrawingFormat::png && dots.count <= kMostSortedDots;
    if (is_plot || (order != DotOrder::recursion && format != DrawingFormat::png)) {
        // The curve's own way, to tell what the shorter one saves.
        sorted = sorted_dots(dots, order == DotOrder::shortest ? DotOrder::space : order);
        if (order == DotOrder::shortest) {
            rendered.curve_way_m = way_length(sorted.x, sorted.y) * excerpt.size.mm_per_page_unit / 1000;
            line->restart(0);
            shorten_way(sorted, {.stop = {}, .progress = [&](double share) {
                                     line->show(share, "shortening the pen's way");
                                 }});
        }
        drawn_dots = stream_of(sorted, dots.scale);
    }
    times.place = watch.lap();

    line->restart(0);
    const std::string what = fmt::format("writing {} dots", grouped(dots.count));
    save_drawing(options.output, settings,
                 {.dots = drawn_dots,
                  .page = excerpt.size,
                  .dot_radius_mm = radius_mm,
                  .tiles = tiles,
                  .picture = picture_box,
                  .tile_size = pipeline.tile().tile().size(),
                  .dpi = options.dpi,
                  .order = DotOrder::recursion},
                 {.stop = {}, .progress = [&](double share) { line->show(share, what); }});
    times.write = watch.lap();
    line.reset();

    rendered.times = times;
    if (rendered.mostly_black && on_terminal()) {
        fmt::print(
            stderr,
            "nearly all dots go into black; --invert --ink '#fff' --paper '#000' --background draws the "
            "light parts instead\n");
    }
    if (is_plot) rendered.preflight = preflight(sorted, excerpt.size, radius_mm);
    rendered.machine = options.machine;
    if (!rendered.machine && format == DrawingFormat::svg) rendered.machine = Machine::axidraw_v3;
    if (is_plot && rendered.machine)
        rendered.plotting =
            plotting_time(sorted, excerpt.size.mm_per_page_unit, speeds_of(*rendered.machine));
    if (is_plot) print_summary(options, rendered);
    if (!options.stats) return;
    // Where on the page the duplicates lie is not known.
    if (dots.duplicates > 0 && (options.region || options.sheet != Sheet{})) rendered.duplicates.reset();
    save_atomically(*options.stats, [&](std::ostream& out) { write_stats(out, options, rendered); });
}

RenderCommand::RenderCommand(CLI::App& program) {
    CLI::App* const command = program.add_subcommand("render",
                                                     "Stipple a picture into a file: SVG for plotters and "
                                                     "drawing programs, PNG as pixels, CSV as a table");
    command->add_option("image", options_.image, "The picture; without one, the built-in sample")
        ->type_name("IMAGE");
    command->add_option("-o,--output", options_.output, "The drawing; its name ends in .svg, .png or .csv")
        ->type_name("OUT")
        ->required();
    command->add_option("--stats", options_.stats, "Save figures about the drawing, as JSON")
        ->type_name("FILE");
    command->add_flag_callback(
        "--huge", [this] { options_.limit = PictureLimit::huge; }, "Read pictures over 400 megapixels too");
    add_dot_options(*command, options_.drawing);
    add_tone_options(*command, options_.drawing);
    add_page_options(*command, options_.drawing);
    add_number(*command, "--dpi", options_.dpi, {.least = 1, .most = 100'000}, "N", "PNG: pixels to the inch")
        ->group("Page");
    add_length(*command, "--margin", options_.margin_mm, {.least = 0, .most = kLongestSideMm},
               "Bare paper on each side, within the width; the dots' radius keeps all of them on the sheet")
        ->group("Page");
    command
        ->add_flag("--background", options_.drawing.background,
                   "SVG: paint the paper under the dots, as a PNG always has it")
        ->group("Page");
    command->add_flag("--tiles", options_.drawing.show_tiles, "SVG: the tiles' outlines, as a layer")
        ->group("Page");
    add_choice(*command, "--machine", options_.machine,
               {Machine::axidraw_v3, Machine::axidraw_se_a3, Machine::grbl_pen, Machine::grbl_laser},
               "Tell how long this machine will plot, with its program's own settings; an SVG's time is told "
               "for axidraw-v3 without it")
        ->group("Page");
    add_arrangement_options(*command, options_.order, options_.sheet, options_.region);
    command->footer(
        "Examples:\n"
        "  dapple render cat.jpg -o cat.svg                    40,000 dots on a page 200 mm wide\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000 --width 400\n"
        "  dapple render cat.jpg -o cat.png --dpi 600 --ink '#1d3557'\n"
        "  dapple render cat.jpg -o cat.svg --width 210 --margin 15   with a border for the pen\n"
        "  dapple render cat.jpg -o part.svg --width 2000 --sheet 2,1/3x4   one sheet of a mural\n"
        "  dapple render cat.jpg -o eye.svg --region 60,40,80x50   a detail, to try pen and paper\n"
        "  dapple render cat.jpg -o cat.csv --stats cat.json   the dots as numbers, and figures about them\n"
        "  dapple render -o sample.svg --invert --ink '#fff' --paper '#000' --background");
    command->callback([this, command] {
        check_options(*command, options_.drawing);
        check_that_fit(*command, options_);
        render(options_);
    });
}

}  // namespace dapple
