#include "app/commands/render.h"

#include <fmt/format.h>
#include <tbb/info.h>
#include <unistd.h>

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
#include "app/files/pdf_file.h"
#include "app/files/sample.h"
#include "app/files/save_drawing.h"
#include "app/files/standard_input.h"
#include "app/files/text_file.h"
#include "app/files/tile_library.h"
#include "app/progress_line.h"
#include "app/settings/drawing_fields.h"
#include "app/settings/embedded_settings.h"
#include "app/settings/project.h"
#include "app/shown_text.h"
#include "core/drawing/pipeline.h"
#include "core/image/ink_use.h"
#include "core/output/preflight.h"
#include "core/output/raster.h"
#include "core/tile/tile_file.h"

namespace dapple {
namespace {

// A picture, or a project that names one and says how it is drawn.
void take_image(RenderOptions& options, const std::filesystem::path& file) {
    if (!ends_as_project(file)) {
        options.image = file;
        return;
    }
    SavingChoice saving;
    bool photograph = true;
    options.project = file;
    options.image = read_project(file, [&](Fields& fields) {
                        describe_drawing(fields, options.drawing, saving);
                        fields.group("density", [&](Fields& density) {
                            density.choice("source", photograph,
                                           {NamedValue{"photograph", true}, NamedValue{"grey", false},
                                            NamedValue{"ramp", false}});
                        });
                    }).picture;
    if (!photograph)
        throw std::runtime_error(
            printable(file.native()) +
            ": shows a plain density, which the window alone draws; choose the photograph "
            "there, under View, and save it again");
    options.saving = saving;
}

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

bool is_standard_stream(const std::filesystem::path& path) {
    return path == kStandardStream;
}

bool reads_standard_input(const RenderOptions& options) {
    return options.image && is_standard_stream(*options.image);
}

DrawingFormat format_of(const RenderOptions& options) {
    if (options.format) return *options.format;
    return is_standard_stream(options.output) ? DrawingFormat::svg : drawing_format(options.output);
}

std::string name_of_image(const RenderOptions& options) {
    if (reads_standard_input(options)) return "the standard input";
    return options.image ? options.image->string() : "the sample";
}

void check_files(const RenderOptions& options) {
    FileInUse picture{options.image, "the picture"}, drawing{options.output, "the drawing"};
    const FileInUse tile{options.drawing.tile, "the tile"}, project{options.project, "the project"},
        settings{options.settings_from, "the settings"};
    if (reads_standard_input(options)) picture.path.reset();
    if (is_standard_stream(options.output)) {
        drawing.path.reset();
        if (is_binary(format_of(options)) && ::isatty(STDOUT_FILENO)) {
            throw std::runtime_error(
                "the standard output is a terminal, which cannot show such a drawing; send it to a file or "
                "a program");
        }
    } else {
        check_apart(options.output, {picture, tile, project});
        check_can_save(options.output);
    }
    if (!options.stats) return;
    check_apart(*options.stats, {picture, tile, project, settings, drawing});
    check_can_save(*options.stats);
}

// What the command draws, made sure to be possible.
DrawingPlan plan_for(Pipeline& pipeline, const RenderOptions& options) {
    DrawingRequest request = request_of(options.drawing);
    request.placing.thresholds = is_table(format_of(options)) || options.saving.order == DotOrder::priority;
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

// What throws for a reason that an option gives, with that option's name.
template <class Make>
auto with_option(const char* option, const Make& make) {
    try {
        return make();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", option, error.what()));
    }
}

// The page of a picture of so many pixels, before it is known how large the dots are if they say so
// themselves.
PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options) {
    const PageSetup& setup = options.drawing.page;
    PageSetup uncut = setup;
    uncut.fit = PageFit::inside;
    const glm::ivec2 cropped = with_option("--crop", [&] { return framing_of(uncut, picture); }).size();
    static_cast<void>(with_option("--margin", [&] { return layout_of(setup, cropped); }));
    const glm::ivec2 size = framing_of(setup, picture).size();
    const PageLayout layout = with_option(
        "--dot-radius", [&] { return layout_of(setup, size, {.mm = reach_mm(options.drawing.dot_size)}); });
    const double width = layout.page.width_mm, height = layout.page.height_mm;
    const auto too_long = [&](const char* given, double side, const char* is, const char* becomes,
                              double other) {
        return std::runtime_error(fmt::format(
            "{}: {} x {} pixels would make a page {:g} mm {} and {:.4g} m {}, and {:g} m is the most; "
            "choose a {} of {:.2g} or less",
            name_of_image(options), size.x, size.y, side, is, other / 1000, becomes, kLongestSideMm / 1000,
            given, side * kLongestSideMm / other * 0.95));
    };
    if (setup.paper != Paper::as_picture) return layout;
    if (height > kLongestSideMm) throw too_long("--width", width, "wide", "high", height);
    if (width > kLongestSideMm) throw too_long("--height", height, "high", "wide", width);
    return layout;
}

// The page, or the part of it that is drawn.
Excerpt excerpt_of(const PageLayout& layout, const RenderOptions& options) {
    const glm::dvec2 corner = layout.picture.low;
    if (!options.region) return sheet_of(layout.page, options.sheet, corner);
    const glm::dvec2 size = options.region->size();
    if (std::min(size.x, size.y) < kShortestSideMm) {
        throw std::runtime_error(fmt::format("--region: {:g} x {:g} mm is too small; give {:g} mm or more",
                                             size.x, size.y, kShortestSideMm));
    }
    return with_option("--region", [&] { return region_of(layout.page, *options.region, corner); });
}

// What the margins leave, seen from the excerpt's corner, in millimetres.
Rectangle<double> margins_on(const Excerpt& excerpt, const PageLayout& layout) {
    const glm::dvec2 offset(excerpt.part.across.offset, excerpt.part.down.offset);
    const glm::dvec2 corner = layout.picture.low + offset * layout.page.mm_per_page_unit;
    return {layout.within_margins.low - corner, layout.within_margins.high - corner};
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
    Rectangle<double> picture;                // on the whole page, in millimetres
    double radius_mm = 0;
    DotOrder order = DotOrder::recursion;
    std::optional<double> curve_way_m = {};   // of the pen, before it was shortened
    bool mostly_black = false;                // light ink would draw the picture better
    std::optional<Preflight> preflight = {};  // of what is plotted, if its dots were in memory
    Machine machine = {};                     // that would draw it
    std::optional<PlottingTime> plotting = {};
    Times times = {};
};

// Of a file that was saved; none of the standard output or a pipe.
std::optional<std::uint64_t> bytes_in(const std::filesystem::path& output) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(output, error);
    if (error || is_standard_stream(output)) return std::nullopt;
    return bytes;
}

// What someone who is about to plot it should know, in a few lines.
void print_summary(const RenderOptions& options, const Rendered& drawn) {
    const std::optional<std::uint64_t> bytes = bytes_in(options.output);
    const std::string size = !bytes ? "" : fmt::format(", {:.1f} MB", static_cast<double>(*bytes) * 1e-6);
    const Preflight& found = *drawn.preflight;
    const std::string saved =
        drawn.curve_way_m ? fmt::format(" ({:.1f} m before its way was shortened)", *drawn.curve_way_m) : "";
    fmt::print(stderr, "{} dots{}; the pen moves {:.1f} m between them{}; the nearest are {:.2g} mm apart\n",
               grouped(drawn.dots), size, found.pen_up_m, saved, found.nearest_mm);
    if (drawn.plotting && drawn.dots > 0) {
        fmt::print(stderr, "{} on {}: {}\n", time_in_words(drawn.plotting->total_s()),
                   words_for(drawn.machine), what_takes_longest(*drawn.plotting));
    }
    const bool svg = format_of(options) == DrawingFormat::svg;
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
                     {"outside_the_margins", found.outside_margins},
                     {"overlapping", found.overlapping},
                     {"rings_m", found.rings_m}};
    }
    nlohmann::ordered_json plotting;
    if (drawn.plotting) {
        plotting = {{"machine", name_of(drawn.machine)},
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
    const auto [top, right, bottom, left] = settings.page.margins;
    nlohmann::ordered_json margin = top;
    if (settings.page.margins != Margins{top, top, top, top}) margin = {top, right, bottom, left};
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
        {"page", paper_titles()[static_cast<std::size_t>(settings.page.paper)]},
        {"margin_mm", margin},
        {"picture_mm",
         {drawn.picture.low.x, drawn.picture.low.y, drawn.picture.size().x, drawn.picture.size().y}},
        {"order", name_of(drawn.order)},
        {"preflight", preflight},
        {"plotting", plotting},
        {"file_bytes", bytes_in(options.output).value_or(0)},
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

// "let the drawing's name end in .png or .tif"
std::string let_it_end_in(const char* endings) {
    return fmt::format("let the drawing's name end in {}", endings);
}

void check_format(const RenderOptions& options) {
    if (is_standard_stream(options.output)) {
        if (options.format == DrawingFormat::tiff)
            throw CLI::ValidationError(
                "--format", "tif is not written from its beginning to its end, so it needs a file; give png");
        return;
    }
    if (!options.format) return;
    std::optional<DrawingFormat> by_name;
    try {
        by_name = drawing_format(options.output);
    } catch (const std::runtime_error&) {
        return;  // it says nothing, or nothing of a drawing
    }
    if (by_name == options.format) return;
    throw CLI::ValidationError(
        "--format", fmt::format("{}, but the name {} says {}; leave one of them away",
                                name_of(*options.format), options.output.string(), name_of(*by_name)));
}

void check_that_fit(const CLI::App& command, const RenderOptions& options) {
    check_format(options);
    const DrawingFormat format = format_of(options);
    if (options.region && command.count("--sheet") > 0)
        throw CLI::ValidationError("--region", "cannot be given together with --sheet");
    if (format != DrawingFormat::svg)
        refuse(command, {"--tiles"}, "only an SVG has layers; " + let_it_end_in(".svg"));
    if (!has_pixels(format))
        refuse(command, {"--dpi"}, "only a PNG or a TIFF has pixels; " + let_it_end_in(".png or .tif"));
    if (has_pixels(format)) refuse(command, {"--order"}, "the pixels of a PNG or a TIFF have no order");
    if (!is_plotted(format))
        refuse(command, {"--machine"},
               "is for what is plotted; " + let_it_end_in(".svg, .gcode, .hpgl or .dxf"));
    if (!has_colours(format)) {
        const std::string what = is_table(format) ? "a table has" : "a file for machines has";
        refuse(command, {"--ink", "--paper", "--background"},
               what + " no colours; " + let_it_end_in(".svg, .pdf, .png or .tif"));
    }
    if (has_optional_paper(format) && !options.drawing.background)
        refuse(command, {"--paper"}, "shows in an SVG or a PDF with --background only; give that too");
    if (format != DrawingFormat::gcode)
        refuse(command, {"--gcode", "--feed", "--dwell"}, "is of G-code; " + let_it_end_in(".gcode or .nc"));
    const bool given = command.count("--order") > 0 || command.count("--relax") > 0;
    if (given && options.saving.order == DotOrder::priority && options.drawing.relax.value_or(0) > 0) {
        throw CLI::ValidationError(
            "--order",
            "priority: the first dots of a relaxed drawing are not one with fewer; give --relax 0");
    }
}

Picture picture_of(const RenderOptions& options) {
    if (!options.image) return sample_picture();
    return reads_standard_input(options) ? read_picture_from_standard_input(options.limit)
                                         : read_picture(*options.image, options.limit);
}

// A tool by its name, or a template of one's own.
void take_tool(RenderOptions& options, const std::string& text) {
    options.gcode_template.reset();
    for (const GcodeTool tool : {GcodeTool::pen, GcodeTool::servo, GcodeTool::laser}) {
        if (text != name_of(tool)) continue;
        options.saving.tool = tool;
        return;
    }
    if (!std::filesystem::exists(text)) {
        throw std::runtime_error(
            fmt::format("--gcode: {} is neither pen, servo nor laser, nor a file with a template", text));
    }
    try {
        options.gcode_template = parse_gcode_template(text_of_file(text));
    } catch (const std::runtime_error& error) {
        const std::string why = error.what();
        throw std::runtime_error(why.starts_with(text) ? why : fmt::format("{}: {}", text, why));
    }
}

void add_gcode_options(CLI::App& command, RenderOptions& options) {
    GcodeStyle& gcode = options.gcode;
    command
        .add_option_function<std::string>(
            "--gcode", [&options](const std::string& text) { take_tool(options, text); },
            "G-code: what the machine does at a dot. pen: lowers it by the Z axis; servo: turns a servo by "
            "M3; laser: a burst by M3; or a template of your own, see below")
        ->type_name("pen|servo|laser|FILE")
        ->default_str("pen")
        ->group("G-code");
    add_number(command, "--feed", gcode.feed_mm_per_min,
               {.least = 0, .most = 1e6, .at_least = NumberRange::Least::excluded}, "MM/MIN",
               "G-code: how fast the tool moves, in millimetres a minute")
        ->group("G-code");
    add_number(command, "--dwell", gcode.dwell_s, {.least = 0, .most = 60}, "SECONDS",
               "G-code: how long the tool rests at a dot, as G4 P, which Grbl and LinuxCNC read in seconds")
        ->group("G-code");
}

constexpr const char* kGcodeHelp =
    "A template for --gcode is a text whose lines begin with start, move, dot or end: what is written once "
    "before the dots, for the way to each dot, at each dot, and once after them. {x} and {y} stand for the "
    "dot's place in mm from the lower left corner, {radius} for its radius, {feed} and {dwell} for the two "
    "options. A pen that a servo turns:\n"
    "  start G21\n"
    "  start G90\n"
    "  move G1 X{x} Y{y} F{feed}\n"
    "  dot M3 S90\n"
    "  dot G4 P{dwell}\n"
    "  dot M3 S20\n"
    "  end M5\n";

}  // namespace

void render(const RenderOptions& options) {
    const DrawingSettings& settings = options.drawing;
    const DrawingFormat format = format_of(options);
    check_files(options);

    Times times = {};
    Stopwatch watch;
    Pipeline pipeline;
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    times.tile = watch.lap();
    std::optional<ProgressLine> line(std::in_place);
    line->show(0, "reading the picture");
    Picture picture = picture_of(options);
    pipeline.set_light(std::move(picture.light), picture.exposure);
    const int width = pipeline.light().width, height = pipeline.light().height;
    times.read = watch.lap();

    PageLayout layout = layout_for({width, height}, options);
    Excerpt excerpt = excerpt_of(layout, options);
    // Better now than after the placing.
    if (has_pixels(format)) static_cast<void>(raster_size(excerpt.size, options.saving.dpi));
    if (format == DrawingFormat::pdf) check_fits_pdf(excerpt.size, 0);
    DrawingPlan plan = plan_for(pipeline, options);
    if (keeps_dots_inside(settings.page)) {
        // The dots' own size follows from their number, and the picture's place from their size.
        layout = plan.layout(pipeline.find_scale(plan));
        excerpt = excerpt_of(layout, options);
    }
    times.tone = watch.lap();

    line->restart(0);
    line->show(0, plan.steps > 0 ? "placing and relaxing the dots" : "placing the dots");
    const DotStream dots = pipeline.stream(plan, excerpt.part);
    check_not_empty(plan, dots.count, options);
    if (format == DrawingFormat::pdf) check_fits_pdf(excerpt.size, dots.count);
    const double radius_mm = plan.radius(dots.scale) * layout.page.mm_per_page_unit;
    DotStream drawn_dots = dots;
    if (has_pixels(format) && excerpt.part != PagePart{}) {
        // Pixels show the part of a dot that reaches over from the next sheet.
        drawn_dots = pipeline.stream(plan, widened(excerpt.part, radius_mm / excerpt.size.mm_per_page_unit));
    }
    std::vector<PlacedTile> tiles;
    if (settings.show_tiles) tiles = pipeline.outlines(plan, dots.scale);
    move_to(excerpt.part, tiles);
    const double left = -excerpt.part.across.offset, top = -excerpt.part.down.offset;
    const double longer = std::max(plan.pixels.x, plan.pixels.y);
    const Rectangle<double> picture_box{{left, top},
                                        {left + plan.pixels.x / longer, top + plan.pixels.y / longer}};
    const DotOrder order = options.saving.order.value_or(usual_order(format, dots.count));
    Rendered rendered{.width = width,
                      .height = height,
                      .mean_density = plan.density->mean(),
                      .tone = plan.tone,
                      .steps = plan.steps,
                      .dots = dots.count,
                      .scale = dots.scale,
                      .duplicates = dots.duplicates,
                      .page = excerpt.size,
                      .picture = layout.picture,
                      .radius_mm = radius_mm,
                      .order = order,
                      .mostly_black = mostly_black(*plan.histogram, plan.tone)};
    Dots sorted;
    const bool in_memory = !has_pixels(format) && dots.count <= kMostSortedDots;
    if (in_memory || (order != DotOrder::recursion && !has_pixels(format))) {
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

    GcodeStyle gcode = options.gcode;
    gcode.lines =
        options.gcode_template.value_or(parse_gcode_template(gcode_template_of(options.saving.tool)));
    line->restart(0);
    const std::string what = fmt::format("writing {} dots", grouped(dots.count));
    save_drawing(options.output, settings,
                 {.dots = drawn_dots,
                  .page = excerpt.size,
                  .dot_radius_mm = radius_mm,
                  .tiles = tiles,
                  .picture = picture_box,
                  .tile_size = pipeline.tile().tile().size(),
                  .dpi = options.saving.dpi,
                  .order = DotOrder::recursion,
                  .gcode = gcode,
                  .format = format,
                  .settings = embedded_settings(options.output, settings, options.saving)},
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
    if (in_memory)
        rendered.preflight = preflight(sorted, excerpt.size, radius_mm, margins_on(excerpt, layout));
    if (in_memory && is_plotted(format)) {
        rendered.machine = options.saving.machine.value_or(usual_machine(format, options.saving.tool));
        rendered.plotting = plotting_time(sorted, excerpt.size.mm_per_page_unit, speeds_of(rendered.machine));
    }
    if (in_memory) print_summary(options, rendered);
    if (!options.stats) return;
    // Where on the page the duplicates lie is not known.
    if (dots.duplicates > 0 && (options.region || options.sheet != Sheet{})) rendered.duplicates.reset();
    save_atomically(*options.stats, [&](std::ostream& out) { write_stats(out, options, rendered); });
}

RenderCommand::RenderCommand(CLI::App& program) {
    CLI::App* const command = program.add_subcommand("render",
                                                     "Stipple a picture into a file: SVG, G-code, HPGL and "
                                                     "DXF for plotters and lasers, PDF, PNG and TIFF for "
                                                     "print, CSV and JSON as tables");
    // First, so that it is taken before the other options, which say otherwise.
    const auto read_image = [this](const std::string& file) {
        take_image(options_, file);
        automatic_tone_ = options_.drawing.automatic_tone;
    };
    command
        ->add_option_function<std::string>(
            "image", read_image,
            "The picture, - for the standard input, or a project (.dapple) that the window saved, whose "
            "settings the other options change; without one, the built-in sample")
        ->type_name("IMAGE");
    const auto read_settings = [this](const std::string& file) {
        const SavedSettings read = settings_from(file);
        options_.saving = read.saving;
        options_.drawing = read.drawing;
        options_.settings_from = file;
        automatic_tone_ = read.drawing.automatic_tone;
    };
    command
        ->add_option_function<std::string>(
            "--settings-from", read_settings,
            "Draw as a project or as a drawing (.svg, .png) that Dapple made, with "
            "what the other options change")
        ->type_name("FILE");
    command
        ->add_option("-o,--output", options_.output,
                     "The drawing; its name ends in " + drawing_endings() + ". - for the standard output")
        ->type_name("OUT")
        ->required();
    add_choice(*command, "--format", options_.format,
               {DrawingFormat::svg, DrawingFormat::pdf, DrawingFormat::png, DrawingFormat::tiff,
                DrawingFormat::gcode, DrawingFormat::hpgl, DrawingFormat::dxf, DrawingFormat::csv,
                DrawingFormat::json},
               "What is written where no name says it: an SVG without this");
    command->add_option("--stats", options_.stats, "Save figures about the drawing, as JSON")
        ->type_name("FILE");
    command->add_flag_callback(
        "--huge", [this] { options_.limit = PictureLimit::huge; }, "Read pictures over 400 megapixels too");
    add_dot_options(*command, options_.drawing);
    add_tone_options(*command, options_.drawing);
    add_page_options(*command, options_.drawing);
    add_number(*command, "--dpi", options_.saving.dpi, {.least = 1, .most = 100'000}, "N",
               "PNG, TIFF: pixels to the inch")
        ->group("Page");
    command
        ->add_flag("--background", options_.drawing.background,
                   "SVG, PDF: paint the paper under the dots, as a PNG always has it")
        ->group("Page");
    command->add_flag("--tiles", options_.drawing.show_tiles, "SVG: the tiles' outlines, as a layer")
        ->group("Page");
    add_choice(
        *command, "--machine", options_.saving.machine,
        {Machine::axidraw_v3, Machine::axidraw_se_a3, Machine::grbl_pen, Machine::grbl_laser},
        "Tell how long this machine will plot, with its program's own settings; without it, an AxiDraw "
        "V3, and a GRBL machine for G-code")
        ->group("Page");
    add_arrangement_options(*command, options_.saving.order, options_.sheet, options_.region);
    add_gcode_options(*command, options_);
    command->footer(
        std::string(kGcodeHelp) +
        "\nExamples:\n"
        "  dapple render cat.jpg -o cat.svg                    40,000 dots on a page 200 mm wide\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000 --width 400\n"
        "  dapple render cat.jpg -o cat.png --dpi 600 --ink '#1d3557'\n"
        "  dapple render cat.jpg -o cat.svg --page a4 --margin 15     on A4, with a border for the pen\n"
        "  dapple render cat.jpg -o cat.svg --page 8.5x11in --fit fill --margin 0.5in\n"
        "  dapple render cat.jpg -o part.svg --width 2000 --sheet 2,1/3x4   one sheet of a mural\n"
        "  dapple render cat.jpg -o eye.svg --region 60,40,80x50   a detail, to try pen and paper\n"
        "  dapple render cat.jpg -o cat.csv --stats cat.json   the dots as numbers, and figures about them\n"
        "  dapple render cat.jpg -o cat.gcode --gcode laser --feed 6000 --dwell 0.02\n"
        "  convert cat.jpg -resize 50% png:- | dapple render - -o - --format pdf > cat.pdf\n"
        "  dapple render cat.dapple -o cat.png --dpi 600       what the window saved as a project\n"
        "  dapple render dog.jpg -o dog.svg --settings-from cat.svg   as cat.svg was drawn\n"
        "  dapple render -o sample.svg --invert --ink '#fff' --paper '#000' --background");
    command->callback([this, command] {
        check_options(*command, options_.drawing, automatic_tone_);
        check_that_fit(*command, options_);
        render(options_);
    });
}

}  // namespace dapple
