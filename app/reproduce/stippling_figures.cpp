#include <fmt/format.h>

#include <array>

#include "app/analysis/report_page.h"
#include "app/files/sample.h"
#include "app/files/tile_library.h"
#include "app/reproduce/figure8_dots.h"
#include "app/reproduce/figures.h"
#include "app/shown_text.h"
#include "core/image/ink.h"
#include "core/image/tone.h"
#include "core/output/raster.h"

namespace dapple {
namespace {

constexpr int kSide = 900;  // pixels
// The fewest and the most dots of the paper's pictures in its figures 5 and 6.
constexpr std::array<std::size_t, 2> kPaperDots{28'291, 44'775};

HtmlPage::Picture picture_of(const Density& density, const DotStream& dots, double scale, const char* alt,
                             std::string caption) {
    // A page on which a millimetre is a pixel.
    const PageSize page = page_size(density, kSide);
    const double radius = radius_for_tone(scale, InkCurve().full_load());
    const Grid<float> coverage =
        coverage_of(dots, page, {.dot_radius_mm = radius * page.mm_per_page_unit, .dpi = 25.4, .threads = 0});
    return {
        .bytes = png_of(ink_on_paper(coverage, kBlack, kWhite)), .alt = alt, .caption = std::move(caption)};
}

// Darkest in a corner: were it even along a side, whole rows of dots would come at one scale.
Density slanted_ramp() {
    Grid<float> grid(256, 256);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) grid.at(x, y) = (float(x) + 0.37f * float(y)) / (1.37f * 255);
    return Density(std::move(grid));
}

void add_row(HtmlPage& page, const Density& density, const char* name, const char* alt,
             const char* sentence) {
    std::vector<HtmlPage::Picture> pictures;
    for (const std::size_t dots : kPaperDots) {
        const Figure8Drawing drawing = figure8_drawing(density, dots);
        pictures.push_back(picture_of(density, stream_of(drawing.placed.dots), drawing.placed.scale, alt,
                                      fmt::format("{}: {}", name, in_words(drawing))));
    }
    page.pictures(pictures, sentence);
}

}  // namespace

void add_stippling_figures(HtmlPage& page) {
    const Density still_life(density_of(sample_picture().light, {}));
    const char* const solids = "a still life of shaded solids, drawn with dots";

    page.heading("Figures 5 and 6: stippled pictures");
    add_row(
        page, still_life, "The still life", solids,
        "The paper's pictures have 28,291 to 44,775 dots and took it up to 80 ms in 2006. Ours have the "
        "fewest and the most of these, or one more where two dots come at one scale, counted as Figure 8 "
        "emits them, with the paper's placer and ranks. "
        "The pictures are our choice, as the paper's are not at hand: here the still life that this program "
        "carries.");
    add_row(page, slanted_ramp(), "A ramp", "a ramp from white to black, drawn with dots",
            "The same numbers on a ramp. The repeated tile shows where the tone changes slowly.");

    RankedTile tile = tile_named("paper16", RankingMethod::energy);
    std::vector<HtmlPage::Picture> pictures;
    for (const std::size_t dots : kPaperDots) {
        Stippling exact;
        stipple(tile, still_life, PlacerKind::exact, {.count = dots}, exact);
        pictures.push_back(picture_of(still_life, stream_of(exact.dots), exact.scale, solids,
                                      fmt::format("The exact placer: {} dots, placed in {:.1f} ms",
                                                  grouped(exact.dots.size()), exact.place_ms)));
    }
    page.pictures(pictures,
                  "Not in the paper: as many dots by this program's own placer, with the same tile ranked "
                  "jointly. No dot comes twice, and thin lines stay.");
}

}  // namespace dapple
