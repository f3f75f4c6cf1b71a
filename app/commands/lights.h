#pragma once
// dapple lights: an environment map to a list of lights.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/tile/ranking.h"

namespace CLI {
class App;
}

namespace dapple {

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

/// Reads, samples and saves; needs an output. Throws std::runtime_error with one sentence naming the file
/// that is wrong; what was at the output's place stays then.
void lights(const LightsOptions& options);

/// Saves how large the errors of samplers are on that map, and prints them. Throws as above.
void compare_lights(const LightsOptions& options);

/// Adds the command to the program and holds its options, so it has to live until all is parsed and done.
class LightsCommand {
 public:
    explicit LightsCommand(CLI::App& program);
    LightsCommand(const LightsCommand&) = delete;
    LightsCommand& operator=(const LightsCommand&) = delete;

    /// What to show in a window, once all is parsed: the command was given without an output.
    const LightsOptions* window() const { return window_wanted_ ? &options_ : nullptr; }

 private:
    LightsOptions options_;
    bool window_wanted_ = false;
};

}  // namespace dapple
