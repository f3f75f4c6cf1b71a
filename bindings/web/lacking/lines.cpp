// Contours, solid blacks and edits, which the page does not draw: engine.cpp refuses settings that ask for
// them, so that nothing here is called, but that no edits are read. With them the page would be too large.

#include "core/drawing/edits.h"
#include "core/lines/inking.h"
#include "core/lines/line_field.h"

namespace dapple {

std::vector<InkLine> find_lines(const Grid<float>&) {
    return {};
}
std::vector<InkArea> find_blacks(const Grid<float>&, double, double) {
    return {};
}
std::vector<InkLine> lines_shown(const std::vector<InkLine>&, double) {
    return {};
}
std::vector<InkLine> outside(const std::vector<InkLine>&, const std::vector<InkArea>&, double) {
    return {};
}
Inking within(Inking, const std::function<bool(glm::dvec2)>&) {
    return {};
}
Inking fitted(Inking, const Grid<float>&, const DotsAmongLines&) {
    return {};
}
Grid<float> reduced(const Grid<float>&) {
    return {};
}
float value_at(const Grid<float>&, glm::vec2) {
    return 0;
}
Grid<float> negative(Grid<float>) {
    return {};
}
Grid<float> room_for_dots(const Inking&, const Density&, const Grid<float>&, const InkCurve&,
                          const DotsAmongLines&) {
    return {};
}
Density with_room(const Density& density, const Grid<float>&) {
    return density;
}
std::vector<InkArea> shapes_of(const Inking&, const Rectangle<double>&, double) {
    return {};
}
Strokes strokes_of(const Inking&, double, double) {
    return {};
}
InkArea flattened(InkArea area) {
    return area;
}
std::vector<Cubic> smooth_curve(std::span<const glm::dvec2>) {
    return {};
}
std::vector<Edit> parse_edits(std::string_view) {
    return {};
}
IsBare bare_places(const std::vector<Edit>&, const PageLayout&) {
    return {};
}
std::uint64_t duplicates_among(const DotPieces&) {
    return 0;
}
void apply(const std::vector<Edit>&, const PageLayout&, double, bool, bool, DotPieces&,
           const std::function<void()>&) {}

}  // namespace dapple
