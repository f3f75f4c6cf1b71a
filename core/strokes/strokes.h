#pragma once
// What a pen draws: lines from where it goes down to where it is raised, in millimetres from the page's upper
// left corner. A stroke of one point is a touch of the pen.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "core/image/rectangle.h"

namespace dapple {

/// `pen` is the place in the drawing's palette of the one that draws it.
using TakeStroke = std::function<void(std::span<const glm::dvec2> points, int pen)>;

/// Strokes on their way into a file, one after the other.
struct StrokeStream {
    std::uint64_t points = 0;            // of all strokes together, about: progress goes by it
    double width_mm = 0.3;               // of the pen, whose ends are round
    std::vector<double> widths_mm = {};  // of each pen, where several have widths of their own
    /// Hands over all strokes, from the first on each time that it is called; none is empty.
    std::function<void(const TakeStroke& take)> for_each_stroke = [](const TakeStroke&) {};

    double width_of(int pen) const {
        const auto i = static_cast<std::size_t>(pen);
        return i < widths_mm.size() ? widths_mm[i] : width_mm;
    }
    double widest() const {
        return widths_mm.empty() ? width_mm : *std::max_element(widths_mm.begin(), widths_mm.end());
    }
};

/// Strokes in memory.
struct Strokes {
    std::vector<glm::dvec2> points;
    std::vector<std::size_t> ends;  // of each stroke among the points: where the next one begins
    std::vector<int> pens = {};     // that draw the strokes; empty: the first

    bool operator==(const Strokes&) const = default;
};

/// Ends the stroke of all points that were added since the last one.
void end_stroke(Strokes& strokes, int pen = 0);

int pen_of(const Strokes& strokes, std::size_t stroke);

void append(Strokes& to, const Strokes& more);

/// Which have to outlive the stream.
StrokeStream stream_of(const Strokes& strokes, double width_mm);

/// Those of one pen alone.
StrokeStream only(const StrokeStream& stream, int pen);

/// All strokes of a stream.
Strokes collected(const StrokeStream& stream);

/// What of the strokes lies in the box, seen from its upper left corner: a stroke that leaves it ends at the
/// edge, and begins again where it comes back. Half a pen's width may reach over the edges.
Strokes cut_to(const Rectangle<double>& box, const StrokeStream& stream);

// Letters that a pen draws, as plotters have no fonts: digits, capitals and . - + ( ) _, in few straight
// lines.
//
// A letter is two thirds as wide as it is high, and the next one begins its height further on:
//
//      0   4  6
//      +---+--+-- 0     "0602204246 0444" is an A: each pair of digits is a point, across and down, and a
//      | A |  | B       blank raises the pen
//      +---+--+-- 6

/// Adds the text as lines of that pen: `corner` is the first letter's upper left one, in millimetres. Small
/// letters are drawn as capitals; of what has no letter here the place stays empty.
void add_text(Strokes& strokes, std::string_view text, glm::dvec2 corner, double height_mm, int pen);

/// How long such a text is.
double text_width_mm(std::string_view text, double height_mm);

}  // namespace dapple
