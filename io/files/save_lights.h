#pragma once
// Light samples to a file; its name's ending says what kind.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"

namespace dapple {

enum class LightFile {
    json,
    csv,
    pbrt,
    mitsuba,
    usd,
    gltf,
    blender,  // a script
    png,      // the map with the samples drawn over it, as it lies in its file
};

inline constexpr const char* kLightEndings = ".json, .csv, .pbrt, .xml, .usda, .gltf, .py or .png";

/// By the ending, in small or capital letters; none if it is another.
std::optional<LightFile> light_file_of(const std::filesystem::path& path);

/// About how many bytes a file of so many samples has; 0 of a picture, which has as many for any number.
double expected_bytes(LightFile kind, std::uint64_t samples);

struct LightSaving {
    std::optional<SphereConvention> convention{};  // none: the one of the program that reads such a file
    double rotation_degrees = 0;                   // see LightListStyle
    std::string source{};                          // the map's name
    double stops = 0;                              // of a picture, over the natural exposure
};

/// Throws std::runtime_error with a sentence if the ending is unknown or the file cannot be written; what was
/// there stays then.
void save_lights(const std::filesystem::path& path, const EnvironmentMap& map, const LightSamples& lights,
                 const LightSaving& saving);

}  // namespace dapple
