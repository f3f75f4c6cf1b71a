#pragma once
// A picture file's content on its way from a decoder: what comes first, then its rows.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "io/decoding/decoder_limits.h"
#include "io/decoding/picture_format.h"

namespace dapple {

// How the camera was held, as EXIF tells it: a TIFF's first directory, tag 274.

/// The EXIF orientation, 1..8. 1 and any other number are upright; 5..8 swap width and height.
struct ExifOrientation {
    int value = 1;
    bool swaps_sides() const { return value >= 5 && value <= 8; }
    /// Where pixel (x, y) of a stored picture of the given size belongs when it is held upright.
    glm::ivec2 upright(int x, int y, int width, int height) const;
};

/// Some bytes of an open file as a whole number; 0 where it ends before.
std::uint64_t number_in_file(int file, std::uint64_t at, int bytes, bool big_endian = true);

/// The orientation, 1..8, in an EXIF block without what its file puts before it. 1, upright, if there is none
/// or it is damaged.
int orientation_in(std::span<const unsigned char> exif);

inline constexpr std::int64_t kUsualPixels = 400'000'000;
inline constexpr std::int64_t kAnyPixels = INT64_MAX;

/// A picture's size, and where in it the first stored pixel lies, which may be outside.
struct DisplayWindow {
    int width = 0, height = 0;
    std::int64_t x = 0, y = 0;
};

struct ImageHeader {
    int width = 0, height = 0;  // as stored, over 0
    int orientation = 1;        // EXIF's, 1..8: how the camera was held
    bool grey = false;          // red, green and blue are the same everywhere
    std::string description;    // "512 x 512 pixels, 8-bit grey png"
    bool scene_light = false;   // as it was in front of a camera, where white is not 1
    float pixel_aspect = 1;     // a pixel's width for its height; where a picture arrives it is always 1
    std::optional<DisplayWindow>
        window{};          // of a picture that is not just what is stored; never where it arrives
    std::string remark{};  // what people should know of how it was read; usually nothing
};

/// Lighter than anything in a picture, and little enough for sums and squares of it to stay numbers.
inline constexpr float kMostLightOfAPixel = 1e18f;

/// Takes a picture: begin() once, then row() for each row from the top down.
class ImageSink {
 public:
    virtual ~ImageSink() = default;

    virtual void begin(const ImageHeader& header) = 0;
    /// Linear light, `width` colours: numbers, none further from 0 than kMostLightOfAPixel. Some are below 0
    /// in pictures of floats.
    virtual void row(std::span<const glm::vec3> colours) = 0;
};

struct DecodeRequest {
    bool over_paper = true;     // transparent and missing parts show white paper; else they are black
    bool square_pixels = true;  // else they stay as they are stored, whatever their shape
    std::int64_t most_pixels = kUsualPixels;  // larger ones are refused before they are read
    /// A smaller picture will do whose longer side is at least so many pixels; it is refused if the whole one
    /// is hardly larger, or has no such copy in its file. 0: the whole one, which PNG's decoder gives anyway.
    int enough_side = 0;
};

/// Why a file is no picture: a sentence without the file's name.
struct DecodeError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
inline constexpr const char* kTooMuchMemory = "needs more memory to decode than a picture of its size should";
inline constexpr const char* kTooMuchTime = "takes far longer to decode than a picture of its size should";
/// It has more pixels than asked for.
struct TooManyPixels : DecodeError {
    using DecodeError::DecodeError;
};

/// Throws TooManyPixels, or DecodeError for what no picture has (no pixels, hundreds of channels).
void check_size(std::int64_t width, std::int64_t height, int channels, const DecodeRequest& request);

// Decoding with a library: each decoder program is linked with one of the functions that do it.

/// Called when the size is known, before the pixels are read, and before that with what a file merely states,
/// which is no less.
using BeforePixels = std::function<void(const PixelBytes&)>;

/// Reads the picture behind an open file descriptor, which stays open. Throws DecodeError with a sentence
/// that does not name the file; what the sink throws passes through.
void decode(int file, PictureFormat format, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink);

}  // namespace dapple
