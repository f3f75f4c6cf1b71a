#include <fmt/format.h>

#include <array>

#include "app/analysis/report_page.h"
#include "app/files/sample.h"
#include "app/files/tile_library.h"
#include "app/reproduce/figures.h"
#include "core/image/ink.h"
#include "core/image/tone.h"
#include "core/output/raster.h"

namespace dapple {
namespace {

constexpr int kSide = 900;  // pixels

HtmlPage::Picture drawing_of(const Density& density, const Stippling& drawn, const std::string& how) {
    // A page on which a millimetre is a pixel.
    const PageSize page = page_size(density, kSide);
    const double radius = radius_for_tone(drawn.scale, InkCurve().full_load());
    const Grid<float> coverage =
        coverage_of(stream_of(drawn.dots), page,
                    {.dot_radius_mm = radius * page.mm_per_page_unit, .dpi = 25.4, .threads = 0});
    return {.bytes = png_of(ink_on_paper(coverage, kBlack, kWhite)),
            .alt = "a still life of shaded solids, drawn with dots",
            .caption = fmt::format(
                "{}: {} dots{}, placed in {:.1f} ms", how, drawn.dots.size(),
                drawn.duplicates > 0 ? fmt::format(", {} of them a second time", drawn.duplicates) : "",
                drawn.place_ms)};
}

}  // namespace

void add_stippling_figures(HtmlPage& page) {
    const Picture picture = sample_picture();
    const Density density(density_of(picture.light, {}));
    RankedTile tile = tile_named("paper16", RankingMethod::energy);

    page.heading("Figures 5 and 6: shaded primitives");
    for (const std::uint64_t dots : {30'000, 45'000}) {
        Stippling exact, printed;
        stipple(tile, density, PlacerKind::exact, {.count = dots}, exact);
        stipple(tile, density, PlacerKind::figure8, {.scale = exact.scale}, printed);
        page.pictures(
            std::array{drawing_of(density, printed, "Figure 8 as printed"),
                       drawing_of(density, exact, "The exact placer")},
            dots == 30'000
                ? "The built-in picture, solids as in the paper but rendered by us, at one scale: Figure 8 "
                  "loses thin lines and places some dots twice."
                : "The paper draws 30,000 to 45,000 dots in 80 ms on the machine of its day, 2006.");
    }
}

}  // namespace dapple
