// dapple-lab compare: this program and the methods that came before it, measured alike.

#include "lab/commands/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/image/tone.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/text_file.h"
#include "io/progress_line.h"
#include "io/signals.h"
#include "lab/analysis/report_page.h"
#include "lab/compare/compare_report.h"
#include "lab/compare/contenders.h"
#include "lab/compare/icons.h"
#include "lab/compare/measure.h"

namespace dapple {

struct CompareOptions {
    std::vector<std::filesystem::path> pictures;  // none: the built-in still life
    bool icons = false;                           // these too
    std::vector<std::string> methods;             // by name; none: all
    std::vector<std::size_t> dots{65'536};
    std::size_t picture_dots = 10'000;
    std::size_t most = 10'000'000;  // dots up to which time is measured
    double seconds = 20;            // for one drawing
    std::uint64_t seed = 1;
    std::optional<std::filesystem::path> json, page;
};

class CompareCommand {
 public:
    explicit CompareCommand(CLI::App& program);

 private:
    CompareOptions options_;
};

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCompared = 100'000'000;  // each dot as two doubles, and its spectrum
constexpr std::size_t kMostMeasured = 4'000'000;    // points of a spectrum
constexpr int kPictureWidth = 480;                  // px

// As large as it is shown.
std::string png_of_light(const Grid<float>& light) {
    Grid<float> small = light;
    while (small.width / 2 >= kPictureWidth) {
        Grid<float> half(small.width / 2, std::max(1, small.height / 2));
        for (int y = 0; y < half.height; ++y) {
            for (int x = 0; x < half.width; ++x) {
                const int below = std::min(2 * y + 1, small.height - 1);
                half.at(x, y) = (small.at(2 * x, 2 * y) + small.at(2 * x + 1, 2 * y) +
                                 small.at(2 * x, below) + small.at(2 * x + 1, below)) /
                                4;
            }
        }
        small = std::move(half);
    }
    Grid<glm::u8vec3> pixels(small.width, small.height);
    std::ranges::transform(small.values, pixels.values.begin(),
                           [](float value) { return glm::u8vec3(srgb_byte(value)); });
    return png_of(pixels);
}

CompareRequest request_of(const CompareOptions& options) {
    CompareRequest request{.dots = options.dots,
                           .picture_dots = options.picture_dots,
                           .growth = {},
                           .seconds = options.seconds,
                           .seed = options.seed,
                           .pngs = options.page.has_value()};
    for (std::size_t count = 1'000; count <= options.most; count *= 10) request.growth.push_back(count);
    const auto add = [&](std::string name, Picture picture) {
        request.pictures.push_back({.name = std::move(name), .light = std::move(picture.light)});
        if (request.pngs) request.pictures.back().png = png_of_light(request.pictures.back().light);
    };
    if (options.pictures.empty() && !options.icons) add("still life", sample_picture());
    for (const fs::path& file : options.pictures) add(file.filename().string(), read_with_remark(file));
    if (options.icons)
        for (ComparedPicture& icon : icons()) add(std::move(icon.name), {.light = std::move(icon.light)});
    return request;
}

void save_report(const fs::path& file, const std::string& text) {
    save_atomically(
        file, [&](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
}

void check_ending(const std::optional<fs::path>& file, const std::string& ending, const std::string& other,
                  const char* option) {
    if (!file) return;
    if (ending_of(*file) != ending && ending_of(*file) != other)
        throw std::runtime_error(
            fmt::format("{}: does not end in {}, which {} needs", file->string(), ending, option));
    check_can_save(*file);
}

// A text in lines of a terminal's width.
std::string in_lines(const std::string& text) {
    std::string lines;
    std::size_t width = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool next_line = width + word.size() > 84;
        if (width > 0) lines += next_line ? '\n' : ' ';
        lines += word;
        width = next_line ? word.size() : width + 1 + word.size();
    }
    return lines;
}

}  // namespace

// Measures, saves, and prints tables on standard output. After Ctrl+C the tables have the methods that were
// finished, and nothing is saved. Throws std::runtime_error with one sentence.
void compare(const CompareOptions& options) {
    check_ending(options.json, ".json", ".json", "--json");
    check_ending(options.page, ".html", ".xhtml", "--page");
    const std::vector<Contender> methods =
        options.methods.empty() ? all_contenders() : contenders_named(options.methods);
    CompareRequest request = request_of(options);

    std::vector<MeasuredMethod> measured;
    bool stopped = false;
    {
        const StopOnInterrupt stop;
        ProgressLine line;
        request.stop = stop.token();
        request.progress = [&](double done, std::string_view what) { line.show(done, what); };
        measured = compare_methods(methods, request);
        stopped = StopOnInterrupt::interrupted();
    }
    if (!measured.empty()) fmt::print("{}", compare_text(measured, request));
    if (stopped)
        throw std::runtime_error(
            fmt::format("stopped: {} of {} methods were measured, and no file was written", measured.size(),
                        methods.size()));
    if (options.json) save_report(*options.json, compare_json(measured, request));
    if (options.page) save_report(*options.page, compare_page(measured, request));
}

CompareCommand::CompareCommand(CLI::App& program) {
    CLI::App* const command =
        program.add_subcommand("compare", "Measure Dapple's dots and those of earlier methods");
    command
        ->add_option("pictures", options_.pictures, "Pictures to draw; without any, the built-in still life")
        ->type_name("IMAGE");
    command->add_flag(
        "--icons", options_.icons,
        "Draw five icons, shapes with hard edges and soft ones, instead of the still life; they are "
        "meant for some 1,024 dots");
    command
        ->add_option("--methods", options_.methods,
                     "Which methods to measure: names with commas between them; without it, all")
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option_function<std::vector<std::string>>(
            "--dots",
            [this](const std::vector<std::string>& texts) {
                options_.dots.clear();
                told_as("--dots", [&] {
                    for (const std::string& text : texts)
                        options_.dots.push_back(count_in(text, kMostMeasured));
                });
            },
            "Dots on constant grey; given several numbers, the tables also have the worst of all but the "
            "first")
        ->type_name("N,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str("65536");
    add_count(*command, "--picture-dots", options_.picture_dots, kMostMeasured, "Dots in each picture")
        ->default_str("10000");
    add_count(*command, "--most", options_.most, kMostCompared,
              "Measure how time grows from 1,000 dots up to this many, ten times as many at each step; below "
              "1,000, it is not measured")
        ->default_str("10000000");
    add_number(*command, "--seconds", options_.seconds, {.least = 0.01, .most = 1e6}, "S",
               "Seconds of one processor that a method may take for one drawing; the tables have a dash "
               "where it would take longer");
    add_seed(*command, options_.seed, "For the methods that draw random numbers");
    command->add_option("--json", options_.json, "Saves all numbers for programs")->type_name("FILE");
    command->add_option("--page", options_.page, "Saves a page with plots, spectra and drawings")
        ->type_name("FILE");
    command->footer(
        in_lines("Methods: " + contender_names() + ".") +
        "\n\n"
        "Time is processor time, all work done by one thread. For pictures each method has a\n"
        "density that allows for the overlap of its own dots. Ctrl+C stops; the tables then have\n"
        "those methods that were finished.\n\n"
        "Examples:\n"
        "  dapple-lab compare --page compare.html              all of them; takes some minutes\n"
        "  dapple-lab compare cat.jpg --methods dapple,lloyd,sobol --most 100000\n"
        "  dapple-lab compare --methods dapple --dots 65536,92672,131072 --json levels.json");
    command->callback([this, command] {
        std::vector<FileInUse> written;
        if (options_.json) written.push_back({*options_.json, "the numbers"});
        if (options_.page) written.push_back({*options_.page, "the page"});
        check_apart(*command, {"--json", "--page"}, written);
        compare(options_);
    });
}

Command add_compare_command(CLI::App& program) {
    return std::make_shared<CompareCommand>(program);
}

}  // namespace dapple
