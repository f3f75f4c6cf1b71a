#pragma once
// Which options of `dapple render` go together: what no single one of them can see.

#include <CLI/CLI.hpp>

#include "app/commands/render.h"

namespace dapple {

/// A part is drawn alone, even of what a project says to save as sheets, and sheets are of the whole page,
/// whatever region a project has. Throws CLI::ValidationError if both were asked for.
void take_part(const CLI::App& command, RenderOptions& options);

/// A pen whose width was given touches the paper once for each dot, or fills one of a given radius by a
/// spiral, rather than that a plotter follows a circle around which the pen's line is as wide again. What is
/// printed or has pixels looks the same either way.
void take_usual_shape(const CLI::App& command, RenderOptions& options);

/// Throws CLI::ValidationError, "--option why", for options that contradict each other or that would have no
/// effect on what is written.
void check_that_fit(const CLI::App& command, const RenderOptions& options);

}  // namespace dapple
