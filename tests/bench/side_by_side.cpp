#include "tests/bench/side_by_side.h"

#include <algorithm>
#include <cmath>

#include "core/image/tone.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "lab/compare/picture_marks.h"

namespace dapple {
namespace {

constexpr int kGap = 12;  // px

std::uint8_t encoded(float light) {
    return static_cast<std::uint8_t>(std::lround(255 * linear_to_srgb(std::clamp(light, 0.0f, 1.0f))));
}

}  // namespace

SideBySide::SideBySide(const Grid<float>& light, int width) : page_(page_of_width(light, width)) {
    panels_.push_back(resampled(light, page_));
}

void SideBySide::add(std::span<const glm::dvec2> dots, double radius) {
    panels_.push_back(raster_of_dots(dots, radius, page_));
    for (float& value : panels_.back().values) value = 1 - value;
}

void SideBySide::save(const std::filesystem::path& file) const {
    const int panels = int(panels_.size());
    Grid<glm::u8vec3> whole(panels * page_.width + (panels - 1) * kGap, page_.height, glm::u8vec3(255));
    for (int i = 0; i < panels; ++i) {
        for (int y = 0; y < page_.height; ++y) {
            glm::u8vec3* const row = whole.row(y) + i * (page_.width + kGap);
            for (int x = 0; x < page_.width; ++x) row[x] = glm::u8vec3(encoded(panels_[i].at(x, y)));
        }
    }
    save_atomically(file, [&](std::ostream& out) {
        write_png(out, {whole.width, whole.height, 96, PngColours::grey},
                  [&](const PixelSink& sink) { sink(whole); });
    });
}

}  // namespace dapple
