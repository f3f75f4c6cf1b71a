#include "io/files/save_lights.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <vector>

#include "core/failure.h"
#include "core/lights/light_list.h"
#include "core/lights/lit_objects.h"
#include "core/maths/portable_math.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

struct LightFormat {
    std::string_view ending;
    int bytes_of_one;  // sample, of photographed maps
    SphereConvention usual;
    void (*write)(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);
};

// In the order of LightFile.
constexpr std::array kFormats{
    LightFormat{".json", 348, SphereConvention::openexr, write_light_json},
    LightFormat{".csv", 257, SphereConvention::openexr, write_light_csv},
    LightFormat{".pbrt", 220, SphereConvention::pbrt, write_light_pbrt},
    LightFormat{".xml", 241, SphereConvention::mitsuba, write_light_mitsuba},
    LightFormat{".usda", 420, SphereConvention::openexr, write_light_usd},
    LightFormat{".gltf", 259, SphereConvention::openexr, write_light_gltf},
    LightFormat{".py", 163, SphereConvention::blender, write_light_blender},
    LightFormat{".png", 0, SphereConvention::openexr, nullptr},
};

void write_picture(std::ostream& out, const EnvironmentMap& map, const LightSamples& lights, double stops) {
    std::vector<glm::dvec2> places;
    for (const LightSample& sample : lights.samples) places.push_back(sample.uv);
    const Grid<glm::u8vec3> picture =
        light_picture(map, places, natural_exposure(map) * portable::exp2(stops));
    write_png(out, {picture.width, picture.height, 96}, [&](const PixelSink& sink) { sink(picture); });
}

}  // namespace

std::optional<LightFile> light_file_of(const fs::path& path) {
    const auto found = std::ranges::find(kFormats, ending_of(path), &LightFormat::ending);
    if (found == kFormats.end()) return std::nullopt;
    return static_cast<LightFile>(found - kFormats.begin());
}

double expected_bytes(LightFile kind, std::uint64_t samples) {
    return kFormats[static_cast<std::size_t>(kind)].bytes_of_one * static_cast<double>(samples);
}

void save_lights(const fs::path& path, const EnvironmentMap& map, const LightSamples& lights,
                 const LightSaving& saving) {
    const std::optional<LightFile> kind = light_file_of(path);
    if (!kind) throw failure("{}: does not end in {}", path.string(), kLightEndings);
    const LightFormat& format = kFormats[static_cast<std::size_t>(*kind)];
    const LightListStyle style{saving.convention.value_or(format.usual), saving.rotation_degrees,
                               saving.source};
    save_atomically(path, [&](std::ostream& out) {
        if (!format.write) return write_picture(out, map, lights, saving.stops);
        TextBuffer text(out);
        format.write(text, lights, style);
        text.flush();
    });
}

}  // namespace dapple
