#pragma once
// Picture files, small enough for a list.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/viewer/model/small_pictures.h"

namespace dapple {

/// The longer side is at most this, in pixels, and more than half of it unless the picture is smaller.
inline constexpr int kThumbnailSide = 192;

/// A larger file is not read for it.
inline constexpr std::uintmax_t kLargestThumbnailFile = 200'000'000;

/// Of the file as it is now: another once it is written anew.
std::string thumbnail_key(const std::filesystem::path& file);

/// Empty if the file is too large. Throws as read_picture().
SmallPicture thumbnail_of(const std::filesystem::path& file, const std::stop_token& stop);

/// Of the copies that mipmaps_of() makes of a picture, the largest that is so small.
SmallPicture small_copy(const std::vector<SmallPicture>& mipmaps, int longest_side);

}  // namespace dapple
