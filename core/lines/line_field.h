#pragma once
// Where a picture has edges and lines, how strong they are, and which way they run: what lines are traced on.
// Places are in pixels, whole numbers at their centres.

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

inline constexpr int kLongestSide = 1280;        // pixels of a picture in which lines are looked for
inline constexpr float kFineScale = 1 / 500.0f;  // how wide fine lines are, of its longer side
inline constexpr float kLeastScale = 0.8f;       // and in pixels

/// How many of its pixels, along a side, become one.
inline int reduction(const Grid<float>& picture) {
    return std::max(1, (std::max(picture.width, picture.height) + kLongestSide - 1) / kLongestSide);
}

/// Means over blocks of so many pixels along a side.
Grid<float> reduced(const Grid<float>& picture);

/// The sRGB-encoded values, 0..1, of a picture of linear light (clamped, NaN black), reduced.
Grid<float> encoded_lightness(const Grid<float>& light);

/// A picture of a fourth of the pixels: means of two by two.
Grid<float> halved(const Grid<float>& picture);

/// Bilinear; beyond the outermost pixels constant.
float value_at(const Grid<float>& grid, glm::vec2 place);

/// An edge and a line are both where local energy is highest across them, the root of the sum of squares of
/// an odd and an even filter (Morrone & Owens 1987; Perona & Malik 1990): once each, right on the edge or in
/// the middle of the line. The filters are the first two derivatives of a Gaussian across the flow, which is
/// that of the smoothed structure tensor (Kang, Lee & Chui 2007).
class LineField {
 public:
    /// Of encoded values, by a Gaussian of standard deviation `sigma` pixels.
    LineField(const Grid<float>& encoded, float sigma);

    glm::ivec2 size() const { return {contrast_.width, contrast_.height}; }

    /// Whether it is a pixel or more within the outermost pixels' centres.
    bool inside(glm::vec2 place) const;

    /// The difference of encoded values over an edge, 0..1, or about that of a line as wide as sigma.
    float contrast_at(glm::vec2 place) const { return value_at(contrast_, place); }

    /// -1 on a line of light, 0 on an edge, 1 on a dark line.
    float phase_at(glm::vec2 place) const { return value_at(phase_, place); }

    /// Contrast as far as it stands out: less that of the surroundings, by which texture is told from
    /// contours (Grigorescu, Petkov & Westenberg 2003), and less where these run all ways.
    float salience_at(glm::vec2 place) const;

    /// Across the flow, of length 1; either of both ways.
    glm::vec2 normal_at(glm::vec2 place) const;

    struct Seed {
        float salience;
        int x, y;
    };
    /// Pixels with more contrast than beside them across the flow, and at least so much salience; the
    /// strongest first.
    std::vector<Seed> seeds(float least_salience) const;

 private:
    glm::vec2 in_blocks(glm::vec2 place) const { return (place + 0.5f) / static_cast<float>(block_) - 0.5f; }

    int block_;  // pixels along a block's side
    Grid<float> contrast_, phase_;
    Grid<float> cosine_, sine_;            // of blocks: of twice the angle of the flow's normal
    Grid<float> coherence_, surrounding_;  // of blocks: 0..1, over a wider part, and mean contrast there
};

}  // namespace dapple
