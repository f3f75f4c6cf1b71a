#include "core/output/csv.h"

#include <cassert>

#include "core/text/text_buffer.h"

namespace dapple {

void write_csv(std::ostream& out, const DotStream& dots, const PageSize& page, const CsvColumns& columns,
               const WritingProgress& progress) {
    TextBuffer text(out);
    text << "x_mm,y_mm,radius_mm,level,rank,critical_scale\n";
    DotsReport report(dots.count, progress);
    dots.for_each_piece([&](const Dots& piece) {
        assert(piece.threshold.size() == piece.size() && piece.critical.size() == piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            report.next();
            const double radius_mm =
                piece.radius.empty() ? columns.dot_radius_mm : piece.radius[i] * page.mm_per_page_unit;
            const TileRank at = tile_rank_of(piece.threshold[i], columns.tile_size);
            text << piece.x[i] * page.mm_per_page_unit << ',' << piece.y[i] * page.mm_per_page_unit << ','
                 << radius_mm << ',' << std::int64_t{at.level} << ',' << std::int64_t{at.rank} << ','
                 << piece.critical[i] << '\n';
        }
        return true;
    });
    text.flush();
}

}  // namespace dapple
