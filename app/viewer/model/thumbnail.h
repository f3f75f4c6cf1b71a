#pragma once
// Picture files, small enough for a list.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/files/thumbnail_cache.h"
#include "app/viewer/model/small_pictures.h"

namespace dapple {

/// A larger file is not read for it.
inline constexpr std::uintmax_t kLargestThumbnailFile = 200'000'000;

/// A key for the file as it is now: another one once it is written anew.
std::string thumbnail_key(const std::filesystem::path& file);

/// The longer side is at most kLargeThumbnailSide. What is kept of the file in the folder of all programs'
/// thumbnails is used, and kept there if it is not; see thumbnail_cache.h. Empty if the file is too large, or
/// is known to be no picture. Throws as read_picture().
SmallPicture thumbnail_of(const std::filesystem::path& file, const std::filesystem::path& kept,
                          const std::stop_token& stop);

/// The largest of the copies that mipmaps_of() makes of a picture whose longer side is no longer than that;
/// empty if there is none.
SmallPicture small_copy(const std::vector<SmallPicture>& mipmaps, int longest_side);

}  // namespace dapple
