#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "io/reports/tile_figure.h"
#include "lab/reproduce/figures.h"
#include "lab/search/cycle_search.h"

namespace dapple {
namespace {

std::array<HtmlPage::Picture, 1> figure_of(const Tile& tile, RankingMethod method) {
    std::ostringstream figure;
    write_tile_figure(figure, ranked(tile, method));
    return {HtmlPage::Picture{.bytes = std::move(figure).str(),
                              .media_type = "image/svg+xml",
                              .alt = "the tile, its copies on the quadrants, and its ranks"}};
}

}  // namespace

void add_tile_figures(HtmlPage& page) {
    page.heading(
        "Figures 1 and 2: a tile and its half-size copies; a hierarchical tile, its ranks and first points");
    page.pictures(
        figure_of(parse_tile_integers("14217,2895/16"), RankingMethod::paper),
        "Both in one drawing, of the tile of Appendix A. Figure 1 is the upper row's first two squares: laid "
        "on its quadrants at half the size, a colour each, the tile covers its own points; each circle is "
        "around a coloured one. Figure 2 is the rest: the paper's ranks, and the first 4, 8, 12 and 16 "
        "points "
        "in their order, each set spread over the whole tile.");
}

void add_tile_of_cycles(HtmlPage& page) {
    page.heading("Not in the paper: 16 points from four tiles of 4");
    const std::vector<FoundCycles> best = search_cycles({4, 4, 4, 4}, 3).best;
    std::vector<std::string> words;
    for (const FoundCycles& found : best) words.push_back(fmt::format("{}", fmt::join(found.words, " ")));
    page.pictures(
        figure_of(make_tile(Rule{}, best.at(2).words), RankingMethod::paper),
        fmt::format(
            "Section 7 names this variation. Of all sets of four 4-point cycles the best three, which are "
            "{}, reach {:.6f}, where the best single cycle of 16 points has 0.696594. This is the last.",
            fmt::join(words, "; "), best.at(2).relative_radius));
}

}  // namespace dapple
