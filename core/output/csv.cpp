#include "core/output/csv.h"

#include <cassert>

#include "core/text/text_lines.h"

namespace dapple {

namespace {

void write_pens(TextBuffer& text, std::span<const Pen> pens) {
    text << R"("pens": [)";
    for (std::size_t i = 0; i < pens.size(); ++i)
        text << (i == 0 ? "" : ", ") << R"({"name": ")" << std::string_view(pens[i].name)
             << R"(", "colour": ")" << hex_of(pens[i].colour) << R"(", "width_mm": )" << pens[i].width_mm
             << '}';
    text << "],\n";
}

}  // namespace

void write_dots_json(std::ostream& out, const DotStream& dots, const PageSize& page,
                     const CsvColumns& columns, const WritingProgress& progress) {
    TextBuffer text(out);
    const bool one_pen = columns.pens.empty();
    text << R"({"page": {"width_mm": )" << page.width_mm << R"(, "height_mm": )" << page.height_mm
         << "},\n\"unit\": \"mm\",\n";
    if (!one_pen) write_pens(text, columns.pens);
    text << R"("columns": ["x_mm", "y_mm", "radius_mm", "level", "rank", "critical_scale")"
         << (one_pen ? "" : ", \"pen\"") << "],\n\"dots\": [";
    DotsReport report(dots.count, page, progress);
    bool first = true;
    dots.for_each_piece([&](const Dots& piece) {
        assert(piece.threshold.size() == piece.size() && piece.critical.size() == piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const TableRow row = table_row(piece, i, page, columns);
            report.next(row.x_mm, row.y_mm, row.radius_mm);
            text << (first ? "\n[" : ",\n[") << row.x_mm << ',' << row.y_mm << ',' << row.radius_mm << ','
                 << std::int64_t{row.at.level} << ',' << std::int64_t{row.at.rank} << ','
                 << row.critical_scale;
            if (!one_pen) text << ',' << std::int64_t{piece.pen};
            text << ']';
            first = false;
        }
        return true;
    });
    text << "\n]}\n";
    text.flush();
}

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
