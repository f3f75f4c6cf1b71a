#pragma once
// The page that a drawing is made for, and where on it the picture lies. One value, which the window's
// section "Page" edits and the commands' options fill.
//
//     ┌─ page ───────────────────────┐
//     │  ┌─ within the margins ────┐ │   The picture lies in the middle of what the margins leave, so much
//     │  │   ┌─ picture ──┐        │ │   smaller than that as a dot's radius on each side: all dots that
//     │  │   │            │        │ │   the picture has are drawn, and no part of one is in the margin.
//     │  │   └────────────┘        │ │   Leaving dots away instead would lighten the picture's edges and
//     │  └─────────────────────────┘ │   change their number.
//     └──────────────────────────────┘
//
// Only a page of the picture's own shape whose margins are said to be 0 is filled to its edges with the dots'
// centres, and cuts those that lie there.

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/export.h"
#include "core/image/mask.h"
#include "core/image/rectangle.h"
#include "core/placing/page.h"
#include "core/text/names.h"

namespace dapple {

enum class Paper {
    as_picture,  // of the picture's shape
    custom,      // of any size
    a0,
    a1,
    a2,
    a3,
    a4,
    a5,
    a6,
    b0,
    b1,
    b2,
    b3,
    b4,
    b5,
    b6,
    letter,
    legal,
    tabloid,
    ansi_c,
    ansi_d,
    ansi_e,
    arch_a,
    arch_b,
    arch_c,
    arch_d,
    arch_e,
};

/// "as the picture", "custom", "A4", "Letter", "ANSI C", "Arch D"; in the order of Paper.
DAPPLE_API std::span<const char* const> names_of(Paper);

/// Width and height in millimetres, upright, of a paper that has a name (ISO 216, ANSI/ASME Y14.1).
DAPPLE_API glm::dvec2 paper_size(Paper paper);

enum class PageOrientation {
    automatic,  // as the picture; a custom page as it is given
    portrait,
    landscape,
};
constexpr auto names_of(PageOrientation) {
    return names("auto", "portrait", "landscape");
}

enum class PageFit {
    inside,  // all of the picture; paper stays bare on two sides
    fill,    // the middle of the picture, cut to the shape that the margins leave, to whole pixels
};
constexpr auto names_of(PageFit) {
    return names("inside", "fill");
}

/// In millimetres.
struct Margins {
    double top = 0, right = 0, bottom = 0, left = 0;

    bool operator==(const Margins&) const = default;
};

/// A part of the picture as it was opened: in pixels, or in percent of its width and height.
struct Crop {
    Rectangle<double> box;
    enum class Unit { pixels, percent } unit = Unit::pixels;

    bool operator==(const Crop&) const = default;
};
constexpr auto names_of(Crop::Unit) {
    return names("pixels", "percent");
}

struct PageSetup {
    Paper paper = Paper::as_picture;
    PageOrientation orientation = PageOrientation::automatic;  // no say in a page of the picture's shape
    double width_mm = 200;  // of a custom page and of one of the picture's shape
    std::optional<double> height_mm =
        {};  // of a custom page; of one of the picture's shape instead of its width
    std::optional<Margins> margins = {};  // none: as wide as a dot reaches
    PageFit fit = PageFit::inside;        // no say in a page of the picture's shape
    std::optional<Crop> crop = {};
    int quarter_turns = 0;  // of the picture, clockwise, after the crop: 0..3
    bool mirrored = false;  // left and right change places, after that

    bool operator==(const PageSetup&) const = default;
};

/// Whether all of every dot is kept within the margins: not on a page of the picture's shape with margins of
/// 0.
bool keeps_dots_inside(const PageSetup& setup);

/// What is drawn of a picture of so many pixels. Throws std::runtime_error if the crop reaches beyond it.
Framing framing_of(const PageSetup& setup, glm::ivec2 picture);

/// How far a dot reaches from its centre: in millimetres and in units of the picture's longer side, the
/// larger of the two.
struct DotReach {
    double mm = 0, picture_units = 0;
};

/// In millimetres from the page's upper left corner.
struct PageLayout {
    PageSize page;  // the page unit is the picture's longer side
    Rectangle<double> picture = {};
    Rectangle<double> within_margins = {};
    double reach_mm = 0;  // of a dot: the usual margin
};

/// The page of a picture that is so many pixels large once it is framed. Its size does not depend on the
/// dots. Throws std::runtime_error if the margins leave no room.
PageLayout layout_of(const PageSetup& setup, glm::ivec2 framed_picture, const DotReach& reach = {});

/// What --page takes: a paper's name in upper or lower case, or "210x297", "8.5x11in". Sets paper, width and
/// height. Throws std::runtime_error saying what is wrong.
DAPPLE_API void read_paper(std::string_view text, PageSetup& setup);

/// "15mm", all around; "10,15,20,15": top, right, bottom, left; "auto": none. Throws std::runtime_error.
DAPPLE_API std::optional<Margins> parse_margins(std::string_view text);
/// The same, in millimetres: "15" or "10,15,20,15".
std::string text_of(const Margins& margins);

/// "100,50,640x480" in pixels, "10%,10%,50%x80%". Throws std::runtime_error.
DAPPLE_API Crop parse_crop(std::string_view text);

/// Throws std::runtime_error if it is less than half a pixel wide or high, which are drawn as one.
void check_crop(const Crop& crop, glm::ivec2 picture);

}  // namespace dapple
