#include "core/lights/light_picture.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/image/colour.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

constexpr int kWidth = 2048;
constexpr double kRim = 1.1;  // pixels

glm::u8vec3 mixed(glm::u8vec3 under, double over, double share) {
    const glm::dvec3 colour = glm::mix(glm::dvec3(under), glm::dvec3(over), std::clamp(share, 0.0, 1.0));
    return glm::u8vec3(colour + 0.5);
}

void draw_disc(Grid<glm::u8vec3>& picture, glm::dvec2 centre, double radius, double grey) {
    const int reach = static_cast<int>(radius) + 2;
    const int cx = static_cast<int>(centre.x), cy = static_cast<int>(centre.y);
    for (int y = std::max(cy - reach, 0); y <= std::min(cy + reach, picture.height - 1); ++y) {
        for (int x = cx - reach; x <= cx + reach; ++x) {
            const double away = glm::distance(glm::dvec2(x + 0.5, y + 0.5), centre);
            glm::u8vec3& pixel = picture.at((x % picture.width + picture.width) % picture.width, y);
            pixel = mixed(pixel, grey, radius + 0.5 - away);
        }
    }
}

}  // namespace

double natural_exposure(const EnvironmentMap& map) {
    double sum = 0, area = 0;
    for (int y = 0; y < map.height(); ++y) {
        const double weight = map.solid_angle(y);
        double lights = 1;  // four at most, whose product is within a double's range: fewer logarithms
        for (int x = 0; x < map.width(); ++x) {
            const double light = luminance(map.radiance().at(x, y));
            if (light > 0) {
                lights *= light;
                area += weight;
            }
            if (x % 4 < 3) continue;
            sum += weight * portable::log(lights);
            lights = 1;
        }
        sum += weight * portable::log(lights);
    }
    return area > 0 ? 0.18 / portable::exp(sum / area) : 1;
}

glm::u8vec3 tone_mapped(const glm::dvec3& radiance, double exposure) {
    const glm::dvec3 light = radiance * exposure;
    const glm::dvec3 pressed = light * (1.25 / (1 + luminance(light)));
    return srgb_bytes(glm::vec3(pressed));
}

Grid<glm::u8vec3> light_picture(const EnvironmentMap& map, std::span<const glm::dvec2> places,
                                double exposure, double disc_radius) {
    const int times = std::max(1, (kWidth + map.width() - 1) / map.width());
    Grid<glm::u8vec3> picture(map.width() * times, map.height() * times);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.at(x, y) = tone_mapped(map.radiance().at(x / times, y / times), exposure);
    // All rims first, so that dense discs don't hide each other.
    const glm::dvec2 size(picture.width, picture.height);
    for (const glm::dvec2 p : places) draw_disc(picture, p * size, disc_radius + kRim, 20);
    for (const glm::dvec2 p : places) draw_disc(picture, p * size, disc_radius, 255);
    return picture;
}

}  // namespace dapple
