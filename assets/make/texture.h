#pragma once

#include <cstdint>
#include <glm/glm.hpp>

/// Fine structure of the surfaces, as functions of a point in a solid's own frame (y is the axis it stands
/// on).
namespace dapple::make {

enum class Texture { plain, turned_wood, wound_thread, woven, speckled };

/// Relief in the frame's units, and what the albedo is multiplied by.
struct Detail {
    double height = 0;
    double tint = 1;
};

Detail detail_at(Texture texture, const glm::dvec3& point);

/// 32 well-mixed bits from three integers.
std::uint32_t mix_bits(std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Smooth noise in [0, 1] with features of size 1.
double smooth_noise(const glm::dvec3& point);

}  // namespace dapple::make
