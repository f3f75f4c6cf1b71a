#pragma once
// The canvas of an environment map: the map with its samples, and two spheres in their light.

#include <array>
#include <glm/vec2.hpp>
#include <vector>

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
    Grid<glm::vec3> preview;  // at most 1,024 wide
};

class LightScene {
 public:
    /// Takes samples anew and draws textures anew where the settings ask for it. Throws std::runtime_error as
    /// light_samples() does; what was shown stays then.
    void update(const LitMap& lit, const LightsSettings& settings);

    /// Into the current ImGui window's draw list.
    void show(glm::vec2 corner, glm::vec2 size, const LightsSettings& settings) const;

    const LightsFacts& facts() const { return facts_; }

    /// Another map: nothing shown is valid any more.
    void forget() { *this = LightScene(); }

 private:
    void take_samples(const LitMap& lit, const LightsSettings& settings);

    bool sampled_ = false, drawn_ = false;
    LightsSettings shown_;
    LightsFacts facts_;
    std::vector<glm::dvec2> places_;
    std::vector<IrradianceMap> found_;  // one, once there are samples
    GlTexture map_texture_;
    std::array<GlTexture, 2> spheres_;
};

}  // namespace dapple
