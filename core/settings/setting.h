#pragma once
// What there is to say of a setting, once: files, the command's options and help, the window's rows and the
// words of undo all have it from here.
//
//     fields.number(setting::contrast, tone.contrast);       // a project's "contrast", refused outside -1..1
//     add_number(app, setting::contrast, tone.contrast);     // --contrast
//     changed |= slider_row(setting::contrast, tone.contrast);
//
// Where a person's choices have other words in the window than in files and options, the row says what they
// mean by itself.

#include <limits>
#include <string>

#include "core/drawing/settings.h"
#include "core/image/auto_tone.h"
#include "core/relaxing/relax.h"

namespace dapple {

/// How far a slider goes, where that is less than what can be typed, and how it goes there.
struct Track {
    double from = 0, to = 0;  // equal: all of the setting's range
    bool logarithmic = false;
};

struct SettingNames {
    const char* field;        // in files, for good
    const char* row = "";     // its label in the window; undo speaks of it so, too
    const char* option = "";  // "--contrast"; none: the command has it another way
};

struct NumberRange {
    double least = 0, most = std::numeric_limits<double>::max();
    enum class Least { included, excluded } at_least = Least::included;

    /// False for a NaN.
    bool holds(double number) const;
    /// "a number from 0 to 2", "a number over 0, up to 2", "a number from 0 up", of "a number".
    std::string in_words(const char* kind) const;
};

struct Setting {
    SettingNames names;
    NumberRange range = {};  // of a number; of a length, in millimetres
    double usual = 0;        // what a fresh drawing has
    Track track = {};
    const char* format = "%.2f";  // of the row's value
    bool length = false;
    const char* value = "";  // of the option, as help shows it: "EV"; none: its range
    const char* help = "";   // a sentence without its full stop: the option's, and the row's tip
    const char* more = "";   // what the option's help adds
};

namespace setting {

// Of a dot, and of the page.
constexpr Setting radius_row(SettingNames names, const char* help) {
    return {.names = names,
            .range = {kSmallestRadiusMm, kLargestRadiusMm},
            .usual = 0.3,
            .track = {0.02, 5, true},
            .format = "%.3f",
            .length = true,
            .help = help};
}
constexpr Setting side_row(SettingNames names, const char* help) {
    return {.names = names,
            .range = {kShortestSideMm, kLongestSideMm},
            .usual = 200,
            .track = {20, 2000, true},
            .format = "%.4g",
            .length = true,
            .help = help};
}

// Tone.
inline constexpr Setting automatic_tone{
    .names = {"automatic_tone", "Auto tone", "--tone"},
    .value = "auto|true",
    .help =
        "auto: sets black, white and middle tones for a clear picture. true: ink covers just as much as the "
        "picture is dark",
    .more = ". --black-point, --white-point, --contrast, --brightness and --gamma switch it to true"};
inline constexpr Setting tone_strength{.names = {"tone_strength", "Auto tone", "--tone-strength"},
                                       .range = {0, 1},
                                       .usual = kUsualToneStrength,
                                       .help =
                                           "Strength of automatic tone: 0 leaves the tone true; 1 brings out "
                                           "the most in dark areas and thins light ones"};
inline constexpr Setting automatic_exposure{.names = {"automatic_exposure", "Exposure"}};
inline constexpr Setting exposure{.names = {"exposure", "Exposure", "--exposure"},
                                  .range = {-kMostStops, kMostStops},
                                  .track = {-8, 8},
                                  .format = "%+.1f EV",
                                  .value = "auto|EV",
                                  .help =
                                      "Exposure in stops: 1 doubles the light, -1 halves it. HDR pictures "
                                      "start with the exposure that shows most of them",
                                  .more = ": auto"};
inline constexpr Setting black_point{.names = {"black_point", "Black point", "--black-point"},
                                     .range = {0, 1},
                                     .help = "Greys up to this become as dark as the dots allow"};
inline constexpr Setting white_point{.names = {"white_point", "White point", "--white-point"},
                                     .range = {0, 1},
                                     .usual = 1,
                                     .help = "Greys from this on become bare paper"};
inline constexpr Setting contrast{.names = {"contrast", "Contrast", "--contrast"},
                                  .range = {-1, 1},
                                  .help = "Above 0 increases the contrast; below 0 reduces it"};
inline constexpr Setting brightness{.names = {"brightness", "Brightness", "--brightness"},
                                    .range = {-1, 1},
                                    .help = "Lightens the picture; below 0 darkens it"};
inline constexpr Setting gamma{
    .names = {"gamma", "Gamma", "--gamma"},
    .range = {0.1, 10},
    .usual = 1,
    .track = {0.25, 4, true},
    .help = "Lightens the middle tones; below 1 darkens them. Black and white stay"};
inline constexpr Setting blur{
    .names = {"blur", "Blur", "--blur"},
    .range = {0, 100},
    .track = {0, 20},
    .format = "%.1f",
    .help = "Smooths grain and noise over this many thousandths of the picture's longer side"};
inline constexpr Setting detail{.names = {"detail", "Detail", "--detail"},
                                .range = {0, 1},
                                .usual = kAutoDetail,
                                .help = "Brings out faint detail a few dots wide, such as whiskers"};
inline constexpr Setting black{
    .names = {"black", "Deepest black", "--black"},
    .range = {kLeastBlack, 1},
    .usual = 1,
    .value = "auto|0.5..1",
    .help =
        "How solid black becomes. At 1 dots cover the paper; below 1 they stay apart, which leaves more dots "
        "for the rest of the picture",
    .more = ". auto: 0.9 for up to 5,000 dots, 1 from 100,000 on and with --tone true"};
inline constexpr Setting invert{.names = {"invert", "Invert", "--invert"},
                                .help = "Draws the light parts, for light ink on dark paper"};

// Dots.
inline constexpr Setting tile{.names = {"tile", "Tile", "--tile"},
                              .value = "TILE",
                              .help =
                                  "A tile's name (dapple tile list), its file, or its two integers as in "
                                  "14217,2895/16"};
inline constexpr Setting ranking{.names = {"ranking", "Ranking", "--ranking"}};
inline constexpr Setting placer{.names = {"placer", "Placer", "--placer"}};
inline constexpr Setting count{.names = {"count", "Dots", "--dots"},
                               .range = {1, kMostDots},
                               .usual = kDefaultDots,
                               .track = {100, 2'000'000, true},
                               .format = "%.0f",
                               .value = "N",
                               .help = "Exactly this many dots on the page: 40000, 40,000 or 40k"};
inline constexpr Setting scale{
    .names = {"scale", "Dots in black", "--scale"},
    .range = {.at_least = NumberRange::Least::excluded},
    .usual = 2500,
    .track = {10, 100'000, true},
    .format = "%.0f",
    .value = "S",
    .help = "How many dots black gets on the same paper; four times the value gives four times as many",
    .more = ". Instead of --dots: a darker picture gets more dots, an all-black one about 16 S"};
inline constexpr Setting relax{.names = {"relax", "Relax", "--relax"},
                               .range = {0, kMostRelaxingSteps},
                               .usual = kFewestUsualSteps,
                               .track = {0, 20},
                               .format = "%.0f",
                               .value = "auto|N",
                               .help =
                                   "Moves the dots in this many steps until they are even and show the "
                                   "picture best; more steps take longer",
                               .more =
                                   ". 0 to 100, or auto: 12 for up to 13,600 dots, 7 from 40,000 on, none "
                                   "for millions of dots too fine to see"};
inline constexpr Setting settle_for{
    .names = {"settle_for", "Relax for", "--settle-for"},
    .help =
        "pictures: dots show tones and edges best. samples: sums over the dots estimate integrals over the "
        "density best; use about 60 steps with --relax"};
inline constexpr Setting sizing{.names = {"sizing", "Dot size"}};
inline constexpr Setting radius{
    .names = {"radius_mm", "Radius", "--dot-radius"},
    .range = {kSmallestRadiusMm, kLargestRadiusMm},
    .usual = 0.3,
    .track = {0.02, 5, true},
    .format = "%.3f",
    .length = true,
    .value = "LENGTH",
    .help = "From a dot's centre to its edge",
    .more =
        ", on paper; 0.1..0.4: from the smallest, in light areas, to the largest, on black, with as many "
        "dots as the tone needs. Without it, all dots have the one radius that gives the picture's tone"};
inline constexpr Setting smallest =
    radius_row({"smallest_mm", "Smallest"}, "Dot radius where the picture is lightest");
inline constexpr Setting largest =
    radius_row({"largest_mm", "Largest"}, "Dot radius where the picture is darkest");
inline constexpr Setting contours{.names = {"contours", "Contours", "--contours"},
                                  .range = {0, 1},
                                  .help =
                                      "Draws the picture's contours as lines among the dots, as in pen and "
                                      "ink: only the strongest at low values, the most at 1"};
inline constexpr Setting solid{
    .names = {"solid", "Solid black", "--solid"},
    .range = {0.5, 1},
    .usual = 1,
    .help =
        "Fills areas darker than this instead of drawing dots: about 0.9 fills what looks black, 1 nothing"};
inline constexpr Setting style{.names = {"style", "Draw", "--style"}};
inline constexpr Setting dot_shape{.names = {"dot_shape", "Dot shape", "--dot-shape"}};
inline constexpr Setting pen_width{
    .names = {"pen_width_mm", "Pen width", "--pen-width"},
    .range = {kFinestPenMm, kWidestPenMm},
    .usual = 0.3,
    .track = {0.05, 3, true},
    .length = true,
    .help = "Width of the pen's line, for lines and for every dot shape but circle",
    .more =
        ". In a file for plotters, without --dot-shape, each dot is a touch of this pen, or a spiral that "
        "fills it to --dot-radius"};
inline constexpr Setting mask{.names = {"mask", "Mask", "--mask"}};
inline constexpr Setting edits{.names = {"edits", "Retouch", "--edits"},
                               .value = "none|EDITS",
                               .help = "What was changed by hand in the window; none: nothing"};

// Page.
inline constexpr Setting page_size{.names = {"paper", "Paper size", "--page"}};
inline constexpr Setting orientation{
    .names = {"orientation", "Orientation", "--orientation"},
    .help = "Portrait or landscape; auto: as the picture is, or as a custom size is given"};
inline constexpr Setting width =
    side_row({"width_mm", "Width", "--width"},
             "Page width, with margins; the height follows from the picture's shape, unless it is given too");
inline constexpr Setting height =
    side_row({"height_mm", "Height", "--height"},
             "Page height, with margins; the width follows from the picture's shape, unless it is given too");
inline constexpr Setting margin{.names = {"margins_mm", "Margin", "--margin"},
                                .range = {0, kLongestSideMm},
                                .track = {0, 100},
                                .format = "%.3g",
                                .length = true,
                                .value = "auto|LENGTH",
                                .help = "Bare paper on each side, free of dots",
                                .more =
                                    ": 15mm, or top,right,bottom,left as in 10,15,20,15; auto: one dot "
                                    "radius. On a page of the picture's shape, 0 cuts the dots at its edges"};
inline constexpr Setting fit{.names = {"fit", "Fit", "--fit"},
                             .help =
                                 "inside: the whole picture, centred within the margins. fill: the middle of "
                                 "the picture, cropped to fill the page up to the margins"};
inline constexpr Setting rotate{.names = {"quarter_turns", "Rotate", "--rotate"},
                                .range = {0, 3},
                                .value = "0|90|180|270",
                                .help = "Rotates the picture clockwise",
                                .more = ", after --crop"};
inline constexpr Setting mirror{
    .names = {"mirrored", "Mirror", "--mirror"},
    .help = "Swaps left and right, for prints from the drawing: transfers, linocut"};
inline constexpr Setting overlap{.names = {"sheet_overlap_mm", "Overlap", "--overlap"},
                                 .range = {0, kWidestOverlapMm},
                                 .track = {0, 30},
                                 .format = "%.3g",
                                 .length = true,
                                 .help =
                                     "Width of the strip that neighbouring sheets share, for cutting and "
                                     "gluing; SVG and PDF have cut marks"};

// Pens and colours.
inline constexpr Setting pens{.names = {"pens", "Inks", "--pens"}};
inline constexpr Setting pen_order{.names = {"pen_order", "Pen order", "--pen-order"}};
inline constexpr Setting pen_ink{
    .names = {"pen_ink", "Pen ink", "--pen-ink"},
    .help =
        "How overlapping dots of several pens look, on screen and in files. transparent: both inks show, as "
        "with fineliners and ballpoints. opaque: only the upper one, as with paint markers; always so if one "
        "of the pens, such as white on brown paper, would hardly show otherwise"};
inline constexpr Setting registration{.names = {"registration", "Registration", "--registration"},
                                      .help =
                                          "Several pens: every pen draws a cross in each corner of the page, "
                                          "to align the pens; separations have them too"};
inline constexpr Setting ink{.names = {"ink", "Ink", "--ink"},
                             .help = "The dots' colour, on screen and in files, with one pen"};
inline constexpr Setting paper{.names = {"paper", "Paper", "--paper"},
                               .help = "The page's colour; in SVG and PDF only on request"};
inline constexpr Setting background{
    .names = {"background", "Paper in files", "--background"},
    .help = "SVG, PDF: paints the paper under the dots, as PNG always does; a plotter needs none"};
inline constexpr Setting show_tiles{
    .names = {"show_tiles", "Tile boundaries", "--tiles"},
    .help =
        "Outlines each copy of the tile; SVG has the outlines as a layer. In the window the letter F shows "
        "how a copy is turned, its colour which kind it is"};

// Saving.
inline constexpr Setting order{.names = {"order", "Dot order", "--order"}};
inline constexpr Setting dpi{.names = {"dpi", "Resolution (ppi)", "--dpi"},
                             .range = {1, 100'000},
                             .usual = 300,
                             .track = {50, 1200, true},
                             .format = "%.0f",
                             .value = "N",
                             .help = "PNG, TIFF: pixels per inch of the page"};
inline constexpr Setting bits{
    .names = {"bits", "Bits", "--bits"}, .value = "8|16", .help = "PNG, TIFF: bits per channel"};
inline constexpr Setting separations{.names = {"separations", "Separations", "--separations"},
                                     .help =
                                         "PNG, TIFF of several pens: also a grey picture for each pen, black "
                                         "where its ink is, for printers who make a screen or plate for each",
                                     .more = ": cat-1-yellow.tif beside cat.tif"};
inline constexpr Setting pen_files{.names = {"pen_files", "Pen files", "--pen-files"},
                                   .help =
                                       "SVG, PDF, G-code, HPGL, DXF of several pens: a file for each pen "
                                       "instead of one for all, so that no plot waits for a pen change",
                                   .more = ": cat-1-yellow.gcode and so on for cat.gcode"};
inline constexpr Setting gcode_tool{.names = {"gcode_tool", "G-code for", "--gcode"}};
inline constexpr Setting gcode_template{.names = {"gcode_template", "Template"}};
inline constexpr Setting machine{.names = {"machine", "Machine", "--machine"},
                                 .help =
                                     "Used to estimate the plotting time, with its software's default "
                                     "settings; the file is the same for all",
                                 .more = ". Without it: an AxiDraw V3, or a GRBL machine for G-code"};
inline constexpr Setting feed{.names = {"feed_mm_per_min", "Feed, mm/min", "--feed"},
                              .range = {0.01, 1e6},
                              .usual = 3000,
                              .track = {100, 20'000, true},
                              .format = "%.0f",
                              .value = "MM/MIN",
                              .help = "G-code: the tool's speed, in millimetres per minute"};
inline constexpr Setting dwell{
    .names = {"dwell_s", "Dwell, s", "--dwell"},
    .range = {0, 60},
    .usual = 0.1,
    .track = {0, 1},
    .value = "SECONDS",
    .help = "G-code: how long the tool rests at a dot, as G4 P, which Grbl and LinuxCNC read in seconds",
    .more =
        "; Grbl rounds each rest up to 0.05 s, and a laser's shorter bursts are moves by M4. Marlin reads P "
        "as milliseconds: give it a template of your own with G4 S{dwell}"};
inline constexpr Setting acceleration{
    .names = {"acceleration_mm_per_s2", "Accel., mm/s2", "--acceleration"},
    .range = {1, 1e5},
    .usual = 10,
    .track = {10, 3000, true},
    .format = "%.0f",
    .value = "MM/S2",
    .help =
        "G-code: the machine's acceleration, used to estimate the plotting time. Grbl's default is 10; most "
        "machines are set to 500 to 3000 ($120)"};
inline constexpr Setting pen_up{.names = {"gcode_pen_up", "Pen up", "--pen-up"},
                                .range = {-10'000, 10'000},
                                .value = "Z|S",
                                .help = "G-code: with the pen off the paper, Z in millimetres or a servo's S",
                                .more = "; without it 2 or 20"};
inline constexpr Setting pen_down{
    .names = {"gcode_pen_down", "Pen down", "--pen-down"},
    .range = {-10'000, 10'000},
    .value = "Z|S",
    .help = "G-code: with the pen on the paper, Z in millimetres or a servo's S",
    .more = "; without it 0 or 90"};
inline constexpr Setting laser_power{
    .names = {"laser_power", "Laser power", "--laser-power"},
    .range = {0, 1e6},
    .usual = 250,
    .track = {0, 1000},
    .format = "%.0f",
    .value = "S",
    .help = "G-code: the S of a laser's M3 or M4; Grbl's default for full power is 1000 ($30)"};

}  // namespace setting
}  // namespace dapple
