// dapple-lab analyse: how even a set of points is, and whether it repeats.

#include "lab/commands/commands.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/analysis/domain.h"
#include "core/analysis/periodogram.h"
#include "core/analysis/report.h"
#include "core/drawing/settings.h"
#include "core/text/number_words.h"
#include "io/available_memory.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/text_file.h"
#include "io/settings/project.h"
#include "lab/analysis/report_json.h"
#include "lab/analysis/report_page.h"
#include "lab/analysis/subject.h"
#include "lab/related/methods.h"

namespace dapple {

struct AnalyseOptions {
    std::optional<std::filesystem::path> input;  // a table (.csv, .tsv, .txt), a drawing of ours (.json,
                                                 // .svg) or a picture; none: a constant grey
    std::filesystem::path output;                // .json, .html or .png
    DrawingSettings drawing;                     // of a picture or a grey
    double grey = 1;                             // its density
    std::optional<std::string> method{};  // of a grey: whose dots, of related_methods(); none: this program's
    std::uint64_t seed = 1;               // of the method
    std::optional<Topology> topology;     // none: window, but torus for a grey
    std::optional<double> width, height;  // of a table's domain; the width in mm of a picture's page
    std::optional<double> period;         // of a table, in its unit
    PictureLimit limit = PictureLimit::usual;
    std::optional<double> memory;  // bytes that it may take; none: what is available
};

class AnalyseCommand {
 public:
    explicit AnalyseCommand(CLI::App& program);

 private:
    AnalyseOptions options_;
};

namespace {

namespace fs = std::filesystem;

constexpr double kMemoryOfDot = 400;  // bytes, measured

bool is_table(const fs::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".csv" || ending == ".tsv" || ending == ".txt";
}

// A drawing of ours, which has its page's size in it.
bool is_drawing(const fs::path& path) {
    const std::string ending = ending_of(path);
    return ending == ".json" || ending == ".svg";
}

bool has_points(const fs::path& path) {
    return is_table(path) || is_drawing(path);
}

enum class ReportFormat { json, html, png };

ReportFormat report_format(const fs::path& path) {
    const std::string ending = ending_of(path);
    if (ending == ".json") return ReportFormat::json;
    if (ending == ".html" || ending == ".xhtml") return ReportFormat::html;
    if (ending == ".png") return ReportFormat::png;
    throw std::runtime_error(fmt::format("{}: does not end in .json, .html or .png", path.string()));
}

// Projects, and drawings that do not keep their dots as such.
void check_has_dots(const fs::path& path) {
    if (ends_as_project(path))
        throw std::runtime_error(
            fmt::format("{0}: a project is neither points nor a picture; draw it with dapple render {0} -o "
                        "{1} and analyse that",
                        path.string(), fs::path(path).replace_extension(".svg").string()));
    const std::string ending = ending_of(path);
    if (ending.empty()) return;
    for (const DrawingFormatName& format : kDrawingFormats) {
        if (ending != format.ending && ending != format.others) continue;
        if (has_pixels(format.format) || is_drawing(path) || is_table(path)) continue;
        throw std::runtime_error(
            fmt::format("{}: the dots of {} files cannot be read; give points (.csv, .tsv, .txt), a drawing "
                        "by dapple render (.json, .svg), or a picture",
                        path.string(), format.shown));
    }
}

const RelatedMethod& method_of(const std::string& name) {
    if (const RelatedMethod* const method = related_method(name)) return *method;
    std::string known;
    for (const RelatedMethod& one : related_methods())
        known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw std::runtime_error(fmt::format("--method: {} is not known; there are {}", name, known));
}

// As many as a tile would be drawn with: 16 to a unit of scale where the density is 1.
std::size_t dots_asked_for(const AnalyseOptions& options) {
    const PlacingRequest& placing = options.drawing.placing;
    return placing.count ? *placing.count : std::size_t(std::lround(16 * placing.scale * options.grey));
}

Subject subject_of(const AnalyseOptions& options) {
    const Topology cut_out = options.topology.value_or(Topology::window);
    if (options.method)
        return dots_of_method(method_of(*options.method), dots_asked_for(options), options.seed,
                              options.topology.value_or(Topology::torus));
    if (!options.input) {
        // As placed, the tile goes on beyond the edges; relaxed dots have nothing beyond them.
        return dots_of_grey(options.grey, options.drawing,
                            options.topology.value_or(
                                options.drawing.relax.value_or(0) > 0 ? Topology::window : Topology::torus));
    }
    if (is_table(*options.input)) {
        return points_of_table(*options.input, {.width = options.width,
                                                .height = options.height,
                                                .topology = cut_out,
                                                .period = options.period});
    }
    if (is_drawing(*options.input)) return points_of_drawing(*options.input, cut_out);
    check_has_dots(*options.input);
    if (options.width && (*options.width < kShortestSideMm || *options.width > kLongestSideMm))
        throw std::runtime_error(
            fmt::format("--width: {:g} is not possible of a picture; give millimetres from {:g} to {:g}",
                        *options.width, kShortestSideMm, kLongestSideMm));
    DrawingSettings drawing = options.drawing;
    if (options.width) drawing.page.width_mm = *options.width;
    return dots_of_picture(options.input, drawing, cut_out, options.limit);
}

std::string report_text(ReportFormat format, const Subject& subject, const PointReport& report) {
    switch (format) {
        case ReportFormat::json:
            return report_json(subject, report);
        case ReportFormat::html:
            return report_page(subject, report);
        case ReportFormat::png:
            return png_of(spectrum_picture(report.spectrum));
    }
    throw std::logic_error("no such format");
}

// Options that say nothing about what is analysed are refused, rather than left without effect.
void check_that_fit(const CLI::App& command, const AnalyseOptions& options) {
    const std::initializer_list<const char*> tone{
        "--exposure", "--tone", "--black-point", "--white-point", "--contrast", "--brightness",
        "--gamma",    "--blur", "--detail",      "--black",       "--invert"};
    if (!options.input) refuse(command, tone, "applies to pictures only; use --density for a constant grey");
    if (options.input)
        refuse(command, {"--method"}, "is for a constant grey; dapple-lab compare draws pictures with it");
    if (!options.method) refuse(command, {"--seed"}, "is for a --method");
    if (options.method)
        refuse(command, {"--tile", "--ranking", "--placer", "--relax"},
               "is for this program's own dots; a --method has its own");
    if (options.input && has_points(*options.input)) {
        refuse(command, tone, "is for pictures, and points have none");
        if (is_drawing(*options.input))
            refuse(command, {"--width", "--height"}, "follows from the drawing itself; leave it out");
        refuse(
            command,
            {"--density", "--dots", "--scale", "--tile", "--ranking", "--placer", "--dot-radius", "--relax"},
            "does not apply to dots that are placed already; leave it out");
        refuse(command, {"--huge"}, "is for pictures");
        if (is_drawing(*options.input)) refuse(command, {"--period"}, "is for tables");
        if (options.width.has_value() != options.height.has_value())
            throw CLI::ValidationError(options.width ? "--width" : "--height",
                                       "give both --width and --height, or neither");
        return;
    }
    refuse(command, {"--period"}, "is for tables; this program knows the period of its own tiles");
    if (options.input) refuse(command, {"--density"}, "is for a constant grey; a picture has its own");
    if (options.input) refuse(command, {"--height"}, "follows from the picture");
    if (!options.input) refuse(command, {"--huge"}, "is for pictures, and none is given");
    if (!options.input && options.drawing.dot_size.sizing == DotSizing::fixed)
        refuse(command, {"--dot-radius"}, "a constant grey has no size in millimetres; leave it out");
    if (!options.input) refuse(command, {"--width", "--height"}, "a constant grey fills a square of side 1");
}

}  // namespace

// Reads, analyses and saves. Throws std::runtime_error with one sentence; what was at the output's place
// stays then.
void analyse(const AnalyseOptions& options) {
    const ReportFormat format = report_format(options.output);
    check_can_save(options.output);
    if (!options.input || !has_points(*options.input)) {
        const auto dots = static_cast<double>(dots_asked_for(options));
        check_memory(dots * kMemoryOfDot, fmt::format("analysing {} dots", about(dots)), options.memory);
    }
    const Subject subject = subject_of(options);
    if (subject.points.empty()) {
        throw std::runtime_error(subject.name + ": no dots at this scale; give a higher --scale");
    }
    const auto report =
        analyse(subject.points, subject.domain, {.name = subject.name, .period = subject.period});
    const std::string text = report_text(format, subject, *report);
    save_atomically(options.output, [&](std::ostream& out) {
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    });
}

AnalyseCommand::AnalyseCommand(CLI::App& program) {
    options_.drawing.automatic_tone = false;  // tone is measured against the picture's own light
    CLI::App* const command = program.add_subcommand(
        "analyse", "Measure how even points are and whether they repeat, into a JSON, HTML or PNG file");
    command
        ->add_option("input", options_.input,
                     "Points (.csv, .tsv, .txt: columns x_mm and y_mm, x and y, or the first two), a drawing "
                     "by dapple render (.json, .csv, .svg of dots: with its page's size), or a picture to "
                     "stipple, which may be a drawing saved as pixels; without it, a constant grey")
        ->type_name("POINTS|DRAWING|IMAGE");
    command
        ->add_option("-o,--output", options_.output,
                     "The report: .json the numbers, .html a page with pictures and plots, .png the spectrum")
        ->type_name("OUT")
        ->required();
    add_number(*command, "--density", options_.grey,
               {.least = 0, .most = 1, .at_least = NumberRange::Least::excluded}, "0..1",
               "Ink of the constant grey: with --scale, 16 S times this many dots");
    command
        ->add_option("--method", options_.method,
                     "A constant grey drawn by another method, one that dapple-lab compare measures")
        ->type_name("NAME");
    add_seed(*command, options_.seed, "The seed for a --method that draws random numbers");
    add_choice(
        *command, "--topology", options_.topology,
        "torus: opposite edges meet; window: nothing is known beyond them. Without it, torus for a constant "
        "grey without --relax, otherwise window. A constant grey is relaxed only if --relax is given");
    const NumberRange length{.least = 0, .most = 1e9, .at_least = NumberRange::Least::excluded};
    add_number(
        *command, "--width", options_.width, length, "LENGTH",
        "Width of the points' area, from (0, 0), in their unit; without it, that of the page in a table by "
        "dapple render, or of the points. For a picture, the page's width in mm, 200 without it");
    add_number(*command, "--height", options_.height, length, "LENGTH", "Height of the points' area");
    add_number(*command, "--period", options_.period, length, "LENGTH",
               "Tests whether the points repeat at multiples of this length");
    command->add_flag_callback(
        "--huge", [this] { options_.limit = PictureLimit::huge; }, "Also reads pictures over 400 megapixels");
    add_memory(*command, options_.memory);
    add_dot_options(*command, options_.drawing);
    add_tone_options(*command, options_.drawing);
    command->footer(
        "Tone is measured against the picture's own light: what the tone options change counts as an "
        "error.\n\n"
        "Examples:\n"
        "  dapple-lab analyse --tile paper16 --dots 40000 -o paper.html       a page to look at\n"
        "  dapple-lab analyse --placer figure8 --scale 2500 -o spectrum.png   the paper's own, its spectrum\n"
        "  dapple-lab analyse cat.jpg -o cat.json                             a drawing's tone and evenness\n"
        "  dapple-lab analyse cat.svg -o cat.html                             the same of dots that are "
        "there\n"
        "  dapple-lab analyse --method lloyd --dots 10000 -o lloyd.html       dots by another method\n"
        "  dapple-lab analyse points.csv --width 1 --height 1 --topology torus -o points.json");
    command->callback([this, command] {
        check_options(*command, options_.drawing);
        check_that_fit(*command, options_);
        static_cast<void>(report_format(options_.output));  // that its name says none is told first
        check_apart(*command, {"--output"}, {{options_.output, "the report"}});
        analyse(options_);
    });
}

Command add_analyse_command(CLI::App& program) {
    return std::make_shared<AnalyseCommand>(program);
}

}  // namespace dapple
