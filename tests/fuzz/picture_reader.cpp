#include "tests/fuzz/picture_reader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <exception>
#include <stdexcept>

#include "io/decoding/decoded_image.h"
#include "io/decoding/decoder_limits.h"

namespace dapple {
namespace {

class Forgetful : public ImageSink {
 public:
    void begin(const ImageHeader&) override {}
    void row(std::span<const glm::vec3>) override {}
};

}  // namespace

void read_any_picture(PictureFormat format, const std::string& bytes) {
    const int file = ::memfd_create("picture", 0);
    if (file < 0 || ::write(file, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error("no memory for a file");
    ::lseek(file, 0, SEEK_SET);
    // Smaller pictures than people may have: hundreds of megapixels of nothing take their time.
    constexpr std::int64_t kMostPixels = 20'000'000;
    limit_decoder_memory(0);
    Forgetful sink;
    try {
        // The side is for the reader of smaller pictures; others give the whole one.
        decode(
            file, format, {.most_pixels = kMostPixels, .enough_side = 8},
            [](const PixelBytes& pixels) { limit_decoder_memory(pixels.in_memory); }, sink);
    } catch (const std::exception&) {
    }
    ::close(file);
}

}  // namespace dapple
