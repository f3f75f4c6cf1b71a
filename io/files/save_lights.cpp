#include "io/files/save_lights.h"

#include <fmt/format.h>

#include <array>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "core/lights/light_list.h"
#include "core/lights/light_picture.h"
#include "core/maths/portable_math.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

SphereConvention usual_convention(LightFile kind) {
    switch (kind) {
        case LightFile::pbrt:
            return SphereConvention::pbrt;
        case LightFile::mitsuba:
            return SphereConvention::mitsuba;
        case LightFile::blender:
            return SphereConvention::blender;
        default:
            return SphereConvention::openexr;
    }
}

void write_picture(std::ostream& out, const EnvironmentMap& map, const LightSamples& lights, double stops) {
    std::vector<glm::dvec2> places;
    for (const LightSample& sample : lights.samples) places.push_back(sample.uv);
    const Grid<glm::u8vec3> picture =
        light_picture(map, places, natural_exposure(map) * portable::exp2(stops));
    write_png(out, {picture.width, picture.height, 96}, [&](const PixelSink& sink) { sink(picture); });
}

}  // namespace

std::optional<LightFile> light_file_of(const fs::path& path) {
    const std::string ending = ending_of(path);
    if (ending == ".json") return LightFile::json;
    if (ending == ".csv") return LightFile::csv;
    if (ending == ".pbrt") return LightFile::pbrt;
    if (ending == ".xml") return LightFile::mitsuba;
    if (ending == ".usda") return LightFile::usd;
    if (ending == ".gltf") return LightFile::gltf;
    if (ending == ".py") return LightFile::blender;
    if (ending == ".png") return LightFile::png;
    return std::nullopt;
}

double expected_bytes(LightFile kind, std::uint64_t samples) {
    // In the order of LightFile, of photographed maps.
    constexpr std::array kBytesOfOne{348, 257, 220, 241, 420, 259, 163, 0};
    return kBytesOfOne[static_cast<std::size_t>(kind)] * static_cast<double>(samples);
}

void save_lights(const fs::path& path, const EnvironmentMap& map, const LightSamples& lights,
                 const LightSaving& saving) {
    const std::optional<LightFile> kind = light_file_of(path);
    if (!kind) throw std::runtime_error(fmt::format("{}: does not end in {}", path.string(), kLightEndings));
    const LightListStyle style{saving.convention.value_or(usual_convention(*kind)), saving.rotation_degrees,
                               saving.source};
    save_atomically(path, [&](std::ostream& out) {
        switch (*kind) {
            case LightFile::json:
                return write_light_json(out, lights, style);
            case LightFile::csv:
                return write_light_csv(out, lights, style);
            case LightFile::pbrt:
                return write_light_pbrt(out, lights, style);
            case LightFile::mitsuba:
                return write_light_mitsuba(out, lights, style);
            case LightFile::usd:
                return write_light_usd(out, lights, style);
            case LightFile::gltf:
                return write_light_gltf(out, lights, style);
            case LightFile::blender:
                return write_light_blender(out, lights, style);
            case LightFile::png:
                return write_picture(out, map, lights, saving.stops);
        }
    });
}

}  // namespace dapple
