#include "app/commands/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <unistd.h>
#include <chrono>
#include <cstdio>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/render_report.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/write_drawing.h"
#include "core/image/auto_tone.h"
#include "core/output/raster.h"
#include "core/placing/stipple.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "io/available_memory.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/file_size.h"
#include "io/files/pdf_file.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/separations.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/progress_line.h"
#include "io/settings/project.h"

namespace dapple {

bool draws_whole_page(const RenderOptions& options) {
    return !options.saving.region && options.sheet == Sheet{};
}

PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options) {
    const PageSetup& setup = options.drawing.page;
    PageSetup uncut = setup;
    uncut.fit = PageFit::inside;
    const glm::ivec2 cropped = with_option("--crop", [&] {
                                   if (setup.crop) check_crop(*setup.crop, picture);
                                   return framing_of(uncut, picture);
                               }).size();
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

DrawnPage page_for(const PageLayout& layout, const RenderOptions& options) {
    if (options.saving.region)
        return with_option("--region", [&] { return drawn_page(layout, options.saving); });
    return with_option("--overlap", [&] { return drawn_page(layout, options.sheet); });
}

namespace {

constexpr double kReportedSize = 20e6;  // bytes: it is told before it is written

// The work from stage to stage: how far it is, told to whoever watches or else to the terminal, and how long
// it took.
class Stages {
 public:
    explicit Stages(const RenderProgress& progress) : progress_(progress) {
        if (!progress_) line_.emplace();
    }

    // The next stage; of all work, it is about the part between the two.
    void begin(std::string text, double from, double to) {
        text_ = std::move(text);
        from_ = from;
        to_ = to;
        if (line_) line_->restart(0);
        show(0);
    }
    void show(double share) {
        if (progress_) progress_(from_ + share * (to_ - from_));
        if (line_) line_->show(share, text_);
    }
    void end() { line_.reset(); }

    // Where nobody watches: a sentence for whoever reads the terminal.
    void say(const std::string& sentence) {
        if (progress_) return;
        const bool goes_on = line_.has_value();
        line_.reset();
        fmt::print(stderr, "{}\n", sentence);
        if (goes_on) line_.emplace();
    }

    // Milliseconds since this was made or last asked.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

 private:
    const RenderProgress& progress_;
    std::optional<ProgressLine> line_;
    std::string text_;
    double from_ = 0, to_ = 1;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void check_output(const RenderOptions& options) {
    if (!is_standard_stream(options.output)) return check_can_save(options.output);
    if (is_text(format_of(options)) || !::isatty(STDOUT_FILENO)) return;
    throw std::runtime_error(
        "the standard output is a terminal, which cannot show this drawing; send it to a file or a program");
}

Picture picture_of(const RenderOptions& options) {
    const PictureColours colours =
        options.drawing.pens.set == PenSet::one ? PictureColours::left_out : PictureColours::kept;
    if (!options.image) return sample_picture(colours);
    if (!reads_standard_input(options)) return read_with_remark(*options.image, options.limit, colours);
    Picture picture = read_picture_from_standard_input(options.limit, colours);
    print_remark("the standard input", picture.remark);
    return picture;
}

// What the command draws, made sure to be possible.
DrawingPlan plan_for(Pipeline& pipeline, const RenderOptions& options, bool thresholds) {
    DrawingSettings settings = options.drawing;
    settings.placing.thresholds = thresholds;
    DrawingPlan plan = pipeline.plan(settings);
    if (plan.density->mean() == 0 && plan.placing.count) {
        throw std::runtime_error(fmt::format("{}: nothing to draw, as all of it is as light as the paper{}",
                                             name_of_image(options),
                                             options.drawing.mask.empty() ? "" : " or masked"));
    }
    if (plan.lowered) {
        const bool by_size = settings.dot_size.sizing == DotSizing::by_tone;
        throw std::runtime_error(fmt::format(
            "{} would make more than {} dots of {}; choose {}",
            by_size ? "--dot-radius: radii this small" : fmt::format("--scale: {:g}", settings.placing.scale),
            grouped(kMostDots), name_of_image(options), by_size ? "larger ones" : "a smaller scale"));
    }
    return plan;
}

// Nothing at all on a page that is not white is a slip; nothing on one sheet of it need not be.
void check_not_empty(const DrawingPlan& plan, std::uint64_t dots, const RenderOptions& options) {
    // The paper's own placer is known for losing all of a thin line.
    const bool loses = plan.placer == PlacerKind::figure8;
    if (dots > 0 || loses || !draws_whole_page(options) || plan.density->mean() == 0) return;
    const bool by_size = options.drawing.dot_size.sizing == DotSizing::by_tone;
    throw std::runtime_error(
        by_size ? "--dot-radius: the dots are too large for any to be drawn; choose smaller ones"
                : fmt::format("--scale: {:g} gives no dots; give a higher one", plan.placing.scale));
}

void check_fits_format(const PageSize& page, std::uint64_t dots, const RenderOptions& options) {
    const DrawingFormat format = format_of(options);
    if (has_pixels(format))
        static_cast<void>(with_option("--dpi", [&] { return raster_size(page, options.saving.dpi); }));
    if (format == DrawingFormat::pdf) check_fits_pdf(page, dots);
}

// Throws if the page is too large for the format: better now than after the placing.
void check_fits(const PageSize& page, std::uint64_t dots, const RenderOptions& options) {
    try {
        check_fits_format(page, dots, options);
    } catch (const std::runtime_error& error) {
        if (!draws_whole_page(options)) throw;
        for (int n = 2; n <= kMostSheetsAtOnce; ++n) {
            try {
                const PageSize sheet{page.width_mm / n, page.height_mm / n, page.mm_per_page_unit};
                check_fits_format(sheet, dots / static_cast<std::uint64_t>(n * n), options);
            } catch (const std::runtime_error&) {
                continue;
            }
            throw std::runtime_error(
                fmt::format("{0}; or draw it in parts with --sheets {1}x{1}", error.what(), n));
        }
        throw;
    }
}

// Throws if what is held of the drawing does not fit into memory: dots in an order that is not the tile's,
// those that lines join, and those of several pens.
void check_holds(const DrawingPlan& plan, const DrawingFile& file, const PageSize& part,
                 const RenderOptions& options) {
    constexpr double kSorted = 100, kJoined = 220, kOfPens = 500;  // bytes a dot, measured
    const DrawingSettings& settings = file.settings;
    double dots = plan.dots();
    const bool joined = settings.style != DrawingStyle::dots;
    const bool streamed = plan.pens.empty() && plan.edits.empty() && !joined;
    if (streamed) dots *= part.width_mm * part.height_mm / (plan.page.width_mm * plan.page.height_mm);
    const auto count = static_cast<std::uint64_t>(dots);
    const DotOrder order = options.saving.order.value_or(usual_order(file.format, count, settings.style));
    if (order == DotOrder::recursion && streamed) return;
    const double each = !plan.pens.empty() ? kOfPens : joined ? kJoined : kSorted;
    check_memory(dots * each, fmt::format("{} dots in the order \"{}\"", about(dots), name_of(order)),
                 options.memory);
}

// The files for each pen, made sure not to be those that the drawing is of.
std::vector<std::filesystem::path> pen_files_of(const RenderOptions& options, DrawingFormat format,
                                                std::span<const Pen> pens) {
    if (is_standard_stream(options.output)) return {};
    auto files = files_of(options.output, format, options.saving, pens);
    std::erase(files, options.output);
    std::vector<FileInUse> written;
    for (const auto& file : files) written.push_back({file, "a pen's file"});
    check_apart(written, options.read);
    return files;
}

}  // namespace

bool reads_standard_input(const RenderOptions& options) {
    return options.image && is_standard_stream(*options.image);
}

std::string name_of_image(const RenderOptions& options) {
    if (reads_standard_input(options)) return "the standard input";
    return options.image ? options.image->string() : "the sample";
}

DrawingFormat format_of(const RenderOptions& options) {
    if (options.format) return *options.format;
    return is_standard_stream(options.output) ? DrawingFormat::svg : drawing_format(options.output);
}

namespace {

// A picture's dots, ready to be drawn on any part of the page.
struct PlacedPicture {
    PlannedDrawing drawing;
    DrawingFile file;
    RenderTimes times;
};

PlacedPicture placed_picture(const RenderOptions& options, Stages& stages) {
    const DrawingSettings& settings = options.drawing;
    RenderTimes times;
    Pipeline pipeline;
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    times.tile = stages.lap();

    stages.begin("reading the picture", 0, 0.1);
    set_picture(pipeline, picture_of(options));
    const glm::ivec2 picture = pipeline.pixels();
    times.read = stages.lap();

    const DrawnPage page = page_for(layout_for(picture, options), options);
    const DrawingFormat format = format_of(options);
    check_fits(page.part.size, 0, options);
    DrawingFile file{.path = options.output,
                     .format = format,
                     .settings = settings,
                     .saving = options.saving,
                     .embedded = embedded_settings(options.output, settings, options.saving)};
    DrawingPlan plan = plan_for(pipeline, options, needs_thresholds(file));
    check_holds(plan, file, page.part.size, options);
    times.tone = stages.lap();

    stages.begin(plan.steps > 0 ? "placing and relaxing the dots" : "placing the dots", 0.1, 0.4);
    return {*pipeline.drawing(std::move(plan)), std::move(file), times};
}

// Draws the part of the page that the options say.
Rendered saved_part(const PlacedPicture& placed, const RenderOptions& options, Stages& stages,
                    const RenderProgress& progress) {
    const DrawingFormat format = placed.file.format;
    const DrawingPlan& plan = placed.drawing.plan;
    RenderTimes times = placed.times;
    const DrawnPage page = page_for(placed.drawing.layout(), options);
    DrawingToSave drawing = drawing_on(page, placed.drawing, placed.file);
    drawing.file.path = options.output;
    const DotStream dots = drawing.dots;
    check_not_empty(plan, dots.count, options);
    check_fits(page.part.size, dots.count, options);
    const DotOrder order = order_of(drawing);
    std::shared_ptr<DotPieces> held;  // none if they are too many, and need not be sorted
    std::optional<double> curve_way;
    if (dots.count <= kMostSortedDots || order != DotOrder::recursion) {
        held = std::make_shared<DotPieces>(sorted_by_pen(dots, DotOrder::recursion));
        times.place = stages.lap();
        if (order == DotOrder::shortest) stages.begin("optimising the pen's route", 0.4, 0.7);
        curve_way =
            put_in_order(*held, order, {.stop = {}, .progress = [&](double share) { stages.show(share); }});
        times.order = stages.lap();
        drawing.dots = stream_of(held, dots.scale);
    }

    if (is_table(format) && plan.inking)
        stages.say(
            "a table has only dots: contours and solid blacks are left out; use SVG, PDF or a file for "
            "machines");
    const auto pen_files = pen_files_of(options, format, plan.pens);
    const std::optional<double> bytes = estimated_bytes(drawing);
    if (bytes >= kReportedSize) stages.say(fmt::format("about {} will be written", bytes_in_words(*bytes)));
    stages.begin(fmt::format("writing {} dots", grouped(dots.count)), 0.7, 1);
    const DotPieces* const measured = dots.count <= kMostSortedDots ? held.get() : nullptr;
    // Writing waits for the disk, or for one thread that compresses. Nobody else reads the figures.
    std::future<DrawingFigures> figures = std::async(std::launch::async, [&] {
        return options.stats || prints_advice(options) ? figures_of(plan, page, drawing, measured)
                                                       : DrawingFigures{};
    });
    save_ordered(drawing, {.stop = {}, .progress = [&](double share) { stages.show(share); }});
    times.write = stages.lap();
    stages.end();
    std::vector<std::string> names;
    for (const auto& own : pen_files) names.push_back(printable(own.string()));
    if (!names.empty())
        stages.say(fmt::format("{}: {}", has_pixels(format) ? "separations" : "a file for each pen",
                               fmt::join(names, ", ")));

    Rendered rendered;
    static_cast<DrawingFigures&>(rendered) = figures.get();
    times.check = stages.lap();
    rendered.width = plan.opened.x;
    rendered.height = plan.opened.y;
    rendered.mean_density = plan.density->mean();
    rendered.tone = plan.tone;
    rendered.steps = plan.steps;
    rendered.dots = dots.count;
    rendered.scale = dots.scale;
    // Where on the page Figure 8's duplicates lie is not known.
    if (dots.duplicates == 0 || page.draws_whole()) rendered.duplicates = dots.duplicates;
    rendered.page = page.part.size;
    rendered.whole_page = page.layout.page;
    rendered.picture = page.layout.picture;
    rendered.radius_mm = drawing.dot_radius_mm;
    rendered.pens = plan.pens;
    if (has_pixels(format)) {
        const RasterSize size = raster_size(page.part.size, options.saving.dpi);
        rendered.pixels = {size.width, size.height};
    }
    rendered.order = order;
    if (curve_way) rendered.curve_way_m = *curve_way * page.part.size.mm_per_page_unit / 1000;
    rendered.times = times;
    if (prints_advice(options) && mostly_black(*plan.histogram, plan.tone) && on_terminal())
        stages.say(
            "nearly all dots will lie in black; use --invert --ink '#fff' --paper '#000' --background to "
            "draw the light parts instead");
    if (!progress) print_summary(options, rendered);
    if (options.stats) save_stats(*options.stats, stats_of(options, rendered));
    return rendered;
}

}  // namespace

Rendered render(const RenderOptions& options, const RenderProgress& progress) {
    check_output(options);
    check_stats(options);
    Stages stages(progress);
    return saved_part(placed_picture(options, stages), options, stages, progress);
}

void render_parts(std::span<const RenderOptions> parts, const RenderProgress& progress,
                  const std::function<void(const RenderOptions& part, const Rendered& drawn)>& take) {
    for (const RenderOptions& part : parts) check_output(part);
    Stages stages(progress);
    const PlacedPicture placed = placed_picture(parts.front(), stages);
    for (const RenderOptions& part : parts) take(part, saved_part(placed, part, stages, progress));
}

}  // namespace dapple
