#pragma once
// Curves as an SVG picture with axes, ticks and labels, to stand alone or inside a page.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace dapple {

enum class AxisScale { linear, logarithmic };

struct PlotAxis {
    std::string label;  // what it is, and its unit: "distance, in mean spacings"
    AxisScale scale = AxisScale::linear;
    std::optional<double> least{}, most{};  // what the data span if not given; positive on a logarithmic axis
    int parts = 0;  // n: ticks at k/n, written so, on a linear axis from 0 to 1; 0: at round numbers
};

enum class PlotMark { line, dots };

struct PlotCurve {
    std::string name;  // in the legend; none, not in it
    /// In order. One that is not finite, or <= 0 on a logarithmic axis, breaks the line.
    std::vector<glm::dvec2> points{};
    glm::vec3 colour{0.13f, 0.35f, 0.65f};  // sRGB-encoded
    PlotMark mark = PlotMark::line;
    double dot_radius = 2.5;  // px
};

/// A dashed line across, to compare with.
struct PlotLevel {
    double y = 0;
    std::string label;
};

struct Plot {
    std::string title;  // what screen readers say and what a mouse at rest shows
    PlotAxis x{}, y{};
    std::vector<PlotCurve> curves{};
    std::vector<PlotLevel> levels{};
    int width = 640, height = 360;  // px of 96 to the inch
};

/// Well-formed XML, an <svg> element without an XML declaration. What lies beyond an axis' limits is cut off.
/// Axes without data go from 0 to 1, or 1 to 10.
std::string svg_plot(const Plot& plot);

/// Round numbers (1, 2 or 5 times a power of ten; powers of ten if logarithmic) from `least` to `most`, both
/// included if they are round: about `about` of them. least < most, and > 0 if logarithmic.
std::vector<double> plot_ticks(double least, double most, int about, AxisScale scale);

}  // namespace dapple
