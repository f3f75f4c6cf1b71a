#include "assets/make/render_stage.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dapple::make {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double pi = std::numbers::pi;

// The random decisions along one ray, each a point of the unit square.
enum Decision { in_pixel, on_lamp, bounce, on_lamp_after_bounce, mirror, decisions };
using Decisions = dvec2[decisions];

// The decisions of all rays of a pixel. For each kind the square is cut into as many cells as there are rays
// and every cell is used once, in an order of its own, so that the mean settles quickly.
class PixelSampler {
 public:
    PixelSampler(int x, int y, int per_side) : per_side_(per_side), cells_(decisions) {
        for (int kind = 0; kind < decisions; ++kind) {
            auto& cells = cells_[kind];
            cells.resize(per_side * per_side);
            for (int i = 0; i < per_side * per_side; ++i) cells[i] = i;
            state_ = mix_bits(x, y, kind);
            for (int i = per_side * per_side - 1; i > 0; --i)
                std::swap(cells[i], cells[static_cast<int>(next() * (i + 1))]);
        }
    }
    void decide(int ray, Decisions& out) {
        for (int kind = 0; kind < decisions; ++kind) {
            const int cell = cells_[kind][ray];
            const double x = (cell % per_side_ + next()) / per_side_;
            out[kind] = {x, (cell / per_side_ + next()) / per_side_};
        }
    }

 private:
    double next() { return (state_ = mix_bits(state_, 1, 2)) * 0x1p-32; }

    int per_side_;
    std::uint32_t state_ = 0;
    std::vector<std::vector<int>> cells_;
};

double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Light of the room from a direction: brighter above and on the lamp's side.
double room(const dvec3& direction) {
    return 0.07 + 0.10 * std::max(0.0, direction.y) - 0.04 * direction.x;
}

double lamp_radiance(const Lamp& lamp) {
    const double area = 4 * glm::length(lamp.half_right) * glm::length(lamp.half_up);
    return lamp.irradiance * glm::dot(lamp.centre, lamp.centre) / area;
}

// Irradiance from one point of the lamp, 0 in shadow.
double from_lamp(const Stage& stage, const dvec3& point, const dvec3& normal, const dvec2& choice) {
    const Lamp& lamp = stage.scene().lamp;
    const dvec3 spot = lamp.centre + (2 * choice.x - 1) * lamp.half_right + (2 * choice.y - 1) * lamp.half_up;
    const double length = glm::length(spot - point);
    const dvec3 to_spot = (spot - point) / length;
    const double facing = glm::dot(normal, to_spot);
    if (facing <= 0 || stage.blocked({point, to_spot}, length)) return 0;
    const double squared = glm::dot(lamp.centre, lamp.centre);
    return lamp.irradiance * facing * std::max(0.0, -glm::dot(lamp.normal, to_spot)) * squared /
           (length * length);
}

dvec3 around_normal(const dvec3& normal, const dvec2& choice) {
    const double r = std::sqrt(choice.x), angle = 2 * pi * choice.y;
    return axes_with_y(normal) * dvec3(r * std::cos(angle), std::sqrt(1 - choice.x), r * std::sin(angle));
}

// What a secondary ray sees: surfaces under the lamp and an even rest.
double glance(const Stage& stage, const Ray& ray, const dvec2& lamp_choice) {
    const auto hit = stage.hit(ray);
    if (!hit) return room(ray.direction);
    return hit->material.albedo * (from_lamp(stage, hit->point, hit->normal, lamp_choice) + 0.025);
}

// A glossy surface also mirrors the lamp itself.
double mirrored(const Stage& stage, const Hit& hit, const dvec3& direction, const Decisions& choices) {
    const double spread = hit.material.roughness;
    const dvec3 facet =
        glm::normalize(hit.normal + spread * (around_normal(hit.normal, choices[mirror]) - hit.normal));
    const dvec3 out = glm::reflect(direction, facet);
    const Ray ray{hit.point, out};
    const Lamp& lamp = stage.scene().lamp;
    const double facing = glm::dot(out, lamp.normal);
    if (facing < 0) {
        const double t = glm::dot(lamp.centre - hit.point, lamp.normal) / facing;
        const dvec3 off = hit.point + t * out - lamp.centre;
        const double u = glm::dot(off, lamp.half_right) / glm::dot(lamp.half_right, lamp.half_right);
        const double v = glm::dot(off, lamp.half_up) / glm::dot(lamp.half_up, lamp.half_up);
        if (t > 0 && std::abs(u) < 1 && std::abs(v) < 1 && !stage.blocked(ray, t)) return lamp_radiance(lamp);
    }
    return glance(stage, ray, choices[on_lamp_after_bounce]);
}

double radiance(const Stage& stage, const Hit& hit, const dvec3& direction, const Decisions& choices) {
    const Material& material = hit.material;
    double light = from_lamp(stage, hit.point, hit.normal, choices[on_lamp]);
    light +=
        glance(stage, {hit.point, around_normal(hit.normal, choices[bounce])}, choices[on_lamp_after_bounce]);
    double sum = material.albedo * light;
    if (material.gloss > 0) {
        // Schlick's approximation of Fresnel's law.
        const double grazing = std::pow(1 - std::clamp(-glm::dot(hit.normal, direction), 0.0, 1.0), 5);
        sum += (material.gloss + (1 - material.gloss) * grazing) * mirrored(stage, hit, direction, choices);
    }
    return sum;
}

// Paper white above, a little darker behind the lit side of the group so that it stands out. (u, v): place in
// the picture, 0..1 from the upper left.
double backdrop(double u, double v) {
    const double du = (u - 0.28) / 0.52;
    return 1.0 - 0.42 * std::exp(-du * du) * smooth_step(0.06, 0.66, v);
}

double see(const Stage& stage, const Ray& ray, double u, double v, const Decisions& choices) {
    const auto hit = stage.hit(ray);
    const double behind = backdrop(u, v);
    if (!hit) return behind;
    const double light = radiance(stage, *hit, ray.direction, choices);
    // The far end of the table is lost in the backdrop: it has no edge.
    return hit->on_table ? glm::mix(light, behind, smooth_step(-0.5, -8.0, hit->point.z)) : light;
}

// A little contrast: what is nearly black becomes black, highlights run softly into white.
double developed(double light) {
    const double x = std::max(0.0, light - 0.016);
    return std::min(1.0, x < 0.7 ? x : 0.7 + 0.3 * (1 - std::exp(-(x - 0.7) / 0.3)) / (1 - std::exp(-1.0)));
}

std::uint8_t srgb(double linear) {
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(encoded, 0.0, 1.0)));
}

}  // namespace

std::vector<std::uint8_t> render(const Stage& stage, const Quality& quality) {
    const Camera& camera = stage.scene().camera;
    const dvec3 ahead = glm::normalize(camera.target - camera.eye);
    const dvec3 right = glm::normalize(glm::cross(ahead, dvec3(0, 1, 0))), up = glm::cross(right, ahead);
    const double reach = std::tan(camera.half_angle);
    const int size = quality.size, rays = quality.samples_per_side * quality.samples_per_side;

    std::vector<std::uint8_t> pixels(static_cast<size_t>(size) * size);
    tbb::parallel_for(0, size, [&](int y) {
        for (int x = 0; x < size; ++x) {
            PixelSampler sampler(x, y, quality.samples_per_side);
            double sum = 0;
            for (int i = 0; i < rays; ++i) {
                Decisions choices;
                sampler.decide(i, choices);
                const double u = (x + choices[in_pixel].x) / size, v = (y + choices[in_pixel].y) / size;
                const dvec3 direction =
                    glm::normalize(ahead + reach * ((2 * u - 1) * right + (1 - 2 * v) * up));
                // Developed before the mean: an edge of a highlight stays smooth.
                sum += developed(see(stage, {camera.eye, direction}, u, v, choices));
            }
            pixels[static_cast<size_t>(y) * size + x] = srgb(sum / rays);
        }
    });
    return pixels;
}

}  // namespace dapple::make
