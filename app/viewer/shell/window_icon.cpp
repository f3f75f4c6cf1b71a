#include "app/viewer/shell/window_icon.h"

#include <GLFW/glfw3.h>
#include <stb_image.h>

#include <memory>
#include <string_view>
#include <vector>

#include "dapple_assets_embedded/assets.h"

namespace dapple {

void set_window_icon(GLFWwindow* window) {
    std::vector<std::unique_ptr<stbi_uc, decltype(&stbi_image_free)>> pixels;
    std::vector<GLFWimage> icons;
    for (std::string_view png : {assets::icon_16_png(), assets::icon_32_png(), assets::icon_64_png()}) {
        GLFWimage icon{};
        icon.pixels =
            stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                                  &icon.width, &icon.height, nullptr, 4);
        if (!icon.pixels) continue;
        pixels.emplace_back(icon.pixels, &stbi_image_free);
        icons.push_back(icon);
    }
    glfwSetWindowIcon(window, static_cast<int>(icons.size()), icons.data());
}

}  // namespace dapple
