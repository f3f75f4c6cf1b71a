#include "app/viewer/model/thumbnail.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <system_error>
#include <utility>

#include "app/files/picture.h"

namespace dapple {
namespace {

// Smaller, so that it is as large as a thumbnail may be; each pixel is the mean of what it covers.
SmallPicture fitted(const SmallPicture& picture) {
    const int longer = std::max(picture.width, picture.height);
    if (longer <= kLargeThumbnailSide) return picture;
    const double step = static_cast<double>(longer) / kLargeThumbnailSide;
    const auto side = [&](int whole) { return std::max(static_cast<int>(std::lround(whole / step)), 1); };
    SmallPicture small(side(picture.width), side(picture.height));
    const glm::dvec2 covered{static_cast<double>(picture.width) / small.width,
                             static_cast<double>(picture.height) / small.height};
    // How much of the pixel at `place` lies in the stretch from `begin` to `end`.
    const auto share = [](int place, double begin, double end) {
        return std::min(place + 1.0, end) - std::max<double>(place, begin);
    };
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            const glm::dvec2 begin = glm::dvec2(x, y) * covered, end = begin + covered;
            const int right = std::min(static_cast<int>(std::ceil(end.x)), picture.width),
                      bottom = std::min(static_cast<int>(std::ceil(end.y)), picture.height);
            glm::dvec4 sum(0);
            double weight = 0;
            for (int from_y = static_cast<int>(begin.y); from_y < bottom; ++from_y) {
                for (int from_x = static_cast<int>(begin.x); from_x < right; ++from_x) {
                    const double area = share(from_x, begin.x, end.x) * share(from_y, begin.y, end.y);
                    sum += area * glm::dvec4(picture.at(from_x, from_y));
                    weight += area;
                }
            }
            small.at(x, y) = glm::u8vec4(sum / weight + 0.5);
        }
    }
    return small;
}

}  // namespace

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

SmallPicture thumbnail_of(const std::filesystem::path& file, const std::filesystem::path& kept,
                          const std::stop_token& stop) {
    if (std::filesystem::file_size(file) > kLargestThumbnailFile) return {};
    const ThumbnailCache cache(kept, file);
    if (auto found = cache.find(stop)) return fitted(*found);
    SmallPicture small;
    try {
        auto picture = read_first_look(file, PictureColours::left_out, stop);
        if (!picture) picture = read_picture(file, PictureLimit::usual, PictureColours::left_out, stop);
        small = fitted(picture->preview);
    } catch (const NoPicture&) {
        cache.keep({});
        throw;
    }
    cache.keep(small);
    return small;
}

}  // namespace dapple
