#pragma once
// The sections of the column that change the drawing, one after another.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "app/viewer/model/banner.h"
#include "app/viewer/model/crop_percent.h"
#include "app/viewer/model/mask_brush.h"
#include "app/viewer/model/pane.h"
#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/picture_entry.h"
#include "core/drawing/page_setup.h"
#include "core/drawing/settings.h"
#include "core/image/histogram.h"
#include "core/image/tone.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/text/number_words.h"
#include "io/settings/palettes.h"
#include "io/settings/presets.h"

namespace dapple {

// The row "Preset" at the top of the column: chooses one, saves the settings as one, removes one. Below it a
// strip of what all of them make of the picture.

class PresetRow {
 public:
    /// Without a folder there are the built-in presets only, and none is saved.
    explicit PresetRow(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What settings make of the picture shown, small; asked for in every frame that shows it.
    using Preview = std::function<EntryPicture(const DrawingSettings&)>;

    /// For settings as they are now. The chosen preset's are given to `take`; the banner says what went wrong
    /// with a file, or that one was saved.
    void draw(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
              const Preview& preview, Banner& banner);

 private:
    void read(Banner& banner);
    void draw_strip(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
                    const Preview& preview, int chosen);

    std::filesystem::path folder_;
    std::vector<Preset> presets_;  // all that can be chosen; empty: not read yet
    KeptRow row_;
};

// The section "Drawing": how many dots there are, how large, how even, in which shape.

/// True while something changes.
bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn, LengthUnit unit = LengthUnit::mm);

/// Its rows that say how many dots there are, for the method's column. True while something changes.
bool draw_amount_rows(DrawingSettings& settings, const DrawnInfo& drawn, LengthUnit unit);

// The section "Tone": how dark the drawing is where the picture is.

/// What the picture and its drawing came to.
struct ToneInfo {
    Histogram histogram{};        // of the picture; empty: none is shown
    Tone drawn{};                 // with the values that were chosen automatically
    float usual_exposure = 0;     // what automatic exposure comes to
    Tone usual{};                 // with the values that automatic tone chooses or would choose
    float* photograph = nullptr;  // how much of it shows under the dots; none: no row for it
};

/// The darkroom: from true light to automatic tone, the histogram with its handles, the sliders, which show
/// what is drawn. Moving one of these makes the tone the person's own; with all of them where automatic tone
/// has them it is automatic again. True while something changes.
bool draw_tone_panel(DrawingSettings& settings, const ToneInfo& info);

// The histogram of the picture, with handles for black, middle and white.

/// Where the middle handle is: the encoded value for which ink covers half of the paper by black point, white
/// point and gamma. Contrast and brightness are left out, as they bend what these make.
float middle_of(const Tone& tone);

/// A picture's histogram above three handles that can be dragged, black point, middle and white point:
///
///        ▂▅▆▇▅▃▂▂▁▁▂▃▅▂        height: square root of how often a lightness occurs
///     ───▲──────▲──────▲───    black point 0..1, white point 0..1, at least 0.01 apart; gamma 0.25..4
///
/// A press anywhere takes the nearest handle along. Lightness that becomes plain black or white is drawn
/// paler. Fills the panel's width. True while a handle changes the tone.
bool draw_histogram(const Histogram& histogram, Tone& tone);

// The section "Page": the paper, its margins, how the picture lies on it, and the sheets of a mural.

/// `drawn` is the page on screen: where a page of a size of one's own starts from. `unit` is what lengths are
/// shown and typed in; settings keep millimetres. Returns true if it changed anything.
bool draw_page_panel(PageSetup& setup, Sheet& sheets, const PageLayout& drawn, LengthUnit unit);

// The tool "Crop": what of the picture is drawn, and how it is turned.

/// What of a picture of so many pixels is drawn, in percent of its width and height. `room`: the page's
/// within its margins, in the direction in which the picture was opened. True when crop or turns changed.
bool draw_crop_rows(PageSetup& setup, CropTool& tool, glm::ivec2 picture, glm::dvec2 room);

// The row "Palette" of the section "Pens": takes the pens of one, keeps the present ones as one, removes one.

class PaletteRow {
 public:
    /// Without a folder there are the built-in palettes only, and none is saved.
    explicit PaletteRow(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// `now` are the pens that draw, none if they are not known; the banner says what went wrong with a file,
    /// or that one was saved. True if pens were taken: they are one's own then.
    bool draw(PenChoice& pens, const Palette& now, Banner& banner);

 private:
    void read(Banner& banner);

    std::filesystem::path folder_;
    std::vector<NamedPalette> palettes_;  // all that can be chosen; empty: not read yet
    KeptRow row_;
};

// The section "Ink and paper": which pens draw, and the colours of ink and paper.

/// The pens that drew what is seen, several or none, and which of them are looked at.
struct PensSeen {
    std::span<const Pen> drawn = {};
    std::span<const std::uint64_t> dots = {};  // how many each of them drew; empty: not known
    ShownPens* shown = nullptr;                // none: no rows for it
};

/// Those kept by name.
struct KeptPalettes {
    PaletteRow* row = nullptr;  // none: no row for them
    Banner* banner = nullptr;   // with a row: see PaletteRow
};

/// True while a setting changes. Each pen that drew has a row with its colour, its dots and an eye, which is
/// no setting. Pens of one's own are listed at the end: each has a name, a colour, a width, a smallest gap
/// and a dot gain, and can be removed while there is another. `mostly_black`: light ink would draw the
/// picture better (see core/image/auto_tone.h), and is offered.
bool draw_pen_panel(DrawingSettings& settings, LengthUnit unit = LengthUnit::mm, const PensSeen& seen = {},
                    const KeptPalettes& kept = {}, bool mostly_black = false);

// The tool "Mask": the brush that paints where there are more dots, fewer or none, and where they are finer.

/// The brush's rows, and a button that clears the drawing's mask. True when the mask changed.
bool draw_mask_panel(DrawingSettings& drawing, MaskBrush& brush);

// The tool "Retouch": what the mouse does with single dots.

/// Its rows, and a button that takes all edits back. True while they are seen.
bool draw_retouch_panel(DrawingSettings& drawing, RetouchTool& tool);

}  // namespace dapple
