#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/text/shown_text.h"
#include "io/reports/html.h"
#include "io/reports/plot.h"
#include "lab/compare/compare_report.h"
#include "lab/compare/tables.h"

namespace dapple {
namespace {

constexpr std::size_t kCurvesInPlot = 3;

// Apart for those who see red and green alike (Okabe & Ito 2008).
constexpr std::array<glm::vec3, kCurvesInPlot> kColours{
    {{0.00f, 0.00f, 0.00f}, {0.00f, 0.45f, 0.70f}, {0.84f, 0.37f, 0.00f}}};

// The methods in groups of so many, dapple's placed dots in each to compare with.
std::vector<std::vector<const MeasuredMethod*>> groups_of(std::span<const MeasuredMethod> measured) {
    std::vector<std::vector<const MeasuredMethod*>> groups;
    const auto dapple =
        std::ranges::find_if(measured, [](const MeasuredMethod& one) { return one.method.ours; });
    for (const MeasuredMethod& one : measured) {
        if (one.method.pictures_only) continue;
        if (groups.empty() || groups.back().size() == kCurvesInPlot) {
            groups.emplace_back();
            if (dapple != measured.end() && &one != &*dapple) groups.back().push_back(&*dapple);
        }
        groups.back().push_back(&one);
    }
    return groups;
}

template <class PointsOf>
std::vector<PlotCurve> curves_of(const std::vector<const MeasuredMethod*>& group, const PointsOf& points_of) {
    std::vector<PlotCurve> curves;
    for (std::size_t i = 0; i < group.size(); ++i) {
        std::vector<glm::dvec2> points = points_of(*group[i]);
        if (points.empty()) continue;  // not measured
        curves.push_back(
            {.name = group[i]->method.title, .points = std::move(points), .colour = kColours[i]});
    }
    return curves;
}

std::vector<glm::dvec2> radial_points(const MeasuredMethod& one) {
    std::vector<glm::dvec2> points;
    if (one.grey.empty() || !one.grey[0]) return points;
    for (const Ring& ring : one.grey[0]->radial_power) points.push_back({ring.frequency, ring.power});
    return points;
}

std::vector<glm::dvec2> growth_points(const MeasuredMethod& one) {
    std::vector<glm::dvec2> points;
    for (const Growth& growth : one.growth)
        if (growth.seconds) points.push_back({double(growth.count), *growth.seconds});
    return points;
}

void add_table(HtmlPage& page, const CompareTable& table) {
    std::vector<HtmlPage::Row> rows;
    for (const std::vector<std::string>& row : table.rows) rows.push_back({.cells = row});
    page.table(table.head, rows);
}

void add_grey_pictures(HtmlPage& page, std::span<const MeasuredMethod> measured) {
    std::vector<HtmlPage::Picture> dots, spectra;
    for (const MeasuredMethod& one : measured) {
        if (one.grey.empty() || !one.grey[0]) continue;
        dots.push_back({.bytes = one.grey[0]->dots_png,
                        .alt = "dots of even grey by " + one.method.title,
                        .caption = one.method.title});
        spectra.push_back({.bytes = one.grey[0]->spectrum_png,
                           .alt = "power spectrum of " + one.method.title,
                           .caption = one.method.title,
                           .pixelated = true});
    }
    page.pictures(dots, "Some fifteen hundred of each method's dots. Look for rows, clumps and holes.");
    page.pictures(
        spectra,
        "Their power spectra, frequency 0 in the middle and the edges at twice the root of the number "
        "of dots. A black disc in the middle is even tone; orange is what repeats.");
}

void add_plots(HtmlPage& page, std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    std::vector<std::string> spectra, growth;
    for (const auto& group : groups_of(measured)) {
        spectra.push_back(svg_plot(
            {.title = "Radially averaged power",
             .x = {.label = "frequency, over the square root of the point count", .least = 0, .most = 2},
             .y = {.label = "mean power", .least = 0, .most = 3},
             .curves = curves_of(group, radial_points),
             .levels = {{.y = 1, .label = "white noise"}}}));
        growth.push_back(
            svg_plot({.title = "Time against number of dots",
                      .x = {.label = "dots", .scale = AxisScale::logarithmic, .least = 1e3, .most = 1e7},
                      .y = {.label = "seconds", .scale = AxisScale::logarithmic, .least = 1e-5, .most = 1e2},
                      .curves = curves_of(group, growth_points)}));
    }
    if (!request.dots.empty())
        page.drawings(spectra, "The spectra averaged over all directions: low on the left is even tone.");
    if (!request.growth.empty())
        page.drawings(growth, "Where a curve ends, the next count took longer than allowed.");
}

void add_drawings(HtmlPage& page, std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    for (std::size_t i = 0; i < request.pictures.size(); ++i) {
        page.heading(printable(request.pictures[i].name) + ", side by side");
        std::vector<HtmlPage::Picture> drawings{
            {.bytes = request.pictures[i].png, .alt = "the picture", .caption = "The picture"}};
        for (const MeasuredMethod& one : measured) {
            if (!one.drawings[i]) continue;
            drawings.push_back({.bytes = one.drawings[i]->png,
                                .alt = "drawn by " + one.method.title,
                                .caption = one.method.title});
        }
        page.pictures(drawings, "Each with the radius that gives the picture's mean light.");
    }
}

}  // namespace

std::string compare_page(std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    HtmlPage page("Dapple and related methods, measured");
    page.paragraph(fmt::format(
        "By dapple-lab compare, on this machine, seed {}. Each method is a plain program from its "
        "own paper; a dash stands for what took longer than {:g} seconds, or does not apply to a "
        "method. Time is processor time, all work done by one thread.",
        request.seed, request.seconds));
    for (const PlacesTable& places : places_tables(measured, request)) {
        page.heading(places.title);
        std::vector<HtmlPage::Row> rows;
        for (const PlacesTable::Row& row : places.rows)
            rows.push_back({.cells = row.cells,
                            .kind = row.dapple_first ? HtmlPage::RowKind::good : HtmlPage::RowKind::plain});
        page.table(kPlacesHead, rows);
        page.paragraph(places.sentence);
    }
    for (const CompareTable& table : compare_tables(measured, request)) {
        page.heading(table.title);
        add_table(page, table);
    }
    page.paragraph(
        "Nearest: distances to the nearest neighbour, over the largest possible. Power below 0.3 and 0.5: of "
        "the spectrum, up to that many times the root of the number of dots, where 1 is white noise. Highest "
        "bin and top 0.1 %: how strongly the dots repeat. Effective Nyquist: the finest waves that are "
        "sampled cleanly. Seam: bare paper along the borders of tiles on black, over the page's. Opposite "
        "edges of the grey are taken to meet, also for those methods that know nothing of it. On pictures: "
        "SSIM and gradients say how much structure is kept, tone error how far the light is off, each seen "
        "through a blur of one dot spacing. Each method has a density that allows for the overlap of its own "
        "dots.");
    page.heading("Spectra and time");
    add_plots(page, measured, request);
    if (!request.dots.empty()) {
        page.heading(fmt::format("Constant grey, {} dots, side by side", grouped(request.dots[0])));
        add_grey_pictures(page, measured);
    }
    add_drawings(page, measured, request);
    return page.text();
}

}  // namespace dapple
