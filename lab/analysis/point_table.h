#pragma once
// Points from a table of text: this program's own CSV, or two columns from elsewhere.

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

/// A line a point. What parts its fields is what does so in the first row: tabs, or else semicolons, commas
/// or blanks. Decimals follow a point, or a comma where commas part nothing, "1,5;2,5": one of them in the
/// whole table. Fields may be in quotes. A first line of words names the columns, of which x_mm and y_mm
/// count, or x and y, in small or capital letters; without one the first two columns do. Where rows have one
/// field more than there are names, each begins with a name of its own, as R writes them. Blank lines and
/// lines that begin with # count for nothing. `name` says in messages where the text is from.
///
/// Throws std::runtime_error with the number of the line if a field is missing or is no finite number, if
/// there are more fields than the header names, if decimals follow now a point and now a comma, or if a
/// header names no x and y; without a number if there is no point.
std::vector<glm::dvec2> parse_point_table(std::string_view text, const std::string& name = "points");

/// What the points fill, where a first line of words names page_width_mm and page_height_mm: as this
/// program's own CSV says it, by the first line of numbers. Both over 0.
std::optional<glm::dvec2> page_of_table(std::string_view text);

struct PlacedPoints {
    Domain domain;
    std::vector<glm::dvec2> points;  // from the domain's lower corner
};

/// Points of which nobody said what they fill: the smallest box that holds them, wider by half their mean
/// spacing on each side, e where (width + e) (height + e) = n e^2. So the box of a square lattice is the one
/// it is periodic in. Throws std::runtime_error if all points are at one place.
PlacedPoints in_their_own_box(std::vector<glm::dvec2> points, Topology topology,
                              const std::string& name = "points");

}  // namespace dapple
