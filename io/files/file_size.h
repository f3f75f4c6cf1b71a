#pragma once
// How large a file will be, told before it is written.

#include <glm/vec2.hpp>

#include "io/files/save_drawing.h"

namespace dapple {

/// Bytes, about: the format's own writer writes some of the dots, or some of the pixels, and the rest is
/// taken to be like them. Throws std::runtime_error as the writer would.
double estimated_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing);

/// Bytes, about, of a drawing that is not in memory: of text, from its first dots alone.
double estimated_bytes_at_once(DrawingFormat format, const DrawingSettings& settings,
                               const DrawingToSave& drawing);

/// Where estimated_bytes() looks at pixels: patches of the page, evenly spread.
struct PixelPatches {
    glm::ivec2 patch, count;  // pixels of each; patches along either side
    glm::dvec2 cell;          // pixels, of the page's part with one patch in its middle
    double pixels_per_unit;

    PixelPatches(const PageSize& page, double dpi);
    /// Which cell a pixel lies in.
    glm::dvec2 index(glm::dvec2 at) const;
    /// From the corner of the patch of that index.
    glm::dvec2 in_patch(glm::dvec2 at, glm::dvec2 index) const;
    /// Whether a dot in such a rectangle of page units may be looked at.
    bool meet(glm::dvec2 low, glm::dvec2 high) const;
};

}  // namespace dapple
