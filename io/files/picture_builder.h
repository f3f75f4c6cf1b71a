#pragma once
// Turns rows of colour into a Picture as they are read, so that nothing larger than the light itself is kept.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "io/decoding/exif_orientation.h"
#include "io/files/picture.h"

namespace dapple {

class PictureBuilder {
 public:
    /// Width and height as stored, before turning.
    PictureBuilder(int width, int height, ExifOrientation orientation = {},
                   PictureColours colours = PictureColours::left_out, std::int64_t most_light = kMostLight);

    /// Linear light over white paper, one stored row: `colours` has width values. The rows come in order.
    void add_row(int y, std::span<const glm::vec3> colours);

    /// Once all rows are in. `scene_light`: it is light as it was in front of a camera, not a photograph's.
    Picture finish(std::string description, bool scene_light = false);

 private:
    struct Sum {
        glm::vec3 light{0};
        float count = 0;
    };

    /// Keeps a row of the picture as it will be.
    void keep_row(int y, std::span<const glm::vec3> colours);

    int pixels_in_one_, rows_in_file_;
    std::vector<Sum> sums_;         // of the file's pixels that become the row that is being made
    std::vector<glm::vec3> means_;  // of them
    int stored_width_, stored_height_;
    ExifOrientation orientation_;
    Grid<float> light_;
    ColourGrid colours_;  // empty: left out
    Grid<Sum> preview_;
};

}  // namespace dapple
