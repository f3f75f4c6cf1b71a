#include "app/viewer/panels/settings_panels.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/viewer/model/crop_percent.h"
#include "app/viewer/widgets/widgets.h"
#include "io/files/sheet_files.h"

namespace dapple {

namespace {

constexpr const char* kNamed = "The paper sets the page size. For another, choose \"custom\".";
constexpr const char* kPictureShape = "The page has the picture's shape. For another, choose a paper.";

bool draw_paper(PageSetup& setup, const PageSize& drawn) {
    if (!choice_row("Paper size", setup.paper, names_of(setup.paper),
                    "The sheet to draw on; \"as the picture\" follows the picture's shape."))
        return false;
    // Either of the two that are no papers begins with the page as it was, to be changed from there.
    if (setup.paper == Paper::custom) {
        setup.width_mm = drawn.width_mm;
        setup.height_mm = drawn.height_mm;
        setup.orientation = PageOrientation::automatic;
    } else if (setup.paper == Paper::as_picture) {
        setup.width_mm = drawn.width_mm;
        setup.height_mm.reset();
    }
    return true;
}

bool draw_sides(PageSetup& setup, const PageSize& drawn, LengthUnit unit) {
    const bool named = setup.paper != Paper::as_picture && setup.paper != Paper::custom;
    const Absent absent(named ? kNamed : nullptr);
    bool changed = false;
    // On a page of the picture's shape, the side typed last says how long the other is.
    const bool by_height = setup.paper == Paper::as_picture && setup.height_mm;
    double width = by_height ? drawn.width_mm : setup.width_mm;
    double height = setup.height_mm.value_or(drawn.height_mm);
    if (slider_row(setting::width, width, {.unit = unit})) {
        setup.width_mm = width;
        if (setup.paper == Paper::as_picture) setup.height_mm.reset();
        changed = true;
    }
    // What follows from the width is the default.
    if (slider_row(setting::height, height,
                   {.usual = setup.height_mm ? std::nullopt : std::optional(height), .unit = unit})) {
        setup.height_mm = height;
        changed = true;
    }
    return changed;
}

Margins on_all_sides(double mm) {
    return {mm, mm, mm, mm};
}

bool are_equal(const Margins& margins) {
    return margins == on_all_sides(margins.top);
}

// Whether each side has a row, though they may be alike at present.
bool& each_side() {
    return *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("each margin"));
}

constexpr const char* kOneMargin = "Width of the bare paper along this edge.";

// The page's margins, or those that are automatic, which are as wide as a dot reaches.
class MarginRows {
 public:
    MarginRows(std::optional<Margins>& margins, const PageLayout& drawn, LengthUnit unit)
        : margins_(margins),
          usual_(std::ceil(drawn.reach_mm * 20 - 1e-9) / 20),  // does not drift with the number of dots
          shown_(margins.value_or(on_all_sides(usual_))),
          shorter_(std::min(drawn.page.width_mm, drawn.page.height_mm)),
          unit_(unit) {}

    bool draw_first() {
        const bool alike = !each_side() && are_equal(shown_);
        const bool changed = row(alike ? setting::margin.names.row : "Top", shown_.top,
                                 alike ? "Width of the bare paper along all four edges. By default, one dot "
                                         "radius, so that no dot is cut."
                                       : kOneMargin);
        if (alike) shown_ = on_all_sides(shown_.top);
        return taken(changed);
    }

    bool draw_others() {
        int by = each_side() || !are_equal(shown_) ? 1 : 0;
        bool changed = false;
        if (segmented_row("Margins", by, std::array{"equal", "each side"},
                          "Bare paper along the edges, free of dots. each side: margins may differ.")) {
            each_side() = by == 1;
            if (by == 0) {
                changed = !are_equal(shown_);
                shown_ = on_all_sides(shown_.top);
            }
        }
        const Absent absent(by == 0 ? "Applies to margins that differ: choose \"each side\" for Margins."
                                    : nullptr);
        changed |= row("Right", shown_.right, kOneMargin);
        changed |= row("Bottom", shown_.bottom, kOneMargin);
        changed |= row("Left", shown_.left, kOneMargin);
        return taken(changed);
    }

 private:
    bool row(const char* label, double& side, const char* tip) const {
        // The picture keeps some room.
        return slider_row(
            label, side,
            range_of(setting::margin, {.usual = usual_,
                                       .most = std::max(shorter_ * 0.49, 1.0),
                                       .track = Track{0, std::clamp(shorter_ * 0.3, 1.0, 100.0)},
                                       .unit = unit_,
                                       .tip = tip}));
    }

    // The usual ones are automatic again: other dots have their own.
    bool taken(bool changed) {
        if (!changed) return false;
        margins_ = shown_;
        if (shown_ == on_all_sides(usual_)) margins_.reset();
        return true;
    }

    std::optional<Margins>& margins_;
    double usual_;
    Margins shown_;
    double shorter_;  // side of the page, mm
    LengthUnit unit_;
};

bool draw_number_of_sheets(const char* label, int& number) {
    return slider_row(label, number,
                      {.min = 1,
                       .max = 10,
                       .neutral = 1,
                       .format = "%.0f",
                       .hard_max = kMostSheetsAtOnce,
                       .tip = "For a mural larger than the printer or plotter: each sheet is exported as a "
                              "file, with a plan of how they join."});
}

bool draw_sheets(Sheet& sheets, const PageSize& drawn, LengthUnit unit) {
    bool changed = draw_number_of_sheets("Sheets across", sheets.columns);
    changed |= draw_number_of_sheets("Sheets down", sheets.rows);
    {
        const Absent absent(is_several(sheets) ? nullptr : "Applies to several sheets only.");
        changed |= slider_row(setting::overlap, sheets.overlap_mm, {.unit = unit});
    }
    if (!is_several(sheets)) return changed;
    try {
        hint((sheets_in_words(drawn, sheets, unit) + ".").c_str());
        note_place("Sheets");
    } catch (const std::runtime_error& error) {
        hint("The overlap is too wide for these sheets.");
        note_place("No sheets");
        tip((std::string(error.what()) + ".").c_str());
    }
    return changed;
}

}  // namespace

bool draw_page_panel(PageSetup& setup, Sheet& sheets, const PageLayout& drawn, LengthUnit unit) {
    if (!section("Page")) return false;
    // "Paper" alone is the colour of it.
    bool changed = draw_paper(setup, drawn.page);
    {
        const Absent absent(setup.paper == Paper::as_picture ? kPictureShape : nullptr);
        changed |= choice_row("Orientation", setup.orientation, std::array{"auto", "portrait", "landscape"},
                              "Portrait or landscape; auto: as the picture is.");
        changed |= segmented_row("Fit", setup.fit, std::array{"inside", "fill"},
                                 "inside: the whole picture, centred within the margins. fill: the middle of "
                                 "the picture, cropped to fill the page up to the margins.");
    }
    changed |= draw_sides(setup, drawn.page, unit);
    MarginRows margins(setup.margins, drawn, unit);
    changed |= margins.draw_first();
    if (!subsection("More page settings", false)) return changed;
    changed |= margins.draw_others();
    return draw_sheets(sheets, drawn.page, unit) || changed;
}

bool draw_crop_rows(PageSetup& setup, CropTool& tool, glm::ivec2 picture, glm::dvec2 room) {
    if (!section("Crop")) {
        tool.on = false;  // what cannot be seen is not to frame
        return false;
    }
    std::optional<Crop>& crop = setup.crop;
    Rectangle<double> box = crop_percent(crop, picture);
    bool changed = false;
    if (choice_row("Proportions", tool.proportion, names_of(tool.proportion),
                   "Proportions that the frame keeps while dragged. page: the paper within its margins. "
                   "Others are upright if the frame is.")) {
        box = in_proportion(box, percent_proportion(tool.proportion, box, picture, room));
        changed = tool.proportion != CropProportion::free;
    }
    switch_row("Crop frame", tool.on,
               "Shows the whole picture with a frame around what is drawn: drag the frame, its edges or its "
               "corners.");
    constexpr std::array kSides{"From left, %", "From top, %", "To right, %", "To bottom, %"};
    for (int i = 0; i < 4; ++i)
        changed |= slider_row(kSides[static_cast<std::size_t>(i)], (i < 2 ? box.low : box.high)[i % 2],
                              {.max = 100,
                               .neutral = i < 2 ? 0.0 : 100.0,
                               .format = "%.1f",
                               .tip = i % 2 == 0 ? "In percent of the picture's width, before rotation."
                                                 : "In percent of the picture's height, before rotation."});
    if (changed) crop = crop_of_percent(box);
    changed |= segmented_row("Rotate", setup.quarter_turns, std::array{"0", "90", "180", "270"},
                             "Rotates the picture on the page, in degrees clockwise.");
    changed |= switch_row(setting::mirror, setup.mirrored);
    const Absent absent(crop ? nullptr : "The whole picture is drawn.");
    if (!wide_button("Remove the crop", "Draws the whole picture.")) return changed;
    crop.reset();
    return true;
}

}  // namespace dapple
