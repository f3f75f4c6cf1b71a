#include <fmt/format.h>

#include <array>
#include <sstream>

#include "app/reproduce/figures.h"
#include "core/reports/tile_figure.h"

namespace dapple {

void add_tile_figures(HtmlPage& page) {
    const StoredTile stored = ranked(parse_tile_integers("14217,2895/16"), RankingMethod::paper);
    std::ostringstream figure;
    write_tile_figure(figure, stored);
    page.heading(
        "Figures 1 and 2: a tile and its half-size copies; a hierarchical tile, its ranks and first points");
    page.pictures(
        std::array{HtmlPage::Picture{.bytes = std::move(figure).str(),
                                     .media_type = "image/svg+xml",
                                     .alt = "the tile, its copies on the quadrants, and its ranks"}},
        "Both in one drawing, of the tile of Appendix A. Figure 1 is the upper row's first two squares: laid "
        "on its quadrants at half the size, a colour each, the tile covers its own points; each circle is "
        "around a coloured one. Figure 2 is the rest: the paper's ranks, and the first 4, 8, 12 and 16 "
        "points "
        "in their order, each set spread over the whole tile.");
}

}  // namespace dapple
