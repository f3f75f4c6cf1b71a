#pragma once
// Small pictures of files that programs share, by the Thumbnail Managing Standard 0.9 of freedesktop.org: of
// file:///home/ada/a.png in large/2b4f...png, which is named by that URI's MD5.

#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <optional>
#include <stop_token>
#include <string>

#include "app/decoding/decoded_image.h"
#include "core/image/grid.h"

namespace dapple {

/// The longer side of those that are kept is at most this, in pixels.
inline constexpr int kLargeThumbnailSide = 256;

/// What is kept of one file as it is at this moment.
class ThumbnailCache {
 public:
    /// `folder`: $XDG_CACHE_HOME/thumbnails. Empty: nothing is found or kept.
    ThumbnailCache(std::filesystem::path folder, const std::filesystem::path& file);

    /// A picture that any program made of the file since it was last written, of any size; an empty one if we
    /// could make none. Nothing: there is neither.
    std::optional<Grid<glm::u8vec4>> find(const std::stop_token& stop) const;

    /// For find() from now on, in folders and files that are the person's alone. An empty picture: none can
    /// be made. What cannot be written is not kept.
    void keep(const Grid<glm::u8vec4>& picture) const;

 private:
    std::optional<Grid<glm::u8vec4>> read(const std::filesystem::path& kept,
                                          const std::stop_token& stop) const;

    std::filesystem::path folder_;  // empty: neither found nor kept
    ThumbnailSubject subject_;
    std::string name_;
};

}  // namespace dapple
