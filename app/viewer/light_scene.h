#pragma once
// The canvas of an environment map: the map with its samples, and two spheres in their light.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/background.h"
#include "app/viewer/camera.h"
#include "app/viewer/camera_mouse.h"
#include "app/viewer/gl_objects.h"
#include "app/viewer/panels/lights_panel.h"
#include "core/image/environment.h"
#include "core/lights/lit_sphere.h"

namespace dapple {

/// A map and what showing it needs, made once: the irradiance takes a second.
struct LitMap {
    explicit LitMap(EnvironmentMap environment);

    EnvironmentMap map;
    IrradianceMap exact;
    double natural_exposure;
    Grid<glm::vec3> preview;  // at most 2,048 wide
};

/// A map's samples and what they light.
struct SampledMap {
    LightsSettings settings;         // that they were taken with
    std::vector<glm::dvec2> places;  // on the map, 0..1
    std::optional<IrradianceMap> found;
    LightsFacts facts;
    std::string error;  // why there are none
};
SampledMap sampled(const LitMap& lit, const LightsSettings& settings);

/// Where things are on the canvas, in ImGui's points.
struct LightLayout {
    CanvasPlace map;
    std::array<glm::vec2, 2> spheres;  // their upper left corners
    float sphere_side = 1;
};
/// The map above, twice as wide as high, the spheres in what is left below.
LightLayout light_layout(glm::vec2 corner, glm::vec2 size);

class LightScene {
 public:
    /// `wake` is called from another thread when samples are there.
    LightScene(std::shared_ptr<const LitMap> lit, std::function<void()> wake);

    /// Has samples taken anew, in the background, and draws textures anew where the settings ask for it.
    /// Returns why there are no samples, once; what was shown stays then.
    std::string update(const LightsSettings& settings);

    /// Behind ImGui's windows, the part of the map that the camera sees.
    void show(const LightLayout& layout, const Camera& camera, const LightsSettings& settings) const;

    const std::shared_ptr<const LitMap>& lit() const { return lit_; }
    const EnvironmentMap& map() const { return lit_->map; }
    /// Of the samples shown.
    const LightsFacts& facts() const { return shown_.facts; }
    std::size_t samples() const { return shown_.places.size(); }
    /// How many times samples were taken.
    std::uint64_t samplings() const { return samplings_; }
    /// They are being taken anew.
    bool sampling() const { return background_.busy(); }

 private:
    void draw_textures(const LightsSettings& settings);
    void show_map(const CanvasPlace& place, const Camera& camera, const LightsSettings& settings) const;
    void show_samples(const CanvasPlace& place, const Camera& camera, const LightsSettings& settings) const;

    std::shared_ptr<const LitMap> lit_;
    std::optional<LightsSettings> asked_;
    SampledMap shown_;
    std::uint64_t samplings_ = 0;

    struct Drawn {
        std::uint64_t sampling = 0;
        double stops = 0, turn_degrees = 0;
        bool operator==(const Drawn&) const = default;
    };
    std::optional<Drawn> drawn_;
    GlTexture map_texture_;
    std::array<GlTexture, 2> spheres_;
    Background<SampledMap> background_;  // last: it reads the map
};

}  // namespace dapple
