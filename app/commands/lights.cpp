#include "app/commands/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "app/commands/options.h"
#include "app/files/atomic_file.h"
#include "app/files/environment.h"
#include "app/files/png_file.h"
#include "app/files/tile_library.h"
#include "core/image/sky.h"
#include "core/lights/light_picture.h"
#include "core/output/light_list.h"
#include "core/output/light_report.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

enum class LightFile { json, csv, pbrt, mitsuba, png };

constexpr const char* kReportEndings = ".html, .csv or .svg";
constexpr const char* kEndings = ".json, .csv, .pbrt, .xml or .png";

std::string ending_of(const fs::path& output) {
    std::string ending = output.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

std::optional<LightFile> kind_of(const fs::path& output) {
    const std::string ending = ending_of(output);
    if (ending == ".json") return LightFile::json;
    if (ending == ".csv") return LightFile::csv;
    if (ending == ".pbrt") return LightFile::pbrt;
    if (ending == ".xml") return LightFile::mitsuba;
    if (ending == ".png") return LightFile::png;
    return std::nullopt;
}

SphereConvention usual_convention(LightFile kind) {
    switch (kind) {
        case LightFile::pbrt:
            return SphereConvention::pbrt;
        case LightFile::mitsuba:
            return SphereConvention::mitsuba;
        default:
            return SphereConvention::openexr;
    }
}

void check_files(const LightsOptions& options) {
    check_apart(options.output, {{options.map, "the map"}, {options.tile, "the tile"}});
    check_can_save(options.output);
}

bool is_report(const fs::path& output) {
    const std::string ending = ending_of(output);
    return ending == ".html" || ending == ".csv" || ending == ".svg";
}

std::string source_of(const LightsOptions& options) {
    return options.map ? options.map->filename().string() : "sky";
}

EnvironmentMap map_of(const LightsOptions& options) {
    return options.map ? read_environment(*options.map) : sky_map();
}

void write_picture(std::ostream& out, const EnvironmentMap& map, const LightSamples& lights, double stops) {
    std::vector<glm::dvec2> places;
    for (const LightSample& sample : lights.samples) places.push_back(sample.uv);
    const Grid<glm::u8vec3> picture = light_picture(map, places, natural_exposure(map) * std::exp2(stops));
    write_png(out, {picture.width, picture.height, 96}, [&](const PixelSink& sink) { sink(picture); });
}

}  // namespace

void lights(const LightsOptions& options) {
    const std::optional<LightFile> kind = kind_of(options.output);
    if (!kind) {
        throw std::runtime_error(fmt::format("{}: does not end in {}", options.output.string(), kEndings));
    }
    check_files(options);
    RankedTile tile = tile_named(options.tile, options.ranking);
    const EnvironmentMap map = map_of(options);
    if (!meets_itself(tile.tile())) {
        fmt::print(
            stderr,
            "dapple: {}: this tile's left and right sides do not fit each other, so samples may lie close "
            "together where the map's sides meet\n",
            options.tile);
    }
    const LightSamples samples = light_samples(map, tile, options.request);

    const std::string source = source_of(options);
    const LightListStyle style{options.convention.value_or(usual_convention(*kind)), options.rotation_degrees,
                               source};
    save_atomically(options.output, [&](std::ostream& out) {
        switch (*kind) {
            case LightFile::json:
                return write_light_json(out, samples, style);
            case LightFile::csv:
                return write_light_csv(out, samples, style);
            case LightFile::pbrt:
                return write_light_pbrt(out, samples, style);
            case LightFile::mitsuba:
                return write_light_mitsuba(out, samples, style);
            case LightFile::png:
                return write_picture(out, map, samples, options.exposure.value_or(0));
        }
    });
}

void compare_lights(const LightsOptions& options) {
    if (!is_report(options.output)) {
        throw std::runtime_error(
            fmt::format("{}: does not end in {}", options.output.string(), kReportEndings));
    }
    check_files(options);
    RankedTile tile = tile_named(options.tile, options.ranking);
    const EnvironmentMap map = map_of(options);
    const LightComparison comparison = compare_samplers(map, tile);
    save_atomically(options.output, [&](std::ostream& out) {
        const std::string ending = ending_of(options.output);
        if (ending == ".csv") return write_comparison_csv(out, comparison);
        if (ending == ".html") {
            out << comparison_page(comparison, source_of(options));
        } else {
            out << comparison_plot(comparison) << '\n';
        }
    });
    fmt::print("{}", comparison_table(comparison));
}

LightsCommand::LightsCommand(CLI::App& program) {
    CLI::App* const command =
        program.add_subcommand("lights", "Turn an environment map into a list of lights for a renderer");
    LightRequest& request = options_.request;
    command
        ->add_option("map", options_.map,
                     "A latitude-longitude map, .hdr or .exr; without one, a sky of our own")
        ->type_name("MAP");
    command
        ->add_option(
            "-o,--output", options_.output,
            std::string("What to write; its name ends in ") + kEndings + ". Without it, a window opens")
        ->type_name("OUT");
    const auto whole = [](const std::string& name, const std::string& text, std::uint64_t least,
                          std::uint64_t most) {
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most) {
            throw CLI::ValidationError(
                name,
                fmt::format("{} is not possible; give a whole number from {} to {}", text, least, most));
        }
        return value;
    };
    command
        ->add_option_function<std::string>(
            "-n,--samples",
            [&request, whole](const std::string& text) {
                request.count = count_in("--samples", text, kMostLightSamples);
            },
            "Exactly so many samples")
        ->type_name("N")
        ->default_str(fmt::format("{}", request.count));
    command
        ->add_option_function<std::string>(
            "--convention",
            [this](const std::string& text) {
                for (const SphereConvention c :
                     {SphereConvention::openexr, SphereConvention::usd, SphereConvention::mitsuba,
                      SphereConvention::blender, SphereConvention::pbrt}) {
                    if (name_of(c) == text) options_.convention = c;
                }
                if (!options_.convention || name_of(*options_.convention) != text) {
                    throw CLI::ValidationError(
                        "--convention",
                        text + " is not known; there are openexr, usd, mitsuba, blender, pbrt");
                }
            },
            "Which way in space a place on the map lies: openexr, usd, mitsuba, blender or pbrt; without it "
            "pbrt for .pbrt, mitsuba for .xml, else openexr")
        ->type_name("NAME");
    add_number(*command, "--rotate", options_.rotation_degrees, {.least = -1e6, .most = 1e6}, "DEG",
               "Turn the map about the up axis, by the right-hand rule");
    add_choice(*command, "--radiance", request.radiance, {SampleRadiance::mean, SampleRadiance::point},
               "A sample's radiance: mean over its region, or the map's at its point");
    add_choice(*command, "--position", request.position,
               {SamplePosition::centroid, SamplePosition::dot, SamplePosition::random},
               "Where in its region a sample is: centroid, the least error; dot, where the placer put it; "
               "random, without any bias");
    command->add_flag_callback(
        "--mis-compensation", [&request] { request.importance = LightImportance::compensated; },
        "Sample only light above the mean: for multiple importance sampling");
    add_choice(*command, "--placer", request.placer, {PlacerKind::exact, PlacerKind::figure8},
               "exact, or figure8 as the paper prints it");
    command->add_option("--tile", options_.tile, "A tile's name, or its two integers as in 14217,2895/16")
        ->type_name("TILE")
        ->default_str(options_.tile);
    add_choice(*command, "--ranking", options_.ranking,
               {RankingOrder::paper, RankingOrder::farthest, RankingOrder::energy},
               "Order in which a tile's dots appear: paper, farthest, or energy, which errs least");
    command
        ->add_option_function<std::string>(
            "--seed",
            [&request, whole](const std::string& text) {
                request.seed = whole("--seed", text, 0, std::numeric_limits<std::uint64_t>::max());
            },
            "Another choice of samples for every number; 0 lays the tile on the map as it is")
        ->type_name("N")
        ->default_str("0");
    add_whole_number(*command, "--threads", request.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; the samples are the same");
    add_number(*command, "--exposure", options_.exposure, {.least = -100, .most = 100}, "STOPS",
               "PNG: lighter or darker than by itself");
    command->footer(
        "Weights are irradiances on a surface that faces the light; they sum to the map's total flux.\n\n"
        "Examples:\n"
        "  dapple lights hall.hdr                               look at it, and at a sphere in its light\n"
        "  dapple lights hall.hdr -n 1024 -o hall.json          directions, radiance, pdf and weights\n"
        "  dapple lights hall.hdr -n 300 -o hall.xml            lights for a Mitsuba 3 scene\n"
        "  dapple lights hall.hdr -n 300 -o hall.pbrt --rotate 90\n"
        "  dapple lights hall.hdr -n 8000 -o hall.png           the map with the samples drawn over it\n"
        "  dapple lights hall.hdr --compare -o hall.html        how good they are, beside other ways");
    CLI::Option* const compare = command->add_flag(
        "--compare", options_.compare,
        std::string("Instead: how much irradiance by samples of several kinds errs, against "
                    "their number; the output ends in ") +
            kReportEndings);
    command->callback([this, compare] {
        if (options_.compare) {
            if (!is_report(options_.output)) {
                throw CLI::ValidationError(compare->get_name(), std::string("needs an output that ends in ") +
                                                                    kReportEndings +
                                                                    ", such as -o report.html");
            }
            return compare_lights(options_);
        }
        if (options_.output.empty()) {
            window_wanted_ = true;
            return;
        }
        if (!kind_of(options_.output)) {
            throw CLI::ValidationError("--output", options_.output.string() + " does not end in " + kEndings);
        }
        if (options_.exposure && kind_of(options_.output) != LightFile::png) {
            throw CLI::ValidationError("--exposure", "is for a picture; let the output's name end in .png");
        }
        lights(options_);
    });
}

}  // namespace dapple
