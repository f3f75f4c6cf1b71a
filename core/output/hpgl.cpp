#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdint>

#include "core/output/drawing_format.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr std::size_t kPointsOfAnInstruction = 50;  // plotters' memory for one is small

class HpglWriter : public InkWriter {
 public:
    HpglWriter(std::ostream& out, const InkPage& page) : text_(out), height_mm_(page.size.height_mm) {
        if (!page.comments.empty()) text_ << fmt::format("CO \"{}\";", fmt::join(page.comments, ", "));
        text_ << "IN;SP1;\n";
    }

    // The plotter begins with its first one.
    void begin_pen(int number, const Pen&, double) override {
        if (number != 0 || !first_) text_ << "PU;SP" << std::int64_t{number + 1} << ";\n";
        first_ = false;
    }

    void dot(const InkDot& dot) override { stroke(std::span(&dot.at, 1)); }

    void stroke(std::span<const glm::dvec2> points) override {
        text_ << "PU";
        place(points[0]);
        text_ << ";PD";
        if (points.size() > 1) place(points[1]);
        for (std::size_t i = 2; i < points.size(); ++i) {
            text_ << (i % kPointsOfAnInstruction == 0 ? ";\nPD" : ",");
            place(points[i]);
        }
        text_ << ";\n";
    }

    void end() override {
        text_ << "PU;SP0;\n";
        text_.flush();
    }

 private:
    static std::int64_t plotter_units(double mm) { return std::llround(mm * kHpglUnitsPerMm); }
    void place(glm::dvec2 p) { text_ << plotter_units(p.x) << ',' << plotter_units(height_mm_ - p.y); }

    TextBuffer text_;
    double height_mm_;
    bool first_ = true;
};

}  // namespace

void write_hpgl(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    HpglWriter writer(out, page);
    write_ink(writer, page, progress);
}

}  // namespace dapple
