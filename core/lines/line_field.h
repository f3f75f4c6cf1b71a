#pragma once
// Where a picture has edges and dark lines, how strong they are, and which way they run: what lines are
// traced on.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/grid.h"

namespace dapple {

inline constexpr int kLongestSide = 1280;        // pixels of a picture in which lines are looked for
inline constexpr double kFineScale = 1 / 500.0;  // of its longer side: how wide fine lines are

/// The sRGB-encoded values, 0..1, of a picture of linear light (clamped, NaN black), reduced by whole blocks
/// of pixels until its longer side is at most `longest`.
Grid<float> encoded_lightness(const Grid<float>& light, int longest);

/// A picture of a fourth of the pixels: means of two by two.
Grid<float> halved(const Grid<float>& picture);

/// Bilinear between pixels' centres, which lie at whole numbers; beyond the outermost constant.
float value_at(const Grid<float>& grid, glm::vec2 place);

/// Places are in pixels, whole numbers at their centres.
///
/// An edge and a line are both where local energy is highest across them, the root of the sum of squares of
/// an odd and an even filter (Morrone & Owens 1987; Perona & Malik 1990): once each, right on the edge or in
/// the middle of the line. The filters are the first two derivatives of a Gaussian across the flow, which is
/// that of the smoothed structure tensor (Kang, Lee & Chui 2007).
class LineField {
 public:
    /// Of encoded values, by a Gaussian of standard deviation `sigma` pixels.
    LineField(const Grid<float>& encoded, float sigma);

    /// The difference of encoded values over an edge, 0..1, or about that of a line as wide as sigma.
    float contrast_at(glm::vec2 place) const { return value_at(contrast_, place); }

    /// Contrast as far as it stands out: less that of the surroundings, by which texture is told from
    /// contours (Grigorescu, Petkov & Westenberg 2003), less where these run all ways, and 0 on lines of
    /// light.
    float salience_at(glm::vec2 place) const;

    /// -1 on a line of light, 0 on an edge, 1 on a dark line.
    float phase_at(glm::vec2 place) const { return value_at(phase_, place); }

    glm::ivec2 size() const { return {contrast_.width, contrast_.height}; }

    /// Whether it is a pixel or more within the outermost pixels' centres.
    bool inside(glm::vec2 place) const {
        return place.x >= 1 && place.y >= 1 && place.x <= static_cast<float>(contrast_.width - 2) &&
               place.y <= static_cast<float>(contrast_.height - 2);
    }

    /// Across the flow, of length 1; either of both ways.
    glm::vec2 normal_at(glm::vec2 place) const;

    struct Seed {
        float salience;
        std::int32_t x, y;
    };
    /// Pixels with more contrast than both neighbours, beside each other or one above the other, and at least
    /// so much salience; the strongest first.
    std::vector<Seed> seeds(float least_salience) const;

 private:
    glm::vec2 in_blocks(glm::vec2 place) const;

    int block_;                            // pixels along a block's side
    Grid<float> contrast_, phase_;         // the even filter's share of it: -1 light, 0 edge, 1 dark
    Grid<float> cosine_, sine_;            // of blocks: of twice the angle of the flow's normal
    Grid<float> coherence_, surrounding_;  // of blocks: 0..1, over a wider part, and mean contrast there
};

}  // namespace dapple
