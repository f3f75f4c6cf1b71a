#pragma once
// The 64-bit floats of a TIFF, which OpenImageIO 2.4 takes for 0 or worse in many files: where rows are asked
// for that are no whole strips, and in all tiles.

#include <memory>
#include <vector>

struct tiff;

namespace dapple {

class TiffDoubles {
 public:
    /// The page that comes after `page` others in an open file, which stays open. Throws DecodeError, also if
    /// it is not of that size.
    TiffDoubles(int file, int page, int width, int height, int channels);

    /// Rows [begin, end) as floats, all channels of a pixel beside each other. `begin` is the first row of a
    /// strip or of a row of tiles. Throws DecodeError if the file does not have them.
    void read(int begin, int end, float* pixels);

 private:
    std::unique_ptr<tiff, void (*)(tiff*)> tiff_;
    int width_ = 0, height_ = 0, channels_ = 1;
    bool tiled_ = false, in_planes_ = false;  // in planes, each channel is by itself
    int piece_width_ = 0, piece_height_ = 0;  // of a strip or tile
    std::vector<double> piece_;
};

}  // namespace dapple
