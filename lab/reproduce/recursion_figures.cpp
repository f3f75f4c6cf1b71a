#include <fmt/format.h>

#include <array>
#include <sstream>

#include "core/analysis/periodogram.h"
#include "core/analysis/report.h"
#include "core/output/drawing_format.h"
#include "io/reports/plot.h"
#include "lab/analysis/report_page.h"
#include "lab/analysis/subject.h"
#include "lab/reproduce/figures.h"

namespace dapple {
namespace {

constexpr double kRampScale = 400;
constexpr double kComparedScale = 2500;

// White at the left, black at the right.
Density ramp() {
    Grid<float> grid(256, 128);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            grid.at(x, y) = static_cast<float>(x) / static_cast<float>(grid.width - 1);
    return Density(std::move(grid));
}

std::string drawing_of(const DotStream& dots, std::vector<PlacedTile> tiles, const Density& density) {
    const PageSize page = page_size(density, 200);
    // Outlines beyond the picture say nothing.
    std::erase_if(tiles,
                  [&](const PlacedTile& tile) { return tile.y >= page.height_mm / page.mm_per_page_unit; });
    std::ostringstream out;
    write_svg(out, {.size = page, .dots = dots, .dot_radius_mm = 0.55, .background = kWhite, .tiles = tiles});
    return std::move(out).str();
}

struct Spectrum {
    HtmlPage::Picture picture;
    PlotCurve radial;
    PointReport report;
};

Spectrum spectrum_of(const std::string& name, const DrawingSettings& settings, glm::vec3 colour) {
    const Subject subject = dots_of_grey(1, settings, Topology::torus);
    Spectrum spectrum{.picture = {},
                      .radial = {.name = name, .colour = colour},
                      .report = *analyse(subject.points, subject.domain, {.period = subject.period})};
    for (const Ring& ring : spectrum.report.radial_power)
        spectrum.radial.points.push_back({ring.frequency, ring.power});
    spectrum.picture = {.bytes = png_of(spectrum_picture(spectrum.report.spectrum)),
                        .alt = "power spectrum of " + name,
                        .caption = fmt::format("{}: {} dots, highest bin {:.0f}, periodicity {:.2f}", name,
                                               spectrum.report.count, spectrum.report.peaks.highest_bin,
                                               spectrum.report.periodicity->value)};
    return spectrum;
}

}  // namespace

void add_recursion_pictures(HtmlPage& page) {
    const Density density = ramp();
    RankedTile tile(parse_tile_integers("14217,2895/16"), RankingMethod::energy);
    const Figure8Result printed = place_figure8(density, tile.tile(), tile.own_ranks(), kRampScale);
    DotPieces dots;
    tile.placer().place(density, {.scale = kRampScale}, dots);

    page.pictures(
        std::array{
            HtmlPage::Picture{
                .bytes = drawing_of(stream_of(printed.dots), printed.tiles, density),
                .media_type = "image/svg+xml",
                .alt = "dots on a ramp from white to black, with the outlines of the tiles",
                .caption = fmt::format("Figure 8 as printed: {} dots, {} of them a second time, {} tiles",
                                       printed.dots.size(), printed.duplicates, printed.tiles.size())},
            HtmlPage::Picture{
                .bytes =
                    drawing_of(stream_of(dots),
                               placed_tiles(tile.placer().table(), density, {.scale = kRampScale}), density),
                .media_type = "image/svg+xml",
                .alt = "the same with the exact placer",
                .caption = fmt::format("The exact placer: {} dots, each once", dots.size())}},
        "Not in the paper: on a ramp from white to black. The darker the picture, the deeper the tile is "
        "subdivided; a colour for each level.");
}

void add_spectra(HtmlPage& page) {
    DrawingSettings between;
    between.tile = "paper16";
    between.ranking = RankingMethod::paper;
    between.placer = PlacerKind::figure8;
    between.placing = {.scale = kComparedScale, .count = {}, .threads = 0};
    DrawingSettings complete = between;
    complete.placing.scale = 4096;
    DrawingSettings joint = between;
    joint.placer = PlacerKind::exact;
    joint.ranking = RankingMethod::energy;
    DrawingSettings turned = joint;
    turned.tile = "aperiodic4096";
    turned.ranking = {};
    const std::array spectra{spectrum_of("Figure 8, complete level", complete, {0.13f, 0.35f, 0.65f}),
                             spectrum_of("Figure 8, between levels", between, {0.85f, 0.35f, 0.1f}),
                             spectrum_of("joint ranking, between levels", joint, {0.1f, 0.55f, 0.35f}),
                             spectrum_of("aperiodic4096, between levels", turned, {0.45f, 0.3f, 0.6f})};
    page.heading("Not in the paper: power spectra");
    page.pictures(
        std::array{spectra[0].picture, spectra[1].picture, spectra[2].picture, spectra[3].picture},
        fmt::format(
            "Constant density. Orange is a wave of more than {} times white noise's power. The first three "
            "are of the tile of Appendix A: the same tile comes again and again, and moved by a tile all "
            "dots meet others (periodicity 1), so that at every orange dot much of the set, or all of it, "
            "moves as one. This is the periodicity that the paper names as its open problem. The fourth is "
            "of this program's own tile, whose copies are turned. Its few orange dots, the highest of power "
            "{:.0f}, are what is left of it: the tiles still lie on a square grid, and what their turned "
            "copies have in common repeats with it.",
            kPeakPower, spectra[3].report.peaks.highest_bin));
    page.drawings(
        std::array{svg_plot(
            {.title = "Radially averaged power",
             .x = {.label = "frequency, over the square root of the point count", .least = 0, .most = 2},
             .y = {.label = "mean power, 1 = white noise", .least = 0, .most = 6},
             .curves = {spectra[0].radial, spectra[1].radial, spectra[2].radial, spectra[3].radial},
             .levels = {{1, "white noise"}},
             .width = 900})},
        "Averaged over all directions. Peaks are rings that the tile's period makes; what lies near 0 on the "
        "left is unevenness of large areas.");
}

}  // namespace dapple
