// How even and how periodic each tile's dots are: constant grey at twelve densities between two levels, on
// the torus. Prints a table in Markdown.
//
//      tile_quality                        the built-in tiles for pictures, 65,536 dots and more
//      tile_quality TILE[:RANKING] ...     TILE as in dapple render --tile
//      tile_quality --level DOTS [TILE] .. only the full level of so many dots or the next one
//      tile_quality --relax STEPS ...      after so many steps of relaxation, before all of these
//
// The paper's ranks on the exact placer give Figure 8's dots without its duplicates. docs/make_quality makes
// docs/quality.md with it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/analysis/black_seams.h"
#include "app/files/tile_library.h"
#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "core/analysis/spectrum.h"
#include "core/relaxing/relax.h"
#include "core/text/numbers.h"

namespace {

using namespace dapple;

constexpr std::size_t kFewestDots = 40'000;
constexpr int kDensities = 12;

struct Marks {
    double highest_bin = 0, top_share = 0, power_03 = 0, power_05 = 0;
    NearestSummary nearest;
    double seam = 0;
};

// A number of each column, the worse of two.
Marks worse(const Marks& a, const Marks& b) {
    return {std::max(a.highest_bin, b.highest_bin),
            std::max(a.top_share, b.top_share),
            std::max(a.power_03, b.power_03),
            std::max(a.power_05, b.power_05),
            {std::min(a.nearest.minimum, b.nearest.minimum), std::min(a.nearest.p1, b.nearest.p1),
             std::min(a.nearest.mean, b.nearest.mean)},
            std::max(a.seam, b.seam)};
}

std::string in_columns(const Marks& m) {
    return fmt::format("{:.0f} | {:.1f} % | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} |",
                       m.highest_bin, 100 * m.top_share, m.power_03, m.power_05, m.nearest.minimum,
                       m.nearest.p1, m.nearest.mean, m.seam);
}

// Relaxed on the torus: with copies of the dots around them, as wide as what moves them from outside.
std::vector<glm::dvec2> relaxed(const std::vector<glm::dvec2>& points, double scale, int steps) {
    if (steps == 0) return points;
    const double rim = relaxing_rim(scale, steps), side = 1 + 2 * rim;
    Dots dots;
    const auto add = [&](glm::dvec2 p) {
        dots.x.push_back(static_cast<float>((p.x + rim) / side));
        dots.y.push_back(static_cast<float>((p.y + rim) / side));
    };
    for (const glm::dvec2 p : points) add(p);
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            if (i == 0 && j == 0) continue;
            for (const glm::dvec2 p : points) {
                const glm::dvec2 copy = p + glm::dvec2(i, j);
                if (glm::all(glm::greaterThan(copy, glm::dvec2(-rim))) &&
                    glm::all(glm::lessThan(copy, glm::dvec2(1 + rim))))
                    add(copy);
            }
        }
    }
    const Density grey(Grid<float>(1, 1, 1.0f));
    DotPieces pieces;
    pieces.pieces.push_back(std::move(dots));
    Relaxation relaxation(std::move(pieces), grey, {.scale = scale * side * side, .threads = 0});
    for (int step = 0; step < steps; ++step) relaxation.step();
    const Dots moved = relaxation.dots_as_taken();
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(glm::fract(glm::dvec2(moved.x[i], moved.y[i]) * side - rim));
    return result;
}

Marks marks_of(const std::vector<glm::dvec2>& points) {
    const Domain torus{};
    const std::vector<glm::dvec2> inside = points_inside(points, torus);
    const Periodogram spectrum = periodogram(inside, torus);
    const Peaks peaks = spectral_peaks(spectrum);
    return {peaks.highest_bin,
            peaks.top_share,
            low_frequency_power(spectrum, 0.3),
            low_frequency_power(spectrum, 0.5),
            nearest_summary(inside, torus),
            seams(points, kSeamLoad).worst()};
}

std::optional<RankingMethod> ranking_named(const std::string& name) {
    for (const RankingMethod method : {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy})
        if (name == name_of(method)) return method;
    throw std::runtime_error(name + ": no such ranking; there are paper, farthest, energy");
}

Marks print_row(RankedTile& tile, const std::string& name, double count, const Density& grey, int steps) {
    PlacingRequest request;
    request.scale = std::round(count) / 16;
    Stippling placed;
    stipple(tile, grey, PlacerKind::exact, request, placed);
    std::vector<glm::dvec2> points;
    for_each_position(placed.dots, [&](float x, float y) { points.emplace_back(x, y); });
    const Marks marks = marks_of(relaxed(points, placed.scale, steps));
    fmt::print("| {} | {} | {}\n", name, placed.dots.size(), in_columns(marks));
    std::fflush(stdout);
    return marks;
}

RankedTile tile_of(const std::string& argument) {
    const std::size_t colon = argument.find(':');
    std::optional<RankingMethod> ranking;
    if (colon != std::string::npos) ranking = ranking_named(argument.substr(colon + 1));
    return tile_named(argument.substr(0, colon), ranking);
}

void measure(const std::string& argument, const Density& grey, int steps) {
    RankedTile tile = tile_of(argument);
    const auto level = static_cast<double>(full_level(tile, kFewestDots));
    print_row(tile, argument, level, grey, steps);
    std::optional<Marks> between;
    for (int k = 1; k < kDensities; ++k) {
        const double count = level * std::pow(4.0, static_cast<double>(k) / kDensities);
        const Marks marks = print_row(tile, "", count, grey, steps);
        between = between ? worse(*between, marks) : marks;
    }
    fmt::print("| {}, worst between levels | | {}\n", argument, in_columns(*between));
}

void measure_level(const std::string& argument, std::size_t fewest_dots, const Density& grey, int steps) {
    RankedTile tile = tile_of(argument);
    print_row(tile, argument, static_cast<double>(full_level(tile, fewest_dots)), grey, steps);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> tiles(argv + 1, argv + argc);
        const auto option = [&](const char* name) {
            std::optional<std::size_t> value;
            if (tiles.size() < 2 || tiles[0] != name) return value;
            value = number_of<std::size_t>(tiles[1]);
            if (!value) throw std::runtime_error(tiles[1] + ": not a number");
            tiles.erase(tiles.begin(), tiles.begin() + 2);
            return value;
        };
        const auto steps = static_cast<int>(option("--relax").value_or(0));
        const std::optional<std::size_t> level = option("--level");
        if (tiles.empty()) {
            tiles = {"paper16:paper", "paper16",       "aperiodic16",  "aperiodic64",
                     "aperiodic256",  "aperiodic1024", "aperiodic4096"};
        }
        const Density grey(Grid<float>(1, 1, 1.0f));
        fmt::print(
            "| tile | dots | highest bin | top 0.1 % | power below 0.3 | below 0.5 | nearest: minimum | "
            "1st percentile | mean | seam |\n|---|---|---|---|---|---|---|---|---|---|\n");
        for (const std::string& tile : tiles) {
            if (level)
                measure_level(tile, *level, grey, steps);
            else
                measure(tile, grey, steps);
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "tile_quality: {}\n", error.what());
        return 1;
    }
}
