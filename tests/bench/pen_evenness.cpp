// How even the dots of all pens and of each are: the tables of docs/pens.md.
//
//      pen_evenness DOTS            constant density, and shares of it
//      pen_evenness DOTS PHOTO      a photograph's, as the cmyk pens share them

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/image/detail.h"
#include "core/pens/pen_dots.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"

namespace {

using namespace dapple;

constexpr int kSide = 512;  // pixels of a constant density, and of what tone is looked at on

std::vector<glm::dvec2> points_of(const Dots& dots) {
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < dots.size(); ++i) points.emplace_back(dots.x[i], dots.y[i]);
    return points;
}

// The root of the mean square of the difference between dots and the density they are of, over its mean: both
// are blurred by a mean spacing of these dots.
double tone_error(const std::vector<glm::dvec2>& points, const Density& density) {
    const double longer = density.longer_side(), across = density.width() / longer,
                 down = density.height() / longer;
    Grid<float> dots(static_cast<int>(std::lround(kSide * across)),
                     static_cast<int>(std::lround(kSide * down)));
    Grid<float> wanted = dots;
    double sum = 0;
    for (int y = 0; y < wanted.height; ++y)
        for (int x = 0; x < wanted.width; ++x)
            sum += wanted.row(y)[x] =
                static_cast<float>(density.at(glm::dvec2(x + 0.5, y + 0.5) / double{kSide}));
    const auto count = static_cast<double>(points.size());
    for (float& value : wanted.values) value *= static_cast<float>(count / sum);
    for (const glm::dvec2 p : points) {
        const int x = std::clamp(static_cast<int>(p.x * kSide), 0, dots.width - 1);
        const int y = std::clamp(static_cast<int>(p.y * kSide), 0, dots.height - 1);
        dots.row(y)[x] += 1;
    }
    const double sigma = kSide * std::sqrt(across * down / count);
    dots = blurred(std::move(dots), sigma);
    wanted = blurred(std::move(wanted), sigma);
    double squares = 0;
    for (std::size_t i = 0; i < dots.values.size(); ++i)
        squares += std::pow(double{dots.values[i]} - double{wanted.values[i]}, 2);
    const auto pixels = static_cast<double>(dots.values.size());
    return std::sqrt(squares / pixels) / (count / pixels);
}

enum class Measured { distances, power, tone };

std::string measured(Measured what, const std::vector<glm::dvec2>& points, const Density& density) {
    if (what == Measured::power) {
        const double longer = density.longer_side();
        const Periodogram spectrum =
            periodogram(points, {density.width() / longer, density.height() / longer, Topology::window});
        return fmt::format("{:.3f} / {:.1f}", low_frequency_power(spectrum, 0.3),
                           spectral_peaks(spectrum).highest_bin);
    }
    if (what == Measured::tone) return fmt::format("{:.1f} %", 100 * tone_error(points, density));
    const LocalDistances found =
        local_distances(points, density, dots_at_full_density(density, points.size()));
    return fmt::format("{:.3f} / {:.3f}", found.p1, found.mean);
}

struct Drawing {
    std::string way;
    DotPieces dots;  // a piece for each pen
};

void print_table(Measured what, const std::vector<Drawing>& drawings, const PenDensities& densities) {
    for (const Drawing& drawing : drawings) {
        std::vector<glm::dvec2> all;
        std::string each;
        for (std::size_t pen = 0; pen < drawing.dots.pieces.size(); ++pen) {
            const std::vector<glm::dvec2> own = points_of(drawing.dots.pieces[pen]);
            all.insert(all.end(), own.begin(), own.end());
            each += fmt::format("{}{}", pen == 0 ? "" : ", ", measured(what, own, *densities.each[pen]));
        }
        fmt::print("| {} | {} | {} |\n", drawing.way, measured(what, all, *densities.all), each);
    }
}

Stippling drawn_dots(Pipeline& pipeline, const Density& density, std::uint64_t count) {
    pipeline.set_plain(density);
    DrawingSettings request;
    request.placing.count = count;
    Stippling drawn;
    pipeline.draw(pipeline.plan(request), drawn);
    return drawn;
}

// A drawing with one pen each. Turned on a square page, or else the same tile would give two of an even
// density the very same dots.
DotPieces independent_layers(Pipeline& pipeline, const PenDensities& densities, std::uint64_t count) {
    DotPieces layers;
    for (std::size_t pen = 0; pen < densities.each.size(); ++pen) {
        const Density& density = *densities.each[pen];
        const double share = density.mean() / densities.all->mean();
        Dots own;
        const Stippling layer =
            drawn_dots(pipeline, density, static_cast<std::uint64_t>(static_cast<double>(count) * share));
        for (const Dots& piece : layer.dots.pieces) append(own, piece);
        const bool square = density.width() == density.height();
        for (std::size_t turn = 0; square && turn < pen; ++turn)
            for (std::size_t i = 0; i < own.size(); ++i) own.x[i] = std::exchange(own.y[i], 1 - own.x[i]);
        layers.pieces.push_back(std::move(own));
    }
    return layers;
}

std::vector<Drawing> drawings_of(const PenDensities& densities, std::uint64_t count) {
    Pipeline pipeline;
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    const Stippling from = drawn_dots(pipeline, *densities.all, count);
    const auto shared_out = [&](bool move) {
        return pen_dots(from.dots, densities, {.scale = from.scale, .move = move, .threads = 0});
    };
    return {{"one drawing, pens exchanged", shared_out(false)},
            {"one drawing, moved too", shared_out(true)},
            {"independent layers", independent_layers(pipeline, densities, count)}};
}

// A picture has a spectrum of its own, so that of its dots says little.
enum class Kind { grey, photograph };

void print_tables(Kind kind, const std::string& title, const PenDensities& densities, std::uint64_t count) {
    const std::vector<Drawing> drawings = drawings_of(densities, count);
    const auto table = [&](const char* what, Measured which) {
        fmt::print("\n{}, {}\n\n| way | all dots | each pen's own |\n|---|---|---|\n", title, what);
        print_table(which, drawings, densities);
    };
    table("nearest distances: 1st percentile / mean", Measured::distances);
    if (kind == Kind::grey) table("spectra: power below 0.3 / highest bin", Measured::power);
    table("tone error", Measured::tone);
}

PenDensities shares_of_grey(const std::vector<double>& shares) {
    const auto grey = [](double value) {
        return std::make_shared<const Density>(Grid<float>(kSide, kSide, static_cast<float>(value)));
    };
    PenDensities densities{grey(0.5), {}};
    for (const double share : shares) densities.each.push_back(grey(0.5 * share));
    return densities;
}

PenDensities shares_of_photograph(const char* file, std::uint64_t count) {
    Picture picture = read_picture(file, PictureLimit::usual, PictureColours::kept);
    Pipeline pipeline;
    pipeline.set_tile(tile_named(kDefaultTile, {}));
    pipeline.set_light(std::move(picture.light), picture.exposure);
    pipeline.set_colours(std::move(picture.colours));
    DrawingSettings settings;
    settings.pens = parse_pens("cmyk");
    settings.placing.count = count;
    return pipeline.plan(settings).by_pen;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20'000;
        if (argc > 2) {
            print_tables(Kind::photograph, "The photograph", shares_of_photograph(argv[2], count), count);
        } else {
            print_tables(Kind::grey, "4 x .25", shares_of_grey({0.25, 0.25, 0.25, 0.25}), count);
            print_tables(Kind::grey, ".6 .3 .1", shares_of_grey({0.6, 0.3, 0.1}), count);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "pen_evenness: {}\n", error.what());
        return 1;
    }
}
