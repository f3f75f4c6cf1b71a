#include "core/output/csv.h"

#include <cassert>

#include "core/output/text_buffer.h"

namespace dapple {

void write_csv(std::ostream& out, const Dots& dots, const PageSize& page, const CsvColumns& columns,
               const WritingProgress& progress) {
    assert(dots.critical.size() == dots.size());
    TextBuffer text(out);
    text << "x_mm,y_mm,radius_mm,level,rank,critical_scale\n";
    for (std::size_t i = 0; i < dots.size(); ++i) {
        if (progress && i % kDotsPerReport == 0)
            progress(static_cast<double>(i) / static_cast<double>(dots.size()));
        const Birthplace birth = birthplace_of(dots.threshold[i], columns.tile_size);
        text << dots.x[i] * page.mm_per_page_unit << ',' << dots.y[i] * page.mm_per_page_unit << ','
             << columns.dot_radius_mm << ',' << std::int64_t{birth.level} << ',' << std::int64_t{birth.rank}
             << ',' << dots.critical[i] << '\n';
    }
    text.flush();
}

}  // namespace dapple
