#pragma once
// A drawing's ink on its way into a file, the same for every format:
//
//     InkPage ──► write_ink(): each pen, its registration marks, its dots or strokes ──► InkWriter ──► file
//
// A format is an InkWriter and a function that makes one and calls write_ink(): see drawing_format.h.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/colour.h"
#include "core/image/rectangle.h"
#include "core/lines/inking.h"
#include "core/output/gcode.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// Told now and then how much of a file is written, 0..1. What it throws passes through the writer, which is
/// how writing is stopped.
using WritingProgress = std::function<void(double share)>;

/// All that a file may show; each format takes what it can hold. What is referred to must outlive it.
struct InkPage {
    PageSize size = {};
    DotStream dots = {};                       // filled circles
    std::optional<StrokeStream> strokes = {};  // drawn in the dots' place
    double dot_radius_mm = 0.2;                // of dots that have none of their own
    DrawnInking inking = {};                   // lines and solid blacks, drawn before their pen's dots
    glm::vec3 ink = kBlack;                    // of a single pen
    std::span<const Pen> pens = {};            // those of the dots or strokes; none: a single one
    std::vector<CutMark> registration = {};    // lines that each pen draws before its dots
    std::optional<GcodeStyle> gcode = {};      // how G-code is written; none: as for a pen on a Z axis
    std::vector<std::string> comments = {};    // for whoever finds a machine's file a year later
    std::optional<glm::vec3> background = {};  // under everything
    std::span<const PlacedTile> tiles = {};    // whose outlines are shown, coloured by level
    /// Where the outlines end, in page units; none: at the page's edges.
    std::optional<Rectangle<double>> picture = {};
    std::span<const CutMark> cut_marks = {};  // of a sheet, in black on top
    std::size_t tile_size = 16;               // N, by which a threshold says level and rank,
    bool figure8 = false;                     // by figure8_rank_of() rather than tile_rank_of()
    std::string_view settings = {};  // that the drawing was made with, without <, > and &; empty: none
};

struct InkDot {
    glm::dvec2 at;  // millimetres from the page's upper left corner
    double radius_mm = 0;
    float threshold = 0, critical = 0;  // as in Dots; 0 where those do not have them
};

/// Writes one file, from its beginning, which is the constructor's, to its end. Places are in millimetres
/// from the page's upper left corner.
class InkWriter {
 public:
    virtual ~InkWriter() = default;

    /// What follows is drawn by this pen, at that place in InkPage::pens, whose lines are so wide. A single
    /// pen begins even if there is no ink, others only with their first dot or stroke.
    virtual void begin_pen(int number, const Pen& pen, double width_mm) = 0;
    virtual void dot(const InkDot& dot) = 0;
    /// A line through all points, or a touch of the pen at a single one.
    virtual void stroke(std::span<const glm::dvec2> points) = 0;
    /// A filled shape; only called where the page has shapes.
    virtual void shape(const InkArea&) {}
    virtual void end() = 0;
};

/// All ink of a page, in the order in which it comes. Throws std::runtime_error if a number is not finite, or
/// lies beyond the page by more than a page: a machine would do what it says. Needs the memory of a piece.
void write_ink(InkWriter& writer, const InkPage& page, const WritingProgress& progress = {});

/// Lines that are no drawing's, of whichever pen draws.
void write_marks(InkWriter& writer, std::span<const CutMark> marks);

}  // namespace dapple
