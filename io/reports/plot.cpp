#include "io/reports/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/image/colour.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

// Room for tick labels and axis labels, px.
constexpr double kLeft = 64, kRight = 24, kTop = 16, kBottom = 52;
constexpr double kLegendLine = 18;

bool drawable(double value, AxisScale scale) {
    return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
}

struct Range {
    double least, most;
};

// An axis with its limits settled: values to 0..1.
class Ruler {
 public:
    Ruler(AxisScale scale, Range range) : scale_(scale), range_(range) {}

    const Range& range() const { return range_; }
    AxisScale scale() const { return scale_; }
    double place(double value) const {
        if (scale_ == AxisScale::linear) return (value - range_.least) / (range_.most - range_.least);
        return std::log(value / range_.least) / std::log(range_.most / range_.least);
    }

 private:
    AxisScale scale_;
    Range range_;
};

template <class Coordinate>
Ruler ruler_of(const Plot& plot, const PlotAxis& axis, const Coordinate& coordinate) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const PlotCurve& curve : plot.curves)
        for (const glm::dvec2 p : curve.points) {
            const double value = coordinate(p);
            if (!drawable(value, axis.scale)) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    const bool logarithmic = axis.scale == AxisScale::logarithmic;
    if (least > most) {
        least = logarithmic ? 1 : 0;
        most = logarithmic ? 10 : 1;
    }
    least = axis.least.value_or(least);
    most = axis.most.value_or(most);
    if (!(most > least)) most = logarithmic ? least * 10 : least + 1;
    return {axis.scale, {least, most}};
}

// A number as an exponent.
std::string raised(long number) {
    constexpr std::array kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char digit : std::to_string(number)) text += digit == '-' ? "⁻" : kDigits[digit - '0'];
    return text;
}

std::string tick_label(double value, AxisScale scale) {
    const double size = std::abs(value);
    if (size < 1e-12) return "0";
    const double power = std::log10(size);
    const bool is_power = value > 0 && std::abs(power - std::round(power)) < 1e-9;
    const bool long_power = scale == AxisScale::logarithmic && (size > 5e3 || size < 5e-4);
    const bool long_number = size >= 1e6 || size < 1e-4;
    if (is_power && (long_power || long_number)) return "10" + raised(std::lround(power));
    return long_number ? fmt::format("{:.0e}", value) : fmt::format("{:.6g}", value);
}

struct Tick {
    double at;
    std::string label;
};

std::vector<Tick> ticks_of(const PlotAxis& axis, const Ruler& ruler, int about) {
    std::vector<Tick> ticks;
    for (int k = 0; axis.parts > 0 && k <= axis.parts; ++k)
        ticks.push_back({double(k) / axis.parts, k == 0            ? "0"
                                                 : k == axis.parts ? "1"
                                                                   : fmt::format("{}/{}", k, axis.parts)});
    if (axis.parts > 0) return ticks;
    for (const double at : plot_ticks(ruler.range().least, ruler.range().most, about, ruler.scale()))
        ticks.push_back({at, tick_label(at, ruler.scale())});
    return ticks;
}

// A curve's name above the picture.
struct LegendEntry {
    const PlotCurve* curve;
    double x = 0;
    int line = 0;
};

// In as many lines as it takes; none for a single curve.
std::vector<LegendEntry> legend_of(const Plot& plot) {
    std::vector<LegendEntry> entries;
    double x = kLeft;
    int line = 0;
    for (const PlotCurve& curve : plot.curves) {
        if (curve.name.empty()) continue;
        const double width = 32 + 6.8 * double(curve.name.size());
        if (x > kLeft && x + width > plot.width) {
            x = kLeft;
            ++line;
        }
        entries.push_back({&curve, x, line});
        x += width;
    }
    if (entries.size() < 2) entries.clear();
    return entries;
}

class Writer {
 public:
    explicit Writer(const Plot& plot)
        : plot_(plot),
          x_(ruler_of(plot, plot.x, [](glm::dvec2 p) { return p.x; })),
          y_(ruler_of(plot, plot.y, [](glm::dvec2 p) { return p.y; })),
          legend_(legend_of(plot)),
          top_(kTop + (legend_.empty() ? 0 : kLegendLine * (legend_.back().line + 1))),
          width_(plot.width - kLeft - kRight),
          height_(plot.height - top_ - kBottom) {}

    std::string svg() {
        add(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )"
            R"(font-family="sans-serif" font-size="12" role="img"><title>{2}</title>)",
            plot_.width, plot_.height, xml_text(plot_.title));
        add(R"(<path d="M0 0H{0}V{1}H0Z" fill="#fff"/>)", plot_.width, plot_.height);
        axes();
        // An inner svg cuts off what lies outside it.
        add(R"(<svg x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}">)", kLeft, top_, width_, height_);
        for (const PlotCurve& curve : plot_.curves) draw(curve);
        add("</svg>");
        levels();
        legend();
        add("</svg>");
        return std::move(text_);
    }

 private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    }

    void axes() {
        const double bottom = top_ + height_;
        const std::vector<Tick> across = ticks_of(plot_.x, x_, 8), up = ticks_of(plot_.y, y_, 6);
        add(R"(<g stroke="#ddd" fill="none">)");
        for (const Tick& tick : across)
            add(R"(<path d="M{:.2f} {:.2f}V{:.2f}"/>)", kLeft + x_.place(tick.at) * width_, top_, bottom);
        for (const Tick& tick : up)
            add(R"(<path d="M{:.2f} {:.2f}H{:.2f}"/>)", kLeft, bottom - y_.place(tick.at) * height_,
                kLeft + width_);
        add(R"(</g><rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="none" stroke="#555"/>)",
            kLeft, top_, width_, height_);
        add(R"(<g fill="#222" text-anchor="middle">)");
        for (const Tick& tick : across)
            add(R"(<text x="{:.2f}" y="{:.2f}">{}</text>)", kLeft + x_.place(tick.at) * width_, bottom + 16,
                tick.label);
        add(R"(<text x="{:.2f}" y="{:.2f}">{}</text></g>)", kLeft + width_ / 2, bottom + 40,
            xml_text(plot_.x.label));
        add(R"(<g fill="#222" text-anchor="end">)");
        for (const Tick& tick : up)
            add(R"(<text x="{:.2f}" y="{:.2f}">{}</text>)", kLeft - 6,
                bottom - y_.place(tick.at) * height_ + 4, tick.label);
        add(R"~(</g><text fill="#222" text-anchor="middle" transform="translate(14 {:.2f}) rotate(-90)">{}</text>)~",
            top_ + height_ / 2, xml_text(plot_.y.label));
    }

    // From the inner svg's corner. Held near it: SVG readers keep coordinates as floats.
    glm::dvec2 pixel(glm::dvec2 p) const {
        return {std::clamp(x_.place(p.x) * width_, -1e5, 1e5),
                std::clamp((1 - y_.place(p.y)) * height_, -1e5, 1e5)};
    }

    void draw(const PlotCurve& curve) {
        const std::string colour = hex_of(curve.colour);
        if (curve.mark == PlotMark::line)
            add(R"(<path fill="none" stroke="{}" stroke-width="1.6" d=")", colour);
        else
            add(R"(<g fill="{}">)", colour);
        bool pen_down = false;
        for (const glm::dvec2 p : curve.points) {
            if (!drawable(p.x, x_.scale()) || !drawable(p.y, y_.scale())) {
                pen_down = false;
                continue;
            }
            const glm::dvec2 at = pixel(p);
            if (curve.mark == PlotMark::line)
                add("{}{:.2f} {:.2f}", pen_down ? 'L' : 'M', at.x, at.y);
            else
                add(R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:g}"/>)", at.x, at.y, curve.dot_radius);
            pen_down = true;
        }
        if (curve.mark == PlotMark::line)
            add("\"/>");
        else
            add("</g>");
    }

    void levels() {
        for (const PlotLevel& level : plot_.levels) {
            if (!drawable(level.y, y_.scale())) continue;
            const double share = y_.place(level.y);
            if (share < 0 || share > 1) continue;
            const double y = top_ + (1 - share) * height_;
            add(R"(<path d="M{0:.2f} {1:.2f}H{2:.2f}" stroke="#666" stroke-dasharray="5 4" fill="none"/>)",
                kLeft, y, kLeft + width_);
            add(R"(<text x="{:.2f}" y="{:.2f}" text-anchor="end" fill="#444" font-size="11" stroke="#fff" stroke-width="3" paint-order="stroke">{}</text>)",
                kLeft + width_ - 4, share > 0.9 ? y + 13 : y - 4, xml_text(level.label));
        }
    }

    void legend() {
        for (const auto& [curve, x, line] : legend_)
            add(R"(<rect x="{:.2f}" y="{}" width="12" height="4" fill="{}"/><text x="{:.2f}" y="{}" fill="#222">{}</text>)",
                x, 8 + kLegendLine * line, hex_of(curve->colour), x + 17, 14 + kLegendLine * line,
                xml_text(curve->name));
    }

    const Plot& plot_;
    Ruler x_, y_;
    std::vector<LegendEntry> legend_;
    double top_, width_, height_;
    std::string text_;
};

}  // namespace

std::vector<double> plot_ticks(double least, double most, int about, AxisScale scale) {
    std::vector<double> ticks;
    if (scale == AxisScale::logarithmic) {
        const int first = static_cast<int>(std::ceil(std::log10(least) - 1e-9));
        const int last = static_cast<int>(std::floor(std::log10(most) + 1e-9));
        const int step = std::max(1, (last - first) / std::max(about, 1) + 1);
        for (int power = first; power <= last; power += last - first < about ? 1 : step)
            ticks.push_back(std::pow(10.0, power));
        if (ticks.size() > 1) return ticks;
        ticks.clear();  // less than a decade or so: round numbers say more
    }
    const double rough = (most - least) / std::max(about, 1);
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double times : {5.0, 2.0, 1.0})
        if (times * decade >= rough * 0.999999) step = times * decade;
    const double slack = 1e-9 * (most - least);
    for (double i = std::ceil((least - slack) / step); i * step <= most + slack; ++i)
        ticks.push_back(i * step);
    return ticks;
}

std::string svg_plot(const Plot& plot) {
    return Writer(plot).svg();
}

}  // namespace dapple
