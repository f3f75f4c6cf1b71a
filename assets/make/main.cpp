/// make_assets FOLDER: writes the sample picture and the window icons. Run again only when they shall change.
#include <stb_image_write.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets/make/icon.h"
#include "assets/make/render_stage.h"
#include "assets/make/still_life.h"

namespace {

using namespace dapple::make;

void write_png(const std::filesystem::path& path, int size, int channels,
               const std::vector<std::uint8_t>& pixels) {
    if (!stbi_write_png(path.c_str(), size, size, channels, pixels.data(), size * channels))
        throw std::runtime_error(path.string() +
                                 ": cannot be written; give a folder that exists and is yours.");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::runtime_error("make_assets needs one argument, the folder to write into.");
    const std::filesystem::path folder = argv[1];
    stbi_write_png_compression_level = 64;  // the length of its search; the default saves time, not bytes
    for (int size : {16, 32, 64})
        write_png(folder / ("icon_" + std::to_string(size) + ".png"), size, 4, icon(size));
    const Quality quality;
    write_png(folder / "still_life.png", quality.size, 1, render(Stage(still_life()), quality));
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
