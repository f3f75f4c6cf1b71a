// Centroids of cells weighted by density squared, against closed forms and dense sampling.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "core/relaxing/lloyd_steps.h"

using namespace dapple;

namespace {

constexpr int kWidth = 64, kHeight = 48;

Grid<float> picture_of(const std::function<double(int, int)>& value) {
    Grid<float> grid(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) grid.at(x, y) = static_cast<float>(value(x, y));
    return grid;
}

// Cells and positions in pixels.
WeightedCentroid in_pixels(const Density& density) {
    return WeightedCentroid(density, 1.0 / kWidth);
}

// A cell about so many pixels wide, of a random shape.
VoronoiCell random_cell(std::mt19937& random, float size) {
    std::uniform_real_distribution<float> side(0.3f * size, 0.7f * size), turn(0, 6.2831853f);
    VoronoiCell cell(-side(random), -side(random), side(random), side(random));
    for (int i = 0; i < 6; ++i) {
        const float angle = turn(random), away = 2 * side(random);
        cell.cut(away * std::cos(angle), away * std::sin(angle));
    }
    return cell;
}

glm::dvec2 corner(const VoronoiCell& cell, int i) {
    return {cell[i % cell.size()].x, cell[i % cell.size()].y};
}

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Where a density that is linear over the cell has its centroid, squared: with the values at a triangle's
// corners, the integrals of products of barycentric coordinates are known.
glm::dvec2 closed_form(const VoronoiCell& cell, const std::function<double(glm::dvec2)>& density) {
    double weight = 0;
    glm::dvec2 moment(0);
    for (int i = 0; i < cell.size(); ++i) {
        const glm::dvec2 p[3]{{0, 0}, corner(cell, i), corner(cell, i + 1)};
        const double d[3]{density(p[0]), density(p[1]), density(p[2])};
        const double area = cross(p[1], p[2]) / 2;
        for (int k = 0; k < 3; ++k) {
            const double a = d[k], b = d[(k + 1) % 3], c = d[(k + 2) % 3];
            const double part =
                area / 60 * (6 * a * a + 2 * b * b + 2 * c * c + 4 * a * b + 4 * a * c + 2 * b * c);
            weight += part;
            moment += part * p[k];
        }
    }
    return moment / weight;
}

// Bilinear between the pixels' centres, and on beyond the outermost as there.
double value_at(const Grid<float>& grid, glm::dvec2 p) {
    const double u = std::clamp(p.x - 0.5, 0.0, kWidth - 1.0), v = std::clamp(p.y - 0.5, 0.0, kHeight - 1.0);
    const int x = std::min(static_cast<int>(u), kWidth - 2), y = std::min(static_cast<int>(v), kHeight - 2);
    const double s = u - x, t = v - y;
    return (1 - t) * ((1 - s) * grid.at(x, y) + s * grid.at(x + 1, y)) +
           t * ((1 - s) * grid.at(x, y + 1) + s * grid.at(x + 1, y + 1));
}

glm::dvec2 sampled(const VoronoiCell& cell, const Grid<float>& grid, glm::dvec2 dot) {
    glm::dvec2 low(0), high(0);
    for (int i = 0; i < cell.size(); ++i) {
        low = glm::min(low, corner(cell, i));
        high = glm::max(high, corner(cell, i));
    }
    constexpr int kSamples = 300;
    double weight = 0;
    glm::dvec2 moment(0);
    for (int j = 0; j < kSamples; ++j) {
        for (int i = 0; i < kSamples; ++i) {
            const glm::dvec2 p = low + (high - low) * (glm::dvec2(i, j) + 0.5) / double(kSamples);
            bool inside = true;
            for (int k = 0; k < cell.size() && inside; ++k)
                inside = cross(corner(cell, k + 1) - corner(cell, k), p - corner(cell, k)) >= 0;
            if (!inside) continue;
            const double d = value_at(grid, dot + p);
            weight += d * d;
            moment += d * d * p;
        }
    }
    return moment / weight;
}

struct Measured {
    double mean = 0, most = 0;  // distance from what is right, over the cell's size
};

// Random cells of that size at random places; `right` gets the cell and its dot.
Measured errors(const Grid<float>& grid, float size, float from_edge, int cells,
                const std::function<glm::dvec2(const VoronoiCell&, glm::dvec2)>& right) {
    const Density density(grid);
    WeightedCentroid centroid = in_pixels(density);
    std::mt19937 random(static_cast<unsigned>(size * 100));
    Measured result;
    for (int i = 0; i < cells; ++i) {
        const VoronoiCell cell = random_cell(random, size);
        std::uniform_real_distribution<float> x(from_edge, kWidth - from_edge),
            y(from_edge, kHeight - from_edge);
        const float dot_x = x(random), dot_y = y(random);
        const Centroid found = centroid.of(cell, centroid.anchor(dot_x, dot_y));
        REQUIRE(found.has_ink);
        const double error = glm::distance(glm::dvec2(found.x, found.y), right(cell, {dot_x, dot_y})) / size;
        result.mean += error / cells;
        result.most = std::max(result.most, error);
    }
    return result;
}

Grid<float> texture() {
    return picture_of([](int x, int y) {
        return 0.5 + 0.3 * std::sin(0.4 * x) * std::cos(0.3 * y) + 0.2 * std::sin(1.3 * x + 0.9 * y);
    });
}

}  // namespace

TEST_CASE("where all is one grey the centroid is the polygon's, whatever the cell's size and place") {
    const Grid<float> grid(kWidth, kHeight, 0.37f);
    const auto right = [](const VoronoiCell& cell, glm::dvec2) {
        return closed_form(cell, [](glm::dvec2) { return 1.0; });
    };
    for (const float size : {0.01f, 0.3f, 2.0f, 5.0f}) CHECK(errors(grid, size, 0, 300, right).most < 1e-5);
    // Cells of many pixels are cut into lines a pixel apart.
    for (const float size : {12.0f, 30.0f})
        CHECK(errors(grid, size, 0, 300, right).most < 4.0 / (size * size));
}

TEST_CASE("over a slope the centroid is that of the density squared") {
    const auto slope = [](double x, double y) { return 0.1 + 0.008 * x + 0.005 * y; };
    const Grid<float> grid = picture_of([&](int x, int y) { return slope(x + 0.5, y + 0.5); });
    const auto right = [&](const VoronoiCell& cell, glm::dvec2 dot) {
        return closed_form(cell, [&](glm::dvec2 p) { return slope(dot.x + p.x, dot.y + p.y); });
    };
    for (const float size : {0.3f, 2.0f, 5.0f}) CHECK(errors(grid, size, 6, 300, right).most < 1e-3);
    CHECK(errors(grid, 15, 16, 300, right).most < 0.01);
}

TEST_CASE("a square over a slope has the centroid of the textbook") {
    const double middle = 0.5, rise = 0.015;  // a pixel
    const Grid<float> grid = picture_of([&](int x, int) { return middle + rise * (x + 0.5 - 32); });
    const Density density(grid);
    WeightedCentroid centroid = in_pixels(density);
    for (const double half : {1.0, 3.0, 10.0}) {
        const auto h = static_cast<float>(half);
        const Centroid found = centroid.of(VoronoiCell(-h, -h, h, h), centroid.anchor(32, 24));
        // The integral of x (m + r x)^2 over that of (m + r x)^2.
        const double right =
            2 * middle * rise * half * half / 3 / (middle * middle + rise * rise * half * half / 3);
        CHECK(found.x == doctest::Approx(right).epsilon(0.01));
        CHECK(std::abs(found.y) < 1e-4);
    }
}

TEST_CASE("a cell over many pixels has the centroid of dense samples") {
    const Grid<float> grid = texture();
    const auto right = [&](const VoronoiCell& cell, glm::dvec2 dot) { return sampled(cell, grid, dot); };
    CHECK(errors(grid, 16, 13, 20, right).most < 0.01);
    CHECK(errors(grid, 22, 17, 20, right).most < 0.01);
}

TEST_CASE("a cell of a few pixels has about the centroid of dense samples") {
    const Grid<float> grid = texture();
    const auto right = [&](const VoronoiCell& cell, glm::dvec2 dot) { return sampled(cell, grid, dot); };
    for (const float size : {1.5f, 3.0f, 5.5f}) {
        const Measured measured = errors(grid, size, 5, 30, right);
        CHECK(measured.mean < 0.025);
        CHECK(measured.most < 0.06);
    }
}

TEST_CASE("beyond the picture's edges the density goes on as it is there") {
    const Grid<float> grid = texture();
    const auto right = [&](const VoronoiCell& cell, glm::dvec2 dot) { return sampled(cell, grid, dot); };
    // Half of these cells reach out.
    CHECK(errors(grid, 40, 0, 30, right).most < 0.01);
    // At the edges and corners.
    const Density density(grid);
    WeightedCentroid centroid = in_pixels(density);
    for (const float h : {2.0f, 9.0f}) {
        for (const glm::vec2 at : {glm::vec2(0, 0), {64, 48}, {0.5f, 20}, {63, 0.2f}, {30, 48}}) {
            const VoronoiCell cell(-h, -h, h, h);
            const Centroid found = centroid.of(cell, centroid.anchor(at.x, at.y));
            CAPTURE(at.x);
            CAPTURE(at.y);
            CHECK(glm::distance(glm::dvec2(found.x, found.y), sampled(cell, grid, at)) < 0.03 * 2 * h);
        }
    }
}

TEST_CASE("without ink in the cell there is no centroid; a trace of it is enough") {
    Grid<float> grid(kWidth, kHeight);
    const auto find = [&](const Grid<float>& values, float half, float x, float y) {
        const Density density(values);
        WeightedCentroid centroid = in_pixels(density);
        return centroid.of(VoronoiCell(-half, -half, half, half), centroid.anchor(x, y));
    };
    for (const float half : {0.5f, 3.0f, 12.0f, 200.0f}) CHECK_FALSE(find(grid, half, 20, 20).has_ink);
    grid.at(25, 20) = 0.01f;
    CHECK_FALSE(find(grid, 3, 20.5f, 20.5f).has_ink);
    const Centroid found = find(grid, 12, 20.5f, 20.5f);
    REQUIRE(found.has_ink);
    CHECK(found.x == doctest::Approx(5).epsilon(0.02));
    CHECK(std::abs(found.y) < 0.1);
}

TEST_CASE("the density at an offset is the picture's") {
    const Grid<float> grid = texture();
    const Density density(grid);
    const WeightedCentroid centroid = in_pixels(density);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> x(0, kWidth), y(0, kHeight), offset(-30, 30);
    for (int i = 0; i < 500; ++i) {
        const float at_x = x(random), at_y = y(random), dx = offset(random), dy = offset(random);
        CHECK(std::abs(centroid.density_at(centroid.anchor(at_x, at_y), dx, dy) -
                       value_at(grid, {at_x + dx, at_y + dy})) < 1e-4);
    }
}
