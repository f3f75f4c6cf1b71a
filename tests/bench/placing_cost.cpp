// How the cost of placing follows the dots and not the picture: `placing_cost FOLDER` measures for some
// minutes, prints the figures and saves them there as cost_dots.svg and cost_picture.svg. Needs 8 GiB.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/density.h"
#include "core/image/tone.h"
#include "core/placing/stipple.h"
#include "io/files/atomic_file.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"
#include "io/reports/plot.h"

using namespace dapple;

namespace {

constexpr double kSecondsEach = 0.5;
constexpr double kMostFigure8Dots = 1e7;  // a second and more from here on

// Milliseconds, the least of as many runs as fit; after a first one that finds its memory.
double least_ms(const std::function<void()>& run) {
    run();
    double least = std::numeric_limits<double>::infinity(), spent = 0;
    while (spent < kSecondsEach) {
        const auto start = std::chrono::steady_clock::now();
        run();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        least = std::min(least, 1000 * took.count());
        spent += took.count();
    }
    return least;
}

// The sample, enlarged or made smaller.
Grid<float> light_of_side(int side) {
    const Grid<float> light = sample_picture().light;
    const Density smooth(light);
    Grid<float> sized(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            sized.at(x, y) =
                static_cast<float>(smooth.at((glm::dvec2(x, y) + 0.5) / static_cast<double>(side)));
        }
    }
    return sized;
}

void save(const std::filesystem::path& file, const Plot& plot) {
    save_atomically(file, [&](std::ostream& out) { out << svg_plot(plot); });
}

Plot plot_against_dots() {
    const Density density(density_of(sample_picture().light, Tone{}));
    RankedTile usual = tile_named(kDefaultTile);
    RankedTile paper = tile_named("paper16", RankingMethod::paper);
    PlotCurve figure8{.name = "Figure 8, paper16", .colour = {0.75f, 0.2f, 0.15f}};
    PlotCurve one{.name = "one core", .colour = {0.13f, 0.35f, 0.65f}};
    PlotCurve all{.name = "all cores", .colour = {0.1f, 0.6f, 0.65f}};
    PlotCurve exactly{.name = "exact count", .colour = {0.5f, 0.35f, 0.7f}};
    PlotCurve writing{.name = "writing the numbers", .colour = {0.55f, 0.55f, 0.55f}};
    fmt::print("{:>10} {:>11} {:>11} {:>11} {:>11} {:>11}  ms\n", "dots", "figure 8", "one core", "all cores",
               "exactly", "writing");
    for (double dots = 1e3; dots <= 1.01e8; dots *= std::sqrt(10.0)) {
        const double scale = scale_for(density, dots);
        const auto add = [dots](PlotCurve& curve, const std::function<void()>& run) {
            curve.points.emplace_back(dots, least_ms(run));
            return curve.points.back().y;
        };
        double figure8_ms = std::nan("");
        if (dots < 1.01 * kMostFigure8Dots) {
            figure8_ms =
                add(figure8, [&] { place_figure8(density, paper.tile(), paper.own_ranks(), scale); });
        }
        DotPieces placed;
        const double one_ms = add(one, [&] { usual.placer().place(density, {.scale = scale}, placed); });
        const double all_ms =
            add(all, [&] { usual.placer().place(density, {.scale = scale, .threads = 0}, placed); });
        const PlacingRequest count{.count = static_cast<std::uint64_t>(dots)};
        const double exactly_ms = add(exactly, [&] { usual.placer().place(density, count, placed); });
        const double writing_ms = add(writing, [&, value = 0.0f]() mutable {
            value += 1;
            for (Dots& piece : placed.pieces) {
                for (FloatBuffer* column : {&piece.x, &piece.y}) std::ranges::fill(*column, value);
            }
        });
        fmt::print("{:>10.0f} {:>11.3f} {:>11.3f} {:>11.3f} {:>11.3f} {:>11.4f}\n", dots, figure8_ms, one_ms,
                   all_ms, exactly_ms, writing_ms);
    }
    return {.title = "Time to place against the number of dots",
            .x = {"dots", AxisScale::logarithmic},
            .y = {"milliseconds", AxisScale::logarithmic},
            .curves = {figure8, exactly, one, all, writing}};
}

Plot plot_against_picture() {
    RankedTile tile = tile_named(kDefaultTile);
    PlotCurve tone{.name = "tone and pyramid", .colour = {0.55f, 0.55f, 0.55f}};
    std::vector<PlotCurve> placing{{.name = "a million dots", .colour = {0.13f, 0.35f, 0.65f}},
                                   {.name = "10,000 dots", .colour = {0.1f, 0.6f, 0.65f}}};
    fmt::print("\n{:>10} {:>11} {:>11} {:>11}  ms\n", "megapixels", "tone", "10^6 dots", "10^4 dots");
    for (const int side : {500, 1000, 2000, 4000, 8000, 14000, 20000}) {
        const double megapixels = 1e-6 * side * side;
        Grid<float> light = light_of_side(side);
        const auto start = std::chrono::steady_clock::now();
        const Density density(density_of(std::move(light), Tone{}));
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        tone.points.emplace_back(megapixels, took.count());
        DotPieces placed;
        for (std::size_t i = 0; i < placing.size(); ++i) {
            const double scale = scale_for(density, i == 0 ? 1e6 : 1e4);
            placing[i].points.emplace_back(
                megapixels, least_ms([&] { tile.placer().place(density, {.scale = scale}, placed); }));
        }
        fmt::print("{:>10.2f} {:>11.2f} {:>11.3f} {:>11.3f}\n", megapixels, took.count(),
                   placing[0].points.back().y, placing[1].points.back().y);
    }
    return {.title = "Time to place against the size of the picture, one core",
            .x = {"megapixels", AxisScale::logarithmic},
            .y = {"milliseconds", AxisScale::logarithmic},
            .curves = {tone, placing[0], placing[1]}};
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
        // Said now, and not after minutes of measuring.
        if (!std::filesystem::is_directory(folder))
            throw std::runtime_error(folder.string() + ": no such folder; name one that is there");
        save(folder / "cost_dots.svg", plot_against_dots());
        save(folder / "cost_picture.svg", plot_against_picture());
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "placing_cost: {}\n", error.what());
        return 1;
    }
}
