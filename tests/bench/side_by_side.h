#pragma once
// Drawings next to each other in one picture.

#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "lab/analysis/seams.h"

namespace dapple {

/// Photograph and drawings, each in linear light, as panels of the same size.
class SideBySide {
 public:
    /// The photograph is the first panel, `width` pixels wide.
    SideBySide(const Grid<float>& light, int width);

    void add(std::span<const glm::dvec2> dots, double radius);

    /// As a grey PNG, the panels from left to right with white between them. Throws std::runtime_error where
    /// it cannot be written; a file that is there stays then.
    void save(const std::filesystem::path& file) const;

 private:
    PixelPage page_;
    std::vector<Grid<float>> panels_;
};

}  // namespace dapple
