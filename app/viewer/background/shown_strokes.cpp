#include "app/viewer/background/shown_strokes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "core/placing/placer.h"
#include "core/routing/short_way.h"

namespace dapple {
namespace {

constexpr std::uint64_t kMostLines = 20'000'000;

Dots in_order(Dots dots, DrawingStyle style, DotOrder order, LineWay way, const std::stop_token& stop) {
    const bool by_way = order == DotOrder::space || order == DotOrder::shortest;
    if (by_way) sort_dots(dots, DotOrder::space);
    const bool shortest = order == DotOrder::shortest && style == DrawingStyle::line;
    if (shortest && way == LineWay::final) shorten_way(dots, {.stop = stop, .progress = {}});
    return dots;
}

// The dots of each pen.
std::vector<Dots> by_pen(const DotPieces& dots) {
    std::vector<Dots> all;
    for (const Dots& piece : dots.pieces) {
        if (all.empty() || all.back().pen != piece.pen) all.emplace_back().pen = piece.pen;
        append(all.back(), piece);
    }
    return all;
}

// Each block has up to kDotsPerBlock lines that follow each other.
void put_into_blocks(ShownStrokes& strokes) {
    for (std::size_t first = 0; first < strokes.lines.size(); first += kDotsPerBlock) {
        DotBlock block{.first = first,
                       .index = first,
                       .count = std::min(kDotsPerBlock, strokes.lines.size() - first),
                       .low = glm::vec2(strokes.lines[first]),
                       .high = glm::vec2(strokes.lines[first])};
        for (std::size_t i = first; i < first + block.count; ++i) {
            const glm::vec2 a(strokes.lines[i].x, strokes.lines[i].y),
                b(strokes.lines[i].z, strokes.lines[i].w);
            block.low = glm::min(block.low, glm::min(a, b));
            block.high = glm::max(block.high, glm::max(a, b));
        }
        strokes.blocks.push_back(block);
    }
}

}  // namespace

ShownStrokes on_screen(const StrokeStream& strokes, std::span<const Pen> pens, double mm_per_page_unit) {
    ShownStrokes shown;
    const double unit = 1 / mm_per_page_unit;
    shown.width = strokes.widest() * unit;
    if (strokes.points > kMostLines) return shown;
    shown.lines.reserve(strokes.points);
    strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        const auto add = [&](glm::dvec2 a, glm::dvec2 b) {
            shown.lines.emplace_back(glm::vec2(a * unit), glm::vec2(b * unit));
            if (pens.empty()) return;
            shown.widths.push_back(static_cast<float>(strokes.width_of(pen) * unit));
            shown.pens.push_back(static_cast<std::uint8_t>(pen));
        };
        if (points.size() == 1) add(points[0], points[0]);
        for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
    });
    put_into_blocks(shown);
    return shown;
}

ShownStrokes shown_inking(const Inking& inking, std::span<const Pen> pens, glm::dvec2 corner) {
    constexpr double kPen = 1.0 / 500;  // page units, of what fills blacks
    ShownStrokes shown = on_screen(
        stream_of(strokes_of({.lines = {}, .areas = inking.areas, .white = {}}, kPen, 1), kPen), {}, 1);
    shown.widths.assign(shown.lines.size(), static_cast<float>(kPen));
    for (const InkLine& simple : inking.lines) {
        const InkLine line = flattened(simple);
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            shown.lines.emplace_back(glm::vec2(line.points[i - 1]), glm::vec2(line.points[i]));
            shown.widths.push_back((line.widths[i - 1] + line.widths[i]) / 2);
        }
    }
    const glm::vec2 from(corner);
    for (glm::vec4& line : shown.lines) line -= glm::vec4(from, from);
    if (!pens.empty()) shown.pens.assign(shown.lines.size(), static_cast<std::uint8_t>(darkest_of(pens)));
    return shown;
}

ShownStrokes shown_strokes(const DotPieces& dots, const DrawingSettings& settings,
                           std::optional<DotOrder> order, std::span<const Pen> pens, const PageSize& page,
                           double dot_radius, LineWay way, const std::stop_token& stop) {
    const double unit = page.mm_per_page_unit, width = settings.pen_width_mm;
    const DrawingStyle style = settings.style;
    const std::vector<double> widths = stroke_widths(settings.pens, width, pens, pen_use(settings));
    if (style == DrawingStyle::dots)
        return on_screen(marks_of(stream_of(dots), page, settings.mark, dot_radius * unit, width, widths),
                         pens, unit);
    Strokes lines;
    for (Dots& own : by_pen(dots)) {
        const Dots ordered = in_order(std::move(own), style, order.value_or(DotOrder::shortest), way, stop);
        append(lines,
               style == DrawingStyle::line ? line_through(ordered, page) : lines_to_nearest(ordered, page));
    }
    StrokeStream stream = stream_of(lines, width);
    stream.widths_mm = widths;
    return on_screen(stream, pens, unit);
}

}  // namespace dapple
