#pragma once
// A mask: where the drawing has more dots than the picture's tone asks for, fewer, or none, and where they
// are finer.
//
// It lies over the picture as it was opened, whatever its size in pixels, so that it stays where it was
// painted when the picture is cropped or turned. A level is 0..255; between the levels' centres it is
// bilinear, beyond the outermost constant. It multiplies the density, which stays at most 1, as black is:
//
//     level    0    64    128    191.5    255
//     factor   0   1/2      1        2      4       level / 128 up to 128, 2^(2 (level - 128) / 127) above
//
// Where dots are finer there are more of them, each with as much less area, so that the tone stays. How fine
// they are is 0..255 too, apart from the level, and lies over the picture in the same way:
//
//     fineness  0    85   170   255
//     dots     x 1   x 2   x 3   x 4      1 + 3 fineness / 255; see refinement.h

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "core/export.h"
#include "core/image/grid.h"
#include "core/image/rectangle.h"

namespace dapple {

// Which part of a picture is drawn, and how it is turned.

/// Pixels of the picture as it was opened, cut out first; then so many quarter turns clockwise, 0..3; in the
/// end left and right may change places.
struct Framing {
    Rectangle<int> pixels;
    int quarter_turns = 0;
    bool mirrored = false;

    bool operator==(const Framing&) const = default;

    /// The result's size in pixels.
    glm::ivec2 size() const {
        const glm::ivec2 cut = pixels.size();
        return quarter_turns % 2 ? glm::ivec2(cut.y, cut.x) : cut;
    }
};

/// All of a picture of that size, as it is.
inline Framing whole_picture(glm::ivec2 size) {
    return {{{0, 0}, size}, 0};
}

/// Where a point of the framed picture lies on the picture as it was opened, both in pixels from the upper
/// left corner.
glm::dvec2 opened_pixel(const Framing& framing, glm::dvec2 framed);

/// The picture's pixels, moved and none changed. Needs a rectangle within the picture that is not empty.
Grid<float> framed(const Grid<float>& picture, const Framing& framing);
Grid<glm::u16vec3> framed(const Grid<glm::u16vec3>& picture, const Framing& framing);

/// The longer side of a mask is at most this: a dot of a usual drawing lies in it on two pixels or three.
inline constexpr int kMostMaskSide = 512;

inline constexpr std::uint8_t kNeutralLevel = 128;

/// Levels that never change, and are copied without cost.
class Mask {
 public:
    /// None: neutral everywhere.
    Mask() = default;
    /// Levels of a shape of mask_size(), and as many finenesses, or no pixels of these where no dots are
    /// finer. Neutral and 0 everywhere is none.
    explicit Mask(Grid<std::uint8_t> levels, Grid<std::uint8_t> fineness = {});

    bool empty() const { return !layers_; }
    /// Not of an empty one.
    const Grid<std::uint8_t>& levels() const { return layers_->levels; }

    bool has_finer() const { return layers_ && !layers_->fineness.empty(); }
    /// Not of an empty one; without pixels where no dots are finer.
    const Grid<std::uint8_t>& fineness() const { return layers_->fineness; }
    Mask without_finer() const { return has_finer() ? Mask(levels()) : *this; }

    bool operator==(const Mask& other) const;

 private:
    struct Layers {
        Grid<std::uint8_t> levels, fineness;
    };
    std::shared_ptr<const Layers> layers_;
};

/// That of a mask for a picture of so many pixels: as many, or fewer of the same shape.
glm::ivec2 mask_size(glm::ivec2 picture);

/// Linear light as a mask, as paint programs show it: middle grey (#808080) is neutral, black is no dots,
/// white is most. A larger picture becomes means of the encoded values.
DAPPLE_API Mask mask_of(const Grid<float>& light);

/// The mask with a picture of linear light as its fineness: black changes nothing, white is finest, between
/// them as encoded. A mask that is there keeps its shape.
DAPPLE_API Mask with_fineness(const Mask& mask, const Grid<float>& light);

/// A level or a fineness at a place in pixels from the mask's corner.
float level_at(const Grid<std::uint8_t>& levels, glm::dvec2 place);

/// What the density is multiplied with at a level 0..255.
float mask_factor(float level);

/// How many times as many dots there are where they are finest.
inline constexpr float kMostTimesFiner = 4;

/// How many times as many there are at a fineness 0..255.
inline float times_finer(float fineness) {
    return 1 + (kMostTimesFiner - 1) * fineness / 255;
}

/// The density of a picture of so many pixels that is framed so, under the mask. 0..1, if it was; up to
/// kMostTimesFiner where dots are finer.
Grid<float> masked(Grid<float> density, const Mask& mask, const Framing& framing, glm::ivec2 picture);

// A round brush that paints a mask.

enum class BrushKind { more, fewer, none, finer, erase };

struct Brush {
    BrushKind kind = BrushKind::more;
    double radius = 0.05;   // in units of the picture's longer side
    double softness = 0.5;  // the share of the radius over which it fades, 0..1
    double strength = 1;    // how far towards its level one stroke goes, 0..1

    bool operator==(const Brush&) const = default;
};

/// From pressing the button to letting it go. Where it goes over itself it does not become stronger, so that
/// it depends neither on how fast the mouse moves nor on how often it is asked.
class BrushStroke {
 public:
    /// On a picture of so many pixels.
    BrushStroke(const Mask& mask, glm::ivec2 picture, const Brush& brush);

    /// Goes on in a straight line; the first point is where it begins. In units of the picture's longer side.
    void go_to(glm::dvec2 point);

    /// The mask with all of the stroke so far.
    Mask mask() const;

 private:
    Grid<std::uint8_t> levels_, fineness_;  // before the stroke
    Grid<float> cover_;
    Brush brush_;
    glm::dvec2 pixels_per_unit_;  // of the mask
    std::optional<glm::dvec2> last_;
};

}  // namespace dapple
