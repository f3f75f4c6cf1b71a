#pragma once
// The canvas of an environment map: the map with its samples, and what they light beside what the map lights.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/model/lit_map.h"
#include "app/viewer/view/camera.h"

namespace dapple {

/// Where things are on the canvas, in ImGui's points.
struct LightLayout {
    CanvasPlace map;
    /// The upper left corners of kLitObjects, by the samples and by the map.
    std::array<std::array<glm::vec2, std::size(kLitObjects)>, 2> objects;
    float object_side = 1;
};
/// The map above, twice as wide as high, the objects in what is left below.
LightLayout light_layout(glm::vec2 corner, glm::vec2 size);

/// What is to be seen.
struct LightsShown {
    const LitMap& lit;
    const SampledMap& samples;
    const LightsSettings& settings;
    // Numbers that change with them.
    int map_number = 0;
    std::uint64_t samplings = 0;
};

class LightScene {
 public:
    /// Behind ImGui's windows, the part of the map that the camera sees.
    void show(const LightLayout& layout, const Camera& camera, const LightsShown& shown);

 private:
    void draw_textures(const LightsShown& shown, int object_pixels);
    static void show_on_map(const GlTexture& texture, const CanvasPlace& place, const Camera& camera,
                            const LightsSettings& settings);
    static void show_points(const CanvasPlace& place, const Camera& camera, const LightsShown& shown);

    struct Drawn {
        int map_number = 0;
        std::uint64_t samplings = 0;
        double stops = 0, turn_degrees = 0;
        int object_pixels = 0;
        bool areas = false;
        bool operator==(const Drawn&) const = default;
    };
    std::optional<Drawn> drawn_;
    GlTexture map_texture_, areas_texture_;
    std::array<std::array<GlTexture, std::size(kLitObjects)>, 2> objects_;
};

}  // namespace dapple
