// Dots as tables, for programs.

#include <fmt/format.h>

#include <string>

#include "core/output/drawing_format.h"
#include "core/text/text_lines.h"

namespace dapple {

namespace {

// What all of these have of a dot.
class TableWriter : public InkWriter {
 public:
    TableWriter(std::ostream& out, const InkPage& page) : text_(out), page_(page) {}

    void begin_pen(int number, const Pen&, double) override { pen_ = number; }
    void stroke(std::span<const glm::dvec2>) override {}

 protected:
    void write_row(const InkDot& dot) {
        const TileRank rank =
            (page_.figure8 ? figure8_rank_of : tile_rank_of)(dot.threshold, page_.tile_size);
        text_ << dot.at.x << ',' << dot.at.y << ',' << dot.radius_mm << ',' << std::int64_t{rank.level} << ','
              << std::int64_t{rank.rank} << ',' << dot.critical;
    }

    TextBuffer text_;
    const InkPage& page_;
    int pen_ = 0;
};

class CsvWriter : public TableWriter {
 public:
    CsvWriter(std::ostream& out, const InkPage& page)
        : TableWriter(out, page), page_size_(fmt::format(",{},{}", page.size.width_mm, page.size.height_mm)) {
        text_ << "x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm"
              << (page.pens.empty() ? "\n" : ",pen\n");
    }

    void dot(const InkDot& dot) override {
        write_row(dot);
        text_ << page_size_;
        if (!page_.pens.empty())
            text_ << ',' << std::string_view(page_.pens[static_cast<std::size_t>(pen_)].name);
        text_ << '\n';
    }

    void end() override { text_.flush(); }

 private:
    const std::string page_size_;
};

class JsonWriter : public TableWriter {
 public:
    JsonWriter(std::ostream& out, const InkPage& page) : TableWriter(out, page) {
        text_ << R"({"page": {"width_mm": )" << page.size.width_mm << R"(, "height_mm": )"
              << page.size.height_mm << "},\n\"unit\": \"mm\",\n";
        if (!page.pens.empty()) write_pens();
        text_ << R"("columns": ["x_mm", "y_mm", "radius_mm", "level", "rank", "critical_scale")"
              << (page.pens.empty() ? "" : ", \"pen\"") << "],\n\"dots\": [";
    }

    void dot(const InkDot& dot) override {
        text_ << (first_ ? "\n[" : ",\n[");
        first_ = false;
        write_row(dot);
        if (!page_.pens.empty()) text_ << ',' << std::int64_t{pen_};
        text_ << ']';
    }

    void end() override {
        text_ << "\n]}\n";
        text_.flush();
    }

 private:
    void write_pens() {
        text_ << R"("pens": [)";
        for (const Pen& pen : page_.pens)
            text_ << (&pen == page_.pens.data() ? "" : ", ") << R"({"name": ")" << std::string_view(pen.name)
                  << R"(", "colour": ")" << hex_of(pen.colour) << R"(", "width_mm": )" << pen.width_mm << '}';
        text_ << "],\n";
    }

    bool first_ = true;
};

}  // namespace

void write_csv(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    CsvWriter writer(out, page);
    write_ink(writer, page, progress);
}

void write_dots_json(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    JsonWriter writer(out, page);
    write_ink(writer, page, progress);
}

}  // namespace dapple
