#include "app/commands/render.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/options.h"
#include "app/drawing_steps.h"
#include "app/files/atomic_file.h"
#include "app/files/sample.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "core/output/raster.h"
#include "core/tile/tile_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

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
    const auto is_the_picture = [&](const fs::path& file) {
        std::error_code error;
        return options.image && fs::equivalent(*options.image, file, error) && !error;
    };
    if (is_the_picture(options.output)) {
        throw std::runtime_error(
            fmt::format("{}: is the picture itself; give the drawing another name", options.output.string()));
    }
    check_can_save(options.output);
    if (!options.stats) return;
    if (is_the_picture(*options.stats) || *options.stats == options.output) {
        throw std::runtime_error(
            fmt::format("{}: is in use already; give the figures another name", options.stats->string()));
    }
    check_can_save(*options.stats);
}

// The count or scale that is asked for, made sure to be possible.
StippleRequest request_for(const RenderOptions& options, const Density& density) {
    StippleRequest request = options.drawing.stipple;
    if (request.count && density.mean() == 0) {
        throw std::runtime_error(
            fmt::format("{}: nothing to draw, all of it is as light as the paper", name_of_image(options)));
    }
    if (request.count && request.placer == PlacerKind::figure8) {
        // It cannot count, but it can come near.
        request.scale = static_cast<double>(*request.count) / (16 * density.mean());
        request.count.reset();
    }
    const double expected = 16 * request.scale * density.mean();
    if (!request.count && expected > static_cast<double>(kMostDots)) {
        throw std::runtime_error(
            fmt::format("--scale: {:g} would make about {:.3g} dots of {}, and {} are the most",
                        request.scale, expected, name_of_image(options), kMostDots));
    }
    return request;
}

struct Drawing {
    Stippling stippling;
    PageSize page;
    double radius_mm = 0;
    std::vector<PlacedTile> tiles;
};

struct Times {
    double tile = 0, read = 0, tone = 0, write = 0;  // milliseconds
};

void write_stats(std::ostream& out, const RenderOptions& options, const Density& density,
                 const Drawing& drawing, const Times& times) {
    const DrawingSettings& settings = options.drawing;
    const Stippling& stippling = drawing.stippling;
    const std::uint64_t emitted = stippling.dots.size();
    const int threads = settings.stipple.threads;
    const nlohmann::ordered_json stats{
        {"image", options.image ? options.image->string() : "sample"},
        {"image_width", density.width()},
        {"image_height", density.height()},
        {"output", options.output.string()},
        {"dots", emitted - stippling.duplicates},
        {"emitted", emitted},
        {"duplicates", stippling.duplicates},
        {"scale", stippling.scale},
        {"mean_density", density.mean()},
        {"placer", name_of(settings.stipple.placer)},
        {"tile", tile_in_use(settings)},
        {"ranking", name_of(settings.ranking)},
        {"width_mm", drawing.page.width_mm},
        {"height_mm", drawing.page.height_mm},
        {"dot_radius_mm", drawing.radius_mm},
        {"threads", threads > 0 ? threads : tbb::info::default_concurrency()},
        {"tile_ms", times.tile},
        {"read_ms", times.read},
        {"tone_ms", times.tone},
        {"place_ms", stippling.place_ms},
        {"write_ms", times.write},
    };
    // File names need not be UTF-8, JSON has to be.
    out << stats.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace

void render(const RenderOptions& options) {
    const DrawingSettings& settings = options.drawing;
    const DrawingFormat format = drawing_format(options.output);
    check_files(options);

    Times times;
    Stopwatch watch;
    RankedTile tile = tile_named(tile_in_use(settings), settings.ranking);
    times.tile = watch.lap();
    Picture picture = options.image ? read_picture(*options.image, options.limit) : sample_picture();
    times.read = watch.lap();
    const Density density(density_of(std::move(picture.light), settings.tone));
    times.tone = watch.lap();

    Drawing drawing;
    drawing.page = page_size(density, settings.width_mm);
    if (format == DrawingFormat::png) {
        // Better now than after the placing.
        PageSize page = drawing.page;
        Dots none;
        cut_to_sheet(options.sheet, none, page, {});
        static_cast<void>(raster_size(page, options.dpi));
    }
    stipple(tile, density, request_for(options, density), drawing.stippling);
    drawing.radius_mm = dot_radius_mm(settings, drawing.stippling.scale, drawing.page);
    if (settings.show_tiles) {
        drawing.tiles = tiles_of(tile, density, settings.stipple.placer, drawing.stippling.scale);
    }
    Dots& dots = drawing.stippling.dots;
    if (format == DrawingFormat::csv || options.order == DotOrder::priority)
        fill_critical_scales(dots, density);
    sort_dots(dots, options.order);
    cut_to_sheet(options.sheet, dots, drawing.page, drawing.tiles);

    watch.lap();
    save_drawing(options.output, settings,
                 {.stippling = drawing.stippling,
                  .page = drawing.page,
                  .tiles = drawing.tiles,
                  .tile_size = tile.tile().size(),
                  .dpi = options.dpi});
    times.write = watch.lap();
    if (!options.stats) return;
    save_atomically(*options.stats,
                    [&](std::ostream& out) { write_stats(out, options, density, drawing, times); });
}

RenderCommand::RenderCommand(CLI::App& program) {
    CLI::App* const command =
        program.add_subcommand("render", "Stipple a picture into an SVG, PNG or CSV file");
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
    add_tone_options(*command, options_.drawing.tone);
    add_page_options(*command, options_.drawing);
    add_number(*command, "--dpi", options_.dpi, {.least = 1, .most = 100'000}, "N", "PNG: pixels to the inch")
        ->group("Page");
    command->add_flag("--background", options_.drawing.background, "SVG: paint the paper under the dots")
        ->group("Page");
    command->add_flag("--tiles", options_.drawing.show_tiles, "SVG: the tiles' outlines, as a layer")
        ->group("Page");
    add_arrangement_options(*command, options_.order, options_.sheet);
    command->footer(
        "Examples:\n"
        "  dapple render cat.jpg -o cat.svg                    40,000 dots on a page 200 mm wide\n"
        "  dapple render cat.jpg -o cat.svg --dots 100000 --width 400\n"
        "  dapple render cat.jpg -o cat.png --dpi 600 --ink '#1d3557'\n"
        "  dapple render cat.jpg -o part.svg --width 2000 --sheet 2,1/3x4   one sheet of a mural\n"
        "  dapple render cat.jpg -o cat.csv --stats cat.json   the dots as numbers, and figures about them\n"
        "  dapple render -o sample.svg --invert --ink '#fff' --paper '#000' --background");
    command->callback([this, command] {
        check_options(*command, options_.drawing);
        if (options_.drawing.show_tiles && drawing_format(options_.output) != DrawingFormat::svg) {
            throw CLI::ValidationError("--tiles",
                                       "only an SVG has layers; let the drawing's name end in .svg");
        }
        render(options_);
    });
}

}  // namespace dapple
