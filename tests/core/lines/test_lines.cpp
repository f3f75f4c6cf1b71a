#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/image/detail.h"
#include "core/image/tone.h"
#include "core/lines/ink_lines.h"

using namespace dapple;

namespace {

// A picture of encoded values, as light. Values are means of 4 x 4 places in each pixel, which are given in
// pixels from the upper left corner.
Grid<float> picture_of(int width, int height, const std::function<double(double x, double y)>& value) {
    constexpr int kPlaces = 4;
    Grid<float> light(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int j = 0; j < kPlaces; ++j)
                for (int i = 0; i < kPlaces; ++i)
                    sum += value(x + (i + 0.5) / kPlaces, y + (j + 0.5) / kPlaces);
            light.at(x, y) = srgb_to_linear(static_cast<float>(sum / (kPlaces * kPlaces)));
        }
    return light;
}

// Sums of uniform numbers, which are nearly normal.
double noise(std::uint32_t& state) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) {
        state = state * 1664525u + 1013904223u;
        sum += state / 4294967296.0;
    }
    return sum;
}

double length_of(const InkLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += glm::distance(line.points[i - 1], line.points[i]);
    return length;
}

// All places on a line, not far from each other.
std::vector<glm::dvec2> places_on(const InkLine& line) {
    std::vector<glm::dvec2> places{line.points.front()};
    for (std::size_t i = 1; i < line.points.size(); ++i)
        for (int k = 1; k <= 64; ++k)
            places.push_back(line.points[i - 1] + (line.points[i] - line.points[i - 1]) * (k / 64.0));
    return places;
}

double distance_to(const std::vector<InkLine>& lines, glm::dvec2 from) {
    double least = 1e9;
    for (const InkLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const glm::dvec2 a = line.points[i - 1], along = line.points[i] - a;
            const double t = std::clamp(glm::dot(from - a, along) / glm::dot(along, along), 0.0, 1.0);
            least = std::min(least, glm::distance(from, a + t * along));
        }
    return least;
}

// Something with lines of all kinds: discs, bars, waves.
double scene(double x, double y) {
    if (std::hypot(x - 90, y - 70) < 40) return 0.25;
    if (std::hypot(x - 210, y - 160) < 55) return 0.9 - 0.2 * std::sin(x * 0.05);
    if (std::abs(x - 270 - 0.05 * y) < 0.8) return 0.1;
    return 0.6 + 0.05 * std::sin(x * 0.02) + 0.05 * std::cos(y * 0.03);
}

}  // namespace

TEST_CASE("a disc's contour is one closed line, within half a pixel of its circle") {
    for (const int size : {200, 500, 900})
        for (const double dark : {0.1, 0.5}) {
            CAPTURE(size);
            CAPTURE(dark);
            const double radius = 0.3 * size, x = 0.5 * size + 0.3, y = 0.5 * size - 0.2;
            const auto lines = find_lines(picture_of(size, size, [&](double u, double v) {
                return std::hypot(u - x, v - y) < radius ? dark : 0.8;
            }));
            REQUIRE(lines.size() == 1);
            CHECK(lines[0].closed());
            CHECK(lines[0].strength > 0.5);
            double mean = 0, most = 0;
            const auto places = places_on(lines[0]);
            for (const glm::dvec2 place : places) {
                const double off = glm::distance(place * double(size), {x, y}) - radius;
                mean += off / static_cast<double>(places.size());
                most = std::max(most, std::abs(off));
            }
            CHECK(std::abs(mean) < 0.2);
            CHECK(most < 0.5);
            CHECK(length_of(lines[0]) * size == doctest::Approx(2 * std::numbers::pi * radius).epsilon(0.01));
        }
}

TEST_CASE("there are no lines in what is even, in ramps and in noise") {
    CHECK(find_lines(Grid<float>(300, 200, 0.5f)).empty());
    CHECK(find_lines(picture_of(300, 300, [](double x, double) { return x / 300; })).empty());
    CHECK(find_lines(picture_of(300, 300, [](double x, double y) { return (x + 2 * y) / 900; })).empty());
    for (const int size : {200, 512, 1024}) {
        std::uint32_t state = 7;
        Grid<float> light(size, size);
        for (float& v : light.values) v = srgb_to_linear(static_cast<float>(0.5 + 5 / 255.0 * noise(state)));
        CHECK(find_lines(light).empty());
    }
}

TEST_CASE("the blocks of a JPEG make no lines") {
    // Each of its own mean, three of 255 steps apart at most, which is more than a fair quality leaves.
    std::uint32_t state = 3;
    Grid<float> means(64, 64);
    for (float& v : means.values) v = static_cast<float>(0.5 + std::clamp(noise(state), -1.5, 1.5) / 255);
    Grid<float> light(512, 512);
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) light.at(x, y) = srgb_to_linear(means.at(x / 8, y / 8));
    CHECK(find_lines(light).empty());
}

TEST_CASE("the edge between two greys is one line, and so are a dark line and a blurred edge") {
    const auto is_one = [](const Grid<float>& light, double where) {
        const auto lines = find_lines(light);
        REQUIRE(lines.size() == 1);
        CHECK(!lines[0].light);
        CHECK(length_of(lines[0]) > 0.97);
        double most = 0;
        for (const glm::dvec2 place : places_on(lines[0]))
            most = std::max(most, std::abs(place.x * 400 - where));
        CHECK(most < 0.5);
    };
    is_one(picture_of(400, 400, [](double x, double) { return x < 170.4 ? 0.5 : 0.7; }), 170.4);
    is_one(picture_of(400, 400, [](double x, double) { return x < 170.4 ? 0.8 : 0.3; }), 170.4);
    is_one(picture_of(400, 400, [](double x, double) { return std::abs(x - 200.7) < 1 ? 0.2 : 0.8; }), 200.7);
    is_one(picture_of(400, 400, [](double x, double) { return 0.6 - 0.2 * std::erf((x - 230) / 7); }), 230);
}

TEST_CASE("a line of light is one, in the middle, not one on each side") {
    const auto lines = find_lines(
        picture_of(400, 400, [](double x, double) { return std::abs(x - 200) < 0.7 ? 0.7 : 0.2; }));
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].light);
    double most = 0;
    for (const glm::dvec2 place : places_on(lines[0])) most = std::max(most, std::abs(place.x * 400 - 200));
    CHECK(most < 0.5);
}

TEST_CASE("the edges of a checkerboard are there once each") {
    constexpr int kSize = 480, kField = 60, kCorner = 8;
    const auto lines = find_lines(picture_of(kSize, kSize, [](double x, double y) {
        return (static_cast<int>(x / kField) + static_cast<int>(y / kField)) % 2 ? 0.75 : 0.25;
    }));
    // Along each edge a line lies on it, and along all of it that many.
    double length = 0;
    for (const InkLine& line : lines) {
        for (const glm::dvec2 place : places_on(line)) {
            const glm::dvec2 at = place * double(kSize);
            const double dx = std::abs(at.x - std::round(at.x / kField) * kField);
            const double dy = std::abs(at.y - std::round(at.y / kField) * kField);
            if (std::max(dx, dy) > kCorner) CHECK(std::min(dx, dy) < 0.7);
        }
        length += length_of(line) * kSize;
    }
    CHECK(length < 14.0 * kSize);
    CHECK(length > 12.5 * kSize);
    for (int edge = 1; edge < 8; ++edge)
        for (int field = 0; field < 8; ++field) {
            const double across = edge * kField, along = (field + 0.5) * kField;
            CHECK(distance_to(lines, glm::dvec2(across, along) / double(kSize)) * kSize < 0.7);
            CHECK(distance_to(lines, glm::dvec2(along, across) / double(kSize)) * kSize < 0.7);
        }
}

TEST_CASE("lines of a picture that is turned are turned, those of a larger one are the same") {
    constexpr int kSide = 300;
    const Grid<float> light = picture_of(kSide, kSide, scene);
    Grid<float> turned(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) turned.at(kSide - 1 - y, x) = light.at(x, y);
    const auto lines = find_lines(light), of_turned = find_lines(turned);
    REQUIRE(lines.size() > 3);
    // But for where they end: by steps.
    constexpr double kEnd = 3;
    double most = 0;
    for (const InkLine& line : lines)
        for (const glm::dvec2 place : places_on(line))
            if (line.strength > 0.3 && glm::distance(place, line.points.front()) * kSide > kEnd &&
                glm::distance(place, line.points.back()) * kSide > kEnd)
                most = std::max(most, distance_to(of_turned, {1 - place.y, place.x}) * kSide);
    CHECK(most < 1);

    // Three times the pixels, each nine times; another number is reduced.
    const auto larger =
        find_lines(picture_of(3 * kSide, 3 * kSide, [](double x, double y) { return scene(x / 3, y / 3); }));
    most = 0;
    for (const InkLine& line : lines)
        for (const glm::dvec2 place : places_on(line))
            if (line.strength > 0.5) most = std::max(most, distance_to(larger, place) * kSide);
    CHECK(most < 2);
    const auto reduced =
        find_lines(picture_of(9 * kSide, 3, [](double x, double) { return x < 1000 ? 0.3 : 0.7; }));
    CHECK(reduced.size() <= 1);
}

TEST_CASE("strengths are from 0.05 to 1, the strongest first, and a stronger edge is stronger and wider") {
    const auto lines = find_lines(picture_of(300, 300, scene));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK(lines[i].strength >= 0.05f);
        CHECK(lines[i].strength <= 1);
        if (i > 0) CHECK(lines[i].strength <= lines[i - 1].strength);
        CHECK(lines[i].points.size() >= 2);
        REQUIRE(lines[i].widths.size() == lines[i].points.size());
        for (const float width : lines[i].widths) CHECK((width > 0 && width <= kBoldWidth));
        for (const glm::dvec2 p : lines[i].points) CHECK((p.x >= 0 && p.y >= 0 && p.x <= 1 && p.y <= 1));
    }
    InkLine before{{}, {}, 0};
    for (const double step : {0.1, 0.2, 0.4, 0.7}) {
        const auto found =
            find_lines(picture_of(300, 300, [&](double x, double) { return x < 150 ? 0.1 : 0.1 + step; }));
        REQUIRE(found.size() == 1);
        CHECK(found[0].strength > before.strength);
        if (!before.widths.empty()) CHECK(found[0].widths[1] > before.widths[1]);
        before = found[0];
    }
}

TEST_CASE("free ends are tapered, ends at the picture's edge are not") {
    for (const bool from_below : {false, true}) {
        const auto lines = find_lines(picture_of(400, 400, [&](double x, double y) {
            return std::abs(x - 200) < 0.8 && (from_below ? y > 150 : y < 250) ? 0.1 : 0.8;
        }));
        REQUIRE(lines.size() == 1);
        const bool free_first = (lines[0].points.front().y < lines[0].points.back().y) == from_below;
        const float free = free_first ? lines[0].widths.front() : lines[0].widths.back();
        const float at_edge = free_first ? lines[0].widths.back() : lines[0].widths.front();
        CHECK(free < 0.5f * at_edge);
        CHECK(at_edge == std::ranges::max(lines[0].widths));
    }
}

TEST_CASE("texture has no strong lines, a contour of the same contrast has one, also within it") {
    // Pebbles of a few pixels, far rougher than noise.
    std::uint32_t state = 11;
    Grid<float> rough(500, 500);
    for (float& v : rough.values) v = static_cast<float>(noise(state));
    rough = blurred(std::move(rough), 1.5);
    const auto strongest = [&](double disc) {
        const auto lines = find_lines(picture_of(500, 500, [&](double x, double y) {
            const double grain =
                0.4 * static_cast<double>(rough.at(static_cast<int>(x), static_cast<int>(y)));
            return 0.5 + grain + (std::hypot(x - 250, y - 250) < 150 ? disc : 0);
        }));
        return lines.empty() ? 0.0f : lines[0].strength;
    };
    CHECK(strongest(0) < 0.5f);
    CHECK(strongest(0.4) > 0.6f);
}

TEST_CASE("lines are the same with one thread and with two, and in any picture there is a result") {
    const Grid<float> light = picture_of(300, 260, scene);
    const auto all = find_lines(light);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = find_lines(light);
    REQUIRE(all.size() == alone.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i].points == alone[i].points);
        CHECK(all[i].widths == alone[i].widths);
        CHECK(all[i].strength == alone[i].strength);
    }
    CHECK(find_lines({}).empty());
    for (const int width : {1, 2, 3, 4, 9})
        for (const int height : {1, 2, 3, 5, 200})
            for (const float value : {0.0f, 1.0f, 7.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()})
                CHECK(find_lines(Grid<float>(width, height, value)).empty());
    Grid<float> odd = light;
    odd.at(100, 100) = std::numeric_limits<float>::quiet_NaN();
    odd.at(100, 101) = std::numeric_limits<float>::infinity();
    for (const InkLine& line : find_lines(odd))
        for (const glm::dvec2 p : line.points) CHECK((std::isfinite(p.x) && std::isfinite(p.y)));
}
