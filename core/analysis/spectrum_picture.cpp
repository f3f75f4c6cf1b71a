#include "core/analysis/spectrum_picture.h"

#include <algorithm>
#include <cmath>

namespace dapple {
namespace {

constexpr glm::u8vec3 kPeakColour{255, 140, 0};

glm::u8vec3 grey_of(float power) {
    const double share = std::log1p(double(power)) / std::log1p(double(kPeakPower));
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * std::min(share, 1.0)));
    return {grey, grey, grey};
}

// The spectrum as it will be coloured, a value a pixel: both halves, shrunk by a whole number, highest first.
Grid<float> shrunk(const Periodogram& spectrum, int bins_per_pixel) {
    const int reach_x = spectrum.max_x / bins_per_pixel, reach_y = spectrum.max_y / bins_per_pixel;
    Grid<float> powers(2 * reach_x + 1, 2 * reach_y + 1);
    const auto place = [&](int k, int reach) {
        // Rounds to the nearest pixel, halves away from 0, so that k and -k land opposite each other.
        const int pixel = (std::abs(k) + bins_per_pixel / 2) / bins_per_pixel;
        return std::min(pixel, reach) * (k < 0 ? -1 : 1) + reach;
    };
    for (int i = -spectrum.max_x; i <= spectrum.max_x; ++i)
        for (int j = -spectrum.max_y; j <= spectrum.max_y; ++j) {
            if (i == 0 && j == 0) continue;
            float& power = powers.at(place(i, reach_x), place(j, reach_y));
            power = std::max(power, spectrum.at(i, j));
        }
    return powers;
}

}  // namespace

Grid<glm::u8vec3> spectrum_picture(const Periodogram& spectrum, int longer_side) {
    const int bins = 2 * std::max(spectrum.max_x, spectrum.max_y) + 1;
    const int bins_per_pixel = (bins + longer_side - 1) / longer_side;
    const Grid<float> powers = shrunk(spectrum, std::max(bins_per_pixel, 1));
    const int times = std::max(1, longer_side / std::max(powers.width, powers.height));

    Grid<glm::u8vec3> picture(powers.width * times, powers.height * times);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) picture.at(x, y) = grey_of(powers.at(x / times, y / times));

    const int margin = times < 3 ? 1 : 0;
    for (int y = 0; y < powers.height; ++y)
        for (int x = 0; x < powers.width; ++x) {
            if (!(powers.at(x, y) > kPeakPower)) continue;
            for (int v = std::max(0, y * times - margin);
                 v < std::min(picture.height, (y + 1) * times + margin); ++v)
                for (int u = std::max(0, x * times - margin);
                     u < std::min(picture.width, (x + 1) * times + margin); ++u)
                    picture.at(u, v) = kPeakColour;
        }
    return picture;
}

}  // namespace dapple
