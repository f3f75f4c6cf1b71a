#pragma once
// What is changed of a drawing by hand: dots taken away, added, moved or resized, in millimetres on the
// paper. So it holds for any number of dots and any tone: what was left bare stays bare, and what was added
// stays. Edits come after placing and relaxing, and move no other dot.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/page_setup.h"
#include "core/export.h"
#include "core/placing/dots.h"
#include "core/text/names.h"

namespace dapple {

/// In millimetres from the page's upper left corner. What is left bare later takes away dots added before.
struct Edit {
    enum class Kind { bare, dot };  // no dots where a disc passes, or in a closed line; one more dot
    Kind kind = Kind::bare;
    std::vector<glm::vec2> points = {};  // the disc's way, 3 or more corners of the line, a dot's one place
    float radius_mm = 0;                 // the disc's, 0: a line; a dot's, 0: as large as the others there
    int pen = 0;                         // that draws the dot, or the last one, if there are fewer
};
constexpr auto names_of(Edit::Kind) {
    return names("bare", "dot");
}

/// "bare r0.5 10,20 11,21;bare 1,1 9,1 5,9;dot 30,40;dot r0.4 p2 31,40;": radii after an r, pens, from 1 on,
/// after a p. Throws std::runtime_error saying which edit is wrong, or if all have over 100,000 points.
DAPPLE_API std::vector<Edit> parse_edits(std::string_view text);
std::string text_of(const Edit& edit);

/// Whether a place, in page units from the picture's corner, is left bare by one of the edits from `since`
/// on. They have to outlive it.
using IsBare = std::function<bool(glm::dvec2 place, std::size_t since)>;
IsBare bare_places(const std::vector<Edit>& edits, const PageLayout& layout);

/// Edits all dots of a page: as placed, or a piece for each pen. Added ones come after the others of their
/// pens, have a threshold of 0, as no tile has them, and exist at that scale; off the page there are none.
/// give_sizes() gives all their usual radii before some get their own. `thresholds`: all are to have some.
void apply(const std::vector<Edit>& edits, const PageLayout& layout, double scale, bool by_pen,
           bool thresholds, DotPieces& dots, const std::function<void()>& give_sizes);

/// How many dots lie where another does.
std::uint64_t duplicates_among(const DotPieces& dots);

}  // namespace dapple
