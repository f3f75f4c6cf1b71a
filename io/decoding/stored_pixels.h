#pragma once
// From the numbers that a file stores to linear light.

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/decoding/colour_profile.h"
#include "io/decoding/decoded_image.h"

namespace dapple {

// Pictures of which a file has only a part, or more: EXR's data window and display window, and TIFF's sizes
// of the whole.

/// Passes a picture on as its header's window has it: pixels outside that are left out, and what the file has
/// none of is bare paper or black. A remark, and the description with it, says so.
class WindowSink : public ImageSink {
 public:
    WindowSink(ImageSink& to, bool over_paper) : to_(to), over_paper_(over_paper) {}

    void begin(const ImageHeader& header) override;
    void row(std::span<const glm::vec3> colours) override;

 private:
    void empty_rows_until(std::int64_t y);

    ImageSink& to_;
    bool over_paper_;
    std::optional<DisplayWindow> window_;
    std::int64_t stored_rows_ = 0, first_column_ = 0, end_column_ = 0;
    std::int64_t row_ = 0, next_ = 0;  // that comes in, and that goes out
    std::vector<glm::vec3> shown_;
};

// Pictures whose pixels are no squares, such as a fax of 204 x 98 dots an inch.

/// Passes a picture on with square pixels: where they are wide there will be more columns, where they are
/// high more rows, each the mean of what it covers. The description says so. Pixels that are square within a
/// hundredth, or said to be over four times as long as wide, which is nobody's picture, stay as they are.
class SquarePixels : public ImageSink {
 public:
    explicit SquarePixels(ImageSink& to) : to_(to) {}

    void begin(const ImageHeader& header) override;
    void row(std::span<const glm::vec3> colours) override;

 private:
    ImageSink& to_;
    std::int64_t columns_ = 0, more_columns_ = 0, rows_ = 0, more_rows_ = 0;
    std::int64_t row_ = 0, next_ = 0;  // that comes in, and that goes out
    std::vector<glm::vec3> wider_, before_, mixed_;
};

/// Which channels of a pixel are what.
struct Channels {
    std::array<int, 3> colour{};  // three times the same: grey
    std::optional<int> alpha;
    bool grey() const { return colour[0] == colour[1] && colour[1] == colour[2]; }
};

struct PixelLayout {
    Channels channels;
    int count = 1;  // channels of a pixel
    Encoding encoding;
    std::string profile{};               // ICC's bytes, which count for more; empty: none
    std::optional<glm::mat3> to_srgb{};  // of light, from other primaries or an exposure
    bool premultiplied = false;          // colours by alpha
    bool over_paper = true;              // white behind what is transparent; else black
    bool eight_bit = false;
};

class StoredPixels {
 public:
    explicit StoredPixels(const PixelLayout& layout);

    /// A row, integers scaled to 0..1, as linear light over what is behind. Throws DecodeError if a pixel is
    /// not a number, infinite, or lighter than any is.
    void decode(std::span<const float> stored, int y, std::span<glm::vec3> light);

 private:
    void decode_by_profile(std::span<const float> stored, std::span<glm::vec3> light);
    glm::vec3 over_what_is_behind(const float* pixel) const;
    glm::vec3 light_of(const float* pixel, float factor) const;

    PixelLayout layout_;
    float behind_;
    std::array<float, 256> eight_bit_{};
    ColourProfile profile_;
    std::vector<float> colours_;  // of a row, for the profile
};

/// "512 x 512 pixels, 8-bit grey png". `kind` is "8-bit" or "float".
std::string describe(int width, int height, const std::string& kind, const Channels& channels,
                     const std::string& format);

}  // namespace dapple
