#include "core/pens/pen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/failure.h"
#include "core/pens/separation.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr glm::vec3 of_hex(std::uint32_t rgb) {
    return glm::vec3(float(rgb >> 16 & 255), float(rgb >> 8 & 255), float(rgb & 255)) / 255.0f;
}

std::string_view without_spaces(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

// The text cut at each of those characters.
std::vector<std::string_view> parts_of(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(at);
        parts.push_back(without_spaces(text.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// `what`: "width".
double pen_length(std::string_view text, const char* what) {
    const std::optional<double> length = millimetres_of(text);
    if (!length || !(*length > 0) || *length > kWidestPenMm)
        throw failure("{} cannot be a pen's {}; give millimetres over 0 and at most {:g}, such as 0.3", text,
                      what, kWidestPenMm);
    return *length;
}

// "0.3", or "0.3+0.05" with its dot gain.
struct TipSize {
    double width_mm = 0, gain_mm = 0;
};

TipSize tip_size(std::string_view text) {
    const std::size_t plus = text.find('+', 1);
    TipSize size{.width_mm = pen_length(without_spaces(text.substr(0, plus)), "width")};
    if (plus == std::string_view::npos) return size;
    const std::string_view behind = without_spaces(text.substr(plus + 1));
    const std::optional<double> gain = millimetres_of(behind);
    if (!gain || !(*gain >= 0) || *gain > kMostGainMm)
        throw failure("{} cannot be a dot gain; give 0 to {:g} millimetres after the width, such as 0.3+0.05",
                      behind, kMostGainMm);
    size.gain_mm = *gain;
    return size;
}

constexpr std::string_view kBlackWord = "black=";

double black_share(std::string_view text) {
    const std::optional<double> share = number_of<double>(text.substr(kBlackWord.size()));
    if (!share || !(*share >= 0 && *share <= 1))
        throw failure("{} is not possible; give 0 to 1, as in cmyk:0.3:black=0.8", text);
    return *share;
}

void check_name(std::string_view name) {
    if (!is_pen_name(name))
        throw failure(
            "\"{}\" cannot be a pen's name; give up to 40 plain letters, digits, spaces and - _ . ( )", name);
}

// "Sky:#3aa0d8:0.3"
Pen parse_pen(std::string_view text) {
    const std::vector<std::string_view> parts = parts_of(text, ':');
    if (parts.size() < 2 || parts.size() > 4)
        throw failure(
            "\"{}\" is not a pen; give a name, a colour and optionally a width, as in Sky:#3aa0d8:0.3, and a "
            "smallest gap between its dots, as in Sky:#3aa0d8:0.3:0.6",
            text);
    check_name(parts[0]);
    Pen pen{.name = std::string(parts[0]), .colour = parse_colour(parts[1])};
    if (parts.size() >= 3) {
        const TipSize size = tip_size(parts[2]);
        pen.width_mm = size.width_mm;
        pen.gain_mm = size.gain_mm;
    }
    if (parts.size() == 4) pen.gap_mm = pen_length(parts[3], "smallest gap");
    return pen;
}

PenChoice pens_in(const std::vector<std::string_view>& texts) {
    Palette pens;
    for (const std::string_view text : texts) pens.push_back(parse_pen(text));
    return own_pens(std::move(pens));
}

}  // namespace

bool is_pen_name(std::string_view name) {
    constexpr std::size_t kLongest = 40;
    const auto fits = [](unsigned char c) {
        return std::isalnum(c) || std::string_view(" -_.()").find(char(c)) != std::string_view::npos;
    };
    return !name.empty() && name.size() <= kLongest && without_spaces(name) == name &&
           std::ranges::all_of(name, fits);
}

bool names_pen_set(std::string_view name) {
    const std::optional<PenSet> set = value_named<PenSet>(name);
    return set && set != PenSet::own;
}

Palette palette_of(const PenChoice& choice) {
    if (choice.set == PenSet::own) return choice.own;
    Palette pens;
    if (choice.set == PenSet::greys)
        pens = {{"Light grey", of_hex(0xbdbdbd)}, {"Grey", of_hex(0x7d7d7d)}, {"Black", of_hex(0x1d1d1b)}};
    if (choice.set == PenSet::cmyk)
        pens = {{"Cyan", of_hex(0x009ee3)},
                {"Magenta", of_hex(0xe6007e)},
                {"Yellow", of_hex(0xffed00)},
                {"Black", of_hex(0x1d1d1b)}};
    for (Pen& pen : pens) {
        pen.width_mm = choice.width_mm;
        pen.gain_mm = choice.gain_mm;
    }
    return pens;
}

std::span<const Pen> common_pens() {
    static const std::array<Pen, 24> pens{{
        {"Black", of_hex(0x1d1d1b)},      {"Dark grey", of_hex(0x55565a)},   {"Grey", of_hex(0x8b8d90)},
        {"Light grey", of_hex(0xc4c6c8)}, {"Yellow", of_hex(0xffed00)},      {"Lemon", of_hex(0xf7f06a)},
        {"Ochre", of_hex(0xd59a2a)},      {"Orange", of_hex(0xf07d00)},      {"Apricot", of_hex(0xf9c48d)},
        {"Red", of_hex(0xe2001a)},        {"Crimson", of_hex(0x9d1b32)},     {"Magenta", of_hex(0xe6007e)},
        {"Pink", of_hex(0xf29fc5)},       {"Purple", of_hex(0x7a3b8f)},      {"Lilac", of_hex(0xb9a0cf)},
        {"Blue", of_hex(0x004e9f)},       {"Ultramarine", of_hex(0x2d3a8c)}, {"Cyan", of_hex(0x009ee3)},
        {"Ice blue", of_hex(0xa6d8ee)},   {"Turquoise", of_hex(0x00a19a)},   {"Green", of_hex(0x008d36)},
        {"Leaf green", of_hex(0x95c11f)}, {"Brown", of_hex(0x7b4a26)},       {"Sienna", of_hex(0xb5662f)},
    }};
    return pens;
}

bool has_colour(const Palette& pens) {
    constexpr float kNearlyGrey = 0.1f;
    return std::ranges::any_of(pens, [](const Pen& pen) {
        const auto [least, most] = std::minmax({pen.colour.r, pen.colour.g, pen.colour.b});
        return most - least > kNearlyGrey;
    });
}

PenChoice own_pens(Palette pens) {
    for (const Pen& pen : pens)
        if (std::ranges::count(pens, pen.name, &Pen::name) > 1)
            throw failure("two pens are called {}; give each a name of its own", pen.name);
    if (pens.empty() || pens.size() > kMostPens)
        throw failure("{} pens are not possible; give 1 to {}", pens.size(), kMostPens);
    if (names_pen_set(pens.front().name))
        throw failure("{} is a set of pens; give the pen another name", pens.front().name);
    return {.set = PenSet::own, .own = std::move(pens)};
}

void sort_pens(Palette& pens, PenOrder order) {
    if (order == PenOrder::listed) return;
    const float sign = order == PenOrder::lightest ? -1 : 1;
    std::ranges::stable_sort(pens, std::ranges::less{},
                             [sign](const Pen& pen) { return sign * luminance(linear_of(pen.colour)); });
}

PenChoice parse_pens(std::string_view text) {
    text = without_spaces(text);
    std::vector<std::string_view> words = parts_of(text, ':');
    PenChoice choice;
    if (words[0] == name_of(PenSet::cmyk) && words.back().starts_with(kBlackWord)) {
        choice.black = black_share(words.back());
        words.pop_back();
    }
    const auto take_width = [&](std::size_t place) {
        if (words.size() > place + 1) throw failure("{} has more than a set of pens and their width", text);
        if (words.size() > place) {
            const TipSize size = tip_size(words[place]);
            choice.width_mm = size.width_mm;
            choice.gain_mm = size.gain_mm;
        }
        return choice;
    };
    for (const PenSet set : {PenSet::one, PenSet::greys, PenSet::cmyk}) {
        if (words[0] != name_of(set)) continue;
        choice.set = set;
        if (set == PenSet::one && words.size() > 1)
            throw std::runtime_error("one takes no width; the dot radius sets their size");
        return take_width(1);
    }
    if (words[0] == name_of(PenSet::automatic)) {
        choice.set = PenSet::automatic;
        const std::optional<int> count = words.size() > 1 ? number_of<int>(words[1]) : choice.automatic;
        if (!count || *count < 1 || *count > int(kMostPens))
            throw failure("{} is not a number of pens; give 1 to {}, as in auto:4", words[1], kMostPens);
        choice.automatic = *count;
        if (text.find('#') != std::string_view::npos) {
            text.remove_prefix(text.find(':', text.find(':') + 1) + 1);
            choice.own = pens_in(parts_of(text, ',')).own;
            if (!chooses_from_own(choice))
                throw failure("{} pens leave auto:{} no choice; give it more to choose from",
                              choice.own.size(), choice.automatic);
            return choice;
        }
        return take_width(2);
    }
    return pens_in(parts_of(text, ','));
}

PenChoice parse_pen_list(std::string_view text) {
    std::vector<std::string_view> lines = parts_of(text, '\n');
    std::erase_if(
        lines, [](std::string_view line) { return line.empty() || line.starts_with("# ") || line == "#"; });
    return pens_in(lines);
}

std::string text_of(const PenChoice& choice) {
    const auto with_width = [](std::string text, double width, double gain) {
        if (!(width > 0)) return text;
        text += fmt::format(":{:g}", width);
        return gain > 0 ? text + fmt::format("+{:g}", gain) : text;
    };
    if (choice.set == PenSet::one) return "one";
    if (choice.set == PenSet::automatic && !chooses_from_own(choice))
        return with_width(fmt::format("auto:{}", choice.automatic), choice.width_mm, choice.gain_mm);
    if (choice.set != PenSet::own && choice.set != PenSet::automatic) {
        const std::string set = with_width(std::string(name_of(choice.set)), choice.width_mm, choice.gain_mm);
        const bool says_black = choice.set == PenSet::cmyk && choice.black != kUsualBlack;
        return says_black ? set + fmt::format(":{}{:g}", kBlackWord, choice.black) : set;
    }
    std::string text, between;
    if (choice.set == PenSet::automatic) text = fmt::format("auto:{}:", choice.automatic);
    for (const Pen& pen : choice.own) {
        text += std::exchange(between, ",") +
                with_width(fmt::format("{}:{}", pen.name, hex_of(pen.colour)), pen.width_mm, pen.gain_mm);
        if (pen.width_mm > 0 && pen.gap_mm > 0) text += fmt::format(":{:g}", pen.gap_mm);
    }
    return text;
}

int darkest_of(std::span<const Pen> pens) {
    const auto light = [](const Pen& pen) { return luminance(linear_of(pen.colour)); };
    std::size_t darkest = 0;
    for (std::size_t i = 1; i < pens.size(); ++i)
        if (light(pens[i]) < light(pens[darkest])) darkest = i;
    return static_cast<int>(darkest);
}

}  // namespace dapple
