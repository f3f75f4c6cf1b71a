#include "app/viewer/panels/settings_panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/viewer/widgets/widgets.h"
#include "core/pens/pen.h"
#include "core/pens/separation.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

SliderRange length_range(double max, double hard_max, LengthUnit unit, const char* tip) {
    return {.max = max, .hard_max = hard_max, .typed = TypedKind::length, .unit = unit, .tip = tip};
}

SliderRange width_range(LengthUnit unit, double width_mm) {
    SliderRange range =
        length_range(1.5, kWidestPenMm, unit, "Width of the pen's line; 0: as wide as the dots.");
    if (width_mm == 0) range.format = "auto";
    return range;
}

SliderRange gain_range(LengthUnit unit) {
    return length_range(0.5, kMostGainMm, unit,
                        "Dot gain: how much wider than the tip dots become on your paper. Measure it with "
                        "dapple testsheet. Wider dots are fewer.");
}

// What pens of one's own begin as: those that drew so far.
Palette palette_to_begin_with(const DrawingSettings& settings) {
    if (settings.pens.set == PenSet::one) return {{.name = "Ink", .colour = settings.ink}};
    const Palette pens = palette_of(settings.pens);
    return pens.empty() ? palette_of({.set = PenSet::cmyk,
                                      .width_mm = settings.pens.width_mm,
                                      .gain_mm = settings.pens.gain_mm})
                        : pens;
}

// Automatic ones are known once they drew.
Palette pens_to_keep(const PenChoice& choice, const PensSeen& seen) {
    if (choice.set != PenSet::automatic) return palette_of(choice);
    return Palette(seen.drawn.begin(), seen.drawn.end());
}

// The choice that people make, of which pens and which colours of ink and paper are two parts.
struct Inks {
    const char* name;
    PenSet set;
    bool white_on_black = false;
};
constexpr std::array kInks{Inks{"one ink", PenSet::one},     Inks{"white on black", PenSet::one, true},
                           Inks{"greys", PenSet::greys},     Inks{"CMYK", PenSet::cmyk},
                           Inks{"custom pens", PenSet::own}, Inks{"automatic", PenSet::automatic}};

bool is_white_on_black(const DrawingSettings& settings) {
    return settings.pens.set == PenSet::one && settings.tone.invert && settings.ink == kWhite &&
           settings.paper == kBlack;
}

void take_inks(DrawingSettings& settings, PenSet set, bool white) {
    if (set == PenSet::own && settings.pens.own.empty()) settings.pens.own = palette_to_begin_with(settings);
    // White ink draws light, and all others draw darkness again.
    if (white || is_white_on_black(settings)) {
        settings.tone.invert = white;
        settings.ink = white ? kWhite : kBlack;
        settings.paper = white ? kBlack : kWhite;
    }
    settings.pens.set = set;
}

bool draw_inks(DrawingSettings& settings) {
    std::array<const char*, kInks.size()> names{};
    std::ranges::transform(kInks, names.begin(), &Inks::name);
    const auto now = std::ranges::find_if(kInks, [&](const Inks& inks) {
        return inks.set == settings.pens.set && inks.white_on_black == is_white_on_black(settings);
    });
    int chosen = static_cast<int>(now - kInks.begin());
    if (!choice_row("Inks", chosen, names,
                    "One ink, or several pens whose colours mix to the picture's; the dots of all keep "
                    "apart. white on black: draws the light parts. custom pens: pens that you name. "
                    "automatic: pens chosen for the picture from the palette."))
        return false;
    const Inks& taken = kInks[static_cast<std::size_t>(chosen)];
    take_inks(settings, taken.set, taken.white_on_black);
    return true;
}

// In colour, as it is an offer.
bool draw_light_ink(DrawingSettings& settings, bool mostly_black) {
    const Absent absent(mostly_black ? nullptr : "Applies to pictures that are nearly black only.");
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    const bool pressed =
        wide_button("White ink on black paper",
                    "Nearly all dots would lie in black; this draws the light parts instead.");
    ImGui::PopStyleColor();
    if (pressed) take_inks(settings, PenSet::one, true);
    return pressed;
}

bool draw_number(PenChoice& pens) {
    const Absent absent(pens.set == PenSet::automatic ? nullptr : "Applies to automatic pens only.");
    return slider_row("How many", pens.automatic,
                      {.min = 1,
                       .max = chooses_from_own(pens) ? double(pens.own.size() - 1) : double{kMostPens},
                       .neutral = 4,
                       .format = "%.0f",
                       .tip = "Number of pens chosen for the picture; more pens mix more colours."});
}

bool draw_tips(PenChoice& pens, LengthUnit unit) {
    const char* const no_width = pens.set == PenSet::own  ? "Each custom pen has its own width."
                                 : chooses_from_own(pens) ? "Each pen of the palette has its own width."
                                                          : nullptr;
    const Absent absent(no_width);
    const bool changed = slider_row("Tip width", pens.width_mm, width_range(unit, pens.width_mm));
    const Absent no_gain(pens.width_mm > 0 ? nullptr : "Give the pens a width first.");
    return slider_row("Dot gain", pens.gain_mm, gain_range(unit)) || changed;
}

bool draw_black_ink(PenChoice& pens) {
    const Absent absent(pens.set == PenSet::cmyk ? nullptr : "Applies to CMYK only.");
    return slider_row("Black in greys", pens.black,
                      {.neutral = kUsualBlack,
                       .tip = "How much grey is drawn in black instead of three colours: 0 as little as "
                              "possible, 1 as much."});
}

bool is_free(const Palette& pens, const std::string& name) {
    return std::ranges::find(pens, name, &Pen::name) == pens.end();
}

// Another common pen, or a numbered one.
Pen another(const Palette& pens) {
    for (const Pen& pen : common_pens())
        if (is_free(pens, pen.name)) return pen;
    Pen pen;
    for (int number = 1; pen.name.empty() || !is_free(pens, pen.name); ++number)
        pen.name = "Pen " + std::to_string(number);
    return pen;
}

enum class OwnPenButton { none, earlier, remove };

// True while something changes.
bool draw_own_pen(const PenChoice& choice, Palette& pens, std::size_t place, LengthUnit unit,
                  OwnPenButton& pressed) {
    Pen& pen = pens[place];
    const std::string number = " " + std::to_string(place + 1);
    ImGui::PushID(static_cast<int>(place));
    ImGui::Dummy({0, ImGui::GetTextLineHeight() / 5});
    const auto good = [&](const std::string& name) {
        return is_pen_name(name) && !names_pen_set(name) && (name == pen.name || is_free(pens, name));
    };
    bool changed = text_row(("Pen" + number).c_str(), pen.name, good,
                            "Up to 40 plain letters, digits, spaces and - _ . ( ), and no other pen's name",
                            "The pen's name, which is its layer's in the file.");
    changed |= colour_row(("Colour" + number).c_str(), pen.colour, "The pen's colour on paper.");
    changed |= slider_row(("Width" + number).c_str(), pen.width_mm, width_range(unit, pen.width_mm));
    {
        const Absent absent(pen.width_mm > 0 ? nullptr : "Give the pen a width first.");
        changed |= slider_row(
            ("Gap" + number).c_str(), pen.gap_mm,
            length_range(
                3, kWidestPenMm, unit,
                "Dots of this pen that are closer run together on your paper; the export reports how many."));
        changed |= slider_row(("Gain" + number).c_str(), pen.gain_mm, gain_range(unit));
    }
    {
        const Absent absent(place == 0 ? "Already first."
                            : choice.order != PenOrder::listed
                                ? "Applies to the pen order \"as listed\" only."
                                : nullptr);
        if (wide_button(("Draw " + pen.name + " earlier").c_str(), "Swaps it with the pen above."))
            pressed = OwnPenButton::earlier;
    }
    {
        const Absent absent(pens.size() > 1 ? nullptr : "A drawing needs one pen.");
        if (wide_button(("Remove " + pen.name).c_str(), "Removes the pen from the set; undo restores it."))
            pressed = OwnPenButton::remove;
    }
    ImGui::PopID();
    return changed;
}

bool draw_own_pens(PenChoice& choice, LengthUnit unit) {
    Palette& pens = choice.own;
    bool changed = false;
    OwnPenButton pressed = OwnPenButton::none;
    std::size_t where = 0;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        const OwnPenButton before = pressed;
        changed |= draw_own_pen(choice, pens, i, unit, pressed);
        if (pressed != before) where = i;
    }
    const auto pen = pens.begin() + static_cast<std::ptrdiff_t>(where);
    if (pressed == OwnPenButton::earlier && where > 0) {
        std::iter_swap(pen - 1, pen);
        return true;
    }
    if (pressed != OwnPenButton::remove || pens.size() == 1) return changed;
    pens.erase(pen);
    return true;
}

// Above the list, so that it stays where it is while the list grows.
bool draw_adding(PenChoice& pens) {
    const Absent absent(pens.set != PenSet::own        ? "Applies to custom pens only."
                        : pens.own.size() >= kMostPens ? "That is the maximum."
                                                       : nullptr);
    if (!wide_button("Add a pen", "Adds a pen in a common colour; change it as you like.")) return false;
    pens.own.push_back(another(pens.own));
    return true;
}

// One pen alone, until an eye above is opened or shut.
void draw_pen_alone(std::span<const Pen> drawn, ShownPens& shown) {
    std::vector<std::string> names{"all pens"};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        names.push_back(std::to_string(i + 1) + " " + drawn[i].name + " alone");
    std::vector<const char*> entries;
    for (const std::string& name : names) entries.push_back(name.c_str());
    const auto alone = std::ranges::find(drawn, shown.only, &Pen::name);
    int chosen = alone == drawn.end() ? 0 : static_cast<int>(alone - drawn.begin()) + 1;
    if (choice_row("Pens shown", chosen, entries,
                   "Shows the dots of all pens or of one, as in its layer. Exports include all pens."))
        shown.only = chosen == 0 ? "" : drawn[static_cast<std::size_t>(chosen - 1)].name;
}

// A row for each pen.
void draw_pen_faces(const PensSeen& seen) {
    if (!seen.shown) return;
    ShownPens& shown = *seen.shown;
    for (std::size_t i = 0; i < seen.drawn.size(); ++i) {
        const Pen& pen = seen.drawn[i];
        bool is_seen = shown.only.empty() ? !shown.hidden.contains(pen.name) : shown.only == pen.name;
        if (!eye_row(("Show " + pen.name).c_str(), pen.name, pen.colour,
                     i < seen.dots.size() ? grouped(seen.dots[i]) : "", is_seen,
                     "Show or hide on screen. Exports include it."))
            continue;
        shown.only.clear();
        if (is_seen)
            shown.hidden.erase(pen.name);
        else
            shown.hidden.insert(pen.name);
    }
}

bool draw_more(DrawingSettings& settings, LengthUnit unit, const PensSeen& seen) {
    const Absent absent(settings.pens.set == PenSet::one ? "Applies to several pens only." : nullptr);
    if (!subsection("More pen settings", false)) return false;
    PenChoice& pens = settings.pens;
    bool changed = draw_tips(pens, unit);
    changed |= choice_row("Pen order", pens.order, std::array{"lightest first", "darkest first", "as listed"},
                          "Order of the pens; later ones lie on top. lightest first: no tip picks up a "
                          "darker ink. darkest first: for inks that cover darker ones.");
    changed |= choice_row(setting::pen_ink.names.row, pens.ink, names_of(pens.ink), setting::pen_ink.help);
    changed |= draw_black_ink(pens);
    changed |= switch_row(setting::registration, settings.registration);
    if (seen.shown) draw_pen_alone(seen.drawn, *seen.shown);
    if (settings.pens.set == PenSet::own) changed |= draw_own_pens(settings.pens, unit);
    return changed;
}

}  // namespace

bool draw_pen_panel(DrawingSettings& settings, LengthUnit unit, const PensSeen& seen,
                    const KeptPalettes& kept, bool mostly_black) {
    if (!section("Ink and paper")) return false;
    bool changed = draw_inks(settings);
    changed |= draw_light_ink(settings, mostly_black);
    {
        const Absent absent(settings.pens.set == PenSet::one ? nullptr
                                                             : "Each of several pens has its own colour.");
        changed |= colour_row(setting::ink, settings.ink, kBlack);
    }
    changed |= colour_row(setting::paper, settings.paper, kWhite);
    changed |= draw_number(settings.pens);
    {
        const Absent absent(settings.pens.set == PenSet::one ? "Applies to several pens only." : nullptr);
        if (kept.row)
            changed |= kept.row->draw(settings.pens, pens_to_keep(settings.pens, seen), *kept.banner);
    }
    changed |= draw_adding(settings.pens);
    // By the settings: the rows stay while others are computed.
    PensSeen rows = seen;
    Palette pens = pens_to_keep(settings.pens, seen);
    sort_pens(pens, settings.pens.order);
    if (!std::ranges::equal(pens, seen.drawn, {}, &Pen::name, &Pen::name)) rows.dots = {};
    rows.drawn = pens;
    draw_pen_faces(rows);
    return draw_more(settings, unit, rows) || changed;
}

}  // namespace dapple
