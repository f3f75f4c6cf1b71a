#pragma once
// Pictures whose pixels are no squares, such as a fax of 204 x 98 dots an inch.

#include <vector>

#include "io/decoding/decoded_image.h"

namespace dapple {

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

}  // namespace dapple
