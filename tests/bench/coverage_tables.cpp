// How much paper evenly spread dots cover: prints the tables of core/image/ink.cpp. Takes a few minutes.
//
// A point of the paper is covered if the nearest dot is within a radius of it. So the distances from sample
// points to their nearest dots say how much dots of any radius cover.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/ink.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "io/files/tile_library.h"

namespace {

using namespace dapple;

constexpr int kPhases = 8, kLoads = 23;  // from one level to the next; 0, 0.1, ...
constexpr double kLoadStep = 0.1;
constexpr double kFewestDots = 65'536;  // a full level
constexpr int kSamples = 1000;          // along a side of the middle of the page
constexpr double kEdge = 0.1;           // of the page, left away
const std::vector kSteps{0, 1, 2, 3, 4, 5, 7, 10, 20, 50};

std::vector<double> coverage(const DotPieces& dots) {
    const auto count = static_cast<double>(dots.size());
    const int side = static_cast<int>(std::sqrt(count / 2));
    std::vector<std::vector<glm::dvec2>> cells(static_cast<std::size_t>(side) * side);
    const auto cell_of = [&](double p) { return std::clamp(static_cast<int>(p * side), 0, side - 1); };
    for_each_position(dots,
                      [&](float x, float y) { cells[cell_of(y) * side + cell_of(x)].emplace_back(x, y); });
    std::vector<double> covered(kLoads, 0);
    for (int j = 0; j < kSamples; ++j) {
        for (int i = 0; i < kSamples; ++i) {
            const glm::dvec2 p = kEdge + (1 - 2 * kEdge) * (glm::dvec2(i, j) + 0.5) / double(kSamples);
            double nearest2 = 1;
            for (int y = cell_of(p.y) - 2; y <= cell_of(p.y) + 2; ++y)
                for (int x = cell_of(p.x) - 2; x <= cell_of(p.x) + 2; ++x)
                    for (const glm::dvec2 dot : cells[y * side + x])
                        nearest2 = std::min(nearest2, glm::dot(dot - p, dot - p));
            const double load = std::numbers::pi * nearest2 * count;
            for (int k = kLoads - 1; k >= 0 && k * kLoadStep > load; --k) covered[k] += 1;
        }
    }
    for (double& c : covered) c /= double(kSamples) * kSamples;
    return covered;
}

void print_row(const std::vector<double>& row) {
    std::string line;
    for (const double c : row) line += fmt::format("{}{:.0f}", line.empty() ? "{" : ", ", 10'000 * c);
    std::puts((line + "},").c_str());
}

}  // namespace

int main() {
    RankedTile tile = tile_named(kDefaultTile);
    const Density black(Grid<float>(16, 16, 1.0f));
    std::vector tables(kSteps.size(), std::vector(kPhases, std::vector<double>()));
    for (int phase = 0; phase < kPhases; ++phase) {
        Stippling placed;
        const double count = kFewestDots * std::pow(4.0, double(phase) / kPhases);
        stipple(tile, black, PlacerKind::exact, {.count = static_cast<std::uint64_t>(count), .threads = 0},
                placed);
        for (std::size_t s = 0; s < kSteps.size(); ++s) {
            // Where dots overlap to solid black they are relaxed otherwise.
            const auto relaxed = [&](float even_from) {
                DotPieces dots = placed.dots;
                relax(dots, black, kSteps[s], {.scale = placed.scale, .threads = 0, .even_from = even_from});
                return coverage(dots);
            };
            tables[s][phase] = relaxed(kNeverEven);
            const std::vector<double> solid = relaxed(0);
            for (int k = 0; k < kLoads; ++k)
                if (k * kLoadStep > kSolidLoad + 1e-9) tables[s][phase][k] = solid[k];
        }
    }
    for (std::size_t s = 0; s < kSteps.size(); ++s) {
        fmt::print("// after {} steps, by phase\n", kSteps[s]);
        for (const auto& row : tables[s]) print_row(row);
        std::vector<double> middle;
        for (int k = 0; k < kLoads; ++k) {
            const auto [least, most] =
                std::ranges::minmax(tables[s], {}, [&](const auto& row) { return row[k]; });
            middle.push_back((least[k] + most[k]) / 2);
        }
        std::puts("// the middle between their extremes");
        print_row(middle);
    }
}
