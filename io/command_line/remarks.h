#pragma once
// What people should know of how a picture was read, on the standard error.

#include <filesystem>
#include <string>

#include "io/files/picture.h"

namespace dapple {

/// "dapple: cat.exr: the file has ..."; nothing where there is no remark.
void print_remark(const std::filesystem::path& file, const std::string& remark);

/// The same as read_picture(), and prints what there is to remark on.
Picture read_with_remark(const std::filesystem::path& file, PictureLimit limit = PictureLimit::usual,
                         PictureColours colours = PictureColours::left_out);

}  // namespace dapple
