#pragma once
// Which options of `dapple render` go together: what no single one of them can see.

#include <CLI/CLI.hpp>

#include "app/commands/render.h"

namespace dapple {

/// Throws CLI::ValidationError, "--option why", for options that contradict each other or that would have no
/// effect on what is written.
void check_that_fit(const CLI::App& command, const RenderOptions& options);

}  // namespace dapple
