#include <fmt/format.h>
#include <stb_image.h>

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/image/tone.h"
#include "io/files/picture.h"

namespace dapple {

Picture decode_png(std::string_view bytes, PictureColours colours) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                              &width, &height, &channels, STBI_rgb_alpha),
        &stbi_image_free);
    if (!pixels) throw std::runtime_error("the picture in memory is not a PNG that can be read");

    std::array<float, 256> linear;
    for (int i = 0; i < 256; ++i) linear[i] = srgb_to_linear(static_cast<float>(i) / 255.0f);

    PictureBuilder builder(width, height, {}, colours);
    std::vector<glm::vec3> row(width);
    const stbi_uc* pixel = pixels.get();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, pixel += 4) {
            const float alpha = static_cast<float>(pixel[3]) / 255.0f;
            const glm::vec3 colour{linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]};
            row[x] = colour * alpha + (1.0f - alpha);
        }
        builder.add_row(y, row);
    }
    return builder.finish(fmt::format("{} x {} pixels, 8-bit png", width, height));
}

}  // namespace dapple
