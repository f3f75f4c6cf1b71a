#pragma once
// A picture as light, whatever file it came in.

#include <cstdint>
#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/colour.h"
#include "core/image/grid.h"
#include "io/decoding/decoded_image.h"

namespace dapple {

class Pipeline;

/// The preview's longer side is at most this, in pixels.
inline constexpr int kPreviewSide = 2048;

/// Light has at most so many values: more than two for each dot of the largest drawing that memory holds.
inline constexpr std::int64_t kMostLight = 128 << 20;

struct Picture {
    Grid<float> light{};  // linear luminance over white paper: 0 black, 1 paper, more in HDR pictures
    /// sRGB-encoded colours over white paper, opaque, same aspect as light; exposed by the stops below.
    Grid<glm::u8vec4> preview{};
    ColourGrid colours{};  // of the same pixels, if they were asked for
    /// A value of the light is the mean of so many by so many of the file's pixels: 1, except for pictures
    /// with more pixels than kMostLight. At the right and lower edge it may be the mean of fewer.
    int pixels_in_one = 1;
    /// usual_exposure() of the light if the file has it as it was in front of a camera, else 0.
    float exposure = 0;
    std::string description{};  // "512 x 512 pixels, 8-bit grey png"
    std::string remark{};       // what people should know of how it was read; usually nothing
};

enum class PictureLimit {
    usual,  // up to 400 megapixels
    huge,   // whatever fits in memory
};

enum class PictureColours { left_out, kept };

/// What transparent parts show, and those that the file has no pixels of, such as the outside of an EXR's
/// data window.
enum class PictureBehind { paper, black };

/// Reads the first picture of a file in any of picture_formats(), the right way up.
///
/// Integer pixels are taken as sRGB-encoded and float ones as linear light unless the file says otherwise:
/// for integers an ICC profile counts first, or a PNG's cICP. Luminance has Rec. 709 weights. Pixels that
/// are no squares are made so.
/// Memory: 4 bytes a value of the light, 10 with its colours.
/// Formats are told by content; libraries read them in a process of their own, with limits on memory and
/// time, which on Linux can do nothing else.
///
/// Throws std::runtime_error with one sentence if the file is missing, a folder, empty, not a picture,
/// damaged, too large, has pixels that are NaN or infinite, or reading was stopped.
Picture read_picture(const std::filesystem::path& path, PictureLimit limit = PictureLimit::usual,
                     PictureColours colours = PictureColours::left_out, std::stop_token stop = {},
                     PictureBehind behind = PictureBehind::paper);

/// A first look at a large JPEG or raw file, or at a TIFF or EXR with mipmaps, in a fraction of the time. It
/// is smaller, its longer side kFirstLookSide pixels or up to twice as many, or half of the whole's in a raw
/// file, and described as the whole is. Nothing for a picture that is small, of another kind, or cannot be
/// read: read_picture() says why.
std::optional<Picture> read_first_look(const std::filesystem::path& path,
                                       PictureColours colours = PictureColours::left_out,
                                       std::stop_token stop = {});
inline constexpr int kFirstLookSide = 800;

/// Draws the picture from now on.
void set_picture(Pipeline& pipeline, Picture picture);

/// A PNG in memory, such as the built-in sample. Throws std::runtime_error if it is none.
Picture decode_png(std::string_view bytes, PictureColours colours = PictureColours::left_out);

// Turns rows of colour into a Picture as they are read, so that nothing larger than the light itself is kept.

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

// The picture that the program carries inside itself.

/// A still life of shaded solids, 1024 x 1024.
Picture sample_picture(PictureColours colours = PictureColours::left_out);

}  // namespace dapple
