// How even and how periodic each tile's dots are: constant grey at twelve densities between two levels, on
// the torus. Prints a table in Markdown.
//
//      tile_quality                        the built-in tiles for pictures, 65,536 dots and more
//      tile_quality TILE[:RANKING] ...     TILE as in dapple render --tile
//      tile_quality --level DOTS [TILE] .. only the full level of so many dots or the next one
//      tile_quality --relax STEPS ...      after so many steps of relaxation, before all of these
//      tile_quality --counts N,N,.. [TILE] just so many dots, placed and after the steps that a drawing has,
//                                          and after those for samples, with how many meet others once the
//                                          page moves by whole tiles; "wang" is a TILE too
//
// The paper's ranks on the exact placer give Figure 8's dots without its duplicates. docs/make_quality makes
// docs/quality.md with it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <glm/vec2.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/drawing/settings.h"
#include "core/text/number_words.h"
#include "io/files/tile_library.h"
#include "lab/analysis/seams.h"
#include "lab/related/methods.h"
#include "lab/related/wang_tiles.h"
#include "tests/bench/dot_marks.h"

namespace {

using namespace dapple;

constexpr std::size_t kFewestDots = 40'000;
constexpr int kDensities = 12;
constexpr double kPageMm2 = 210 * 297;
constexpr int kEvenSteps = 25, kSampleSteps = 60;
constexpr const char* kWang = "wang";

// A number of each column, the worse of two.
DotMarks worse(const DotMarks& a, const DotMarks& b) {
    return {std::max(a.highest_bin, b.highest_bin),
            std::max(a.top_share, b.top_share),
            std::max(a.power_03, b.power_03),
            std::max(a.power_05, b.power_05),
            {std::min(a.nearest.minimum, b.nearest.minimum), std::min(a.nearest.p1, b.nearest.p1),
             std::min(a.nearest.mean, b.nearest.mean)},
            std::max(a.seam, b.seam),
            std::max(a.structure_01, b.structure_01),
            std::max(a.structure_03, b.structure_03)};
}

std::string in_columns(const DotMarks& m) {
    return fmt::format("{:.0f} | {:.1f} % | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} |",
                       m.highest_bin, 100 * m.top_share, m.power_03, m.power_05, m.nearest.minimum,
                       m.nearest.p1, m.nearest.mean, m.seam);
}

std::optional<RankingMethod> ranking_named(const std::string& name) {
    for (const RankingMethod method : {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy})
        if (name == name_of(method)) return method;
    throw std::runtime_error(name + ": no such ranking; there are paper, farthest, energy");
}

std::vector<glm::dvec2> placed_dots(RankedTile& tile, double count, const Density& grey) {
    PlacingRequest request;
    request.scale = std::round(count) / kDotsPerScale;
    Stippling placed;
    stipple(tile, grey, PlacerKind::exact, request, placed);
    std::vector<glm::dvec2> points;
    for_each_position(placed.dots, [&](float x, float y) { points.emplace_back(x, y); });
    return points;
}

// As a drawing's are: stirred, then so many steps.
std::vector<glm::dvec2> as_relaxed(const std::vector<glm::dvec2>& placed, double scale, int steps,
                                   float kernel = kPictureKernel) {
    return steps == 0 ? placed : relaxed_on_torus(stirred_on_torus(placed, scale), scale, steps, kernel);
}

DotMarks print_row(RankedTile& tile, const std::string& name, double count, const Density& grey, int steps) {
    const auto points = placed_dots(tile, count, grey);
    const double scale = std::round(count) / kDotsPerScale;
    const DotMarks marks = dot_marks(as_relaxed(points, scale, steps), kSeamLoad);
    fmt::print("| {} | {} | {}\n", name, points.size(), in_columns(marks));
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
    std::optional<DotMarks> between;
    for (int k = 1; k < kDensities; ++k) {
        const double count = level * std::pow(4.0, static_cast<double>(k) / kDensities);
        const DotMarks marks = print_row(tile, "", count, grey, steps);
        between = between ? worse(*between, marks) : marks;
    }
    fmt::print("| {}, worst between levels | | {}\n", argument, in_columns(*between));
}

void measure_level(const std::string& argument, std::size_t fewest_dots, const Density& grey, int steps) {
    RankedTile tile = tile_of(argument);
    print_row(tile, argument, static_cast<double>(full_level(tile, fewest_dots)), grey, steps);
}

// Placed, after the steps that a drawing of so many dots has, after more, and after those for samples.
void print_rows(const std::string& name, const std::vector<glm::dvec2>& points, double tile_side) {
    const auto count = static_cast<double>(points.size());
    struct Settling {
        int steps;
        float kernel;
        const char* what;
    };
    for (const auto& [steps, kernel, what] : {Settling{0, kPictureKernel, ""},
                                              {usual_steps(count, kPageMm2), kPictureKernel, ""},
                                              {kEvenSteps, kPictureKernel, ""},
                                              {kSampleSteps, kSampleKernel, " for samples"}}) {
        const auto dots = as_relaxed(points, count / kDotsPerScale, steps, kernel);
        const DotMarks m = dot_marks(dots, kSeamLoad);
        fmt::print("| {} | {} | {}{} | {:.0f} | {:.1e} | {:.1e} | {:.3f} | {:.3f} | {:.2f} | {:.1f} % |\n",
                   name, points.size(), steps, what, m.highest_bin, m.structure_01, m.structure_03,
                   m.nearest.p1, m.nearest.mean, m.seam, 100 * coincidence(dots, tile_side));
        std::fflush(stdout);
    }
}

// The side of the tiles that are full at a count, or were last.
double side_at(double count, double tile_points, double level_factor) {
    const double level = std::floor(std::log(count / tile_points) / std::log(level_factor) + 1e-9);
    return std::pow(level_factor, -std::max(level, 0.0) / 2);
}

void measure_counts(const std::string& argument, const std::vector<std::size_t>& counts,
                    const Density& grey) {
    if (argument == kWang) {
        const double factor = related_method(kWang)->level_factor;
        for (const std::size_t count : counts) {
            const double side = side_at(static_cast<double>(count), kWangPoints, factor);
            print_rows(argument, recursive_wang_tiles({.count = count}), side);
        }
        return;
    }
    RankedTile tile = tile_of(argument);
    const std::string name = short_tile_name(argument);
    for (const std::size_t count : counts) {
        const auto dots = static_cast<double>(count);
        print_rows(name, placed_dots(tile, dots, grey),
                   side_at(dots, static_cast<double>(tile.tile().size()), 4));
    }
}

std::vector<std::size_t> counts_of(const std::string& list) {
    std::vector<std::size_t> counts;
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const auto count = number_of<std::size_t>(list.substr(at, end - at));
        if (!count) throw std::runtime_error(list + ": not numbers with commas between them");
        counts.push_back(*count);
        at = end + 1;
    }
    return counts;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> tiles(argv + 1, argv + argc);
        const auto option = [&](const char* name) {
            std::optional<std::string> value;
            if (tiles.size() < 2 || tiles[0] != name) return value;
            value = tiles[1];
            tiles.erase(tiles.begin(), tiles.begin() + 2);
            return value;
        };
        const auto number = [&](const char* name) {
            std::optional<std::size_t> value;
            const auto text = option(name);
            if (!text) return value;
            value = number_of<std::size_t>(*text);
            if (!value) throw std::runtime_error(*text + ": not a number");
            return value;
        };
        const Density grey(Grid<float>(1, 1, 1.0f));
        if (const auto list = option("--counts")) {
            const std::vector<std::size_t> counts = counts_of(*list);
            if (tiles.empty()) tiles = {kDefaultTile, "aperiodic4096", kWang};
            fmt::print(
                "| tile | dots | steps | highest bin | structure factor 0.03 to 0.1 | 0.1 to 0.3 | "
                "nearest: 1st percentile | mean | seam | coincidence "
                "|\n|---|---|---|---|---|---|---|---|---|---|\n");
            for (const std::string& tile : tiles) measure_counts(tile, counts, grey);
            return 0;
        }
        const auto steps = static_cast<int>(number("--relax").value_or(0));
        const std::optional<std::size_t> level = number("--level");
        if (tiles.empty()) {
            tiles = {"paper16:paper", "paper16",       "aperiodic16",   "aperiodic64",
                     "aperiodic256",  "aperiodic1024", "aperiodic4096", "kinds4096"};
        }
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
