#include <array>
#include <limits>

#include "app/reproduce/figures.h"
#include "core/reports/plot.h"

namespace dapple {
namespace {

// f applied so many times, 2^times x modulo 1: as many straight pieces, each from 0 up to 1 and none
// joined to the next.
PlotCurve pieces_of_f(int times) {
    const int pieces = 1 << times;
    PlotCurve curve;
    for (int piece = 0; piece < pieces; ++piece) {
        curve.points.push_back({double(piece) / pieces, 0});
        curve.points.push_back({double(piece + 1) / pieces, 1});
        curve.points.push_back({double(piece + 1) / pieces, std::numeric_limits<double>::quiet_NaN()});
    }
    return curve;
}

std::string plot_of_f(int times, const char* title, const char* y) {
    return svg_plot({.title = title,
                     .x = {.label = "x", .least = 0, .most = 1},
                     .y = {.label = y, .least = 0, .most = 1},
                     .curves = {pieces_of_f(times)},
                     .width = 480,
                     .height = 440});
}

}  // namespace

void add_function_figures(HtmlPage& page) {
    page.heading("Figure 3: a plot of f");
    page.drawings(
        std::array{plot_of_f(1, "f(x)", "f(x)")},
        "f(x) = 2x for x below 1/2, and 2x - 1 from there on. A point of a self-similar tile lies in "
        "one of its quadrants; doubled, it has to lie on a point of the tile. So the points are those "
        "that f, on either axis, takes to one another.");
    page.heading("Figure 4: a plot of f^(3)");
    page.drawings(
        std::array{plot_of_f(3, "f^(3)(x)", "f(f(f(x)))")},
        "f three times over: eight pieces, each eight times as steep as x. Where a piece meets the "
        "diagonal is a point that comes back to itself after three steps, a multiple of 1/7; a tile "
        "of N points is such a cycle of N steps, in multiples of 1/(2^N - 1).");
}

}  // namespace dapple
