#include "app/settings/drawing_fields.h"

#include "app/files/gcode_choice.h"
#include "core/image/exposure.h"
#include "core/relaxing/relax.h"

namespace dapple {
namespace {

constexpr double kSmallestScale = 1e-9;

}  // namespace

// Each begins with all members by name: with one more or less it doesn't compile.

static void describe(Fields& fields, Tone& tone) {
    auto& [exposure, black_point, white_point, contrast, brightness, gamma, blur, detail, black, invert] =
        tone;
    fields.number("exposure", exposure, {-kMostStops, kMostStops});
    fields.number("black_point", black_point, {0, 1});
    fields.number("white_point", white_point, {0, 1});
    fields.number("contrast", contrast, {-1, 1});
    fields.number("brightness", brightness, {-1, 1});
    fields.number("gamma", gamma, {0.1, 10});
    fields.number("blur", blur, {0, 100});
    fields.number("detail", detail, {0, 1});
    fields.number("black", black, {kLeastBlack, 1});
    fields.flag("invert", invert);
    if (!(black_point < white_point)) fields.refuse("black_point", "has to be below white_point");
}

static void describe(Fields& fields, DotSize& size) {
    auto& [sizing, radius_mm, smallest_mm, largest_mm] = size;
    fields.choice("sizing", sizing,
                  {NamedValue{"automatic", DotSizing::automatic}, NamedValue{"fixed", DotSizing::fixed},
                   NamedValue{"by_tone", DotSizing::by_tone}});
    fields.number("radius_mm", radius_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    fields.number("smallest_mm", smallest_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    fields.number("largest_mm", largest_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    if (smallest_mm > largest_mm) fields.refuse("smallest_mm", "has to be at most largest_mm");
}

static void describe(Fields& fields, Margins& margins) {
    auto& [top, right, bottom, left] = margins;
    fields.number("top", top, {0, kLongestSideMm});
    fields.number("right", right, {0, kLongestSideMm});
    fields.number("bottom", bottom, {0, kLongestSideMm});
    fields.number("left", left, {0, kLongestSideMm});
}

static void describe(Fields& fields, std::optional<Crop>& crop) {
    bool on = crop.has_value();
    Crop part = crop.value_or(Crop{{{0, 0}, {100, 100}}, Crop::Unit::percent});
    auto& [box, unit] = part;
    fields.flag("on", on);
    fields.number("left", box.low.x, {});
    fields.number("top", box.low.y, {});
    fields.number("right", box.high.x, {});
    fields.number("bottom", box.high.y, {});
    fields.choice("unit", unit,
                  {NamedValue{"pixels", Crop::Unit::pixels}, NamedValue{"percent", Crop::Unit::percent}});
    if (!(box.low.x < box.high.x)) fields.refuse("left", "has to be below right");
    if (!(box.low.y < box.high.y)) fields.refuse("top", "has to be below bottom");
    crop.reset();
    if (on) crop = part;
}

static void describe(Fields& fields, PageSetup& page) {
    auto& [paper, orientation, width_mm, height_mm, margins, fit, crop, quarter_turns] = page;
    fields.choice("paper", paper, paper_titles());
    fields.choice("orientation", orientation,
                  {PageOrientation::automatic, PageOrientation::portrait, PageOrientation::landscape});
    fields.number("width_mm", width_mm, {kShortestSideMm, kLongestSideMm});
    fields.number("height_mm", height_mm, {kShortestSideMm, kLongestSideMm});
    fields.group("margins_mm", margins);
    fields.choice("fit", fit, {PageFit::inside, PageFit::fill});
    fields.group("crop", crop);
    fields.whole("quarter_turns", quarter_turns, {0, 3});
    if (paper == Paper::custom && !height_mm) fields.refuse("height_mm", "has to be said for a custom page");
}

void describe(Fields& fields, DrawingSettings& drawing) {
    auto& [automatic_tone, automatic_exposure, tone, tile, ranking, placer, placing, relax, dot_size, page,
           sheets, pens, registration, ink, paper, background, show_tiles, style, mark, pen_width_mm, mask] =
        drawing;
    fields.flag("automatic_tone", automatic_tone);
    fields.flag("automatic_exposure", automatic_exposure);
    fields.group("tone", tone);
    fields.tile("tile", tile);
    fields.choice("ranking", ranking, {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy});
    fields.choice("placer", placer, {PlacerKind::exact, PlacerKind::figure8});
    // Of the placing, what people choose; the number of threads belongs to the computer.
    fields.whole("count", placing.count, 1, kMostDots);
    fields.number("scale", placing.scale, {kSmallestScale});
    fields.whole("relax", relax, {0, kMostRelaxingSteps});
    fields.group("dot_size", dot_size);
    fields.group("page", page);
    fields.text("sheets", grid_text(sheets), [&sheets = sheets](const std::string& text) {
        const Sheet read = parse_sheets(text);
        sheets.columns = read.columns;
        sheets.rows = read.rows;
    });
    fields.number("sheet_overlap_mm", sheets.overlap_mm, {0, kWidestOverlapMm});
    fields.text("pens", text_of(pens), [&pens = pens](const std::string& text) { pens = parse_pens(text); });
    fields.choice("pen_order", pens.order, {PenOrder::lightest, PenOrder::darkest, PenOrder::listed});
    fields.flag("registration", registration);
    fields.colour("ink", ink);
    fields.colour("paper", paper);
    fields.flag("background", background);
    fields.flag("show_tiles", show_tiles);
    fields.choice("style", style, {DrawingStyle::dots, DrawingStyle::line, DrawingStyle::nearest});
    fields.text("dot_shape", text_of(mark),
                [&mark = mark](const std::string& text) { mark = parse_dot_mark(text); });
    fields.number("pen_width_mm", pen_width_mm, {kFinestPenMm, kWidestPenMm});
    fields.mask("mask", mask);
}

static void describe(Fields& fields, OwnTemplate& own) {
    auto& [text, file] = own;
    fields.text("text", text, [&text = text](const std::string& read) {
        if (!read.empty()) static_cast<void>(parse_gcode_template(read));
        text = read;
    });
    fields.text("file", file, [&file = file](const std::string& read) { file = read; });
}

void describe(Fields& fields, SavingChoice& saving) {
    auto& [order, dpi, tool, machine, bits, gcode_template, feed_mm_per_min, dwell_s, acceleration_mm_per_s2,
           pen_up, pen_down, laser_power, separations] = saving;
    fields.choice("order", order,
                  {DotOrder::recursion, DotOrder::priority, DotOrder::space, DotOrder::shortest});
    fields.number("dpi", dpi, {1, 100'000});
    fields.choice("gcode_tool", tool, {GcodeTool::pen, GcodeTool::servo, GcodeTool::laser});
    fields.choice("machine", machine, kMachines);
    fields.choice("bits", bits, {NamedValue{"8", 8}, NamedValue{"16", 16}});
    fields.group("gcode_template", gcode_template);
    fields.number("feed_mm_per_min", feed_mm_per_min, {kSlowestFeed, kFastestFeed});
    fields.number("dwell_s", dwell_s, {0, kLongestDwellS});
    fields.number("acceleration_mm_per_s2", acceleration_mm_per_s2, {kLeastAcceleration, kMostAcceleration});
    fields.number("gcode_pen_up", pen_up, {-kMostHeight, kMostHeight});
    fields.number("gcode_pen_down", pen_down, {-kMostHeight, kMostHeight});
    fields.number("laser_power", laser_power, {0, kMostLaserPower});
    fields.flag("separations", separations);
}

void describe_drawing(Fields& fields, DrawingSettings& drawing, SavingChoice& saving) {
    fields.group("drawing", drawing);
    fields.group("saving", saving);
}

}  // namespace dapple
