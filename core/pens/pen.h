#pragma once
// Pens, and the sets of them that a drawing is made with.

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/export.h"
#include "core/image/colour.h"
#include "core/text/names.h"

namespace dapple {

/// What is seen of a colour below it.
enum class PenInk {
    transparent,  // multiplied by its own in each channel of linear light, as of fineliners and process inks
    opaque,       // nothing, as of paint markers
};
constexpr auto names_of(PenInk) {
    return names("transparent", "opaque");
}

struct Pen {
    std::string name;                  // as its layer is called; letters, digits, spaces and - _ . ( )
    glm::vec3 colour = kBlack;         // sRGB-encoded, 0..1: what it leaves on white paper
    double width_mm = 0;               // of its line, and so of its dots; 0: as large as the dots are drawn
    double gap_mm = 0;                 // the middles of two of its dots that are nearer run together on paper
    double gain_mm = 0;                // dot gain: how much wider than its line its dots are, as ink spreads
    PenInk ink = PenInk::transparent;  // a palette's pens have the choice's

    bool operator==(const Pen&) const = default;
};

/// How wide its dots come out on paper, in millimetres; 0: as large as the dots are drawn.
inline double dot_width_mm(const Pen& pen) {
    return pen.width_mm > 0 ? pen.width_mm + pen.gain_mm : 0;
}

/// 1 to 40 plain letters, digits, spaces inside and - _ . ( ): what layers in files are called.
bool is_pen_name(std::string_view name);

using Palette = std::vector<Pen>;

inline constexpr std::size_t kMostPens = 12;
/// The least and the most that a pen's width may be.
inline constexpr double kFinestPenMm = 0.001, kWidestPenMm = 50;
/// The most that its dots may be wider.
inline constexpr double kMostGainMm = 10;

enum class PenSet {
    one,        // ink
    greys,      // three
    cmyk,       // with the colours of process inks on coated paper, in sRGB
    own,        // any
    automatic,  // those of common_pens(), or of own ones, that draw the picture best
};
/// How much of greys black draws in place of coloured inks, where the inks leave a choice.
inline constexpr double kUsualBlack = 0.5;
constexpr auto names_of(PenSet) {
    return names("one", "greys", "cmyk", "own", "auto");
}
/// Whether it is one of those that need no pens of one's own, which text that begins so is read as.
bool names_pen_set(std::string_view name);

/// In which order several pens draw. Equally light ones draw as they are listed.
enum class PenOrder {
    lightest,  // first, so that a pen's tip never drags a darker ink along
    darkest,   // first: for inks that cover darker ones, such as paint markers
    listed,    // as the set lists them
};
constexpr auto names_of(PenOrder) {
    return names("lightest", "darkest", "listed");
}

struct PenChoice {
    PenSet set = PenSet::one;
    int automatic = 4;    // how many, 1..kMostPens
    double width_mm = 0;  // of all pens of a set that is not one's own; 0: as large as the dots are drawn
    double gain_mm = 0;   // of the same pens
    double black = kUsualBlack;  // of cmyk, 0..1: see Separation
    Palette own = {};            // of automatic ones those to choose from: see chooses_from_own()
    // Not of the text.
    PenOrder order = PenOrder::lightest;
    PenInk ink = PenInk::transparent;

    bool operator==(const PenChoice&) const = default;
};

/// What the choice says; none for one pen, and for automatic ones, which depend on the picture.
DAPPLE_API Palette palette_of(const PenChoice& choice);

/// Two dozen colours that many makers of fibre pens have.
DAPPLE_API std::span<const Pen> common_pens();

/// Whether one of them is neither a grey nor nearly one, as black inks are.
bool has_colour(const Palette& pens);

void sort_pens(Palette& pens, PenOrder order);

/// What --pens takes: "one", "greys", "cmyk", "auto:5", each with a width as in "cmyk:0.3mm"; or own pens,
/// each a name, a colour and, if wanted, a width, and then a smallest gap: "Sky:#3aa0d8:0.3:0.6,
/// Ochre:#c08a2e:0.5"; or "auto:5:" and own pens to choose from. A width may have a dot gain behind it,
/// "0.3+0.05"; cmyk may end in "black=0.8". Throws std::runtime_error saying what is wrong.
DAPPLE_API PenChoice parse_pens(std::string_view text);
/// A file's: own pens, one a line; lines that begin with # and a space, and empty ones, say nothing.
DAPPLE_API PenChoice parse_pen_list(std::string_view text);
/// Those pens. Throws if two have one name, or if there are none or too many; or if the first is called as a
/// set, which its text would then be read as.
DAPPLE_API PenChoice own_pens(Palette pens);
/// The same text again.
DAPPLE_API std::string text_of(const PenChoice& choice);

/// The place of the darkest pen among them, 0 if there are none.
int darkest_of(std::span<const Pen> pens);

}  // namespace dapple
