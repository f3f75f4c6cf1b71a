#pragma once
// Pictures for tests to read, written with OpenImageIO.

#include <filesystem>
#include <string>
#include <vector>

namespace dapple {

/// Values are written as they are, 0..1 being the whole range of integer types.
struct PictureFile {
    int width = 1, height = 1, channels = 1;
    std::vector<float> values = {};  // width * height * channels
    std::string type = "uint8";
    std::string colour_space = "";  // "" leaves it to the format
    std::string profile = "";       // ICC's bytes
    int orientation = 1;            // EXIF's
    int tile = 0;                   // side of the file's tiles, 0 for scan lines
    int strip = 0;                  // rows of a TIFF's strips; 0 leaves it to the format
    bool planes = false;            // of a TIFF, each channel by itself
    bool premultiplied = false;     // values are colours times alpha already; as EXR always has them
    bool append = false;            // as a further picture of a file that there is
};

/// The format is told by the name. Throws std::runtime_error if it fails.
void write_picture(const std::filesystem::path& path, const PictureFile& picture);

}  // namespace dapple
