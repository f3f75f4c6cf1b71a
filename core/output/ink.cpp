#include "core/output/ink.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace dapple {
namespace {

constexpr double kUsualLineMm = 0.3;  // of a pen whose width is not known
// What reaches onto a small part of a page may be larger than that: a dot's shape, about its centre.
constexpr double kLeastReachMm = 250;

// How far a file is, and a last check of the numbers in it: of dots, or of the points of strokes.
class InkReport {
 public:
    InkReport(const InkPage& page, const WritingProgress& progress)
        : count_(static_cast<double>(page.strokes ? page.strokes->points : page.dots.count)),
          progress_(progress) {
        const double side = std::max(page.size.width_mm, page.size.height_mm);
        low_ = -std::max(side, kLeastReachMm);
        high_ = side - low_;
    }

    void check(glm::dvec2 at, double radius_mm = 0) const {
        // Written so that what is not a number fails.
        if (!(at.x >= low_ && at.x <= high_ && at.y >= low_ && at.y <= high_ && radius_mm >= 0 &&
              radius_mm <= high_))
            refuse(at, radius_mm);
    }

    // Reports every 2^15th: a few times a second at least.
    void next(glm::dvec2 at, double radius_mm = 0) {
        check(at, radius_mm);
        if (progress_ && done_ % (1 << 15) == 0)
            progress_(std::min(static_cast<double>(done_) / std::max(count_, 1.0), 1.0));
        ++done_;
    }

 private:
    [[noreturn]] static void refuse(glm::dvec2 at, double radius_mm) {
        throw std::runtime_error(fmt::format(
            "a dot or a line would lie at {:g}, {:g} mm{}, far from its page, and is not written; this is a "
            "fault of Dapple: please report it with the settings",
            at.x, at.y, radius_mm != 0 ? fmt::format(" with a radius of {:g} mm", radius_mm) : ""));
    }

    double count_, low_ = 0, high_ = 0;
    const WritingProgress& progress_;
    std::uint64_t done_ = 0;
};

// Above nothing but the paper.
Pen single_pen(glm::vec3 ink) {
    return {.name = pen_name(ink), .colour = ink, .ink = PenInk::opaque};
}

}  // namespace

void write_marks(InkWriter& writer, std::span<const CutMark> marks) {
    for (const CutMark& mark : marks) writer.stroke(std::array{mark.from, mark.to});
}

void write_ink(InkWriter& writer, const InkPage& page, const WritingProgress& progress) {
    const Pen single = single_pen(page.ink);
    const std::span<const Pen> pens = page.pens.empty() ? std::span(&single, 1) : page.pens;
    InkReport report(page, progress);
    const auto write_inking = [&] {
        for (const InkArea& area : page.inking.shapes) {
            for (const std::vector<glm::dvec2>& ring : area.rings)
                for (const glm::dvec2 p : ring) report.check(p);
            writer.shape(area);
        }
        stream_of(page.inking.strokes, 0).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
            for (const glm::dvec2 p : points) report.check(p);
            writer.stroke(points);
        });
    };
    int drawing = -1;
    bool inked = page.inking.empty();
    const auto take = [&](int number) {
        if (page.pens.empty()) number = 0;
        if (number == drawing) return;
        drawing = number;
        const Pen& pen = pens[static_cast<std::size_t>(number)];
        const double own_mm = pen.width_mm > 0 ? pen.width_mm : kUsualLineMm;
        writer.begin_pen(number, pen, page.strokes ? page.strokes->width_of(number) : own_mm);
        write_marks(writer, page.registration);
        if (!inked && number == page.inking.pen) write_inking();
        inked = inked || number == page.inking.pen;
    };
    if (page.pens.empty()) take(0);

    if (page.strokes) {
        page.strokes->for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
            for (const glm::dvec2 p : points) report.next(p);
            take(pen);
            writer.stroke(points);
        });
    } else {
        const double unit = page.size.mm_per_page_unit;
        page.dots.for_each_piece([&](const Dots& piece) {
            if (piece.size() > 0) take(piece.pen);
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const InkDot dot{
                    .at = {piece.x[i] * unit, piece.y[i] * unit},
                    .radius_mm = piece.radius.empty() ? page.dot_radius_mm : piece.radius[i] * unit,
                    .threshold = piece.threshold.empty() ? 0 : piece.threshold[i],
                    .critical = piece.critical.empty() ? 0 : piece.critical[i]};
                report.next(dot.at, dot.radius_mm);
                writer.dot(dot);
            }
            return true;
        });
    }
    if (!inked) take(page.inking.pen);
    writer.end();
}

}  // namespace dapple
