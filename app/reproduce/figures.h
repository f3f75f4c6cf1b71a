#pragma once
// The paper's figures, made from scratch: each function adds one to the page, with a sentence that says what
// it shows. Where the printed figure is known here only by what the text says of it, ours shows that.

#include <filesystem>
#include <vector>

#include "core/reports/html.h"

namespace dapple {

/// Figure 1: the self-similar tile and its half-size copies. Figure 2: its ranks.
void add_tile_figures(HtmlPage& page);

/// Figures 3 and 4: the recursion on a ramp, and the spectrum of what it places.
void add_recursion_figures(HtmlPage& page);

/// Figures 5 and 6: shaded primitives drawn with 30,000 and 45,000 dots.
void add_stippling_figures(HtmlPage& page);

/// Figure 7: environment maps, with 8,000 and 34,000 light samples each. A sky of our own if none are given.
/// Throws std::runtime_error if a file is no environment map.
void add_light_figures(HtmlPage& page, const std::vector<std::filesystem::path>& maps);

}  // namespace dapple
