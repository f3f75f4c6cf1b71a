// dapple record: a film of how a drawing comes about.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/settings_options.h"
#include "core/drawing/settings.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/tile_library.h"
#include "io/film/film.h"
#include "io/progress_line.h"
#include "io/settings/project.h"

namespace dapple {

namespace {

struct RecordOptions {
    std::optional<std::filesystem::path> image;  // none: the built-in sample
    std::filesystem::path output;                // see check_film_path()
    DrawingSettings drawing;
    FilmChoice film;
    std::optional<Rectangle<double>> region;  // of the settings, which are for drawings
    PictureLimit limit = PictureLimit::usual;
    bool automatic_tone = true;  // before the options say another
};

void show_picture(Pipeline& pipeline, const RecordOptions& options) {
    const PictureColours colours =
        options.drawing.pens.set == PenSet::one ? PictureColours::left_out : PictureColours::kept;
    set_picture(pipeline, options.image ? read_with_remark(*options.image, PictureLimit::usual, colours)
                                        : sample_picture(colours));
}

// Throws std::runtime_error with one sentence naming the file that is wrong; what was at the output's place
// stays then.
void record(const RecordOptions& options) {
    check_film_path(options.output);
    const DrawingSettings settings = film_settings(options.drawing, options.film.kind);
    Pipeline pipeline;
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    show_picture(pipeline, options);
    ProgressLine line;
    const FilmFrame frame = film_frames(
        pipeline, settings, options.film,
        {.stop = {}, .progress = [&](double share) { line.show(share, "finding the pen's route"); }});
    line.restart(0);
    const std::string what = fmt::format("drawing {} pictures", frames_of(options.film));
    save_film(options.output, frame, options.film,
              {.stop = {}, .progress = [&](double share) { line.show(share, what); }});
}

void take(RecordOptions& options, const SavedSettings& settings) {
    const SavingChoice& saving = settings.saving;
    options.drawing = settings.drawing;
    // As the window plays it.
    options.film.machine = saving.machine.value_or(usual_machine(DrawingFormat::svg, saving.tool));
    options.film.order = saving.order;
    options.region = saving.region;
    options.automatic_tone = settings.drawing.automatic_tone;
}

}  // namespace

Command add_record_command(CLI::App& program) {
    const auto kept = std::make_shared<RecordOptions>();
    RecordOptions& options = *kept;
    CLI::App* const command = program.add_subcommand(
        "record", "Film how a drawing grows: dot by dot, level by level, by zooming in, or as it is plotted");
    const auto read_image = [&options](const std::string& file) {
        if (!ends_as_project(file)) {
            options.image = file;
            return;
        }
        const ProjectInput project = read_project_input(file);
        options.image = project.picture;
        take(options, {project.drawing, project.saving});
    };
    // First, so that it is taken before the other options, which say otherwise.
    command
        ->add_option_function<std::string>(
            "image", read_image,
            "The picture, or a project (.dapple) saved by the window; without one, the built-in sample")
        ->type_name("IMAGE");
    add_settings_options(*command, options.drawing,
                         [&options](const SavedSettings& settings) { take(options, settings); });
    command
        ->add_option("-o,--output", options.output,
                     "The film: a name ending in .webp, which web browsers play; or a folder, existing or "
                     "ending in /, for numbered PNG files")
        ->type_name("OUT")
        ->required();
    add_choice(
        *command, "--show", options.film.kind,
        "growth: from a few dots to all. levels: one level of tiles after another, each in its colour. zoom: "
        "into the middle, with ever more dots. plot: stroke by stroke, as a machine draws it");
    add_number(*command, "--seconds", options.film.seconds, {.least = kShortestFilm, .most = kLongestFilm},
               "S", "Length of the film");
    add_whole_number(*command, "--fps", options.film.frames_per_second, {.least = 1, .most = 60},
                     "Frames per second");
    add_whole_number(*command, "--size", options.film.longer_side, {.least = 16, .most = 4096},
                     "Pixels along the longer side");
    add_number(*command, "--depth", options.film.depth, {.least = 1, .most = kDeepestFilm}, "TIMES",
               "zoom: magnification at the end");
    add_choice(*command, "--machine", options.film.machine, "plot: the machine to show");
    add_choice(*command, "--order", options.film.order,
               "plot: the order of the dots, as for `dapple render`; without it, the one for SVG");
    add_dot_options(*command, options.drawing);
    add_style_options(*command, options.drawing);
    add_tone_options(*command, options.drawing);
    add_mask_options(*command, options.drawing.mask, options.limit);
    add_page_options(*command, options.drawing);
    command->footer(
        "Films other than plot show dots as placed: round, in one ink, not relaxed, and at most 2,000,000; "
        "those of growth relax at the end.\n"
        "To make a video of numbered files, with even sides for players, for example with --fps 25:\n"
        "  ffmpeg -framerate 25 -i frames/frame-%04d.png -vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2' -pix_fmt "
        "yuv420p film.mp4\n\n"
        "Examples:\n"
        "  dapple record cat.jpg -o cat.webp                       from a few dots to 40,000\n"
        "  dapple record cat.jpg -o zoom.webp --show zoom --depth 1000 --seconds 12\n"
        "  dapple record cat.jpg -o levels.webp --show levels --tile paper16\n"
        "  dapple record cat.jpg -o plot/ --show plot --style line --dots 5000 --fps 30");
    command->callback([&options, command] {
        check_options(*command, options.drawing, options.automatic_tone);
        const FilmKind kind = options.film.kind;
        if (kind != FilmKind::zoom)
            refuse(*command, {"--depth"}, "applies to a zoom only; give --show zoom too");
        if (kind != FilmKind::plot)
            refuse(*command,
                   {"--machine", "--order", "--style", "--dot-shape", "--pen-width", "--pens", "--placer"},
                   "applies to the film of a plot only; give --show plot too");
        if (kind != FilmKind::plot && kind != FilmKind::growth)
            refuse(*command, {"--relax", "--finer"},
                   "applies to the films of growth and of a plot only; leave it out");
        check_finer(*command, film_settings(options.drawing, kind));
        std::vector<FileInUse> written;
        for (const std::filesystem::path& file : files_of(options.output, options.film))
            written.push_back({file, "the film"});
        std::vector<FileInUse> read{{options.drawing.tile, "the tile"}};
        if (options.image) read.push_back({*options.image, "the picture"});
        check_apart(*command, {"--output"}, written, read);
        if (options.region)
            fmt::print(stderr, "the film shows the whole page, not just {}, the region that is saved\n",
                       text_of_region(*options.region));
        record(options);
    });
    return kept;
}

}  // namespace dapple
