#pragma once
// dapple render --sheets: all sheets of a drawing too large for one, and how to join them.

#include "app/commands/render.h"

namespace CLI {
class App;
}

namespace dapple {

/// --sheets, --overlap. The overlap is of `--sheet` too.
void add_mural_options(CLI::App& app, Sheet& sheets);

/// Says that none of so many pictures or sheets is this run's.
void tell_of_no_share(const WorkShare& share, std::size_t count, const char* things);

/// Draws each of options.drawing.sheets into a file of its own, and the plan beside them. Throws what
/// render() throws; sheets that were drawn before then stay, and the sentence says how many.
void render_mural(const RenderOptions& options);

}  // namespace dapple
