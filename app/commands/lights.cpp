// dapple lights: an environment map to a list of lights.

#include "app/commands/commands.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/failure.h"
#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/text/shown_text.h"
#include "core/tile/ranking.h"
#include "io/available_memory.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/environment_file.h"
#include "io/files/save_lights.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/reports/light_report.h"

namespace dapple {

namespace {

struct LightsOptions {
    std::optional<std::filesystem::path> map;  // none: a sky of our own
    std::filesystem::path output;              // see kLightEndings; empty: a window
    LightRequest request{.threads = 0};
    std::optional<SphereConvention> convention;  // none: the one of the program that reads such a file
    bool clamp = false;                          // light below 0 is none
    bool compare = false;                        // instead: how samplers err; output .html, .csv or .svg
    double rotation_degrees = 0;
    std::string tile = "paper16";
    RankingMethod ranking = RankingMethod::energy;
    std::optional<std::filesystem::path> pdf;  // also: the density by which samples are placed, an .exr
    std::optional<double> memory;              // bytes that it may take; none: what is available
    std::optional<double> exposure;            // of a PNG, in stops over the natural one
};

namespace fs = std::filesystem;

constexpr double kLargeFile = 1e9;    // bytes, that are told of before they are written
constexpr double kMemoryOfOne = 180;  // bytes a sample, measured
constexpr const char* kReportEndings = ".html, .csv or .svg";

bool is_report(const fs::path& output) {
    const std::string ending = ending_of(output);
    return ending == ".html" || ending == ".csv" || ending == ".svg";
}

std::string source_of(const LightsOptions& options) {
    return options.map ? options.map->filename().string() : "sky";
}

EnvironmentMap map_of(const LightsOptions& options) {
    if (!options.map) return sky_map();
    EnvironmentFile file = read_environment(*options.map, LightBelowZero::none);
    print_remark(*options.map, file.remark);
    const std::string name = printable(options.map->string());
    const std::string pixels = fmt::format("{} pixel{}", file.below_zero, file.below_zero == 1 ? "" : "s");
    if (file.below_zero > 0 && !options.clamp)
        throw failure("{}: light is below 0 at {}; repair the map first, or give --clamp to set it to 0",
                      name, pixels);
    if (file.below_zero > 0)
        fmt::print(stderr, "dapple: {}: light below 0 at {} was set to 0\n", name, pixels);
    if (file.ends_at_white)
        fmt::print(stderr,
                   "dapple: {}: this picture has no light above white, so a sun in it is far too dim; use a "
                   ".hdr or .exr\n",
                   name);
    return std::move(file.map);
}

void check_that_fit(const CLI::App& command, const LightsOptions& options) {
    if (options.pdf && ending_of(*options.pdf) != ".exr")
        throw CLI::ValidationError("--pdf", options.pdf->string() + " does not end in .exr");
    if (options.compare) {
        refuse(command,
               {"--samples", "--convention", "--rotate", "--radiance", "--position", "--mis-compensation",
                "--order", "--placer", "--seed", "--threads", "--exposure", "--pdf", "--memory"},
               "cannot be used with --compare, which tries samples of several kinds and numbers");
        return;
    }
    if (options.request.placer == PlacerKind::figure8)
        refuse(command, {"--ranking"},
               "does not apply to the figure8 placer, which has its own order; leave it out");
    if (options.request.radiance == SampleRadiance::point &&
        options.request.position != SamplePosition::random)
        throw CLI::ValidationError("--radiance",
                                   "point applies to random samples only; give --position random too");
    if (options.output.empty()) {
        refuse(command, {"--convention", "--ranking", "--pdf"},
               "applies to a file only; name one with --output");
        return;
    }
    if (light_file_of(options.output) == LightFile::png) {
        refuse(command, {"--convention", "--rotate", "--radiance"},
               "applies to lists of lights only; leave it out");
    } else {
        refuse(command, {"--exposure"}, "applies to a picture only; let the output's name end in .png");
    }
}

// Reads, samples and saves; needs an output. Throws std::runtime_error with one sentence naming the file
// that is wrong; what was at the output's place stays then.
void lights(const LightsOptions& options) {
    check_can_save(options.output);
    if (options.pdf) check_can_save(*options.pdf);
    RankedTile tile = tile_named(options.tile, options.ranking);
    const EnvironmentMap map = map_of(options);
    const std::uint64_t count = options.request.count;
    check_memory(kMemoryOfOne * static_cast<double>(count), fmt::format("{} samples", grouped(count)),
                 options.memory);
    if (const double bytes = expected_bytes(*light_file_of(options.output), count); bytes >= kLargeFile)
        fmt::print(stderr,
                   "dapple: {}: {} samples will take about {:.1f} GB on disk and {:.1f} GB of memory\n",
                   printable(options.output.string()), grouped(count), bytes / 1e9,
                   kMemoryOfOne * static_cast<double>(count) / 1e9);
    if (!meets_itself(tile.tile()))
        fmt::print(stderr,
                   "dapple: {}: this tile's left and right sides do not fit, so samples may be close "
                   "together where the map's sides meet\n",
                   printable(options.tile));
    const LightSamples samples = light_samples(map, tile, options.request);

    save_lights(
        options.output, map, samples,
        {options.convention, options.rotation_degrees, source_of(options), options.exposure.value_or(0)});
    if (options.pdf)
        save_atomically(*options.pdf, [&](std::ostream& out) {
            write_exr(out, light_pdf(map, options.request.importance));
        });
}

// Saves how large the errors of samplers are on that map, and prints them. Throws as above.
void compare_lights(const LightsOptions& options) {
    check_can_save(options.output);
    RankedTile tile = tile_named(options.tile, options.ranking);
    const EnvironmentMap map = map_of(options);
    const LightComparison comparison = compare_samplers(map, tile);
    save_atomically(options.output, [&](std::ostream& out) {
        const std::string ending = ending_of(options.output);
        if (ending == ".csv") return write_comparison_csv(out, comparison);
        if (ending == ".html")
            out << comparison_page(comparison, source_of(options));
        else
            out << comparison_plot(comparison) << '\n';
    });
    fmt::print("{}", comparison_table(comparison));
}

}  // namespace

Command add_lights_command(CLI::App& program, std::function<void(const ShownMap&)> show) {
    const auto kept = std::make_shared<LightsOptions>();
    LightsOptions& options = *kept;
    CLI::App* const command =
        program.add_subcommand("lights", "Turn an environment map into a list of lights for a renderer");
    LightRequest& request = options.request;
    command
        ->add_option("map", options.map,
                     "A latitude-longitude map, .hdr or .exr; without one, a built-in sky")
        ->type_name("MAP");
    command
        ->add_option("-o,--output", options.output,
                     std::string("The output file; its name ends in ") + kLightEndings +
                         ". Without it, a window opens")
        ->type_name("OUT");
    add_count(*command, "-n,--samples", request.count, kMostLightSamples, "Exactly this many samples")
        ->default_str(fmt::format("{}", request.count));
    add_choice(*command, "--convention", options.convention,
               "How places on the map become directions: openexr, usd, mitsuba, blender or pbrt. Without it, "
               "pbrt for .pbrt, mitsuba for .xml, else openexr");
    add_number(*command, "--rotate", options.rotation_degrees, {.least = -1e6, .most = 1e6}, "DEG",
               "Rotates the map about the up axis, by the right-hand rule");
    add_choice(
        *command, "--radiance", request.radiance,
        "A sample's radiance. mean: over its region; point: the map's at the sample, with --position random");
    add_choice(*command, "--position", request.position,
               "A sample's place in its region. settled: the least error; dot: as placed; random: no bias");
    add_choice(*command, "--order", request.order,
               "priority: the most important first, so that the first few make a set, once each of the "
               "others adds its weight to the nearest of them. placed: in the tile's order");
    command->add_flag_callback(
        "--mis-compensation", [&request] { request.importance = LightImportance::compensated; },
        "Samples only light above the mean: for multiple importance sampling");
    command
        ->add_option("--pdf", options.pdf,
                     "Also writes the density of the samples, per steradian at each pixel of the map, to an "
                     ".exr: for multiple importance sampling")
        ->type_name("FILE");
    add_memory(*command, options.memory);
    command->add_flag("--clamp", options.clamp,
                      "Sets light below 0, which some programs leave in maps, to 0");
    add_choice(*command, "--placer", request.placer, "exact, or figure8 as printed in the article");
    add_tile(*command, options.tile);
    add_choice(*command, "--ranking", options.ranking,
               "Order in which a tile's dots appear: paper, farthest, or energy, which has the least error");
    add_seed(*command, request.seed,
             "Another choice of samples for every number; 0 lays the tile on the map as it is");
    add_whole_number(*command, "--threads", request.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; the samples are the same");
    add_number(*command, "--exposure", options.exposure, {.least = -100, .most = 100}, "STOPS",
               "PNG: how much lighter or darker to show the map");
    command->footer(
        "Weights are irradiances on a surface that faces the light; they sum to the map's total flux.\n\n"
        "Examples:\n"
        "  dapple lights hall.hdr                               show it, and what it lights\n"
        "  dapple lights hall.hdr -n 1024 -o hall.json          directions, radiance, pdf and weights\n"
        "  dapple lights hall.hdr -n 300 -o hall.xml            lights for a Mitsuba 3 scene\n"
        "  dapple lights hall.hdr -n 300 -o hall.pbrt --rotate 90\n"
        "  dapple lights hall.hdr -n 8000 -o hall.png           the map with the samples drawn over it\n"
        "  dapple lights hall.hdr --compare -o hall.html        how good they are, compared with other "
        "methods");
    CLI::Option* const compare =
        command->add_flag("--compare", options.compare,
                          std::string("Writes a report instead of a list: the error of irradiance against "
                                      "the number of samples, of several kinds; the output ends in ") +
                              kReportEndings);
    command->callback([&options, command, compare, show = std::move(show)] {
        if (options.compare) {
            if (!is_report(options.output))
                throw CLI::ValidationError(compare->get_name(), std::string("needs an output that ends in ") +
                                                                    kReportEndings +
                                                                    ", such as -o report.html");
            check_that_fit(*command, options);
            check_apart(*command, {"--output"}, {{options.output, "the report"}});
            return compare_lights(options);
        }
        if (options.output.empty()) {
            check_that_fit(*command, options);
            return show({.map = options.map,
                         .request = options.request,
                         .tile = options.tile,
                         .stops = options.exposure.value_or(0),
                         .turn_degrees = options.rotation_degrees});
        }
        if (!light_file_of(options.output))
            throw CLI::ValidationError("--output",
                                       options.output.string() + " does not end in " + kLightEndings);
        check_that_fit(*command, options);
        std::vector<FileInUse> written{{options.output, "the lights"}};
        if (options.pdf) written.push_back({*options.pdf, "the density"});
        check_apart(*command, {"--output", "--pdf"}, written);
        lights(options);
    });
    return kept;
}

}  // namespace dapple
