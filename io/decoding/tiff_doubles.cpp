#include "io/decoding/tiff_doubles.h"

#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "io/decoding/decoded_image.h"

namespace dapple {

TiffDoubles::TiffDoubles(int file, int page, int width, int height, int channels)
    // "m": by reading; a file that gets shorter meanwhile would end the process.
    : tiff_(::TIFFFdOpen(::dup(file), "picture", "rm"), &::TIFFClose) {
    if (!tiff_ || ::TIFFSetDirectory(tiff_.get(), static_cast<tdir_t>(page)) == 0)
        throw DecodeError("not a picture that can be read");
    const auto number = [this](std::uint32_t tag) {
        std::uint32_t value = 0;
        ::TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
        return static_cast<int>(std::min<std::uint32_t>(value, INT32_MAX));
    };
    const auto short_number = [this](std::uint32_t tag) {
        std::uint16_t value = 0;
        ::TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
        return static_cast<int>(value);
    };
    width_ = number(TIFFTAG_IMAGEWIDTH);
    height_ = number(TIFFTAG_IMAGELENGTH);
    channels_ = short_number(TIFFTAG_SAMPLESPERPIXEL);
    in_planes_ = short_number(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    tiled_ = ::TIFFIsTiled(tiff_.get()) != 0;
    piece_width_ = tiled_ ? number(TIFFTAG_TILEWIDTH) : width_;
    piece_height_ = tiled_ ? number(TIFFTAG_TILELENGTH) : std::min(number(TIFFTAG_ROWSPERSTRIP), height_);
    if (short_number(TIFFTAG_BITSPERSAMPLE) != 64 || width_ != width || height_ != height ||
        channels_ != channels || piece_width_ <= 0 || piece_height_ <= 0)
        throw DecodeError("not a picture that can be read");
    const tmsize_t bytes = tiled_ ? ::TIFFTileSize(tiff_.get()) : ::TIFFStripSize(tiff_.get());
    piece_.resize(static_cast<std::size_t>(bytes) / sizeof(double));
}

void TiffDoubles::read(int begin, int end, float* pixels) {
    const int planes = in_planes_ ? channels_ : 1, per_plane = channels_ / planes;
    const auto read_piece = [&](int x, int y, int plane, int rows) {
        const auto ux = static_cast<std::uint32_t>(x), uy = static_cast<std::uint32_t>(y);
        const auto sample = static_cast<std::uint16_t>(plane);
        const auto bytes = static_cast<tmsize_t>(piece_.size() * sizeof(double));
        const tmsize_t got =
            tiled_ ? ::TIFFReadEncodedTile(tiff_.get(), ::TIFFComputeTile(tiff_.get(), ux, uy, 0, sample),
                                           piece_.data(), bytes)
                   : ::TIFFReadEncodedStrip(tiff_.get(), ::TIFFComputeStrip(tiff_.get(), uy, sample),
                                            piece_.data(), bytes);
        const std::size_t needed = static_cast<std::size_t>(piece_width_) * per_plane *
                                   static_cast<std::size_t>(tiled_ ? piece_height_ : rows) * sizeof(double);
        if (got < 0 || static_cast<std::size_t>(got) < needed || piece_.size() * sizeof(double) < needed)
            throw DecodeError("the picture is damaged (row " + std::to_string(y) + " is not there)");
    };
    for (int y = begin; y < end; y += piece_height_) {
        const int rows = std::min(piece_height_, height_ - y), kept_rows = std::min(rows, end - y);
        for (int x = 0; x < width_; x += piece_width_) {
            const int columns = std::min(piece_width_, width_ - x);
            for (int plane = 0; plane < planes; ++plane) {
                read_piece(x, y, plane, rows);
                for (int row = 0; row < kept_rows; ++row) {
                    const double* from =
                        piece_.data() + static_cast<std::size_t>(row) * piece_width_ * per_plane;
                    float* to =
                        pixels + (static_cast<std::size_t>(y - begin + row) * width_ + x) * channels_ + plane;
                    for (int column = 0; column < columns; ++column, to += channels_) {
                        for (int k = 0; k < per_plane; ++k) to[k] = static_cast<float>(*from++);
                    }
                }
            }
        }
    }
}

}  // namespace dapple
