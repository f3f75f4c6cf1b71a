#include "app/files/thumbnail_cache.h"

#include <glib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/files/atomic_file.h"
#include "app/files/picture.h"
#include "app/files/png_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

using GlibText = std::unique_ptr<gchar, decltype(&g_free)>;

// Each program and version has its own: another may know more formats.
constexpr const char* kFailures = "fail/dapple-" DAPPLE_VERSION;

bool lies_in(const fs::path& folder, const fs::path& file) {
    const fs::path from_there = file.lexically_relative(folder);
    return !from_there.empty() && *from_there.begin() != "..";
}

// With the folders above it that are missing.
void make_private_folder(const fs::path& folder) {
    if (!fs::exists(folder.parent_path())) make_private_folder(folder.parent_path());
    if (::mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST)
        throw std::system_error(errno, std::generic_category());
}

}  // namespace

ThumbnailCache::ThumbnailCache(fs::path folder, const fs::path& file) {
    const fs::path whole = fs::absolute(file).lexically_normal();
    struct stat now {};
    if (folder.empty() || lies_in(folder, whole) || ::stat(whole.c_str(), &now) != 0) return;
    if (::access(whole.c_str(), R_OK) != 0) return;  // what it shows is not for this person
    const GlibText uri(g_filename_to_uri(whole.c_str(), nullptr, nullptr), &g_free);
    if (!uri) return;
    const GlibText md5(g_compute_checksum_for_string(G_CHECKSUM_MD5, uri.get(), -1), &g_free);
    folder_ = std::move(folder);
    subject_ = {.uri = uri.get(), .modified = std::to_string(now.st_mtime)};
    name_ = std::string(md5.get()) + ".png";
}

std::optional<Grid<glm::u8vec4>> ThumbnailCache::read(const fs::path& kept,
                                                      const std::stop_token& stop) const {
    std::error_code ignored;
    if (!fs::is_regular_file(kept, ignored)) return std::nullopt;
    try {
        Picture picture = read_picture(kept, PictureLimit::usual, PictureColours::left_out, stop);
        if (picture.thumbnail_of == subject_) return std::move(picture.preview);
    } catch (const std::runtime_error&) {
        // A new one will take its place.
    }
    return std::nullopt;
}

std::optional<Grid<glm::u8vec4>> ThumbnailCache::find(const std::stop_token& stop) const {
    if (folder_.empty()) return std::nullopt;
    for (const char* size : {"large", "x-large", "xx-large", "normal"})
        if (auto found = read(folder_ / size / name_, stop)) return found;
    if (read(folder_ / kFailures / name_, stop)) return Grid<glm::u8vec4>();
    return std::nullopt;
}

void ThumbnailCache::keep(const Grid<glm::u8vec4>& picture) const {
    if (folder_.empty()) return;
    Grid<glm::u8vec3> pixels(1, 1);  // of a failure, which nobody looks at
    if (!picture.empty()) {
        pixels = Grid<glm::u8vec3>(picture.width, picture.height);
        std::ranges::copy(picture.values, pixels.values.begin());
    }
    const fs::path folder = folder_ / (picture.empty() ? kFailures : "large");
    try {
        make_private_folder(folder);
        save_atomically(folder / name_, [&](std::ostream& out) {
            write_png(out,
                      {.width = pixels.width,
                       .height = pixels.height,
                       .texts = {{kThumbnailUri, subject_.uri},
                                 {kThumbnailTime, subject_.modified},
                                 {"Software", "Dapple"}}},
                      [&](const PixelSink& sink) { sink(pixels); });
        });
        fs::permissions(folder / name_, fs::perms::owner_read | fs::perms::owner_write);
    } catch (const std::runtime_error&) {
        // It is made again the next time.
    }
}

}  // namespace dapple
