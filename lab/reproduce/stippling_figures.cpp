#include <fmt/format.h>

#include <array>
#include <span>

#include "core/image/ink.h"
#include "core/image/tone.h"
#include "core/output/raster.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"
#include "lab/analysis/report_page.h"
#include "lab/reproduce/figure8_dots.h"
#include "lab/reproduce/figures.h"

namespace dapple {
namespace {

constexpr int kSide = 900;  // pixels
// The dots of the paper's pictures in its figures 5 and 6.
constexpr std::array<std::size_t, 4> kFigure5{44'202, 44'775, 41'709, 37'997};
constexpr std::array<std::size_t, 4> kFigure6{38'714, 30'583, 28'291, 36'809};

HtmlPage::Picture picture_of(const Density& density, const DotStream& dots, double scale, const char* alt,
                             std::string caption) {
    // A page on which a millimetre is a pixel.
    const PageSize page = page_size(density, kSide);
    const double radius = radius_for_tone(scale, InkCurve().full_load());
    const Grid<float> coverage =
        coverage_of({.size = page, .dots = dots, .dot_radius_mm = radius * page.mm_per_page_unit},
                    {.dpi = kMmPerInch, .threads = 0});
    return {
        .bytes = png_of(ink_on_paper(coverage, kBlack, kWhite)), .alt = alt, .caption = std::move(caption)};
}

// An even area would bring hundreds of dots at one scale: less than half a grey level parts them.
Density tilted(Grid<float> grid) {
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            grid.at(x, y) *=
                1 - 0.0019f * (float(x) + 0.37f * float(y)) / (1.37f * float(grid.width + grid.height));
    return Density(std::move(grid));
}

// Darkest in a corner: were it even along a side, whole rows of dots would come at one scale.
Density slanted_ramp() {
    Grid<float> grid(256, 256);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) grid.at(x, y) = (float(x) + 0.37f * float(y)) / (1.37f * 255);
    return Density(std::move(grid));
}

void add_row(HtmlPage& page, const Density& density, std::span<const std::size_t> printed, const char* alt,
             const char* sentence) {
    std::vector<HtmlPage::Picture> pictures;
    for (const std::size_t dots : printed) {
        const Figure8Drawing drawing = figure8_drawing(density, dots);
        pictures.push_back(
            picture_of(density, stream_of(drawing.placed.dots), drawing.placed.scale, alt,
                       fmt::format("Printed: {} dots; ours: {}", grouped(dots), in_words(drawing))));
    }
    page.pictures(pictures, sentence);
}

}  // namespace

void add_stippling_figures(HtmlPage& page) {
    const Density still_life = tilted(density_of(sample_picture().light, {}));
    const char* const solids = "a still life of shaded solids, drawn with dots";

    page.heading("Figures 5 and 6: stippled pictures");
    add_row(
        page, still_life, kFigure5, solids,
        "The counts of figure 5. Each picture took the paper approximately 80 ms in 2006. Ours are by its "
        "placer and ranks and have as many dots, counted as Figure 8 emits them, or one more where two come "
        "at one scale. The pictures are our choice: here the still life that this program carries, tilted by "
        "less than half a grey level, as its even areas would bring hundreds of dots at once.");
    add_row(page, slanted_ramp(), kFigure6, "a ramp from white to black, drawn with dots",
            "The counts of figure 6, on a ramp. The repeated tile shows where the tone changes slowly.");

    RankedTile tile = tile_named("paper16", RankingMethod::energy);
    std::vector<HtmlPage::Picture> pictures;
    for (const std::size_t dots : {kFigure6[2], kFigure5[1]}) {
        Stippling exact;
        stipple(tile, still_life, PlacerKind::exact, {.count = dots}, exact);
        pictures.push_back(picture_of(still_life, stream_of(exact.dots), exact.scale, solids,
                                      fmt::format("The exact placer: {} dots, placed in {:.1f} ms",
                                                  grouped(exact.dots.size()), exact.place_ms)));
    }
    page.pictures(pictures,
                  "Not in the paper: the fewest and the most of these by this program's own placer, with the "
                  "same tile ranked jointly. No dot comes twice, and thin lines stay.");
}

}  // namespace dapple
