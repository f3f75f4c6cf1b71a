#pragma once
// A comparison of light samplers: as CSV, as text, as a plot and as a page.

#include <ostream>
#include <string>
#include <string_view>

#include "core/lights/sampler_comparison.h"

namespace dapple {

/// sampler,samples,relative_error,largest_error,glossy_error,largest_glossy_error,slope and a line for each
/// sampler and count.
void write_comparison_csv(std::ostream& out, const LightComparison& comparison);

/// Error over count, both logarithmic, an <svg> element.
std::string comparison_plot(const LightComparison& comparison);

/// A page with the plot, the figures, and the ratios of the least error of the others to ours.
std::string comparison_page(const LightComparison& comparison, std::string_view map_name);

/// The figures as tables of text, a line a count, and the slopes.
std::string comparison_table(const LightComparison& comparison);

}  // namespace dapple
