#pragma once
// What `dapple render` says of drawings once they are saved: a few lines for whoever plots them, and figures
// as JSON.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/render.h"
#include "core/drawing/drawing_figures.h"
#include "core/image/tone.h"

namespace dapple {

/// Milliseconds of wall time. Dots that are not held in memory are placed while they are written.
struct RenderTimes {
    double tile = 0, read = 0, tone = 0;
    double place = 0;  // and relax
    double order = 0;  // sort, and find the pen's way
    double write = 0;
    double check = 0;  // measure what is told before plotting, as far as that outlasts the writing
};

/// What was drawn.
struct Rendered : DrawingFigures {
    int width = 0, height = 0;  // of the picture
    double mean_density = 0;
    Tone tone;  // as drawn
    int steps = 0;
    std::uint64_t dots = 0;
    double scale = 0;
    std::optional<std::uint64_t> duplicates = {};  // among them; none if that is not known
    PageSize page;                                 // the sheet, the region or all of it
    PageSize whole_page = {};
    glm::ivec2 pixels{0, 0};    // of the file, if it has some
    Rectangle<double> picture;  // on the whole page, in millimetres
    double radius_mm = 0;
    DotOrder order = DotOrder::recursion;
    std::optional<double> curve_way_m = {};  // of the pen, before it was shortened
    Palette pens = {};                       // several
    RenderTimes times = {};
};

/// Whether --advice, a machine or a format for machines asks for the time and the findings.
bool prints_advice(const RenderOptions& options);

/// A line about its file, to standard error; where advice is asked for, that too.
void print_summary(const RenderOptions& options, const Rendered& drawn);

/// A line for each kind of finding among several drawings, which `name` names: in how many of them, and what
/// it is in the first one. Empty if there is none.
struct NamedFindings {
    std::string name;
    std::vector<Finding> findings;
};
std::vector<std::string> findings_among(std::span<const NamedFindings> drawings);

/// One drawing's figures, a JSON object.
std::string stats_of(const RenderOptions& options, const Rendered& drawn);

/// Several drawings', a JSON array.
std::string stats_of_all(std::span<const std::string> stats);

/// Into a file, or - for the standard output. The first throws what check_can_save() throws, if there are to
/// be any.
void check_stats(const RenderOptions& options);
void save_stats(const std::filesystem::path& where, const std::string& stats);

}  // namespace dapple
