#pragma once
// From the numbers that a file stores to linear light.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

namespace dapple {

/// Which channels of a pixel are what.
struct Channels {
    std::array<int, 3> colour{};  // three times the same: grey
    std::optional<int> alpha;
    bool grey() const { return colour[0] == colour[1] && colour[1] == colour[2]; }
};

/// How stored values become light.
struct Encoding {
    enum class Kind { linear, srgb, power } kind = Kind::srgb;
    float gamma = 1;  // of a power

    float light(float stored) const;
};

struct PixelLayout {
    Channels channels;
    int count = 1;  // channels of a pixel
    Encoding encoding;
    bool premultiplied = false;  // colours by alpha
    bool eight_bit = false;
};

class StoredPixels {
 public:
    explicit StoredPixels(const PixelLayout& layout);

    /// A row, integers scaled to 0..1, as linear light over white paper. Throws DecodeError if a pixel is
    /// infinite or not a number.
    void decode(std::span<const float> stored, int y, std::span<glm::vec3> light) const;

 private:
    glm::vec3 over_paper(const float* pixel) const;
    glm::vec3 light_of(const float* pixel, float factor) const;

    PixelLayout layout_;
    std::array<float, 256> eight_bit_{};
};

/// "512 x 512 pixels, 8-bit grey png". `kind` is "8-bit" or "float".
std::string describe(int width, int height, const std::string& kind, const Channels& channels,
                     const std::string& format);

}  // namespace dapple
