#include "lab/related/methods.h"

#include <algorithm>
#include <iterator>

#include "lab/related/best_candidate.h"
#include "lab/related/dart_throwing.h"
#include "lab/related/floyd_steinberg.h"
#include "lab/related/gaussian_blue_noise.h"
#include "lab/related/jittered.h"
#include "lab/related/lbg.h"
#include "lab/related/penrose.h"
#include "lab/related/plain_lloyd.h"
#include "lab/related/quasi_random.h"
#include "lab/related/wang_tiles.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

constexpr RelatedMethod kMethods[] = {
    {.name = "white-noise",
     .title = "white noise",
     .source = "independent dots",
     .dots = white_noise,
     .nested = true,
     .limits = "any count"},
    {.name = "jittered",
     .title = "jittered grid",
     .source = "Cook 1986",
     .dots = jittered_grid,
     .limits = "any count"},
    {.name = "best-candidate",
     .title = "best candidate",
     .source = "Mitchell 1991",
     .dots = best_candidate,
     .nested = true,
     .limits = "time grows with the square of the count"},
    {.name = "dart-throwing",
     .title = "dart throwing",
     .source = "Cook 1986; maximal: Ebeida et al. 2012; pictures: McCool & Fiume 1992",
     .dots = dart_throwing,
     .limits = "constant: maximal, the count about one in a hundred off"},
    {.name = "lloyd",
     .title = "Lloyd, 100 steps",
     .source = "Lloyd 1957; pictures: Secord 2002",
     .dots = lloyd,
     .limits = "pictures: its time grows with the pixels too"},
    {.name = "lloyd-squared",
     .title = "Lloyd, density squared",
     .source = "Secord 2002, with the density's square as the weight",
     .dots = lloyd_squared,
     .pictures_only = true,
     .limits = "on constant grey the same as Lloyd"},
    {.name = "lbg",
     .title = "LBG",
     .source = "Deussen, Spicker & Zheng 2017",
     .dots = lbg,
     .limits = "the count some in a hundred off; dots of one size"},
    {.name = "gaussian",
     .title = "Gaussian blue noise",
     .source = "Ahmed, Ren & Wonka 2022",
     .dots = gaussian_blue_noise,
     .limits = "1,000 steps with momentum, or until dots lie still; pictures: its time grows with contrast"},
    {.name = "wang",
     .title = "recursive Wang tiles",
     .source = "Kopf et al. 2006",
     .dots = recursive_wang_tiles,
     .nested = true,
     .has_tiles = true,
     .level_factor = 16,
     .limits = "a set of our own, 16 tiles of 1,024 points, made once; no seed"},
    {.name = "penrose",
     .title = "Penrose tiles, relaxed",
     .source = "Ostromoukhov, Donohue & Jodoin 2004",
     .dots = penrose_tiles,
     .limits = "numbers and corrections of our own, made once; no seed"},
    {.name = "halton",
     .title = "Halton",
     .source = "Halton 1960",
     .dots = halton,
     .nested = true,
     .limits = "any count; no seed"},
    {.name = "hammersley",
     .title = "Hammersley",
     .source = "Hammersley 1960",
     .dots = hammersley,
     .limits = "any count; no seed"},
    {.name = "sobol",
     .title = "Sobol",
     .source = "Sobol 1967",
     .dots = sobol,
     .nested = true,
     .limits = "up to 2^32 dots; no seed"},
    {.name = "rank-1",
     .title = "rank-1 lattice",
     .source = "Dammertz & Keller 2008",
     .dots = rank1_lattice,
     .limits = "up to 2^31 dots; no seed"},
    {.name = "floyd-steinberg",
     .title = "Floyd-Steinberg",
     .source = "Floyd & Steinberg 1976",
     .dots = floyd_steinberg,
     .limits = "dots on pixels; the count about one in a hundred off; no seed"},
};

}  // namespace

std::span<const RelatedMethod> related_methods() {
    return kMethods;
}

const RelatedMethod* related_method(std::string_view name) {
    const auto* const found = std::ranges::find(kMethods, name, &RelatedMethod::name);
    return found == std::end(kMethods) ? nullptr : found;
}

}  // namespace dapple
