#include "assets/make/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dapple::make {
namespace {

using glm::dvec3;
constexpr double tau = 2 * std::numbers::pi;

double unit(std::uint32_t bits) {
    return bits * 0x1p-32;
}

double at_corner(const glm::ivec3& c) {
    return unit(mix_bits(static_cast<std::uint32_t>(c.x), static_cast<std::uint32_t>(c.y),
                         static_cast<std::uint32_t>(c.z)));
}

// Grooves of the chisel around the axis, and grain that runs along it.
Detail turned_wood(const dvec3& p) {
    const double wander = smooth_noise({3 * p.x, 1.1 * p.y, 3 * p.z});
    const double rings = smooth_noise({26 * p.x, 1.6 * p.y, 26 * p.z});
    const double pores = smooth_noise({90 * p.x, 5 * p.y, 90 * p.z});
    // Two bands of grooves, near the foot and near the top.
    const bool band = (p.y > 0.42 && p.y < 0.78) || (p.y > 1.62 && p.y < 1.98);
    const double groove = band ? std::pow(0.5 + 0.5 * std::cos(tau * (p.y - 0.42) / 0.09), 5) : 0.0;
    const double grain =
        0.62 + 0.6 * rings + 0.4 * (wander - 0.5) - (pores > 0.72 ? 0.9 * (pores - 0.72) : 0.0);
    return {.height = -0.012 * groove, .tint = grain * (1 - 0.55 * groove)};
}

// One thread laid turn upon turn, slightly slanted.
Detail wound_thread(const dvec3& p) {
    const double turn = 44 * p.y + std::atan2(p.z, p.x) / tau;
    const double round = std::abs(std::sin(0.5 * tau * turn));
    return {.height = 0.006 * round, .tint = 0.55 + 0.45 * std::sqrt(round)};
}

// Over and under, as on a basket: strips along the equator and the meridians take turns.
Detail woven(const dvec3& p) {
    constexpr double columns = 28, rows = 14;
    const double u = std::atan2(p.z, p.x) / tau * columns;
    const double v = std::atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z)) / tau * 2 * rows;
    const double across = std::abs(std::sin(0.5 * tau * u)), along = std::abs(std::sin(0.5 * tau * v));
    const bool over = (static_cast<int>(std::floor(u)) + static_cast<int>(std::floor(v))) & 1;
    const double top =
        over ? std::sqrt(across) * (0.25 + 0.75 * along) : std::sqrt(along) * (0.25 + 0.75 * across);
    const double straws = std::abs(std::sin(1.5 * tau * (over ? u : v)));
    return {.height = 0.02 * top + 0.002 * straws, .tint = (0.35 + 0.65 * top) * (0.6 + 0.4 * straws)};
}

// Granite: dark and pale grains of two sizes.
Detail speckled(const dvec3& point) {
    // Off the axes, so that the noise's own lattice doesn't show on a flat side.
    const dvec3 p(0.8 * point.x - 0.6 * point.y, 0.48 * point.x + 0.64 * point.y - 0.6 * point.z,
                  0.36 * point.x + 0.48 * point.y + 0.8 * point.z);
    const double coarse = smooth_noise(52.0 * p), fine = smooth_noise(95.0 * p + 7.0);
    const double dark = std::clamp((coarse - 0.62) * 8, 0.0, 1.0),
                 pale = std::clamp((fine - 0.66) * 9, 0.0, 1.0);
    return {.height = -0.001 * dark, .tint = (1 - 0.8 * dark) * (1 + 0.4 * pale)};
}

}  // namespace

std::uint32_t mix_bits(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h = a * 0x9e3779b1u ^ (b * 0x85ebca77u + 0x165667b1u) ^ (c * 0xc2b2ae3du + 0x27d4eb2fu);
    for (int round = 0; round < 2; ++round) {
        h ^= h >> 16;
        h *= 0x7feb352du;
        h ^= h >> 15;
        h *= 0x846ca68bu;
        h ^= h >> 16;
    }
    return h;
}

double smooth_noise(const dvec3& point) {
    const dvec3 cell = glm::floor(point), f = point - cell, s = f * f * (3.0 - 2.0 * f);
    const glm::ivec3 c(cell);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
        const dvec3 weight = glm::mix(1.0 - s, s, dvec3(bit));
        sum += weight.x * weight.y * weight.z * at_corner(c + bit);
    }
    return sum;
}

Detail detail_at(Texture texture, const dvec3& point) {
    switch (texture) {
        case Texture::plain:
            break;
        case Texture::turned_wood:
            return turned_wood(point);
        case Texture::wound_thread:
            return wound_thread(point);
        case Texture::woven:
            return woven(point);
        case Texture::speckled:
            return speckled(point);
    }
    return {};
}

}  // namespace dapple::make
