// Tiles in other bases and dimensions: the best relative radii, how even and how periodic their dots are
// beside those of two-way subdivision, and a figure. Prints tables in Markdown; takes some minutes.
//
//      variations [FIGURE.svg RAMPS.svg]

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "lab/volume/cyclic_tile.h"
#include "tests/bench/cyclic_words.h"

namespace {

using namespace dapple;

std::string text_of_word(const std::vector<std::uint8_t>& word) {
    std::string text;
    for (const std::uint8_t letter : word) text += static_cast<char>('0' + letter);
    return text;
}

template <int Base, int Dimension>
void print_radii(int count, std::size_t how_many, double lowest) {
    const AllWords found = best_words<Base, Dimension>(count, how_many, lowest);
    fmt::print("| {}, {} | {} |", Base, Dimension, count);
    for (const auto& [radius, word] : found.best) fmt::print(" {:.6f}", radius);
    fmt::print(" | `{}` |\n", text_of_word(found.best.begin()->second));
    std::fflush(stdout);
}

// The worst of twelve densities over a level: the highest peak, the power up to half of the root of the
// number, and the nearest distances.
template <int Base>
void print_dots(const char* name, const std::string& word) {
    const auto tile = make_cyclic_tile<Base, 2>(letters_of(word));
    const auto even = [](const auto&) { return 1.0; };
    constexpr double kFewest = 20'000;
    double peak = 0, full_peak = 0, power = 0, p1 = 1, mean = 1, full_p1 = 0;
    constexpr int kDensities = 12;
    double full = static_cast<double>(tile.size());
    while (full < kFewest) full *= Base * Base;
    for (int i = 0; i < kDensities; ++i) {
        std::vector<glm::dvec2> points;
        for (const auto& dot :
             subdivided(tile, full * std::pow(Base * Base, i / double(kDensities)), even, even))
            points.push_back(dot.place);
        const Domain square{};
        const Periodogram spectrum = periodogram(points, square);
        const NearestSummary nearest = nearest_summary(points, square);
        const double highest = spectral_peaks(spectrum).highest_bin / static_cast<double>(points.size());
        if (i == 0) full_peak = highest;
        if (i == 0) full_p1 = nearest.p1;
        peak = std::max(peak, highest);
        power = std::max(power, low_frequency_power(spectrum, 0.5));
        p1 = std::min(p1, nearest.p1);
        mean = std::min(mean, nearest.mean);
    }
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, full_peak, peak, power,
               full_p1, p1, mean);
}

// Points, the half-size or third-size copies with the tile's own points ringed, and the order.
template <int Base>
void draw(std::ostream& out, const std::string& word) {
    const auto tile = make_cyclic_tile<Base, 2>(letters_of(word));
    constexpr double kSide = 60, kGap = 6;
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"198mm\" height=\"66mm\" viewBox=\"-3 -3 198 "
           "66\">\n";
    const auto dot = [&](double panel, const glm::dvec2& at, double radius, const char* look) {
        out << fmt::format("<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:g}\" {}/>\n",
                           panel * (kSide + kGap) + at.x * kSide, at.y * kSide, radius, look);
    };
    for (int panel = 0; panel < 3; ++panel) {
        const double x = panel * (kSide + kGap);
        out << fmt::format(
            "<rect x=\"{}\" y=\"0\" width=\"60\" height=\"60\" fill=\"#fff\" stroke=\"#000\" "
            "stroke-width=\".3\"/>\n",
            x);
        for (int line = 1; line < Base && panel < 2; ++line)
            out << fmt::format(
                "<path d=\"M{0:.3f} 0V60M{1} {2:.3f}h60\" stroke=\"#999\" stroke-width=\".2\"/>\n",
                x + kSide * line / Base, x, kSide * line / Base);
    }
    for (const auto& point : tile.points) dot(0, point, 1, "");
    for (const auto& newborn : tile.newborns) dot(1, newborn.place, 0.6, "fill=\"#c33\"");
    for (const auto& point : tile.points) {
        dot(1, point, 0.6, "");
        dot(1, point, 1.1, "fill=\"none\" stroke=\"#000\" stroke-width=\".2\"");
    }
    for (std::size_t rank = 0; rank < tile.size(); ++rank)
        out << fmt::format(
            "<text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"3.4\" text-anchor=\"middle\" "
            "font-family=\"sans-serif\">{}</text>\n",
            2 * (kSide + kGap) + tile.points[rank].x * kSide, tile.points[rank].y * kSide + 1.2, rank);
    out << "</svg>\n";
}

constexpr const char *kBest16 = "3022123303112100", *kBest18 = "735264788153624100";

// So many dots of a ramp from light to dark, on a square `left` millimetres from the picture's edge.
template <int Base>
void draw_ramp(std::ostream& out, const std::string& word, std::size_t count, double left) {
    constexpr double kSide = 95, kWidth = 0.84;
    const auto tile = make_cyclic_tile<Base, 2>(letters_of(word));
    auto dots = subdivided(
        tile, 2.1 * double(count),
        [](const SubdivisionCell<2>& cell) { return double(cell.place.x + 1) * std::pow(Base, -cell.level); },
        [](const glm::dvec2& place) { return place.x; });
    std::ranges::sort(dots, {}, &CriticalDot<2>::critical);
    dots.resize(std::min(dots.size(), count));
    out << fmt::format("<path stroke=\"#000\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"", kWidth);
    for (const auto& dot : dots)
        out << fmt::format("M{:.2f} {:.2f}h0", left + kSide * dot.place.x, kSide * dot.place.y);
    out << "\"/>\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1) {
        std::ofstream out(argv[1]);
        draw<3>(out, kBest18);
    }
    if (argc > 2) {
        std::ofstream out(argv[2]);
        out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"198mm\" height=\"96mm\" "
               "viewBox=\"-.5 -.5 198 96\">\n<rect x=\"-.5\" y=\"-.5\" width=\"198\" height=\"96\" "
               "fill=\"#fff\"/>\n";
        draw_ramp<2>(out, kBest16, 4000, 0);
        draw_ramp<3>(out, kBest18, 4000, 102);
        out << "</svg>\n";
    }
    fmt::print("| base, dimension | points | best relative radii | the best word |\n|---|---|---|---|\n");
    print_radii<2, 2>(8, 4, 0);
    print_radii<2, 2>(12, 4, 0);
    print_radii<2, 2>(16, 4, 0);
    print_radii<3, 2>(9, 5, 0);
    print_radii<3, 2>(18, 3, 0);
    print_radii<2, 3>(8, 5, 0);
    print_radii<2, 3>(16, 2, 0);
    double best = 0;
    std::vector<std::uint8_t> best_word;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        std::vector<std::uint8_t> word = annealed_word<3, 2>(27, WordAim::radius, seed, 30'000);
        const auto points = points_of_word<3, 2>(word);
        const double radius = relative_radius<glm::dvec2>(points);
        if (radius <= best) continue;
        best = radius;
        best_word = std::move(word);
    }
    fmt::print("| 3, 2 | 27 | {:.6f}, the best that 40 annealings found | `{}` |\n\n", best,
               text_of_word(best_word));
    fmt::print(
        "| tile | peak / n, full level | peak / n, worst | power below half, worst | 1st percentile, full "
        "level | 1st "
        "percentile, worst | mean, worst |\n|---|---|---|---|---|---|---|\n");
    print_dots<2>("two-way, 16 points, the best", kBest16);
    print_dots<2>("two-way, 16 points, the paper's", "3022031123321100");
    print_dots<3>("three-way, 9 points, the best", "753826410");
    print_dots<3>("three-way, 18 points, the best", kBest18);
    print_dots<3>("three-way, 27 points, as above", text_of_word(best_word));
}
