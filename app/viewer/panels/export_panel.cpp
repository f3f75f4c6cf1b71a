#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <system_error>

#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/output/raster.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

constexpr const char* kOrders =
    "Order of the dots in the file and on the plotter.\n"
    "as placed: tile by tile.\n"
    "short moves: each dot near the one before, found at once.\n"
    "shortest: a short route; for a million dots it takes some seconds to find.\n"
    "by priority: unless relaxed, the first n dots nearly equal a drawing with n dots, so that a plot may "
    "stop at any time.";

constexpr const char* kTools =
    "What the machine does at a dot.\n"
    "pen: lowers it with the Z axis.\n"
    "servo: turns a servo (M3).\n"
    "laser: burns briefly.\n"
    "custom: follows your template, a text file.";

bool draw_order(std::optional<DotOrder>& choice, DotOrder usual) {
    const DotOrder order = choice.value_or(usual);
    constexpr std::array kShown{DotOrder::recursion, DotOrder::space, DotOrder::shortest, DotOrder::priority};
    int chosen = static_cast<int>(std::ranges::find(kShown, order) - kShown.begin());
    const bool changed = segmented_row(
        "Dot order", chosen, std::array{"as placed", "short moves", "shortest", "by priority"}, kOrders);
    if (changed) choice = kShown[static_cast<std::size_t>(chosen)];
    return changed;
}

// Another template, if the file is one.
std::optional<OwnTemplate> template_in(const std::string& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed)) return std::nullopt;  // others may make us wait
    try {
        return read_gcode_template(file);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

bool draw_gcode(SavingChoice& saving) {
    constexpr int kOwn = 3;
    OwnTemplate& own = saving.gcode_template;
    int chosen = own.text.empty() ? static_cast<int>(saving.tool) : kOwn;
    bool changed = segmented_row("G-code for", chosen, std::array{"pen", "servo", "laser", "custom"}, kTools);
    if (changed && chosen == kOwn) {
        own = {.text =
                   std::string(gcode_template_of(saving.tool, saving.dwell_s))};  // until another is named
    } else if (changed) {
        own = {};
        saving.tool = static_cast<GcodeTool>(chosen);
        saving.pen_up = saving.pen_down = {};  // a servo's are no millimetres
    }
    {
        const Absent absent(own.text.empty() ? "Choose \"custom\" above." : nullptr);
        std::string file = own.file;
        if (text_row(
                "Template", file, [](const std::string& name) { return template_in(name).has_value(); },
                "Not a template: its lines have to begin with start, move, dot or end.",
                "The file that sets what the machine does at a dot. The project keeps a copy.")) {
            own = template_in(file).value_or(own);
            changed = true;
        }
    }
    changed |= slider_row(setting::feed, saving.feed_mm_per_min);
    changed |= slider_row(setting::dwell, saving.dwell_s);
    changed |= slider_row(setting::acceleration, saving.acceleration_mm_per_s2);
    const bool burns = own.text.empty() && saving.tool == GcodeTool::laser;
    const bool servo = saving.tool == GcodeTool::servo;
    const GcodeHeights usual = usual_heights(saving.tool);
    const auto height_row = [&](const Setting& setting, std::optional<double>& value, double usual_one) {
        double height = value.value_or(usual_one);
        if (!slider_row(setting, height,
                        {.usual = usual_one,
                         .track = servo ? Track{0, 180} : Track{-10, 20},
                         .format = servo ? "%.0f" : "%.1f"}))
            return false;
        value = height;
        return true;
    };
    {
        const Absent absent(burns ? "A laser has no pen to lift." : nullptr);
        changed |= height_row(setting::pen_up, saving.pen_up, usual.up);
        changed |= height_row(setting::pen_down, saving.pen_down, usual.down);
    }
    const bool fires = burns || !own.text.empty();
    const Absent absent(fires ? nullptr : "Applies to lasers only: choose one above.");
    changed |= slider_row(setting::laser_power, saving.laser_power);
    return changed;
}

bool draw_machine(SavingChoice& saving, DrawingFormat format, const ExportInfo& info) {
    // As Machine has them, after none.
    constexpr std::array kMachines{"none",  "AxiDraw V3",       "AxiDraw SE/A3",
                                   "iDraw", "GRBL pen plotter", "GRBL laser"};
    const bool needs_one = is_for_machines(format);
    std::optional<Machine> machine = saving.machine;
    if (needs_one && !machine) machine = usual_machine(format, saving.tool);
    int chosen = machine ? static_cast<int>(*machine) + !needs_one : 0;
    const bool changed = choice_row("Machine", chosen, std::span(kMachines).subspan(needs_one ? 1 : 0),
                                    "Used for the time and the advice below; the file is the same for all.");
    if (changed) saving.machine = static_cast<Machine>(chosen - !needs_one);
    if (changed && !needs_one && chosen == 0) saving.machine.reset();
    if (info.dots == 0 || !machine) return changed;
    hint(info.plotting ? fmt::format("Plotting takes {}, {}; pen travel {:.1f} m.",
                                     time_in_words(info.plotting->total_s()),
                                     what_takes_longest(*info.plotting), info.way_m)
                             .c_str()
                       : "Plotting takes \u2026");
    note_place("Plotting time");
    return changed;
}

/// What a button beneath a finding does about it.
struct Cure {
    std::string label;
    std::function<void(ViewerSettings& settings)> apply;
};

Margins widened(const Margins& margins, double by) {
    return {margins.top + by, margins.right + by, margins.bottom + by, margins.left + by};
}

constexpr double kOpenBlack = 0.7;  // of which hardly any dots overlap

Cure with_dots(double dots) {
    const auto count = static_cast<std::uint64_t>(dots);
    return {fmt::format("Use {} dots", grouped(count)),
            [count](ViewerSettings& settings) { settings.drawing.placing.count = count; }};
}

std::optional<Cure> cure_of(const Finding& finding, const DrawingSettings& drawing) {
    const double amount = finding.amount;
    const bool own_count = drawing.dot_size.sizing == DotSizing::by_tone;
    switch (finding.kind) {
        case FindingKind::hours:
        case FindingKind::tone:
        case FindingKind::joined:
        case FindingKind::too_many:
            if (amount >= 1 && amount <= double(kMostDots) && !own_count) return with_dots(amount);
            break;
        case FindingKind::rings:
            return Cure{"Fill the dots with spirals",
                        [](ViewerSettings& settings) { settings.drawing.mark = {DotShape::spiral}; }};
        case FindingKind::overlap:
            if (drawing.style == DrawingStyle::dots && drawing.dot_size.sizing == DotSizing::automatic &&
                drawing.tone.black.value_or(1) > kOpenBlack)
                return Cure{fmt::format("Set deepest black to {:g}", kOpenBlack),
                            [](ViewerSettings& settings) { settings.drawing.tone.black = kOpenBlack; }};
            break;
        case FindingKind::over_edge:
            return Cure{"Use automatic margins",
                        [](ViewerSettings& settings) { settings.drawing.page.margins.reset(); }};
        case FindingKind::in_margins:
            return Cure{fmt::format("Widen the margins by {:.1f} mm", amount),
                        [amount](ViewerSettings& settings) {
                            std::optional<Margins>& margins = settings.drawing.page.margins;
                            margins = widened(margins.value_or(Margins{}), amount);
                        }};
        case FindingKind::fine_pixels:
            return Cure{fmt::format("Use {:.0f} ppi", amount),
                        [amount](ViewerSettings& settings) { settings.saving.dpi = amount; }};
        case FindingKind::dwell:
            if (amount > 0)
                return Cure{fmt::format("Set dwell to {:g} s", amount),
                            [amount](ViewerSettings& settings) { settings.saving.dwell_s = amount; }};
            break;
        case FindingKind::tile_layer:
            return Cure{"Hide the tile boundaries",
                        [](ViewerSettings& settings) { settings.drawing.show_tiles = false; }};
        case FindingKind::background:
            return Cure{"Hide the background",
                        [](ViewerSettings& settings) { settings.drawing.background = false; }};
        default:  // a choice that is the person's
            break;
    }
    return std::nullopt;
}

// Folded, and those about machines only where one was asked for.
bool draw_findings(std::vector<Finding> findings, ViewerSettings& settings, DrawingFormat format) {
    if (!settings.saving.machine && !is_for_machines(format))
        std::erase_if(findings, [](const Finding& finding) { return is_about_machines(finding.kind); });
    const std::string shown = fmt::format("Plotting advice ({})", findings.size());
    if (findings.empty() || !subsection("Plotting advice", false, shown.c_str())) return false;
    bool changed = false;
    for (const Finding& finding : findings) {
        // The time is shown above, with its machine.
        const bool timed = finding.kind == FindingKind::hours;
        hint(((timed ? finding.cure : sentence_of(finding)) + ".").c_str());
        note_place(("Finding " + std::string(name_of(finding.kind))).c_str());
        const std::optional<Cure> cure = cure_of(finding, settings.drawing);
        if (!cure) continue;
        if (key_button(cure->label.c_str())) {
            cure->apply(settings);
            changed = true;
        }
        note_place(cure->label.c_str());
    }
    return changed;
}

// "2480 x 3508 pixels, 210 x 297 mm, about 24 MB, 400,000 dots".
std::string file_in_words(const ViewerSettings& settings, DrawingFormat format, const ExportInfo& info) {
    if (!info.trouble.empty()) return "Cannot be written; see below.";
    const Sheet& sheets = settings.drawing.sheets;
    if (is_several(sheets))
        return fmt::format("{} x {} sheets and a plan, a file each: {}", sheets.columns, sheets.rows,
                           size_in_words(info));
    const std::string words = paper_in_words(info.page, settings.unit) + ", " + size_in_words(info);
    if (!has_pixels(format)) return words;
    const RasterSize size = raster_size(info.page, settings.saving.dpi);
    return fmt::format("{} x {} pixels, {}", size.width, size.height, words);
}

// That only a part of the page is saved, which the settings that were opened say.
bool draw_region(std::optional<Rectangle<double>>& region) {
    const glm::dvec2 size = region->size();
    hint(fmt::format("Saves only {:g} x {:g} mm of the page, {:g} mm from its left and {:g} mm from its top.",
                     size.x, size.y, region->low.x, region->low.y)
             .c_str());
    const bool whole = key_button("Save the whole page");
    note_place("Save the whole page");
    if (whole) region.reset();
    return whole;
}

}  // namespace

std::string size_in_words(const ExportInfo& info) {
    const std::string dots = grouped(info.dots) + (info.dots == 1 ? " dot" : " dots");
    return info.bytes ? "about " + bytes_in_words(*info.bytes) + ", " + dots : dots;
}

bool draw_export_panel(ViewerSettings& settings, DrawingFormat format, const ExportInfo& info) {
    bool changed = false;
    hint(file_in_words(settings, format, info).c_str());
    note_place("File size");
    const char* const why_one =
        settings.drawing.pens.set == PenSet::one ? "Applies to several pens only." : nullptr;
    if (has_pixels(format)) {
        changed |= slider_row(setting::dpi, settings.saving.dpi);
        int deep = settings.saving.bits == 16;
        if (segmented_row("Bits", deep, std::array{"8", "16"}, "Bits per channel.")) {
            settings.saving.bits = deep ? 16 : 8;
            changed = true;
        }
        const Absent absent(why_one);
        changed |= switch_row(setting::separations, settings.saving.separations);
    } else if (!is_table(format)) {
        const Absent absent(why_one);
        changed |= switch_row(setting::pen_files, settings.saving.pen_files);
    }
    if (has_order(format, settings.drawing.style))
        changed |= draw_order(settings.saving.order, usual_order(format, info.dots, settings.drawing.style));
    if (format == DrawingFormat::gcode) changed |= draw_gcode(settings.saving);
    if (is_plotted(format)) changed |= draw_machine(settings.saving, format, info);
    if (has_optional_paper(format))
        changed |= switch_row(format == DrawingFormat::svg ? "Paper in SVG" : "Paper in PDF",
                              settings.drawing.background,
                              "Paints the paper's colour under the dots; a plotter needs none.");
    if (settings.saving.region && !is_several(settings.drawing.sheets))
        changed |= draw_region(settings.saving.region);
    if (!info.trouble.empty()) {
        hint(info.trouble.c_str());
        return changed;
    }
    changed |= draw_findings(info.findings, settings, format);
    if (settings.drawing.show_tiles && format != DrawingFormat::svg)
        hint("The tile boundaries are not saved: only SVG has layers.");
    return changed;
}

}  // namespace dapple
