#pragma once
// A drawing as a machine plots it: what is on the paper after so many seconds.

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/output/plotting_time.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

struct PlotFilm {
    DotPieces dots;               // in the machine's order;
    Strokes strokes;              // or, if there are any, these in their place
    std::vector<double> seconds;  // at which each dot, or each point of the strokes, is drawn; never falling
    double total_seconds = 0;

    /// How many dots, or points of strokes, there are after so long.
    std::size_t drawn_after(double seconds) const;
    /// In page units where these are dots, in millimetres where they are strokes. Nowhere before the first.
    std::optional<glm::dvec2> pen_at(std::size_t drawn) const;
};

/// The dots come in the order given, a touch each; its total is plotting_time()'s.
PlotFilm plot_film(DotPieces dots, double mm_per_page_unit, const MachineProgram& program);

/// Its total is figures_of()'s; along a stroke the pen goes at one speed.
PlotFilm plot_film(Strokes strokes, const MachineProgram& program);

/// The first so many, their pens and radii too.
DotPieces first_dots(const DotPieces& dots, std::size_t count);

/// The strokes of the first so many points.
Strokes first_points(const Strokes& strokes, std::size_t count);

}  // namespace dapple
