#include "app/viewer/model/thumbnail.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/files/picture.h"
#include "app/viewer/model/mipmaps.h"

namespace dapple {

std::string thumbnail_key(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    const auto written = std::filesystem::last_write_time(file, ignored).time_since_epoch().count();
    return fmt::format("{} {} {}", file.string(), size, written);
}

SmallPicture small_copy(const std::vector<SmallPicture>& mipmaps, int longest_side) {
    const auto fits = [&](const SmallPicture& copy) {
        return std::max(copy.width, copy.height) <= longest_side;
    };
    const auto first = std::ranges::find_if(mipmaps, fits);
    return first == mipmaps.end() ? SmallPicture{} : *first;
}

SmallPicture thumbnail_of(const std::filesystem::path& file, const std::stop_token& stop) {
    if (std::filesystem::file_size(file) > kLargestThumbnailFile) return {};
    auto picture = read_first_look(file, PictureColours::left_out, stop);
    if (!picture) picture = read_picture(file, PictureLimit::usual, PictureColours::left_out, stop);
    return small_copy(mipmaps_of(std::move(picture->preview)), kThumbnailSide);
}

}  // namespace dapple
