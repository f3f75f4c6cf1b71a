#include "core/drawing/drawing.h"

#include <memory>

namespace dapple {

DotOrder usual_order(DrawingFormat format, std::uint64_t dots, DrawingStyle style) {
    if (style == DrawingStyle::line && !is_table(format))
        return dots <= kMostSortedDots ? DotOrder::shortest : DotOrder::space;
    if (!is_plotted(format) || dots > kMostSortedDots) return DotOrder::recursion;
    return dots <= kMostRoutedDots ? DotOrder::shortest : DotOrder::space;
}

bool has_order(DrawingFormat format, DrawingStyle style) {
    return !has_pixels(format) || style == DrawingStyle::line;
}

DotMark mark_in(const DrawingFile& file) {
    const DotMark& mark = file.settings.mark;
    const bool circles = mark.shape == DotShape::circle;
    if (!circles || !is_touched(file.format) || !has_several_sizes(file.settings)) return mark;
    const bool by_radius = file.format == DrawingFormat::gcode &&
                           file.saving.gcode_template.text.find("{radius}") != std::string::npos;
    return by_radius ? mark : DotMark{DotShape::spiral};
}

namespace {

// Lines and solid blacks before the other strokes of their pen.
StrokeStream with_inking(StrokeStream strokes, const DrawnInking& inking) {
    if (inking.strokes.points.empty()) return strokes;
    strokes.points += inking.strokes.points.size();
    strokes.for_each_stroke = [&inking, others = std::move(strokes.for_each_stroke)](const TakeStroke& take) {
        bool drawn = false;
        const auto draw = [&] {
            if (std::exchange(drawn, true)) return;
            stream_of(inking.strokes, 0).for_each_stroke([&](std::span<const glm::dvec2> points, int) {
                take(points, inking.pen);
            });
        };
        others([&](std::span<const glm::dvec2> points, int pen) {
            if (pen == inking.pen) draw();
            take(points, pen);
        });
        draw();
    };
    return strokes;
}

std::optional<StrokeStream> strokes_of_dots(const DrawingToSave& drawing) {
    if (drawing.strokes) return drawing.strokes;
    const DrawingSettings& settings = drawing.file.settings;
    const DotMark mark = mark_in(drawing.file);
    const bool dots = settings.style == DrawingStyle::dots;
    if (is_table(drawing.file.format) || (dots && mark.shape == DotShape::circle)) return std::nullopt;
    const double width = settings.pen_width_mm;
    const std::vector<double> widths = stroke_widths(settings.pens, width, drawing.pens, pen_use(settings));
    if (dots) return marks_of(drawing.dots, drawing.page, mark, drawing.dot_radius_mm, width, widths);
    auto lines = std::make_shared<Strokes>();
    for (const Dots& own : sorted_by_pen(drawing.dots, DotOrder::recursion).pieces)
        append(*lines, settings.style == DrawingStyle::line ? line_through(own, drawing.page)
                                                            : lines_to_nearest(own, drawing.page));
    if (const auto& corner = drawing.part_corner_mm) {
        const Rectangle<double> part{*corner,
                                     *corner + glm::dvec2(drawing.page.width_mm, drawing.page.height_mm)};
        *lines = cut_to(part, stream_of(*lines, width));
    }
    StrokeStream stream = stream_of(*lines, width);
    stream.widths_mm = widths;
    stream.for_each_stroke = [lines, all = stream.for_each_stroke](const TakeStroke& take) { all(take); };
    return stream;
}

}  // namespace

std::optional<StrokeStream> strokes_of(const DrawingToSave& drawing) {
    std::optional<StrokeStream> strokes = strokes_of_dots(drawing);
    if (strokes) strokes = with_inking(std::move(*strokes), drawing.inking);
    return strokes;
}

Machine usual_machine(DrawingFormat format, GcodeTool tool) {
    if (format != DrawingFormat::gcode) return Machine::axidraw_v3;
    return tool == GcodeTool::laser ? Machine::grbl_laser : Machine::grbl_pen;
}

Dots sorted_dots(const DotStream& stream, DotOrder order, const Watch& watch) {
    Dots all;
    stream.for_each_piece([&](const Dots& piece) {
        all.reserve(stream.count, !piece.critical.empty());
        append(all, piece);
        return true;
    });
    sort_dots(all, order);
    if (order == DotOrder::shortest) shorten_way(all, watch);
    return all;
}

DotPieces sorted_by_pen(const DotStream& stream, DotOrder order, const Watch& watch) {
    DotPieces sorted;
    stream.for_each_piece([&](const Dots& piece) {
        if (sorted.pieces.empty() || sorted.pieces.back().pen != piece.pen) {
            sorted.pieces.emplace_back();
            sorted.pieces.back().pen = piece.pen;
        }
        append(sorted.pieces.back(), piece);
        return !watch.stop.stop_requested();
    });
    put_in_order(sorted, order, watch);
    return sorted;
}

std::optional<double> put_in_order(DotPieces& by_pen, DotOrder order, const Watch& watch) {
    std::optional<double> curve_way;
    const auto pens = static_cast<double>(by_pen.pieces.size());
    double done = 0;
    for (Dots& own : by_pen.pieces) {
        sort_dots(own, order);
        if (order != DotOrder::shortest) continue;
        curve_way = curve_way.value_or(0) + way_length(own.x, own.y);
        shorten_way(own, {.stop = watch.stop, .progress = [&](double share) {
                              if (watch.progress) watch.progress((done + share) / pens);
                          }});
        ++done;
    }
    return curve_way;
}

DotOrder order_of(const DrawingToSave& drawing) {
    const DrawingFile& file = drawing.file;
    if (!has_order(file.format, file.settings.style)) return DotOrder::recursion;
    return file.saving.order.value_or(usual_order(file.format, drawing.dots.count, file.settings.style));
}

}  // namespace dapple
