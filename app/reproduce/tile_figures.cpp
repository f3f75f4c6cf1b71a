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
    page.heading("Figures 1 and 2: the self-similar tile and its ranks");
    page.pictures(
        std::array{HtmlPage::Picture{.bytes = std::move(figure).str(),
                                     .media_type = "image/svg+xml",
                                     .alt = "the tile, its copies on the quadrants, and its ranks"}},
        "The tile of Appendix A. Laid on its quadrants at half the size, a colour each, it covers its own "
        "points: each circle is around a coloured one. Below, its first points in the order of the ranks: "
        "each such set is spread over the whole tile.");

    std::vector<HtmlPage::Row> rows(stored.tile.size());
    for (std::size_t i = 0; i < stored.tile.size(); ++i) {
        const auto rank = static_cast<std::size_t>(stored.ranking.tile[i]);
        const glm::dvec2 p = to_unit_square(stored.tile.points[i]) * 65535.0;
        rows[rank].cells = {fmt::format("{}", rank), fmt::format("{:.0f}", p.x), fmt::format("{:.0f}", p.y)};
    }
    page.table({"Rank", "x, of 65535", "y, of 65535"}, rows);
}

}  // namespace dapple
