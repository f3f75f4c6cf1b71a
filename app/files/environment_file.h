#pragma once
// Environment maps from files.

#include <filesystem>
#include <stop_token>

#include "core/image/environment.h"

namespace dapple {

/// Reads a latitude-longitude map in any of picture_formats(), Radiance HDR and OpenEXR above all. Float
/// pixels are linear radiance, others sRGB-encoded; grey is taken as white light; transparency is ignored.
///
/// Throws std::runtime_error with one sentence if the file is missing, a folder, empty, not a picture,
/// damaged or over 400 megapixels, or reading was stopped, or what EnvironmentMap says, with the file's name
/// before it.
EnvironmentMap read_environment(const std::filesystem::path& path, const std::stop_token& stop = {});

}  // namespace dapple
