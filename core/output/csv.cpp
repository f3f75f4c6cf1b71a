#include "core/output/csv.h"

#include <cassert>

#include "core/text/text_buffer.h"

namespace dapple {

TableRow table_row(const Dots& piece, std::size_t i, const PageSize& page, const CsvColumns& columns) {
    const double mm = page.mm_per_page_unit;
    return {piece.x[i] * mm, piece.y[i] * mm,
            piece.radius.empty() ? columns.dot_radius_mm : piece.radius[i] * mm,
            (columns.figure8 ? figure8_rank_of : tile_rank_of)(piece.threshold[i], columns.tile_size),
            piece.critical[i]};
}

void write_csv(std::ostream& out, const DotStream& dots, const PageSize& page, const CsvColumns& columns,
               const WritingProgress& progress) {
    TextBuffer text(out);
    text << "x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm"
         << (columns.pens.empty() ? "\n" : ",pen\n");
    DotsReport report(dots.count, page, progress);
    dots.for_each_piece([&](const Dots& piece) {
        assert(piece.threshold.size() == piece.size() && piece.critical.size() == piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const TableRow row = table_row(piece, i, page, columns);
            report.next(row.x_mm, row.y_mm, row.radius_mm);
            text << row.x_mm << ',' << row.y_mm << ',' << row.radius_mm << ',' << std::int64_t{row.at.level}
                 << ',' << std::int64_t{row.at.rank} << ',' << row.critical_scale << ',' << page.width_mm
                 << ',' << page.height_mm;
            if (!columns.pens.empty())
                text << ',' << std::string_view(columns.pens[static_cast<std::size_t>(piece.pen)].name);
            text << '\n';
        }
        return true;
    });
    text.flush();
}

}  // namespace dapple
