#pragma once
// The paper's figures, made from scratch under the captions that it prints: each function adds some to the
// page, with a sentence that says what they show. Where the paper's own pictures are drawn, ours are others,
// and the page says so.

#include <filesystem>
#include <vector>

#include "io/reports/html.h"

namespace dapple {

/// Figure 1: the self-similar tile and its half-size copies. Figure 2: its ranks and its first 4, 8, 12 and
/// 16 points.
void add_tile_figures(HtmlPage& page);

/// Figure 3: a plot of f. Figure 4: a plot of f^(3) with its fixed points.
void add_function_figures(HtmlPage& page);

/// Figures 5 and 6: stippled pictures, with as many dots as the paper's eight have.
void add_stippling_figures(HtmlPage& page);

/// Figure 7: environment maps with as many samples as the paper's four have. A sky of our own if none are
/// given. Throws std::runtime_error if a file is no environment map.
void add_light_figures(HtmlPage& page, const std::vector<std::filesystem::path>& maps);

/// Named in the paper, but not shown: 16 points from four tiles of 4.
void add_tile_of_cycles(HtmlPage& page);

/// Not in the paper: what Figure 8, the algorithm, does on a ramp.
void add_recursion_pictures(HtmlPage& page);

/// Not in the paper: the power spectra of what it places, and of what the exact placer does.
void add_spectra(HtmlPage& page);

}  // namespace dapple
