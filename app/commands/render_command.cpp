// dapple render: its options, and what they come to.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/batch.h"
#include "app/commands/render.h"
#include "app/commands/render_report.h"
#include "app/commands/settings_options.h"
#include "core/drawing/drawing_figures.h"
#include "core/drawing/write_drawing.h"
#include "core/failure.h"
#include "core/text/number_words.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/save_drawing.h"
#include "io/files/separations.h"
#include "io/files/sheet_files.h"
#include "io/settings/project.h"

namespace dapple {

class RenderCommand {
 public:
    explicit RenderCommand(CLI::App& program);

 private:
    void add_input_options(CLI::App& command);
    void add_output_options(CLI::App& command);
    void add_saving_options(CLI::App& command);
    void run(const CLI::App& command);

    RenderOptions options_;
    std::vector<std::filesystem::path> pictures_;  // where there are several
    int jobs_ = 0;
    bool automatic_tone_ = true;  // before the options say another
};

namespace {

// Which options of `dapple render` go together: what no single one of them can see.

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
        "--format", fmt::format("{}, but the name {} means {}; leave one of them out",
                                name_of(*options.format), options.output.string(), name_of(*by_name)));
}

// A part is drawn alone, even of what a project says to save as sheets, and sheets are of the whole page,
// whatever region a project has. Throws CLI::ValidationError if both were asked for.
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

// A pen whose width was given touches the paper once for each dot, or fills one of a given radius by a
// spiral, rather than that a plotter follows a circle around which the pen's line is as wide again. What is
// printed or has pixels looks the same either way.
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

// Throws CLI::ValidationError, "--option why", for options that contradict each other or that would have no
// effect on what is written.
void check_that_fit(const CLI::App& command, const RenderOptions& options) {
    const auto refuse_if = [&](bool wrong, std::initializer_list<const char*> names, const std::string& why) {
        if (wrong) refuse(command, names, why);
    };
    check_format(options);
    const DrawingFormat format = format_of(options);
    const DrawingSettings& drawing = options.drawing;
    const bool to_pipe = is_standard_stream(options.output), several = is_several(drawing.sheets);
    const bool pixels = has_pixels(format), table = is_table(format),
               one_pen = drawing.pens.set == PenSet::one;
    if (options.stats && is_standard_stream(*options.stats) && to_pipe)
        throw CLI::ValidationError("--stats",
                                   "the drawing is written to the standard output already; name a file");
    if (several && to_pipe)
        throw CLI::ValidationError("--sheets", "makes several files; name a file to call them after");
    if (several && reads_standard_input(options))
        throw CLI::ValidationError("--sheets",
                                   "the standard input can be read only once; save the picture as a file");
    refuse_if(!several && command.count("--sheet") == 0, {"--overlap"},
              "applies to sheets only; give --sheets or --sheet too");
    refuse_if(one_pen, {"--registration", "--pen-order", "--pen-ink", "--pen-files"},
              "applies to several pens only; give --pens too");
    const std::string plotted =
        "applies to files for plotting only; " + let_it_end_in(".svg, .pdf, .gcode, .hpgl or .dxf");
    const std::string of_pixels = "applies to a PNG or a TIFF only; " + let_it_end_in(".png or .tif");
    refuse_if(pixels || table, {"--pen-files"}, plotted);
    refuse_if(table, {"--registration"}, plotted);
    refuse_if(pixels && !options.saving.separations, {"--registration"},
              plotted + ", or give --separations too");
    refuse_if(format != DrawingFormat::svg, {"--tiles"}, "only an SVG has layers; " + let_it_end_in(".svg"));
    refuse_if(!pixels, {"--dpi"}, "only a PNG or a TIFF has pixels; " + let_it_end_in(".png or .tif"));
    refuse_if(one_pen, {"--separations"}, "applies to several pens only; give --pens too");
    refuse_if(!pixels, {"--separations"}, of_pixels);
    refuse_if(to_pipe, {"--separations", "--pen-files"},
              "makes several files; name a file to call them after");
    refuse_if(!pixels, {"--bits"}, of_pixels);
    refuse_if(!has_order(format, drawing.style), {"--order"}, "the pixels of a PNG or a TIFF have no order");
    refuse_if(table, {"--style", "--dot-shape", "--pen-width"},
              "a table has no shapes or lines, only dots; leave it out");
    refuse_if(drawing.style != DrawingStyle::dots, {"--dot-shape"},
              "applies to --style dots only; leave it out, or give that style");
    check_finer(command, drawing);
    refuse_if(drawing.style == DrawingStyle::dots && drawing.mark.shape == DotShape::point, {"--dot-radius"},
              "a point is as large as the pen makes it; leave it out, or give another --dot-shape");
    const DotSize& size = drawing.dot_size;
    const double finest = size.sizing == DotSizing::by_tone ? size.smallest_mm : size.radius_mm;
    refuse_if(command.count("--pen-width") > 0 && drawing.mark.shape == DotShape::spiral &&
                  finest < drawing.pen_width_mm / 2 - kSmallestRadiusMm,
              {"--dot-radius"},
              fmt::format("cannot be below {:g} mm with a pen {:g} mm wide; give that or more",
                          drawing.pen_width_mm / 2, drawing.pen_width_mm));
    const bool pen_draws =
        draws_strokes(drawing) ||
        dots_as({.format = format, .settings = drawing, .saving = options.saving}) == DotsAs::touches;
    refuse_if(
        !pen_draws, {"--pen-width"},
        "applies to a plotter's pen, to --style line or nearest, and to a --dot-shape other than circle; "
        "give one of those too");
    refuse_if(!is_plotted(format), {"--machine"},
              "applies to files for plotting only; " + let_it_end_in(".svg, .gcode, .hpgl or .dxf"));
    refuse_if(!has_colours(format), {"--ink", "--paper", "--background"},
              std::string(table ? "a table has" : "a file for machines has") + " no colours; " +
                  let_it_end_in(".svg, .pdf, .png or .tif"));
    refuse_if(has_optional_paper(format) && !drawing.background && one_pen, {"--paper"},
              "shows in an SVG or a PDF with --background only; give that too");
    refuse_if(!one_pen, {"--ink"}, "is one pen's colour, and --pens has its own; leave one of them out");
    refuse_if(format != DrawingFormat::gcode,
              {"--gcode", "--feed", "--dwell", "--acceleration", "--pen-up", "--pen-down", "--laser-power"},
              "applies to G-code only; " + let_it_end_in(".gcode or .nc"));
    if (format == DrawingFormat::gcode)
        told_as(command.count("--pen-down") > 0 ? "--pen-down" : "--pen-up",
                [&] { check_heights(options.saving); });
    const bool given = command.count("--order") > 0 || command.count("--relax") > 0;
    if (given && options.saving.order == DotOrder::priority && drawing.relax.value_or(0) > 0)
        throw CLI::ValidationError(
            "--order",
            "priority: the first dots of a relaxed drawing do not make one with fewer dots; give --relax 0");
}

namespace fs = std::filesystem;

// A picture, or a project that names one and says how it is drawn.
void take_image(RenderOptions& options, const std::filesystem::path& file) {
    if (!ends_as_project(file)) {
        options.image = file;
        return;
    }
    ProjectInput project = read_project_input(file);
    options.image = std::move(project.picture);
    options.drawing = std::move(project.drawing);
    options.saving = project.saving;
}

void check_batch_picture(const std::string& file) {
    if (file == kStandardStream)
        throw CLI::ValidationError("IMAGE", "- cannot be one of several; name only files");
    if (ends_as_project(file)) {
        throw CLI::ValidationError("IMAGE", file +
                                                ": a project cannot be one of several; give pictures, and "
                                                "the project's settings by --settings-from");
    }
}

// A folder for a single picture names its drawing; several need one.
void take_folder(RenderOptions& options, std::size_t pictures) {
    const bool folder = is_output_folder(options.output);
    if (pictures > 1 && !folder) {
        throw CLI::ValidationError(
            "--output", fmt::format("{}: {} pictures need a folder; end its name in /, as in -o {}/",
                                    options.output.string(), pictures, options.output.stem().string()));
    }
    if (!folder) return;
    if (!options.format) options.format = DrawingFormat::svg;
    if (pictures > 1) return;
    if (!options.image || is_standard_stream(*options.image))
        throw CLI::ValidationError("--output", options.output.string() +
                                                   " is a folder, where drawings take their pictures' names, "
                                                   "and this picture has none; name a file");
    make_folder(options.output);
    options.output = output_in(options.output, *options.image, *options.format);
}

constexpr const char* kExamples =
    "\n"
    "Examples:\n"
    "  dapple render cat.jpg -o cat.svg                    40,000 dots on a page 200 mm wide\n"
    "  dapple render cat.jpg -o cat.svg --dots 100000 --width 400\n"
    "  dapple render cat.jpg -o cat.png --dpi 600 --ink '#1d3557'\n"
    "  dapple render cat.jpg -o cat.svg --style line --dots 20k     one line through all dots\n"
    "  dapple render cat.jpg -o cat.svg --dot-shape spiral --pen-width 0.3   dots that a pen fills\n"
    "  dapple render cat.jpg -o cat.svg --page a4 --margin 15     on A4, with a border for the pen\n"
    "  dapple render cat.jpg -o cat.svg --page a4 --pens cmyk:0.3   a layer for each of four pens\n"
    "  dapple render cat.jpg -o cat.svg --page 8.5x11in --fit fill --margin 0.5in\n"
    "  dapple render cat.jpg -o part.svg --width 2000 --sheet 2,1/3x4   one sheet of a mural\n"
    "  dapple render cat.jpg -o mural.pdf --width 1000 --sheets 4x4 --overlap 10   all sheets, and a plan\n"
    "  dapple render cat.jpg -o eye.svg --region 60,40,80x50   a detail, to try pen and paper\n"
    "  dapple render cat.jpg -o cat.csv --stats cat.json   the dots as numbers, and figures about them\n"
    "  dapple render cat.jpg -o cat.gcode --gcode laser --feed 6000 --dwell 0.02\n"
    "  convert cat.jpg -resize 50% png:- | dapple render - -o - --format pdf > cat.pdf\n"
    "  dapple render *.jpg -o drawings/ --format pdf       a drawing of each\n"
    "  dapple render cat.dapple -o cat.png --dpi 600       a project that the window saved\n"
    "  dapple render dog.jpg -o dog.svg --settings-from cat.svg   as cat.svg was drawn\n"
    "  dapple render -o sample.svg --invert --ink '#fff' --paper '#000' --background";

void add_drawing(const RenderOptions& options, const fs::path& output, std::vector<FileInUse>& written) {
    const PenChoice& choice = options.drawing.pens;
    Palette pens;
    if (choice.set != PenSet::automatic) pens = palette_of(choice);
    sort_pens(pens, choice.order);
    std::vector<fs::path> files = is_several(options.drawing.sheets)
                                      ? files_of(output, options.drawing.sheets, options.saving, pens)
                                      : files_of(output, format_of(options), options.saving, pens);
    for (fs::path& file : files)
        written.push_back({std::move(file), files.size() > 1 ? "a part of the drawing" : "the drawing"});
}

// None of the drawings, their sheets, the pens' own files and the figures may be written over what is read,
// or over each other. Files of pens that are chosen from a picture are not known yet: what they must not be
// written over is left in options.read.
void check_files_apart(const CLI::App& command, RenderOptions& options, std::span<const fs::path> pictures) {
    // A drawing may take the place of the one that its settings are from, but the figures may not.
    options.read = files_read(command, {"--output", "--stats", "--settings-from"});
    if (options.image) options.read.push_back({*options.image, "the picture"});
    options.read.push_back({options.drawing.tile, "the tile"});
    std::vector<FileInUse> written;
    for (const fs::path& picture : pictures)
        add_drawing(options, output_in(options.output, picture, format_of(options)), written);
    if (pictures.empty() && !is_standard_stream(options.output))
        add_drawing(options, options.output, written);
    const bool figures = options.stats && !is_standard_stream(*options.stats);
    if (figures) written.push_back({*options.stats, "the figures"});
    check_apart(written, options.read);
    if (figures && command.count("--settings-from") > 0)
        check_apart({written.back()}, {{command["--settings-from"]->as<std::string>(), "the settings"}});
}

// The share of this process among those that Open MPI, Slurm or a starter with PMI has begun.
WorkShare share_of_rank() {
    constexpr std::array kStarters{
        std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
        std::pair{"PMI_RANK", "PMI_SIZE"},
        std::pair{"SLURM_PROCID", "SLURM_NTASKS"},
    };
    for (const auto& [rank_name, size_name] : kStarters) {
        const char* const rank_text = std::getenv(rank_name);
        const char* const size_text = std::getenv(size_name);
        if (!rank_text || !size_text) continue;
        const auto rank = number_of<std::size_t>(rank_text), size = number_of<std::size_t>(size_text);
        if (!rank || !size || *rank >= *size)
            throw failure("auto: {}={} and {}={} give no rank among several", rank_name, rank_text, size_name,
                          size_text);
        return {*rank, *size};
    }
    throw std::runtime_error("auto applies to runs started by mpirun or srun only; give a share such as 1/4");
}

}  // namespace

RenderCommand::RenderCommand(CLI::App& program) {
    CLI::App* const command =
        program.add_subcommand("render",
                               "Stipple a picture into a file: SVG, G-code, HPGL and DXF for plotters and "
                               "lasers, PDF, PNG and TIFF for print, CSV and JSON as tables");
    add_input_options(*command);  // taken before the other options, which say otherwise
    add_output_options(*command);
    add_dot_options(*command, options_.drawing);
    add_style_options(*command, options_.drawing);
    add_tone_options(*command, options_.drawing);
    add_mask_options(*command, options_.drawing.mask, options_.limit);
    add_page_options(*command, options_.drawing);
    add_saving_options(*command);
    command->footer(std::string(gcode_help()) + kExamples);
    command->callback([this, command] { run(*command); });
}

void RenderCommand::add_input_options(CLI::App& command) {
    const auto read_image = [this](const std::vector<std::string>& files) {
        if (files.size() > 1) {
            for (const std::string& file : files) check_batch_picture(file);
            pictures_.assign(files.begin(), files.end());
            return;
        }
        take_image(options_, files.front());
        automatic_tone_ = options_.drawing.automatic_tone;
    };
    command
        .add_option_function<std::vector<std::string>>(
            "image", read_image,
            "The picture, - for the standard input, or a project (.dapple) saved by the window, whose "
            "settings the other options change; without one, the built-in sample. Several pictures become a "
            "drawing each in a folder")
        ->type_name("IMAGE");
    add_settings_options(command, options_.drawing, [this](const SavedSettings& settings) {
        options_.drawing = settings.drawing;
        options_.saving = settings.saving;
        automatic_tone_ = settings.drawing.automatic_tone;
    });
}

void RenderCommand::add_output_options(CLI::App& command) {
    command
        .add_option("-o,--output", options_.output,
                    "The drawing; its name ends in " + drawing_endings() +
                        ". - for the standard output. A folder, existing or ending in /: drawings named "
                        "after their pictures, in --format")
        ->type_name("OUT")
        ->required();
    add_choice(command, "--format", options_.format, "The format if no file name gives it; without it, SVG");
    add_whole_number(command, "--jobs", jobs_, {.least = 0, .most = 256},
                     "How many of several pictures to draw at a time; 0: one for every two cores, at most 4");
    add_text(
        command, "--share", "R/N|auto",
        [this](const std::string& text) {
            if (text == "auto") return void(options_.share = share_of_rank());
            const auto share = numbers_of<std::size_t, 2>(text, "/");
            if (!share || (*share)[0] < 1 || (*share)[0] > (*share)[1])
                throw std::runtime_error(text + " is not a share; give one such as 1/4, the first of four");
            options_.share = {(*share)[0] - 1, (*share)[1]};
        },
        "Draws only every N-th of several pictures or sheets, from the R-th on, so that N runs share the "
        "work; auto: the share of this run's rank under mpirun or srun");
    command
        .add_option("--stats", options_.stats,
                    "Saves figures about the drawing, as JSON; - for the standard output")
        ->type_name("FILE");
    command.add_flag("--advice", options_.advice,
                     "Also prints what to know before printing or plotting, as --machine and files for "
                     "plotters do");
    command.add_flag_callback(
        "--huge", [this] { options_.limit = PictureLimit::huge; }, "Also reads pictures over 400 megapixels");
    add_memory(command, options_.memory);
}

void RenderCommand::add_saving_options(CLI::App& command) {
    add_number(command, setting::dpi, options_.saving.dpi)->group("Page");
    const auto read_bits = [this](const std::string& text) {
        if (text != "8" && text != "16") throw std::runtime_error(text + " is not possible; give 8 or 16");
        options_.saving.bits = text == "8" ? 8 : 16;
    };
    add_text(command, setting::bits.names.option, unit_of(setting::bits), read_bits, help_of(setting::bits))
        ->default_str("8")
        ->group("Page");
    add_flag(command, setting::separations, options_.saving.separations)->group("Page");
    add_flag(command, setting::pen_files, options_.saving.pen_files)->group("Page");
    add_flag(command, setting::background, options_.drawing.background)->group("Page");
    add_flag(command, setting::show_tiles, options_.drawing.show_tiles)->group("Page");
    add_flag(command, setting::registration, options_.drawing.registration)->group("Page");
    add_choice(command, setting::machine, options_.saving.machine)->group("Page");
    add_arrangement_options(command, options_.saving.order, options_.sheet, options_.saving.region);
    add_mural_options(command, options_.drawing.sheets);
    add_gcode_options(command, options_.saving);
}

void RenderCommand::run(const CLI::App& command) {
    check_options(command, options_.drawing, automatic_tone_);
    take_folder(options_, pictures_.size());
    take_usual_shape(command, options_);
    if (pictures_.size() < 2) refuse(command, {"--jobs"}, "applies to several pictures only; leave it out");
    if (command.count("--share") > 0) {
        if (pictures_.size() < 2 && !is_several(options_.drawing.sheets))
            refuse(command, {"--share"},
                   "applies to several pictures or the sheets of a mural only; leave it out");
        refuse(command, {"--stats"},
               "would be written by each of the runs that share the work; leave it out");
    }
    take_part(command, options_);
    check_that_fit(command, options_);
    if (!pictures_.empty() && is_several(options_.drawing.sheets))
        throw CLI::ValidationError("--sheets",
                                   "applies to one picture only; draw the others' sheets one by one");
    check_names_differ(pictures_, options_.output, format_of(options_));
    check_files_apart(command, options_, pictures_);
    if (pictures_.empty()) {
        if (is_several(options_.drawing.sheets))
            render_mural(options_);
        else
            render(options_);
        return;
    }
    std::vector<std::filesystem::path> shared;
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        if (options_.share.has(i)) shared.push_back(pictures_[i]);
    if (shared.empty()) return tell_of_no_share(options_.share, pictures_.size(), "pictures");
    const BatchResult result = render_batch(options_, shared, jobs_);
    const std::string summary = batch_summary(result, options_.output);
    fmt::print(stderr, "{}\n", summary);
    if (!result.failures.empty())
        throw failure("{} of {} pictures failed", result.failures.size(), shared.size());
}

Command add_render_command(CLI::App& program) {
    return std::make_shared<RenderCommand>(program);
}

}  // namespace dapple
