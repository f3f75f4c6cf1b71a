#include "lab/analysis/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/analysis/periodogram.h"
#include "core/output/raster.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "core/tile/tile_file.h"
#include "io/files/png_file.h"
#include "io/reports/html.h"
#include "io/reports/plot.h"

namespace dapple {
namespace {

constexpr int kPictureSide = 900;
constexpr double kDotsInDetail = 2500;

std::string introduction(const Subject& subject) {
    std::string text = fmt::format("{} points of {}", grouped(subject.points.size()), subject.name);
    if (const auto& placed = subject.placed) {
        text += fmt::format(", placed with the tile {}, {} ranking, by the {} placer at scale {:.6g}",
                            placed->tile, name_of(placed->ranking), name_of(placed->placer), placed->scale);
        if (placed->duplicates > 0)
            text += fmt::format(", which emitted {} dots, {} of them a second time", grouped(placed->emitted),
                                grouped(placed->duplicates));
    }
    return text + (subject.domain.topology == Topology::torus
                       ? ". Opposite edges are taken to meet, as if the set went on beyond them."
                       : ". Nothing is assumed beyond the edges.");
}

void add_pictures(HtmlPage& page, const Subject& subject) {
    const Domain& domain = subject.domain;
    const double longer = std::max(domain.width, domain.height),
                 shorter = std::min(domain.width, domain.height);
    const double part = std::sqrt(kDotsInDetail / double(subject.points.size()) * shorter / longer);
    std::vector<HtmlPage::Picture> pictures{{.bytes = png_of_points(subject.points, domain, kPictureSide),
                                             .alt = "all the points, as black dots",
                                             .caption = "All of them"}};
    if (part < 0.7) {
        pictures.push_back(
            {.bytes = png_of_points(subject.points, domain, kPictureSide, part),
             .alt = "some of the points, enlarged",
             .caption = fmt::format("The upper left corner, {:.1f} times as large", 1 / part)});
    }
    page.pictures(
        pictures,
        "Look for rows, a weave, clumps and holes. An even set has none: every dot keeps its distance, "
        "yet nothing repeats.");
}

void add_spectrum(HtmlPage& page, const PointReport& report) {
    page.heading("Spectrum");
    page.pictures(
        std::array{
            HtmlPage::Picture{.bytes = png_of(spectrum_picture(report.spectrum)),
                              .alt = "power spectrum, frequency 0 in the middle",
                              .caption = fmt::format("Up to {:g} times the square root of the point count",
                                                     report.spectrum.highest_frequency),
                              .pixelated = true}},
        "How strongly the set waves in each direction (where the pixel lies) and at each fineness (how far "
        "out). "
        "The black disc in the middle says that large areas are even. Orange dots are waves that run through "
        "the "
        "whole set: it repeats itself. A good set shows a black disc, a soft grey ring and no orange.");
    page.drawings(
        std::array{radial_power_plot(report), anisotropy_plot(report)},
        "Left, the spectrum averaged over all directions: near 0 on the left means even tone, 1 is what "
        "dots thrown at random have. Right, how much directions differ: 0 dB if they differ by chance "
        "only, peaks above it if the set is regular.");
}

struct Figure {
    std::string name, value, noise, lattice, meaning;
};

std::vector<Figure> figures_of(const Subject& subject, const PointReport& report) {
    const double n = double(std::max<std::size_t>(report.count, 1));
    const double bins = 0.5 * 3.14159265 * (4 - 0.25) * n;  // half the ring 0.5 < |k| < 2 sqrt(n)
    const auto number = [](double value) { return fmt::format("{:.4f}", value); };
    std::vector<Figure> figures{
        {"Smallest distance (relative radius)", number(report.relative_radius), "about 0", "1.0000",
         "over the hexagonal lattice's; two dots touch sooner the smaller it is"},
        {"1st percentile of nearest distances", number(report.nearest.p1), "0.05", "1.0000",
         "one dot in a hundred has a neighbour nearer than this"},
        {"Mean of nearest distances", number(report.nearest.mean), "0.4653", "1.0000",
         "how well dots keep apart"},
        {"Power below 0.3", number(report.power_below_03), "1", "0", "unevenness of large areas"},
        {"Power below 0.5", number(report.power_below_05), "1", "0", "unevenness of middling areas"},
        {"Highest bin", fmt::format("{:.1f}", report.peaks.highest_bin),
         fmt::format("about {:.0f}", std::log(bins) + 0.58), grouped(report.count),
         "strongest wave; far above white noise, the eye sees rows"},
        {"Share of the top 0.1 % of bins", fmt::format("{:.2f} %", 100 * report.peaks.top_share), "0.79 %",
         "100 %", "how much of the structure is repetition"},
        {"Effective Nyquist frequency", number(report.effective_nyquist), "0", "about 1",
         "finest waves that the set samples cleanly, over a square lattice's"},
    };
    if (report.periodicity && subject.period)
        figures.push_back(
            {"Periodicity", number(report.periodicity->value), "about 0", "1",
             fmt::format("share of dots that meet another when the set is moved by {} and {} tiles of "
                         "side {:.4g}, the worst of all moves",
                         report.periodicity->lag_x, report.periodicity->lag_y, subject.period->x)});
    figures.push_back({"Local density, deviation", number(report.local_density.deviation), "0.1250",
                       "about 0",
                       fmt::format("of counts in {} x {} cells, over their mean",
                                   report.local_density.columns, report.local_density.rows)});
    const StarDiscrepancy& star = report.star_discrepancy;
    figures.push_back({"Star discrepancy",
                       star.lower == star.upper ? fmt::format("{:.6f}", star.lower)
                                                : fmt::format("{:.6f} to {:.6f}", star.lower, star.upper),
                       "", "", "worst error when counting dots in a box in the corner to measure its area"});
    figures.push_back({"L2 star discrepancy", fmt::format("{:.6f}", report.l2_star_discrepancy),
                       fmt::format("{:.6f}", std::sqrt(5 / (36 * n))), "", "that error in the mean square"});
    return figures;
}

void add_figures(HtmlPage& page, const Subject& subject, const PointReport& report) {
    page.heading("In numbers");
    std::vector<HtmlPage::Row> rows;
    for (const Figure& figure : figures_of(subject, report))
        rows.push_back({.cells = {figure.name, figure.value, figure.noise, figure.lattice, figure.meaning}});
    page.table({"What", "This set", "Dots at random", "Hexagonal lattice", "Which means"}, rows);
}

void add_tone(HtmlPage& page, const Subject& subject) {
    if (subject.tone.empty()) return;
    page.heading("Tone");
    std::vector<HtmlPage::Row> rows;
    for (const ToneFromAfar& seen : subject.tone)
        rows.push_back({.cells = {fmt::format("{:g} spacings", seen.sigma_spacings),
                                  fmt::format("{:.2f} m", seen.distance_mm / 1000),
                                  fmt::format("{:+.2f} %", 100 * seen.fidelity.mean_error),
                                  fmt::format("{:.2f} %", 100 * seen.fidelity.rms_error),
                                  fmt::format("{:.1f} dB", seen.fidelity.psnr_db),
                                  fmt::format("{:.4f}", seen.fidelity.ssim)}});
    page.table({"Eye's blur", "Seen from", "Mean error", "Root mean square error", "PSNR", "SSIM"}, rows);
    page.paragraph(
        "The drawing beside the photograph, both blurred as an eye with a blur of one minute of arc does "
        "from that "
        "distance, in linear light, where 100 % is the paper. A mean error above 0 is a drawing that is too "
        "light; "
        "SSIM is 1 where no difference is to be seen.");
}

}  // namespace

std::string png_of(const Grid<glm::u8vec3>& picture) {
    std::ostringstream out;
    write_png(out, {picture.width, picture.height, 96}, [&](const PixelSink& sink) { sink(picture); });
    return std::move(out).str();
}

std::string png_of_points(const std::vector<glm::dvec2>& points, const Domain& domain, int longer_side,
                          double part) {
    const double unit = longer_side / std::max(domain.width, domain.height) / part;  // px
    // A page on which a millimetre is a pixel.
    const PageSize page{std::min(domain.width * unit, double(longer_side)),
                        std::min(domain.height * unit, double(longer_side)), unit};
    Dots dots;
    for (const glm::dvec2 p : points) {
        if (p.x * unit > page.width_mm + longer_side || p.y * unit > page.height_mm + longer_side) continue;
        dots.x.push_back(static_cast<float>(p.x));
        dots.y.push_back(static_cast<float>(p.y));
    }
    const double spacing = std::sqrt(domain.area() / double(std::max<std::size_t>(points.size(), 1))) * unit;
    const double radius = std::clamp(0.28 * spacing, 0.5, longer_side / 60.0);
    const Grid<float> coverage = coverage_of({.size = page, .dots = stream_of(dots), .dot_radius_mm = radius},
                                             {.dpi = kMmPerInch, .threads = 0});
    return png_of(ink_on_paper(coverage, kBlack, kWhite));
}

std::string radial_power_plot(const PointReport& report) {
    PlotCurve curve;
    double highest = 2;
    for (const Ring& ring : report.radial_power) {
        curve.points.push_back({ring.frequency, ring.power});
        highest = std::max(highest, ring.power);
    }
    // Peaks of a lattice would press all the rest flat.
    return svg_plot(
        {.title = "Radially averaged power",
         .x = {.label = "frequency, over the square root of the point count", .least = 0, .most = 2},
         .y = {.label = "mean power, 1 = white noise", .least = 0, .most = std::min(highest, 4.0)},
         .curves = {std::move(curve)},
         .levels = {{1, "white noise"}}});
}

std::string anisotropy_plot(const PointReport& report) {
    PlotCurve curve;
    double highest = 10;
    for (const Ring& ring : report.radial_power) {
        if (ring.bins < 2) continue;
        curve.points.push_back({ring.frequency, ring.anisotropy_db});
        highest = std::max(highest, ring.anisotropy_db);
    }
    return svg_plot(
        {.title = "Anisotropy",
         .x = {.label = "frequency, over the square root of the point count", .least = 0, .most = 2},
         .y = {.label = "anisotropy, decibel", .least = -10, .most = std::ceil(highest / 5) * 5},
         .curves = {std::move(curve)},
         .levels = {{0, "the same in all directions"}}});
}

std::string pair_correlation_plot(const PointReport& report) {
    const PairCorrelation& pairs = report.pair_correlation;
    PlotCurve curve;
    double highest = 2;
    for (std::size_t b = 0; b < pairs.g.size(); ++b) {
        curve.points.push_back({(double(b) + 0.5) * pairs.bin_width, pairs.g[b]});
        highest = std::max(highest, pairs.g[b]);
    }
    return svg_plot(
        {.title = "Pair correlation",
         .x = {.label = "distance, in mean spacings",
               .least = 0,
               .most = double(pairs.g.size()) * pairs.bin_width},
         .y = {.label = "dots at that distance, 1 = white noise", .least = 0, .most = std::min(highest, 6.0)},
         .curves = {std::move(curve)},
         .levels = {{1, "white noise"}}});
}

std::string report_page(const Subject& subject, const PointReport& report) {
    HtmlPage page("Analysis of " + subject.name);
    page.paragraph(introduction(subject));
    if (!subject.points.empty()) add_pictures(page, subject);
    add_spectrum(page, report);
    page.heading("Distances");
    page.drawings(
        std::array{pair_correlation_plot(report)},
        "How many dots lie at each distance of a dot. Nothing up to almost one spacing means that dots "
        "keep apart; a curve that soon settles at 1 means that they are otherwise free, spikes that go on "
        "and on that the set is a lattice or repeats.");
    add_figures(page, subject, report);
    add_tone(page, subject);
    return page.text();
}

}  // namespace dapple
