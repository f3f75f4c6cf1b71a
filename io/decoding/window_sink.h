#pragma once
// Pictures of which a file has only a part, or more: EXR's data window and display window, and TIFF's sizes
// of the whole.

#include <vector>

#include "io/decoding/decoded_image.h"

namespace dapple {

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

}  // namespace dapple
