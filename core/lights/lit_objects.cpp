#include "core/lights/lit_objects.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>

#include "core/image/colour.h"
#include "core/lights/direction.h"
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

double to_the(unsigned exponent, double base) {
    double power = 1;
    for (; exponent > 0; exponent >>= 1, base *= base)
        if (exponent & 1) power *= base;
    return power;
}

constexpr int kGlossyRows = 36;   // a lobe of cosine^kGlossy is 19 degrees wide
constexpr int kGroundSide = 64;   // places along each side of the ground's square
constexpr double kLookDown = 50;  // degrees, on the ground

glm::dvec2 place_of(const Grid<glm::dvec3>& values, int column, int row) {
    return {(column + 0.5) / values.width, (row + 0.5) / values.height};
}

// Between four values, which are those of (column, row).
glm::dvec3 bilinear(double x, double y, const auto& value) {
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    return glm::mix(glm::mix(value(x0, y0), value(x0 + 1, y0), x - x0),
                    glm::mix(value(x0, y0 + 1), value(x0 + 1, y0 + 1), x - x0), y - y0);
}

std::vector<DistantLight> above_horizon(std::span<const DistantLight> lights) {
    std::vector<DistantLight> above;
    std::ranges::copy_if(lights, std::back_inserter(above),
                         [](const DistantLight& light) { return light.direction.y > 0; });
    return above;
}

// The ground's places about its middle.
double ground_step() {
    return 2 * ShadedGround::kRadius / (kGroundSide - 1);
}

// What is seen where a ray meets an object, and the share of the pixel that the object covers.
struct Seen {
    glm::dvec3 radiance{};
    double covered = 0;
};

class Sight {
 public:
    Sight(const LitObjects& objects, const ObjectLook& look)
        : objects_(objects),
          look_(look),
          centre_(look.size / 2.0),
          radius_(std::max(look.size / 2.0 - 1, 0.5)),
          down_(kLookDown * std::numbers::pi / 180) {}

    Seen at(LitObject object, glm::dvec2 pixel) const {
        const glm::dvec2 at = glm::dvec2(pixel.x - centre_, centre_ - pixel.y) / radius_;
        switch (object) {
            case LitObject::diffuse:
                return sphere(at, radius_, 0, [&](glm::dvec3 normal, glm::dvec3) {
                    return objects_.diffuse.at(turned(normal)) / std::numbers::pi;
                });
            case LitObject::glossy:
                return sphere(at, radius_, 0, [&](glm::dvec3 normal, glm::dvec3 view) {
                    const glm::dvec3 mirrored = view - 2 * glm::dot(view, normal) * normal;
                    return objects_.glossy.at(turned(mirrored)) * ((kGlossy + 1) / (2 * std::numbers::pi));
                });
            case LitObject::shaded:
                return shaded(at * ShadedGround::kRadius);
        }
        return {};
    }

 private:
    // Of radius 1, as many pixels; who sees it looks down by an angle.
    Seen sphere(glm::dvec2 at, double pixels, double down, const auto& radiance) const {
        const double away = glm::length(at);
        const double covered = std::clamp((1 - away) * pixels + 0.5, 0.0, 1.0);
        if (away > 1) at /= away;
        const double towards = std::sqrt(std::max(0.0, 1 - glm::dot(at, at)));
        const glm::dvec3 right(-1, 0, 0), up(0, portable::cos(down), portable::sin(down)),
            view(0, -portable::sin(down), portable::cos(down));
        return {radiance(at.x * right + at.y * up - towards * view, view), covered};
    }

    Seen shaded(glm::dvec2 at) const {
        const double a_radius = radius_ / ShadedGround::kRadius;  // pixels
        const Seen ball = sphere(at - glm::dvec2(0, portable::cos(down_)), a_radius, down_,
                                 [&](glm::dvec3 normal, glm::dvec3) {
                                     return objects_.from_above.at(turned(normal)) / std::numbers::pi;
                                 });
        glm::dvec2 place(-at.x, at.y / portable::sin(down_));
        const double away = glm::length(place);
        // How fast it grows from pixel to pixel.
        const double slope =
            glm::length(glm::dvec2(place.x, place.y / portable::sin(down_))) / std::max(away, 1e-9);
        const double covered =
            away > 1 ? std::clamp((ShadedGround::kRadius - away) / slope * a_radius + 0.5, 0.0, 1.0) : 1;
        if (away > ShadedGround::kRadius) place *= ShadedGround::kRadius / away;
        const glm::dvec3 there = turned({place.x, 0, place.y});
        const glm::dvec3 ground = objects_.ground.at({there.x, there.z}) / std::numbers::pi;
        return {glm::mix(ground, ball.radiance, ball.covered), std::max(covered, ball.covered)};
    }

    glm::dvec3 turned(glm::dvec3 direction) const {
        return turned_about_up(direction, -look_.turn_degrees, SphereConvention::openexr);
    }

    const LitObjects& objects_;
    const ObjectLook& look_;
    double centre_, radius_, down_;
};

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

std::vector<DistantLight> texel_lights(const EnvironmentMap& map) {
    std::vector<DistantLight> lights;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const glm::dvec3 weight = glm::dvec3(map.radiance().at(x, y)) * map.solid_angle(y);
            if (weight == glm::dvec3{}) continue;
            const glm::dvec2 uv{(x + 0.5) / map.width(), (y + 0.5) / map.height()};
            lights.push_back({direction_of(uv, SphereConvention::openexr), weight});
        }
    }
    return lights;
}

DistantLight block_light(const EnvironmentMap& map, glm::ivec2 low, glm::ivec2 high) {
    DistantLight light;
    for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
            const glm::dvec3 flux = glm::dvec3(map.radiance().at(x, y)) * map.solid_angle(y);
            const glm::dvec2 uv{(x + 0.5) / map.width(), (y + 0.5) / map.height()};
            light.weight += flux;
            light.direction += luminance(flux) * direction_of(uv, SphereConvention::openexr);
        }
    }
    const double length = glm::length(light.direction);
    light.direction = length > 0 ? light.direction / length : glm::dvec3{};
    return light;
}

std::vector<DistantLight> block_lights(const EnvironmentMap& map, int texels_a_side) {
    const glm::ivec2 size(map.width(), map.height());
    std::vector<DistantLight> lights;
    for (int y = 0; y < size.y; y += texels_a_side) {
        for (int x = 0; x < size.x; x += texels_a_side) {
            const glm::ivec2 low(x, y);
            const DistantLight light = block_light(map, low, glm::min(low + texels_a_side, size));
            if (light.direction != glm::dvec3{}) lights.push_back(light);
        }
    }
    return lights;
}

std::vector<glm::dvec3> irradiance(std::span<const DistantLight> lights, std::span<const glm::dvec3> normals,
                                   unsigned exponent) {
    std::vector<glm::dvec3> result(normals.size());
    tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t i) {
        glm::dvec3 sum{};
        for (const DistantLight& light : lights) {
            const double cosine = glm::dot(light.direction, normals[i]);
            if (cosine > 0) sum += light.weight * to_the(exponent, cosine);
        }
        result[i] = sum;
    });
    return result;
}

RelativeError relative_error(std::span<const glm::dvec3> found, std::span<const glm::dvec3> exact,
                             std::span<const double> weights) {
    RelativeError error;
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double right = luminance(exact[i]), weight = weights.empty() ? 1 : weights[i];
        if (!(right > 0)) continue;
        const double here = std::abs(luminance(found[i]) - right) / right;
        error.mean += weight * here;
        error.largest = std::max(error.largest, here);
        sum += weight;
    }
    if (sum > 0) error.mean /= sum;
    return error;
}

std::vector<glm::dvec3> fibonacci_normals(int count) {
    constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.23606797749978969641);
    std::vector<glm::dvec3> normals(count);
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - height * height);
        normals[i] = {radius * portable::cos(i * kGoldenAngle), height,
                      radius * portable::sin(i * kGoldenAngle)};
    }
    return normals;
}

IrradianceMap::IrradianceMap(std::span<const DistantLight> lights, unsigned exponent, int rows)
    : values_(2 * rows, rows) {
    std::vector<glm::dvec3> normals;
    for (int y = 0; y < values_.height; ++y)
        for (int x = 0; x < values_.width; ++x)
            normals.push_back(direction_of(place_of(values_, x, y), SphereConvention::openexr));
    values_.values = irradiance(lights, normals, exponent);
}

glm::dvec3 IrradianceMap::at(glm::dvec3 normal) const {
    const glm::dvec2 uv = uv_of(normal, SphereConvention::openexr);
    const int width = values_.width, height = values_.height;
    return bilinear(
        uv.x * width - 0.5, std::clamp(uv.y * height - 0.5, 0.0, height - 1.0),
        [&](int column, int row) { return values_.at((column + width) % width, std::min(row, height - 1)); });
}

RelativeError difference(const IrradianceMap& found, const IrradianceMap& exact) {
    std::vector<double> weights;
    for (int y = 0; y < exact.values().height; ++y)
        weights.resize(weights.size() + static_cast<std::size_t>(exact.values().width),
                       portable::sin(std::numbers::pi * place_of(exact.values(), 0, y).y));
    return relative_error(found.values().values, exact.values().values, weights);
}

ShadedGround::ShadedGround(std::span<const DistantLight> lights) : values_(kGroundSide, kGroundSide) {
    const std::vector<DistantLight> above = above_horizon(lights);
    tbb::parallel_for(0, kGroundSide, [&](int row) {
        for (int column = 0; column < kGroundSide; ++column) {
            const glm::dvec3 place(column * ground_step() - kRadius, 0, row * ground_step() - kRadius);
            const glm::dvec3 to_sphere = glm::dvec3(0, 1, 0) - place;
            const double away = glm::length(to_sphere);
            const glm::dvec3 towards = to_sphere / away;
            const double rim_cosine = std::sqrt(std::max(1 - 1 / (away * away), 0.0));
            glm::dvec3 sum{};
            for (const DistantLight& light : above)
                if (glm::dot(light.direction, towards) < rim_cosine) sum += light.weight * light.direction.y;
            values_.at(column, row) = sum;
        }
    });
}

glm::dvec3 ShadedGround::at(glm::dvec2 place) const {
    const glm::dvec2 cell =
        glm::clamp((place + kRadius) / ground_step(), glm::dvec2(0), glm::dvec2(kGroundSide - 1));
    return bilinear(cell.x, cell.y, [&](int column, int row) {
        return values_.at(std::min(column, kGroundSide - 1), std::min(row, kGroundSide - 1));
    });
}

LitObjects::LitObjects(std::span<const DistantLight> lights)
    : diffuse(lights),
      glossy(lights, kGlossy, kGlossyRows),
      from_above(above_horizon(lights)),
      ground(lights) {}

Grid<glm::u8vec4> object_picture(const LitObjects& objects, LitObject object, const ObjectLook& look) {
    Grid<glm::u8vec4> picture(look.size, look.size);
    const Sight sight(objects, look);
    tbb::parallel_for(0, look.size, [&](int y) {
        for (int x = 0; x < look.size; ++x) {
            const Seen seen = sight.at(object, {x + 0.5, y + 0.5});
            picture.at(x, y) = glm::u8vec4(tone_mapped(seen.radiance, look.exposure),
                                           static_cast<glm::u8>(255 * seen.covered + 0.5));
        }
    });
    return picture;
}

}  // namespace dapple
