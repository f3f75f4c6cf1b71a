#pragma once
// Moving pictures as an animated WebP, pixel for pixel.

#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <ostream>

#include "core/image/grid.h"

namespace dapple {

class WebpFilm {
 public:
    /// It is played over and over.
    explicit WebpFilm(int frames_per_second);
    ~WebpFilm();

    /// sRGB-encoded; all as large, up to 16,383 pixels a side. Throws std::runtime_error if libwebp fails.
    void add(const Grid<glm::u8vec3>& frame);
    /// All of them. Needs one at least. Throws std::runtime_error if libwebp fails, and what the stream does.
    void write(std::ostream& out);

 private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace dapple
