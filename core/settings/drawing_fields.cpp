#include "core/settings/drawing_fields.h"

#include "core/drawing/edits.h"
#include "core/settings/fields.h"
#include "core/settings/setting.h"

namespace dapple {

// Each begins with all members by name: with one more or less it doesn't compile.

static void describe(Fields& fields, Tone& tone) {
    auto& [exposure, black_point, white_point, contrast, brightness, gamma, blur, detail, black, invert] =
        tone;
    fields.number(setting::exposure, exposure);
    fields.number(setting::black_point, black_point);
    fields.number(setting::white_point, white_point);
    fields.number(setting::contrast, contrast);
    fields.number(setting::brightness, brightness);
    fields.number(setting::gamma, gamma);
    fields.number(setting::blur, blur);
    fields.number(setting::detail, detail);
    fields.number(setting::black, black);
    fields.flag(setting::invert, invert);
    if (!(black_point < white_point)) fields.refuse("black_point", "has to be below white_point");
}

static void describe(Fields& fields, DotSize& size) {
    auto& [sizing, radius_mm, smallest_mm, largest_mm] = size;
    fields.choice(setting::sizing, sizing);
    fields.number(setting::radius, radius_mm);
    fields.number(setting::smallest, smallest_mm);
    fields.number(setting::largest, largest_mm);
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
    fields.number({"left", "From left"}, box.low.x, {});
    fields.number({"top", "From top"}, box.low.y, {});
    fields.number({"right", "To right"}, box.high.x, {});
    fields.number({"bottom", "To bottom"}, box.high.y, {});
    fields.choice("unit", unit);
    if (!(box.low.x < box.high.x)) fields.refuse("left", "has to be below right");
    if (!(box.low.y < box.high.y)) fields.refuse("top", "has to be below bottom");
    crop.reset();
    if (on) crop = part;
}

static void describe(Fields& fields, PageSetup& page) {
    auto& [paper, orientation, width_mm, height_mm, margins, fit, crop, quarter_turns, mirrored] = page;
    fields.choice(setting::page_size, paper);
    fields.choice(setting::orientation, orientation);
    fields.number(setting::width, width_mm);
    fields.number(setting::height, height_mm);
    fields.optional_group({setting::margin, "Margins"}, margins);
    fields.choice(setting::fit, fit);
    fields.group("crop", crop);
    fields.whole(setting::rotate, quarter_turns);
    fields.flag(setting::mirror, mirrored);
    if (paper == Paper::custom && !height_mm) fields.refuse("height_mm", "is needed for a custom page");
}

void describe(Fields& fields, DrawingSettings& drawing) {
    auto& [automatic_tone, tone_strength, automatic_exposure, tone, mask, tile, ranking, placer, placing,
           relax, settle_for, dot_size, page, sheets, pens, registration, ink, paper, background, show_tiles,
           contours, solid, style, mark, pen_width_mm, edits] = drawing;
    fields.flag(setting::automatic_tone, automatic_tone);
    fields.number(setting::tone_strength, tone_strength);
    fields.flag(setting::automatic_exposure, automatic_exposure);
    fields.group("tone", tone);
    fields.tile(setting::tile, tile);
    fields.choice(setting::ranking, ranking);
    fields.choice(setting::placer, placer);
    // What people choose of the placing; the number of threads belongs to the computer.
    fields.whole(setting::count, placing.count);
    fields.number(setting::scale, placing.scale);
    fields.whole(setting::relax, relax);
    fields.choice(setting::settle_for, settle_for);
    fields.group("dot_size", dot_size);
    fields.group("page", page);
    fields.text({"sheets", "Sheets across"}, grid_text(sheets), [&sheets = sheets](const std::string& text) {
        const Sheet read = parse_sheets(text);
        sheets.columns = read.columns;
        sheets.rows = read.rows;
    });
    fields.number(setting::overlap, sheets.overlap_mm);
    fields.text(setting::pens, text_of(pens),
                [&pens = pens](const std::string& text) { pens = parse_pens(text); });
    fields.choice(setting::pen_order, pens.order);
    fields.choice(setting::pen_ink, pens.ink);
    fields.flag(setting::registration, registration);
    fields.colour(setting::ink, ink);
    fields.colour(setting::paper, paper);
    fields.flag(setting::background, background);
    fields.flag(setting::show_tiles, show_tiles);
    fields.number(setting::contours, contours);
    fields.number(setting::solid, solid);
    fields.choice(setting::style, style);
    fields.text(setting::dot_shape, text_of(mark),
                [&mark = mark](const std::string& text) { mark = parse_dot_mark(text); });
    fields.number(setting::pen_width, pen_width_mm);
    fields.mask(setting::mask, mask);
    fields.text(setting::edits, edits, [&edits = edits](const std::string& text) {
        static_cast<void>(parse_edits(text));
        edits = text;
    });
}

static void describe(Fields& fields, OwnTemplate& own) {
    auto& [text, file] = own;
    fields.text("text", text, [&text = text](const std::string& read) {
        if (!read.empty()) static_cast<void>(parse_gcode_template(read));
        text = read;
    });
    fields.text("file", file, [&file = file](const std::string& read) { file = read; });
}

static std::optional<Rectangle<double>> region_or_all(const std::string& text) {
    if (text.empty()) return std::nullopt;
    return parse_region(text);
}

void describe(Fields& fields, SavingChoice& saving) {
    auto& [order, dpi, tool, machine, bits, gcode_template, feed_mm_per_min, dwell_s, acceleration_mm_per_s2,
           pen_up, pen_down, laser_power, separations, pen_files, region] = saving;
    fields.choice(setting::order, order);
    fields.number(setting::dpi, dpi);
    fields.choice(setting::gcode_tool, tool);
    fields.choice(setting::machine, machine);
    fields.choice(setting::bits, bits, {NamedValue{"8", 8}, NamedValue{"16", 16}});
    fields.group(setting::gcode_template, gcode_template);
    fields.number(setting::feed, feed_mm_per_min);
    fields.number(setting::dwell, dwell_s);
    fields.number(setting::acceleration, acceleration_mm_per_s2);
    fields.number(setting::pen_up, pen_up);
    fields.number(setting::pen_down, pen_down);
    fields.number(setting::laser_power, laser_power);
    fields.flag(setting::separations, separations);
    fields.flag(setting::pen_files, pen_files);
    fields.text("region", region ? text_of_region(*region) : "",
                [&region = region](const std::string& text) { region = region_or_all(text); });
}

void describe_drawing(Fields& fields, DrawingSettings& drawing, SavingChoice& saving) {
    fields.group("drawing", drawing);
    fields.group("saving", saving);
}

std::string changed_drawing_settings(const SettingsPlace& place, DrawingSettings drawing,
                                     SavingChoice saving) {
    DrawingSettings usual_drawing;
    SavingChoice usual_saving;
    return changed_settings(
        place, [&](Fields& fields) { describe_drawing(fields, drawing, saving); },
        [&](Fields& fields) { describe_drawing(fields, usual_drawing, usual_saving); });
}

}  // namespace dapple
