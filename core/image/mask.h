#pragma once
// A mask: where the drawing has more dots than the picture's tone asks for, fewer, or none.
//
// It lies over the picture as it was opened, whatever its size in pixels, so that it stays where it was
// painted when the picture is cropped or turned. A level is 0..255; between the levels' centres it is
// bilinear, beyond the outermost constant. It multiplies the density, which stays at most 1, as black is:
//
//     level    0    64    128    191.5    255
//     factor   0   1/2      1        2      4       level / 128 up to 128, 2^(2 (level - 128) / 127) above

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>

#include "core/image/framing.h"
#include "core/image/grid.h"

namespace dapple {

/// The longer side of a mask is at most this: a dot of a usual drawing lies in it on two pixels or three.
inline constexpr int kMostMaskSide = 512;

inline constexpr std::uint8_t kNeutralLevel = 128;

/// Levels that never change, and are copied without cost.
class Mask {
 public:
    /// None: neutral everywhere.
    Mask() = default;
    /// Levels of a shape of mask_size(). Neutral everywhere is none.
    explicit Mask(Grid<std::uint8_t> levels);

    bool empty() const { return !levels_; }
    /// Not of an empty one.
    const Grid<std::uint8_t>& levels() const { return *levels_; }

    bool operator==(const Mask& other) const;

 private:
    std::shared_ptr<const Grid<std::uint8_t>> levels_;
};

/// That of a mask for a picture of so many pixels: as many, or fewer of the same shape.
glm::ivec2 mask_size(glm::ivec2 picture);

/// Linear light as a mask, as paint programs show it: middle grey (#808080) is neutral, black is no dots,
/// white is most. A larger picture becomes means of the encoded values.
Mask mask_of(const Grid<float>& light);

/// What the density is multiplied with at a level 0..255.
float mask_factor(float level);

/// The density of a picture of so many pixels that is framed so, under the mask. 0..1, if it was.
Grid<float> masked(Grid<float> density, const Mask& mask, const Framing& framing, glm::ivec2 picture);

}  // namespace dapple
