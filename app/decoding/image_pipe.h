#pragma once
// A decoded picture through a pipe, from the decoder's process to ours.
//
// First a byte that says what follows: the header and all rows, or why there is none. Numbers are as this
// machine stores them: both ends are the same program's.

#include <string>
#include <vector>

#include "app/decoding/decoded_image.h"

namespace dapple {

/// The decoder's end. The header goes out with the first row, so that nothing is made ready at the other end
/// for a picture that turns out damaged at once.
class ImagePipe : public ImageSink {
 public:
    explicit ImagePipe(int descriptor) : descriptor_(descriptor) {}

    void begin(const ImageHeader& header) override;
    void row(std::span<const glm::vec3> colours) override;
    /// After the last row.
    void finish();
    /// In place of rows that are still to come.
    void fail(const std::string& sentence, bool too_many_pixels);

 private:
    void put(const void* bytes, std::size_t size);
    void put_text(const std::string& text);
    void flush();

    int descriptor_;
    ImageHeader header_;
    bool started_ = false;
    std::vector<char> buffer_;
};

/// The other end. Gives the picture to the sink; true once all rows have come, false if the pipe ended
/// before. Throws DecodeError or TooManyPixels with what the decoder says, and for what no decoder says.
bool receive_image(int descriptor, const DecodeRequest& request, ImageSink& sink);

}  // namespace dapple
