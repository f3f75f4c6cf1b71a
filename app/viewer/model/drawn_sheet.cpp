#include "app/viewer/model/drawn_sheet.h"

namespace dapple {
namespace {

glm::dvec2 corner_of(const Excerpt& excerpt) {
    return {excerpt.part.across.offset, excerpt.part.down.offset};
}

PagePart part_of(SheetDots dots, const Excerpt& sheet, const Excerpt& page, double radius) {
    switch (dots) {
        case SheetDots::own:
            return sheet.part;
        case SheetDots::reaching:
            return widened(sheet.part, radius);
        case SheetDots::of_the_page:
            return page.part;
    }
    return sheet.part;
}

}  // namespace

DrawnSheet see_sheet(PlacedDrawing& drawing, const Sheet& sheet, SheetDots dots) {
    const PageLayout& layout = drawing.layout;
    const Excerpt page = sheet_of(layout.page, {}, layout.picture.low);
    const Excerpt seen = sheet_of(layout.page, sheet, layout.picture.low);
    const PagePart part = part_of(dots, seen, page, drawing.dot_radius);
    for (Dots& piece : drawing.stippling.dots.pieces) cut_to(part, piece);
    move_to(seen.part, drawing.outlines);
    const glm::dvec2 picture = -corner_of(seen);
    return {seen.size,
            {picture, picture + drawing.page_size},
            (corner_of(seen) - corner_of(page)) * seen.size.mm_per_page_unit};
}

}  // namespace dapple
