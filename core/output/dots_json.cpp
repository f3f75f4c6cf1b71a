#include "core/output/dots_json.h"

#include <cassert>

#include "core/text/text_buffer.h"

namespace dapple {

void write_dots_json(std::ostream& out, const DotStream& dots, const PageSize& page,
                     const CsvColumns& columns, const WritingProgress& progress) {
    TextBuffer text(out);
    text << R"({"page": {"width_mm": )" << page.width_mm << R"(, "height_mm": )" << page.height_mm
         << "},\n\"unit\": \"mm\",\n"
         << R"("columns": ["x_mm", "y_mm", "radius_mm", "level", "rank", "critical_scale"],)"
         << "\n\"dots\": [";
    DotsReport report(dots.count, progress);
    bool first = true;
    dots.for_each_piece([&](const Dots& piece) {
        assert(piece.threshold.size() == piece.size() && piece.critical.size() == piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            report.next();
            const TableRow row = table_row(piece, i, page, columns);
            text << (first ? "\n[" : ",\n[") << row.x_mm << ',' << row.y_mm << ',' << row.radius_mm << ','
                 << std::int64_t{row.at.level} << ',' << std::int64_t{row.at.rank} << ','
                 << row.critical_scale << ']';
            first = false;
        }
        return true;
    });
    text << "\n]}\n";
    text.flush();
}

}  // namespace dapple
