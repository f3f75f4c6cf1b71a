// A picture in memory, a shaded disc, as 40,000 dots in an SVG: disc_to_svg disc.svg
#include <dapple/core/drawing/stippler.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <vector>

int main(int argc, char** argv) try {
    if (argc != 2) return std::fputs("usage: disc_to_svg FILE.svg\n", stderr), 2;
    constexpr int kSide = 400;
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double across = x / 200.0 - 1, down = y / 200.0 - 1,
                         height2 = 0.8 - across * across - down * down;
            pixels.push_back(height2 < 0 ? 255 : static_cast<std::uint8_t>(230 * std::sqrt(height2)));
        }
    }
    dapple::Stippler stippler;
    stippler.set_picture(dapple::picture_of_srgb(pixels, kSide, kSide, 1));
    dapple::Settings settings;
    settings.drawing.page.width_mm = 150;
    const auto drawing = stippler.draw(settings);
    std::ofstream file(argv[1]);
    drawing->write(file, dapple::DrawingFormat::svg);
    if (!file.flush()) return std::fprintf(stderr, "%s: cannot be written\n", argv[1]), 1;
} catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
}
