#pragma once
// A decoded picture through a pipe, from the decoder's process to ours.
//
// First, where it is known, how much there is to decode; then a byte that says what follows: the header and
// all rows, or why there is none. Numbers are as this machine stores them: both ends are the same program's.
// But a file may have taken hold of the decoder's: nothing that comes out is believed.

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "io/decoding/decoded_image.h"

namespace dapple {

/// What a picture fails by: its file, its size, or what has nothing to do with it.
enum class PictureFailure { file, too_many_pixels, system };

/// The decoder's end. The header goes out with the first row, so that nothing is made ready at the other end
/// for a picture that turns out damaged at once.
class ImagePipe : public ImageSink {
 public:
    explicit ImagePipe(int descriptor) : descriptor_(descriptor) {}

    /// Before the picture begins: memory for so many bytes of pixels is about to be taken.
    void expect(std::uint64_t pixel_bytes);
    void begin(const ImageHeader& header) override;
    void row(std::span<const glm::vec3> colours) override;
    /// After the last row.
    void finish() { flush(); }
    /// In place of rows that are still to come.
    void fail(const std::string& sentence, PictureFailure by);

 private:
    void put(const void* bytes, std::size_t size);
    void put_text(const std::string& text);
    void flush();

    int descriptor_;
    ImageHeader header_;
    bool started_ = false;
    std::vector<char> buffer_;
};

/// How long the other end waits in all for what the decoder sends: so long, and as long as a decoder may work
/// on as many bytes as it says it expects, within what a picture of the request can have. One that works ends
/// by its own limits; this is for one that does not.
struct DecoderPatience {
    std::chrono::milliseconds at_first = std::chrono::minutes(2), per_megabyte = std::chrono::seconds(1);
};

/// The other end. Gives the picture to the sink; true once all rows have come and the pipe has ended, false
/// if it ended before. Throws DecodeError or TooManyPixels with what the decoder says; DecodeError for what
/// no decoder says, whether a header, a row that breaks ImageSink's contract or something after the last one;
/// and when it has waited for too long.
bool receive_image(int descriptor, const DecodeRequest& request, ImageSink& sink,
                   const DecoderPatience& patience = {});

}  // namespace dapple
