#pragma once
// Environment maps from files.

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <stop_token>
#include <string>

#include "core/image/environment.h"
#include "core/image/grid.h"

namespace dapple {

// OpenEXR into a stream: a grid of floats.

/// The channel Y, which is grey. Not compressed.
void write_exr(std::ostream& out, const Grid<float>& values);

struct EnvironmentFile {
    EnvironmentMap map;
    bool ends_at_white = false;  // of a picture that was made to be looked at, such as a JPEG
    std::size_t below_zero = 0;  // pixels with light below 0, which was taken as none
    std::string remark{};        // what people should know of how it was read; usually nothing
};

enum class LightBelowZero { refused, none };

/// Reads a latitude-longitude map in any of picture_formats(), Radiance HDR and OpenEXR above all. Float
/// pixels are linear radiance, others sRGB-encoded; grey is taken as white light; what is transparent, or
/// lies outside an EXR's data window, is black. It is turned as the file says, by EXIF's orientation or the
/// order of Radiance's rows.
///
/// Throws std::runtime_error with one sentence if the file is missing, a folder, empty, not a picture,
/// damaged or over 400 megapixels, or reading was stopped, or what EnvironmentMap says, with the file's name
/// before it.
EnvironmentFile read_environment(const std::filesystem::path& path,
                                 LightBelowZero below_zero = LightBelowZero::refused,
                                 const std::stop_token& stop = {});

}  // namespace dapple
