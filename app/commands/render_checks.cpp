#include "app/commands/render_checks.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "app/commands/batch.h"
#include "app/commands/settings_options.h"
#include "core/drawing/drawing_figures.h"
#include "core/drawing/gcode_choice.h"
#include "io/command_line/options.h"
#include "io/files/save_drawing.h"

namespace dapple {
namespace {

// "let the drawing's name end in .png or .tif"
std::string let_it_end_in(const char* endings) {
    return fmt::format("let the drawing's name end in {}", endings);
}

void check_format(const RenderOptions& options) {
    if (is_output_folder(options.output)) return;
    if (is_standard_stream(options.output)) {
        if (options.format == DrawingFormat::tiff)
            throw CLI::ValidationError("--format",
                                       "TIFF cannot go to a pipe; name a file, or use --format png");
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
        "--format", fmt::format("{}, but the name {} says {}; leave one of them out",
                                name_of(*options.format), options.output.string(), name_of(*by_name)));
}

}  // namespace

void take_part(const CLI::App& command, RenderOptions& options) {
    Sheet& sheets = options.drawing.sheets;
    std::optional<Rectangle<double>>& region = options.saving.region;
    const bool one_sheet = command.count("--sheet") > 0;
    const bool one_region = region && command.count("--region") > 0;
    if (one_region && one_sheet)
        throw CLI::ValidationError("--region", "cannot be given together with --sheet");
    if (command.count("--sheets") > 0) {
        const char* const why = "is a part of what --sheets draws; leave one of them out";
        refuse(command, {"--sheet"}, why);
        if (one_region) refuse(command, {"--region"}, why);
    }
    if (one_sheet) options.sheet.overlap_mm = sheets.overlap_mm;
    if (one_sheet || one_region || !is_several(sheets)) sheets = {};
    if (one_sheet || is_several(sheets)) region.reset();
}

void take_usual_shape(const CLI::App& command, RenderOptions& options) {
    DrawingSettings& drawing = options.drawing;
    if (draws_strokes(drawing) || command.count("--dot-shape") > 0 || !is_plotted(format_of(options))) return;
    const bool pen = command.count("--pen-width") > 0;
    const bool pens = command.count("--pens") > 0 && have_widths(drawing.pens);
    if (drawing.dot_size.sizing == DotSizing::automatic) {
        if (pen || pens) drawing.mark.shape = DotShape::point;
    } else if (pen) {
        drawing.mark.shape = DotShape::spiral;
    }
}

void check_that_fit(const CLI::App& command, const RenderOptions& options) {
    check_format(options);
    const DrawingFormat format = format_of(options);
    if (options.stats && is_standard_stream(*options.stats) && is_standard_stream(options.output))
        throw CLI::ValidationError("--stats", "the drawing goes to the standard output already; name a file");
    if (is_several(options.drawing.sheets)) {
        if (is_standard_stream(options.output))
            throw CLI::ValidationError("--sheets", "makes several files; name a file to call them after");
        if (reads_standard_input(options))
            throw CLI::ValidationError(
                "--sheets", "the standard input can be read once only; save the picture as a file");
    } else if (command.count("--sheet") == 0)
        refuse(command, {"--overlap"}, "applies to sheets only; give --sheets or --sheet too");
    if (options.drawing.pens.set == PenSet::one)
        refuse(command, {"--registration", "--pen-order", "--pen-ink", "--pen-files"},
               "is for several pens; give --pens too");
    if (has_pixels(format) || is_table(format)) {
        const std::string plotted =
            "applies to files for plotting only; " + let_it_end_in(".svg, .pdf, .gcode, .hpgl or .dxf");
        refuse(command, {"--pen-files"}, plotted);
        if (!has_pixels(format)) refuse(command, {"--registration"}, plotted);
        if (!options.saving.separations)
            refuse(command, {"--registration"}, plotted + ", or give --separations too");
    }
    if (format != DrawingFormat::svg)
        refuse(command, {"--tiles"}, "only an SVG has layers; " + let_it_end_in(".svg"));
    if (!has_pixels(format))
        refuse(command, {"--dpi"}, "only a PNG or a TIFF has pixels; " + let_it_end_in(".png or .tif"));
    if (options.drawing.pens.set == PenSet::one)
        refuse(command, {"--separations"}, "is for several pens; give --pens too");
    if (!has_pixels(format))
        refuse(command, {"--separations"},
               "applies to a PNG or a TIFF only; " + let_it_end_in(".png or .tif"));
    if (is_standard_stream(options.output))
        refuse(command, {"--separations", "--pen-files"},
               "makes several files; name a file to call them after");
    if (!has_pixels(format))
        refuse(command, {"--bits"}, "applies to a PNG or a TIFF only; " + let_it_end_in(".png or .tif"));
    const DrawingSettings& drawing = options.drawing;
    if (!has_order(format, drawing.style))
        refuse(command, {"--order"}, "the pixels of a PNG or a TIFF have no order");
    if (is_table(format))
        refuse(command, {"--style", "--dot-shape", "--pen-width"},
               "a table has no shapes or lines, only dots; leave it out");
    if (drawing.style != DrawingStyle::dots)
        refuse(command, {"--dot-shape"}, "applies to --style dots only; leave it out, or give that style");
    check_finer(command, drawing);
    if (drawing.style == DrawingStyle::dots && drawing.mark.shape == DotShape::point)
        refuse(command, {"--dot-radius"},
               "a point is as large as the pen makes it; leave it out, or give another --dot-shape");
    const DotSize& size = drawing.dot_size;
    const double finest = size.sizing == DotSizing::by_tone ? size.smallest_mm : size.radius_mm;
    if (command.count("--pen-width") > 0 && drawing.mark.shape == DotShape::spiral &&
        finest < drawing.pen_width_mm / 2 - kSmallestRadiusMm)
        refuse(command, {"--dot-radius"},
               fmt::format("cannot be below {:g} mm with a pen {:g} mm wide; give that or more",
                           drawing.pen_width_mm / 2, drawing.pen_width_mm));
    const bool pen_draws =
        draws_strokes(drawing) || dots_as(drawing, options.saving, format) == DotsAs::touches;
    if (!pen_draws)
        refuse(command, {"--pen-width"},
               "applies to a plotter's pen, to --style line or nearest, and to a --dot-shape other than "
               "circle; give one of those too");
    if (!is_plotted(format))
        refuse(command, {"--machine"},
               "applies to files for plotting only; " + let_it_end_in(".svg, .gcode, .hpgl or .dxf"));
    if (!has_colours(format)) {
        const std::string what = is_table(format) ? "a table has" : "a file for machines has";
        refuse(command, {"--ink", "--paper", "--background"},
               what + " no colours; " + let_it_end_in(".svg, .pdf, .png or .tif"));
    }
    if (has_optional_paper(format) && !options.drawing.background && options.drawing.pens.set == PenSet::one)
        refuse(command, {"--paper"}, "shows in an SVG or a PDF with --background only; give that too");
    if (options.drawing.pens.set != PenSet::one)
        refuse(command, {"--ink"}, "is one pen's colour, and --pens has its own; leave one of them out");
    if (format != DrawingFormat::gcode)
        refuse(command,
               {"--gcode", "--feed", "--dwell", "--acceleration", "--pen-up", "--pen-down", "--laser-power"},
               "applies to G-code only; " + let_it_end_in(".gcode or .nc"));
    if (format == DrawingFormat::gcode) {
        try {
            check_heights(options.saving);
        } catch (const std::runtime_error& error) {
            throw CLI::ValidationError(command.count("--pen-down") > 0 ? "--pen-down" : "--pen-up",
                                       error.what());
        }
    }
    const bool given = command.count("--order") > 0 || command.count("--relax") > 0;
    if (given && options.saving.order == DotOrder::priority && options.drawing.relax.value_or(0) > 0) {
        throw CLI::ValidationError(
            "--order",
            "priority: the first dots of a relaxed drawing do not make one with fewer dots; give --relax 0");
    }
}

}  // namespace dapple
