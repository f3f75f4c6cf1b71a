#include "core/drawing/page_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>
#include <vector>

#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr double kLeastRoomMm = 0.01;       // for the picture on either side: finer than any pen
constexpr double kLongestPageMm = 100'000;  // a side: longer ones are slips of the keyboard

struct NamedPaper {
    const char* title;
    glm::dvec2 size;  // mm, upright
};

// In the order of Paper.
constexpr std::array<NamedPaper, 27> kPapers{{
    {"as the picture", {0, 0}},
    {"custom", {0, 0}},
    {"A0", {841, 1189}},
    {"A1", {594, 841}},
    {"A2", {420, 594}},
    {"A3", {297, 420}},
    {"A4", {210, 297}},
    {"A5", {148, 210}},
    {"A6", {105, 148}},
    {"B0", {1000, 1414}},
    {"B1", {707, 1000}},
    {"B2", {500, 707}},
    {"B3", {353, 500}},
    {"B4", {250, 353}},
    {"B5", {176, 250}},
    {"B6", {125, 176}},
    {"Letter", {8.5 * kMmPerInch, 11 * kMmPerInch}},
    {"Legal", {8.5 * kMmPerInch, 14 * kMmPerInch}},
    {"Tabloid", {11 * kMmPerInch, 17 * kMmPerInch}},
    {"ANSI C", {17 * kMmPerInch, 22 * kMmPerInch}},
    {"ANSI D", {22 * kMmPerInch, 34 * kMmPerInch}},
    {"ANSI E", {34 * kMmPerInch, 44 * kMmPerInch}},
    {"Arch A", {9 * kMmPerInch, 12 * kMmPerInch}},
    {"Arch B", {12 * kMmPerInch, 18 * kMmPerInch}},
    {"Arch C", {18 * kMmPerInch, 24 * kMmPerInch}},
    {"Arch D", {24 * kMmPerInch, 36 * kMmPerInch}},
    {"Arch E", {36 * kMmPerInch, 48 * kMmPerInch}},
}};
static_assert(kPapers.size() == static_cast<std::size_t>(Paper::arch_e) + 1);

// Without what people write in one way or another: "ANSI C", "ansi-c", "Ansi_C".
std::string paper_key(std::string_view name) {
    std::string key;
    for (const char c : name) {
        if (c == ' ' || c == '-' || c == '_') continue;
        key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return key;
}

// Width and height of the page; none if it goes by the picture.
std::optional<glm::dvec2> own_size(const PageSetup& setup, glm::ivec2 picture) {
    if (setup.paper == Paper::as_picture) return std::nullopt;
    const bool custom = setup.paper == Paper::custom;
    const glm::dvec2 size = custom ? glm::dvec2(setup.width_mm, setup.height_mm.value_or(setup.width_mm))
                                   : paper_size(setup.paper);
    const glm::dvec2 upright(std::min(size.x, size.y), std::max(size.x, size.y));
    bool lies = picture.x > picture.y;
    if (setup.orientation == PageOrientation::automatic && custom) return size;
    if (setup.orientation != PageOrientation::automatic)
        lies = setup.orientation == PageOrientation::landscape;
    return lies ? glm::dvec2(upright.y, upright.x) : upright;
}

void check_room(double left, double right, double page, const char* first, const char* second,
                const char* direction) {
    if (page - left - right >= kLeastRoomMm) return;
    const std::string margins = left == right
                                    ? fmt::format("{:g} mm on either side", left)
                                    : fmt::format("{:g} mm {} and {:g} mm {}", left, first, right, second);
    throw std::runtime_error(fmt::format("{} leave no room on a page {:g} mm {}", margins, page, direction));
}

// What the margins leave of a page that has a size of its own.
glm::dvec2 room_on(glm::dvec2 page, const Margins& margins) {
    check_room(margins.left, margins.right, page.x, "left", "right", "wide");
    check_room(margins.top, margins.bottom, page.y, "above", "below", "high");
    return page - glm::dvec2(margins.left + margins.right, margins.top + margins.bottom);
}

// Pixels.
glm::dvec2 unit_of(const Crop& crop, glm::ivec2 picture) {
    return crop.unit == Crop::Unit::percent ? glm::dvec2(picture) / 100.0 : glm::dvec2(1);
}

Rectangle<int> cropped(const Crop& crop, glm::ivec2 picture) {
    const glm::dvec2 unit = unit_of(crop, picture);
    const auto [low, high] = crop.box;
    // Half a pixel of rounding is forgiven.
    if (glm::any(glm::greaterThan(high * unit, glm::dvec2(picture) + 0.5)))
        throw std::runtime_error(
            fmt::format("the part reaches to {:.10g} x {:.10g} pixels, and the picture is {} x {}",
                        high.x * unit.x, high.y * unit.y, picture.x, picture.y));
    const glm::ivec2 first = glm::min(glm::ivec2(glm::round(low * unit)), picture - 1);
    const glm::ivec2 end = glm::min(glm::ivec2(glm::round(high * unit)), picture);
    return {first, glm::max(end, first + 1)};
}

}  // namespace

std::span<const char* const> names_of(Paper) {
    static const std::vector<const char*> titles = [] {
        std::vector<const char*> all;
        for (const NamedPaper& paper : kPapers) all.push_back(paper.title);
        return all;
    }();
    return titles;
}

glm::dvec2 paper_size(Paper paper) {
    return kPapers[static_cast<std::size_t>(paper)].size;
}

bool keeps_dots_inside(const PageSetup& setup) {
    return setup.paper != Paper::as_picture || setup.margins != Margins{};
}

Framing framing_of(const PageSetup& setup, glm::ivec2 picture) {
    Framing framing{whole_picture(picture).pixels, setup.quarter_turns, setup.mirrored};
    if (setup.crop) framing.pixels = cropped(*setup.crop, picture);
    const std::optional<glm::dvec2> page = own_size(setup, framing.size());
    if (!page || setup.fit != PageFit::fill) return framing;
    glm::dvec2 room = room_on(*page, setup.margins.value_or(Margins{}));
    if (setup.quarter_turns % 2) room = {room.y, room.x};
    const glm::dvec2 size = framing.pixels.size();
    const double scale = std::min(size.x / room.x, size.y / room.y);
    const glm::ivec2 cut =
        glm::clamp(glm::ivec2(glm::round(room * scale)), glm::ivec2(1), framing.pixels.size());
    framing.pixels.low += (framing.pixels.size() - cut) / 2;
    framing.pixels.high = framing.pixels.low + cut;
    return framing;
}

PageLayout layout_of(const PageSetup& setup, glm::ivec2 framed_picture, const DotReach& reach) {
    const Margins margins = setup.margins.value_or(Margins{});
    const glm::dvec2 pixels(framed_picture), bare(margins.left + margins.right, margins.top + margins.bottom);
    const double longer = std::max(pixels.x, pixels.y);
    glm::dvec2 size, room;
    double mm_per_pixel = 0;
    if (const std::optional<glm::dvec2> own = own_size(setup, framed_picture)) {
        size = *own;
        room = room_on(size, margins);
    } else {
        const bool by_height = setup.height_mm.has_value();
        if (by_height)
            check_room(margins.top, margins.bottom, *setup.height_mm, "above", "below", "high");
        else
            check_room(margins.left, margins.right, setup.width_mm, "left", "right", "wide");
        mm_per_pixel =
            by_height ? (*setup.height_mm - bare.y) / pixels.y : (setup.width_mm - bare.x) / pixels.x;
        room = pixels * mm_per_pixel;
        size = room + bare;
    }
    const Rectangle<double> within{{margins.left, margins.top}, glm::dvec2(margins.left, margins.top) + room};
    if (keeps_dots_inside(setup)) {
        const glm::dvec2 fitting =
            glm::min((room - 2 * reach.mm) / pixels, room / (pixels + 2 * reach.picture_units * longer));
        mm_per_pixel = std::min(fitting.x, fitting.y);
    }
    if (!(mm_per_pixel > 0)) {
        throw std::runtime_error(
            fmt::format("{:g} x {:g} mm within the margins leave no room for dots of radius {:g} mm", room.x,
                        room.y, reach.mm));
    }
    const glm::dvec2 drawn = pixels * mm_per_pixel;
    const glm::dvec2 corner = within.low + glm::max((room - drawn) / 2.0, 0.0);
    const double reach_mm = std::max(reach.mm, reach.picture_units * longer * mm_per_pixel);
    return {{size.x, size.y, longer * mm_per_pixel}, {corner, corner + drawn}, within, reach_mm};
}

void read_paper(std::string_view text, PageSetup& setup) {
    const std::string key = paper_key(text);
    for (std::size_t i = static_cast<std::size_t>(Paper::a0); i < kPapers.size(); ++i) {
        if (paper_key(kPapers[i].title) != key) continue;
        setup.paper = static_cast<Paper>(i);
        return;
    }
    const std::size_t by = text.find('x');
    const auto wrong = [&] {
        return std::runtime_error(
            fmt::format("{} is not known; give a0 to a6, b0 to b6, letter, legal, tabloid, ansi-c to ansi-e, "
                        "arch-a to arch-e, or a size such as 210x297 or 8.5x11in",
                        text));
    };
    if (by == std::string_view::npos) throw wrong();
    const std::string second(text.substr(by + 1));
    std::string first(text.substr(0, by));
    // A unit at the end is that of both: "8.5x11in".
    if (number_of<double>(first))
        first += second.substr(std::min(second.find_first_not_of("0123456789.+-eE"), second.size()));
    const std::optional<double> width = millimetres_of(first), height = millimetres_of(second);
    if (!width || !height) throw wrong();
    for (const double side : {*width, *height}) {
        if (side >= kLeastRoomMm && side <= kLongestPageMm) continue;
        throw std::runtime_error(fmt::format("{} is not possible; a page's sides are from {:g} to {:g} mm",
                                             text, kLeastRoomMm, kLongestPageMm));
    }
    setup.paper = Paper::custom;
    setup.width_mm = *width;
    setup.height_mm = *height;
}

std::optional<Margins> parse_margins(std::string_view text) {
    if (text == "auto") return std::nullopt;
    std::vector<double> lengths;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        const std::optional<double> length = millimetres_of(rest.substr(0, comma));
        if (!length || !std::isfinite(*length))
            throw std::runtime_error(
                fmt::format("{} is not auto, nor a length in mm, cm, in or pt, nor four with commas between "
                            "them: top, right, bottom, left",
                            text));
        if (*length < 0 || *length > kLongestPageMm)
            throw std::runtime_error(fmt::format(
                "{} is not possible; give a length in mm, cm, in or pt at least 0 and at most {:g}", text,
                kLongestPageMm));
        lengths.push_back(*length);
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    if (lengths.size() == 1) return Margins{lengths[0], lengths[0], lengths[0], lengths[0]};
    if (lengths.size() == 4) return Margins{lengths[0], lengths[1], lengths[2], lengths[3]};
    throw std::runtime_error(fmt::format(
        "{}: give one margin for all sides, or four: top, right, bottom, left, as in 10,15,20,15", text));
}

std::string text_of(const Margins& margins) {
    const auto [top, right, bottom, left] = margins;
    if (margins == Margins{top, top, top, top}) return fmt::format("{:.6g}", top);
    return fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}", top, right, bottom, left);
}

Crop parse_crop(std::string_view text) {
    Crop crop;
    std::string numbers;
    int percents = 0, zeros = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(",x"), rest.size());
        std::string_view number = rest.substr(0, end);
        if (number.ends_with('%')) {
            ++percents;
            number.remove_suffix(1);
        } else if (number_of<double>(number) == 0) {
            ++zeros;  // the same in either unit
        }
        numbers += number;
        numbers += rest.substr(end, 1);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const auto values = numbers_of<double, 4>(numbers, ",,x");
    if (!values || (percents > 0 && percents + zeros != 4)) {
        throw std::runtime_error(fmt::format(
            "{} is not a part of a picture; write X,Y,WIDTHxHEIGHT in pixels, as in 100,50,640x480, "
            "or in percent, as in 10%,10%,50%x80%",
            text));
    }
    const auto [x, y, width, height] = *values;
    // Written so that what is not a number is refused too.
    if (!(x >= 0) || !(y >= 0) || !(width > 0) || !(height > 0) || !std::isfinite(x + y + width + height)) {
        throw std::runtime_error(
            fmt::format("{}: the corner is counted from the picture's, from 0 up, and the part needs a width "
                        "and a height over 0",
                        text));
    }
    crop.box = {{x, y}, {x + width, y + height}};
    if (percents) crop.unit = Crop::Unit::percent;
    return crop;
}

void check_crop(const Crop& crop, glm::ivec2 picture) {
    const glm::dvec2 size = crop.box.size() * unit_of(crop, picture);
    if (size.x >= 0.5 && size.y >= 0.5) return;
    throw std::runtime_error(
        fmt::format("the part is {:.3g} x {:.3g} pixels of the picture's {} x {}; make it one pixel wide and "
                    "high, or more",
                    size.x, size.y, picture.x, picture.y));
}

}  // namespace dapple
