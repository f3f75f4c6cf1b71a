#include <array>
#include <limits>

#include "io/reports/plot.h"
#include "lab/reproduce/figures.h"

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

// With the diagonal, and the points that come back to themselves after so many steps.
std::string plot_of_f(int times, const char* title, const char* y) {
    const int pieces = 1 << times;
    PlotCurve diagonal{.name = {}, .points = {{0, 0}, {1, 1}}, .colour = {0.6f, 0.6f, 0.6f}};
    PlotCurve fixed{
        .name = {}, .points = {}, .colour = {0.85f, 0.35f, 0.1f}, .mark = PlotMark::dots, .dot_radius = 4};
    for (int k = 0; k < pieces - 1; ++k) fixed.points.push_back(glm::dvec2(double(k) / (pieces - 1)));
    return svg_plot({.title = title,
                     .x = {.label = "x", .least = 0, .most = 1, .parts = pieces},
                     .y = {.label = y, .least = 0, .most = 1, .parts = pieces},
                     .curves = {pieces_of_f(times), diagonal, fixed},
                     .width = 480,
                     .height = 440});
}

}  // namespace

void add_function_figures(HtmlPage& page) {
    page.heading("Figures 3 and 4: plots of f and f^(3)");
    page.drawings(
        std::array{plot_of_f(1, "f(x)", "f(x)"), plot_of_f(3, "f^(3)(x)", "f(f(f(x)))")},
        "f(x) = 2x for x below 1/2, and 2x - 1 from there on. A point of a self-similar tile lies in "
        "one of its quadrants; doubled, it has to lie on a point of the tile. So the points are those "
        "that f, on either axis, takes to one another. Three times over f has eight pieces, each eight times "
        "as steep as x. The dots, where a piece meets the diagonal, are the points that come back to "
        "themselves after three steps: the multiples of 1/7, of which 1 is 0 again. A tile of N points is "
        "such a cycle of N steps, in multiples of 1/(2^N - 1).");
}

}  // namespace dapple
