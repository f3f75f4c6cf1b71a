#include "lab/volume/turning_view.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/image/tone.h"

namespace dapple {
namespace {

constexpr int kParts = 4;   // of a pixel's side, for soft edges: a bit each in a mask
constexpr int kPhases = 8;  // places within a pixel's side that balls' middles are rounded to
constexpr std::uint16_t kAll = 0xffff, kFullLight = 4095;  // of light: sixteen times as much is a pixel's
constexpr float kNear = 0.1f, kFar = 0.88f;                // of the way to the paper, in roots of light

// What a ball covers of a pixel, and how much of the light that it mirrors comes from there.
struct Covered {
    std::uint16_t mask = 0, gloss = 0;  // of kFullLight
};

// Balls of one radius: for each place within a pixel a square of pixels.
class Stamps {
 public:
    explicit Stamps(double of_radius)
        : radius(of_radius), reach(static_cast<int>(std::ceil(of_radius))), side_(2 * reach + 1) {
        for (int y = 0; y < kPhases; ++y)
            for (int x = 0; x < kPhases; ++x)
                for (int v = -reach; v <= reach; ++v)
                    for (int u = -reach; u <= reach; ++u)
                        pixels_.push_back(covered(u - (x + 0.5) / kPhases, v - (y + 0.5) / kPhases));
    }
    const Covered* row(int phase, int v) const {
        return pixels_.data() + (static_cast<std::size_t>(phase) * side_ + v + reach) * side_ + reach;
    }

    double radius;
    int reach;

 private:
    // Of the pixel whose corner is there from the ball's middle.
    Covered covered(double u, double v) const {
        constexpr double kCorner = 0.71;  // from a pixel's middle
        Covered pixel;
        const double away = std::hypot(u + 0.5, v + 0.5);
        if (away > radius + kCorner) return pixel;
        if (away < radius - kCorner) pixel.mask = kAll;
        for (int part = 0; pixel.mask != kAll && part < kParts * kParts; ++part) {
            const double x = u + (part % kParts + 0.5) / kParts, y = v + (part / kParts + 0.5) / kParts;
            if (x * x + y * y <= radius * radius) pixel.mask |= static_cast<std::uint16_t>(1 << part);
        }
        // Light from the upper left and the front; on small balls there is no room for it.
        const double x = (u + 0.5) / radius, y = (v + 0.5) / radius;
        const double front = std::sqrt(std::max(0.0, 1 - x * x - y * y));
        const double lit = std::max(0.0, -0.46 * x - 0.56 * y + 0.69 * front);
        const double room = std::clamp((radius - 1.5) / 4, 0.0, 1.0);
        pixel.gloss = static_cast<std::uint16_t>(kFullLight * room * (0.16 * lit + 0.55 * std::pow(lit, 14)));
        return pixel;
    }

    int side_;
    std::vector<Covered> pixels_;
};

// A pixel while balls are added from the nearest on.
struct Layers {
    std::uint16_t mask = 0;
    std::array<std::uint16_t, 3> light{};
};

struct Seen {
    float x, y, depth;  // in pixels
    std::uint32_t ball;
};

std::vector<Seen> seen_from(std::span<const Ball> balls, const TurnedView& view, double pixels) {
    const glm::dvec3 middle = (view.box.low + view.box.high) / 2.0;
    const double angle = 2 * std::numbers::pi * view.turn, c = std::cos(angle), s = std::sin(angle);
    const double level = std::cos(view.down), down = std::sin(view.down), centre = view.side / 2.0;
    std::vector<Seen> seen;
    seen.reserve(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const glm::dvec3 at = (balls[i].place - middle) * pixels;
        const double across = c * at.x - s * at.y, away = s * at.x + c * at.y;
        seen.push_back({static_cast<float>(centre + across),
                        static_cast<float>(centre - at.z * level - away * down),
                        static_cast<float>(away * level - at.z * down), static_cast<std::uint32_t>(i)});
    }
    return seen;
}

// The nearest first, as far as one sees.
std::vector<Seen> by_depth(const std::vector<Seen>& seen, float nearest, float range) {
    constexpr float kSteps = 4095;
    std::vector<std::size_t> begin(static_cast<std::size_t>(kSteps) + 2);
    const auto step = [&](const Seen& ball) {
        return static_cast<std::size_t>((ball.depth - nearest) / range * kSteps);
    };
    for (const Seen& ball : seen) ++begin[step(ball) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Seen> sorted(seen.size());
    for (const Seen& ball : seen) sorted[begin[step(ball)]++] = ball;
    return sorted;
}

const Stamps& stamps_of(double radius, std::vector<Stamps>& made) {
    const auto known = std::ranges::find(made, radius, &Stamps::radius);
    return known != made.end() ? *known : made.emplace_back(radius);
}

void stamp(Grid<Layers>& layers, const Seen& ball, const Stamps& stamps, const glm::vec3& light) {
    const float whole_x = std::floor(ball.x), whole_y = std::floor(ball.y);
    const int column = static_cast<int>(whole_x), row = static_cast<int>(whole_y);
    const auto phase_of = [](float part) { return std::min(static_cast<int>(part * kPhases), kPhases - 1); };
    const int phase = phase_of(ball.y - whole_y) * kPhases + phase_of(ball.x - whole_x);
    const int left = std::max(column - stamps.reach, 0),
              right = std::min(column + stamps.reach, layers.width - 1);
    for (int y = std::max(row - stamps.reach, 0); y <= std::min(row + stamps.reach, layers.height - 1); ++y) {
        Layers* const pixels = layers.row(y);
        const Covered* const covered = stamps.row(phase, y - row);
        for (int x = left; x <= right; ++x) {
            Layers& pixel = pixels[x];
            const Covered& here = covered[x - column];
            const auto added = static_cast<std::uint16_t>(here.mask & ~pixel.mask);
            if (!added) continue;
            pixel.mask |= added;
            const int parts = std::popcount(added);
            for (int i = 0; i < 3; ++i) {
                const float own = light[i] + (kFullLight - light[i]) * (here.gloss / float{kFullLight});
                pixel.light[static_cast<std::size_t>(i)] +=
                    static_cast<std::uint16_t>(parts * static_cast<int>(own));
            }
        }
    }
}

std::vector<std::uint8_t> encoded_sums() {
    std::vector<std::uint8_t> encoded(kParts * kParts * kFullLight + 1);
    for (std::size_t sum = 0; sum < encoded.size(); ++sum)
        encoded[sum] = static_cast<std::uint8_t>(
            std::lround(255 * linear_to_srgb(static_cast<float>(sum) / (kParts * kParts * kFullLight))));
    return encoded;
}

}  // namespace

double ball_radius(const Box& box, std::size_t balls) {
    return 0.3 * glm::length(box.high - box.low) / 2 / std::cbrt(static_cast<double>(balls + 1));
}

Grid<glm::u8vec3> turned_view(std::span<const Ball> balls, const TurnedView& view) {
    static const std::vector<std::uint8_t> encoded = encoded_sums();
    const double pixels = view.side / 2.1 / std::max(glm::length(view.box.high - view.box.low) / 2, 1e-300);
    const std::vector<Seen> seen = seen_from(balls, view, pixels);
    const auto [near, far] = std::minmax_element(
        seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
    const float nearest = seen.empty() ? 0 : near->depth,
                range = seen.empty() ? 1 : std::max(far->depth - nearest, 1e-6f);
    Grid<Layers> layers(view.side, view.side, Layers{});
    std::vector<Stamps> made;
    for (const Seen& each : by_depth(seen, nearest, range)) {
        const Ball& ball = balls[each.ball];
        const double radius = std::max(0.6, std::min(ball.radius * pixels, view.side / 30.0));
        const float faded = glm::mix(kNear, kFar, (each.depth - nearest) / range);
        const glm::vec3 root = glm::mix(ball.ink, glm::vec3(1), faded);
        stamp(layers, each, stamps_of(radius, made), root * root * float{kFullLight});
    }
    Grid<glm::u8vec3> picture(view.side, view.side);
    std::ranges::transform(layers.values, picture.values.begin(), [](const Layers& pixel) {
        if (!pixel.mask) return glm::u8vec3(255);
        const int paper = kFullLight * (kParts * kParts - std::popcount(pixel.mask));
        return glm::u8vec3(encoded[pixel.light[0] + paper], encoded[pixel.light[1] + paper],
                           encoded[pixel.light[2] + paper]);
    });
    return picture;
}

Grid<glm::u8vec3> turned_view(std::span<const glm::dvec3> dots, double turn, int side) {
    const Box box = box_around(dots);
    const double radius = ball_radius(box, dots.size());
    std::vector<Ball> balls;
    for (const glm::dvec3& dot : dots) balls.push_back({dot, radius});
    return turned_view(balls, {.box = box, .turn = turn, .side = side});
}

}  // namespace dapple
