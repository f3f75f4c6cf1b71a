#include "lab/compare/contenders.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "core/drawing/settings.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"
#include "io/files/tile_library.h"
#include "lab/related/methods.h"

namespace dapple {
namespace {

const Density& even_grey() {
    static const Density grey(Grid<float>(1, 1, 1.0f));
    return grey;
}

// A built-in tile, made ready when it is first asked for.
struct LateTile {
    std::string_view name;
    std::optional<RankingMethod> ranking;
    std::optional<RankedTile> loaded{};

    RankedTile& tile() {
        if (!loaded) loaded.emplace(tile_named(std::string(name), ranking));
        return *loaded;
    }
};

struct OwnPlacing {
    std::string_view tile = kDefaultTile;
    std::optional<RankingMethod> ranking{};  // none: the tile's own
    PlacerKind placer = PlacerKind::exact;
    int steps = 0;  // of relaxation
};

std::function<PlainDots(const DotsWanted&)> placed_with(const OwnPlacing& how) {
    const auto late = std::make_shared<LateTile>(LateTile{how.tile, how.ranking});
    return [late, how](const DotsWanted& wanted) -> PlainDots {
        const Density& density = wanted.density ? *wanted.density : even_grey();
        PlacingRequest request;
        request.count = wanted.count;
        request.threads = 1;
        Stippling placed;
        if (!stipple(late->tile(), density, how.placer, request, placed, wanted.stop)) return {};
        const double stirring = stirring_of(late->tile().placer().table(), placed.scale);
        const RelaxingRequest relaxing{.scale = placed.scale, .stirring = stirring};
        if (!relax(placed.dots, density, how.steps, relaxing, wanted.stop)) return {};
        PlainDots dots;
        dots.reserve(placed.dots.size());
        // Rounded to float, one can lie just on the far edge.
        for_each_position(placed.dots, [&](float x, float y) {
            dots.push_back(wanted.density ? glm::dvec2(x, y) : on_unit_torus({x, y}));
        });
        return dots;
    };
}

}  // namespace

std::vector<Contender> all_contenders() {
    std::vector<Contender> all{
        {.name = "dapple",
         .title = "Dapple, as placed",
         .source = "this program",
         .limits = "up to a billion dots; no seed",
         .nested = true,
         .ours = true,
         .has_tiles = true,
         .dots = placed_with({})},
        {.name = "dapple-relaxed",
         .title = fmt::format("Dapple, {} steps", kFewestUsualSteps),
         .source = "this program",
         .limits = "up to a billion dots; on a page whose edges are edges; no seed",
         .ours = true,
         .has_tiles = true,
         .dots = placed_with({.steps = kFewestUsualSteps})},
        {.name = "paper",
         .title = "the paper's tile and ranks",
         .source = "Lagae & Dutré 2006",
         .limits = "Figure 8's dots without those that it places twice, by our placer; no seed",
         .nested = true,
         .has_tiles = true,
         .dots = placed_with({.tile = "paper16", .ranking = RankingMethod::paper})},
        {.name = "figure8",
         .title = "the paper's Figure 8 as printed",
         .source = "Lagae & Dutré 2006",
         .limits = "the count is that of distinct dots; a quarter of all are placed twice; no seed",
         .has_tiles = true,
         .dots = placed_with(
             {.tile = "paper16", .ranking = RankingMethod::paper, .placer = PlacerKind::figure8})},
    };
    for (const RelatedMethod& method : related_methods()) {
        all.push_back({.name = std::string(method.name),
                       .title = std::string(method.title),
                       .source = std::string(method.source),
                       .limits = std::string(method.limits),
                       .nested = method.nested,
                       .has_tiles = method.has_tiles,
                       .pictures_only = method.pictures_only,
                       .level_factor = method.level_factor,
                       .dots = method.dots});
    }
    return all;
}

std::string contender_names() {
    std::string names;
    for (const Contender& one : all_contenders()) names += (names.empty() ? "" : ", ") + one.name;
    return names;
}

std::vector<Contender> contenders_named(const std::vector<std::string>& names) {
    const std::vector<Contender> all = all_contenders();
    std::vector<Contender> chosen;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(all, name, &Contender::name);
        if (found == all.end())
            throw std::runtime_error(
                fmt::format("--methods: {} is not known; there are {}", name, contender_names()));
        chosen.push_back(*found);
    }
    return chosen;
}

}  // namespace dapple
