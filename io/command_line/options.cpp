#include "io/command_line/options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "core/drawing/edits.h"
#include "core/failure.h"
#include "core/image/auto_tone.h"
#include "core/image/detail.h"
#include "core/relaxing/relax.h"
#include "core/text/number_words.h"
#include "io/settings/palettes.h"
#include "io/settings/xdg_folders.h"

namespace dapple {
namespace {

double in_range(const std::string& text, std::optional<double> value, const NumberRange& range,
                const char* kind) {
    if (!value || !std::isfinite(*value)) throw failure("{} is not {}", text, kind);
    if (!range.holds(*value)) throw failure("{} is not possible; give {}", text, range.in_words(kind));
    return *value;
}

// In millimetres.
double length_in(const std::string& text, const NumberRange& range) {
    return in_range(text, millimetres_of(text), range, "a length in mm, cm, in or pt");
}

int whole_number_in(const std::string& text, const NumberRange& range) {
    const double value = number_in(text, range);
    if (!number_of<int>(text)) throw std::runtime_error(text + " is not a whole number");
    return static_cast<int>(value);
}

CLI::Option* add_text(CLI::App& app, const Setting& setting, const Read& read) {
    return dapple::add_text(app, setting.names.option, unit_of(setting), read, help_of(setting));
}

// "0.2"; or "0.1..0.4", from the smallest to the largest.
DotSize dot_size_in(const std::string& text) {
    const NumberRange range = setting::radius.range;
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {.sizing = DotSizing::fixed, .radius_mm = length_in(text, range)};
    const double smallest = length_in(text.substr(0, dots), range);
    const double largest = length_in(text.substr(dots + 2), range);
    if (smallest > largest) throw std::runtime_error(text + ": put the smaller radius first, as in 0.1..0.4");
    return {.sizing = DotSizing::by_tone, .smallest_mm = smallest, .largest_mm = largest};
}

// What is not a set of pens and has no colour in it is a file's name, or a palette's; also behind "auto:4:".
PenChoice pens_in(const std::string& text) {
    std::error_code error;
    const std::size_t first = text.find(':'), second = first == text.npos ? first : text.find(':', first + 1);
    if (second != text.npos && value_named<PenSet>(text.substr(0, first)) == PenSet::automatic &&
        text.find('#') == text.npos) {
        const std::string behind = text.substr(second + 1);
        if (!millimetres_of(behind.substr(0, behind.find('+'))))
            return parse_pens(text.substr(0, second + 1) + text_of(own_pens(palette_of(pens_in(behind)))));
    }
    if (text.find('#') == std::string::npos && std::filesystem::is_regular_file(text, error))
        return read_pens(text);
    if (is_pen_name(text) && !names_pen_set(text))
        return own_pens(palette_named(text, within_folder(config_folder(), "palettes")).pens);
    return parse_pens(text);
}

void add_colour(CLI::App& app, const Setting& setting, glm::vec3& target) {
    const auto read = [&target](const std::string& text) { target = parse_colour(text); };
    dapple::add_text(app, setting.names.option, "#RRGGBB", read, help_of(setting))
        ->default_str(hex_of(target));
}

// Puts the options made while it lives under a heading of their own in the help.
class Heading {
 public:
    Heading(CLI::App& app, const std::string& title)
        : app_(app), before_(app.option_defaults()->get_group()) {
        app.option_defaults()->group(title);
    }
    Heading& operator=(Heading&&) = delete;
    ~Heading() { app_.option_defaults()->group(before_); }

 private:
    CLI::App& app_;
    std::string before_;
};

}  // namespace

std::string help_of(const Setting& setting) {
    return std::string(setting.help) + setting.more;
}

std::string unit_of(const Setting& setting) {
    if (*setting.value) return setting.value;
    return setting.length ? "LENGTH" : fmt::format("{:g}..{:g}", setting.range.least, setting.range.most);
}

void told_as(const std::string& option, const std::function<void()>& read) {
    try {
        read();
    } catch (const std::runtime_error& error) {
        throw CLI::ValidationError(option, error.what());
    }
}

CLI::Option* add_text(CLI::App& app, const std::string& name, const std::string& unit, const Read& read,
                      const std::string& help) {
    // The last one of its names.
    const auto take = [option = name.substr(name.rfind(',') + 1), read](const std::string& text) {
        told_as(option, [&] { read(text); });
    };
    return app.add_option_function<std::string>(name, take, help)->type_name(unit);
}

double number_in(const std::string& text, const NumberRange& range) {
    return in_range(text, number_of<double>(text), range, "a number");
}

CLI::Option* add_length(CLI::App& app, const std::string& name, double& target, const NumberRange& range,
                        const std::string& help) {
    const auto read = [=, &target](const std::string& text) { target = length_in(text, range); };
    return add_text(app, name, "LENGTH", read, help)->default_str(fmt::format("{:g}mm", target));
}

CLI::Option* add_length(CLI::App& app, const Setting& setting, double& target) {
    return add_length(app, setting.names.option, target, setting.range, help_of(setting));
}

CLI::Option* add_flag(CLI::App& app, const Setting& setting, bool& target) {
    return app.add_flag(setting.names.option, target, help_of(setting));
}

CLI::Option* add_whole_number(CLI::App& app, const std::string& name, int& target, const NumberRange& range,
                              const std::string& help) {
    const auto read = [=, &target](const std::string& text) { target = whole_number_in(text, range); };
    return add_text(app, name, "N", read, help)->default_str(fmt::format("{}", target));
}

CLI::Option* add_words(CLI::App& app, const std::string& name, std::span<const char* const> words,
                       const std::function<void(std::size_t)>& read, const std::string& help) {
    const std::vector<std::string> known(words.begin(), words.end());
    const auto take = [=](const std::string& text) {
        const auto found = std::ranges::find(known, text);
        if (found == known.end())
            throw failure("{} is not known; there are {}", text, fmt::join(known, ", "));
        read(static_cast<std::size_t>(found - known.begin()));
    };
    return add_text(app, name, fmt::format("{}", fmt::join(known, "|")), take, help);
}

CLI::Option* add_memory(CLI::App& app, std::optional<double>& bytes) {
    const auto read = [&bytes](const std::string& text) {
        bytes = quantity_of(text);
        if (!bytes || !(*bytes > 0))
            throw std::runtime_error(text + " is not possible; give bytes, such as 12G");
    };
    return add_text(app, "--memory", "BYTES", read,
                    "Memory that may be used, such as 12G, instead of what is available");
}

CLI::Option* add_pens(CLI::App& app, PenChoice& pens, const std::string& help) {
    const auto take = [&pens](const std::string& text) {
        PenChoice read = pens_in(text);
        read.order = pens.order;
        read.ink = pens.ink;
        pens = std::move(read);
    };
    return add_text(app, "--pens", "PENS", take, help);
}

CLI::Option* add_paper(CLI::App& app, PageSetup& page, const std::string& help) {
    const auto read = [&page](const std::string& text) { read_paper(text, page); };
    return add_text(app, "--page", "PAPER", read, help);
}

CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help) {
    const auto read = [&seed](const std::string& text) {
        const auto number = number_of<std::uint64_t>(text);
        if (!number)
            throw failure("{} is not possible; give a whole number from 0 to {}", text,
                          std::numeric_limits<std::uint64_t>::max());
        seed = *number;
    };
    return add_text(app, "--seed", "N", read, help)->default_str(fmt::format("{}", seed));
}

std::uint64_t count_in(const std::string& text, std::uint64_t most) {
    const std::optional<std::uint64_t> count = count_of(text);
    if (!count || *count < 1 || *count > most)
        throw failure("{} is not possible; give a whole number from 1 to {}", text, grouped(most));
    return *count;
}

CLI::Option* add_ranking(CLI::App& app, std::optional<RankingMethod>& ranking) {
    return add_choice(app, "--ranking", ranking,
                      "Order in which a tile's dots appear: paper, farthest or energy; without it, the one "
                      "kept with the tile");
}

CLI::Option* add_tile(CLI::App& app, std::string& tile) {
    return add_text(app, setting::tile, [&tile](const std::string& text) { tile = text; })->default_str(tile);
}

void add_dot_options(CLI::App& app, DrawingSettings& settings) {
    const Heading heading(app, "Dots");
    PlacingRequest& placing = settings.placing;

    const auto read_count = [&placing](const std::string& text) {
        placing.count = count_in(text, kMostDots);
    };
    add_text(app, setting::count, read_count)->default_str(fmt::format("{}", kDefaultDots));

    // A scale takes the place of the count, whichever comes first; both are refused once all is read.
    const auto read_scale = [&placing](const std::string& text) {
        placing.scale = number_in(text, setting::scale.range);
        placing.count.reset();
    };
    add_text(app, setting::scale, read_scale);

    add_choice(app, "--placer", settings.placer,
               "exact: every dot once; figure8: as printed in the article, with about a quarter of the dots "
               "twice and about as many as --dots");
    add_tile(app, settings.tile);

    add_ranking(app, settings.ranking);

    const auto read_relax = [&settings](const std::string& text) {
        if (text == "auto")
            settings.relax.reset();
        else
            settings.relax = whole_number_in(text, setting::relax.range);
    };
    add_text(app, setting::relax, read_relax)->default_str("auto");
    add_choice(app, setting::settle_for, settings.settle_for);

    const auto read_radius = [&settings](const std::string& text) { settings.dot_size = dot_size_in(text); };
    add_text(app, setting::radius, read_radius);
    add_whole_number(app, "--threads", placing.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; the dots are the same with any number");
}

void add_style_options(CLI::App& app, DrawingSettings& settings) {
    const Heading heading(app, "Dots");
    add_choice(app, "--style", settings.style,
               "dots: each by itself; line: one line through all dots, by a short route that takes some "
               "seconds to find, or in --order; nearest: a network of lines from each dot to its nearest "
               "few, without crossings");
    add_text(
        app, "--dot-shape", "SHAPE|PATH",
        [&settings](const std::string& text) { settings.mark = parse_dot_mark(text); },
        "A dot's shape: circle, filled; point, pen down and up; stroke, a short line; spiral or hatch, "
        "filled by the pen; ring; cross; or an SVG path in a box from 0,0 to 1,1, as in 'M0,0 L1,1', of M, "
        "L, H, V, C, Q, A and Z")
        ->default_str(text_of(settings.mark));
    add_length(app, setting::pen_width, settings.pen_width_mm);
    add_number(app, setting::contours, settings.contours);
    add_number(app, setting::solid, settings.solid);
    add_text(app, setting::edits, [&settings](const std::string& text) {
        settings.edits = text == "none" ? "" : text;
        static_cast<void>(parse_edits(settings.edits));
    });
}

void add_tone_options(CLI::App& app, DrawingSettings& settings) {
    const Heading heading(app, "Tone");
    Tone& tone = settings.tone;
    const auto read_exposure = [&settings](const std::string& text) {
        settings.automatic_exposure = text == "auto";
        settings.tone.exposure = 0;
        if (!settings.automatic_exposure)
            settings.tone.exposure = static_cast<float>(number_in(text, setting::exposure.range));
    };
    add_text(app, setting::exposure, read_exposure)->default_str("auto");
    const auto read_tone = [&settings](const std::string& text) {
        if (text != "auto" && text != "true")
            throw std::runtime_error(text + " is not known; there are auto and true");
        settings.automatic_tone = text == "auto";
    };
    add_text(app, setting::automatic_tone, read_tone)->default_str(settings.automatic_tone ? "auto" : "true");
    add_number(app, setting::tone_strength, settings.tone_strength);
    add_number(app, setting::black_point, tone.black_point);
    add_number(app, setting::white_point, tone.white_point);
    add_number(app, setting::contrast, tone.contrast);
    add_number(app, setting::brightness, tone.brightness);
    add_number(app, setting::gamma, tone.gamma);
    add_number(app, setting::blur, tone.blur);
    add_number(app, setting::detail, tone.detail);
    const auto read_black = [&tone](const std::string& text) {
        tone.black.reset();
        if (text != "auto") tone.black = number_in(text, setting::black.range);
    };
    add_text(app, setting::black, read_black)
        ->default_str(tone.black ? fmt::format("{}", *tone.black) : "auto");
    add_flag(app, setting::invert, tone.invert);
}

void add_page_options(CLI::App& app, DrawingSettings& settings) {
    const Heading heading(app, "Page");
    PageSetup& page = settings.page;
    add_paper(app, page,
              "A paper: a0 to a6, b0 to b6, letter, legal, tabloid, ansi-c to ansi-e, arch-a to arch-e, or a "
              "size such as 210x297 or 8.5x11in. Without it, the page has the picture's shape");
    add_choice(app, setting::orientation, page.orientation);
    add_length(app, setting::width, page.width_mm);
    add_text(app, setting::height,
             [&page](const std::string& text) { page.height_mm = length_in(text, setting::height.range); });
    add_text(app, setting::margin, [&page](const std::string& text) {
        page.margins = parse_margins(text);
    })->default_str(page.margins ? text_of(*page.margins) + "mm" : "auto");
    add_choice(app, setting::fit, page.fit);
    add_text(
        app, "--crop", "X,Y,WxH", [&page](const std::string& text) { page.crop = parse_crop(text); },
        "Draws only a part of the picture, in pixels as in 100,50,640x480, or in percent as in "
        "10%,10%,50%x80%");
    add_text(app, setting::rotate, [&page](const std::string& text) {
        const std::optional<int> degrees = number_of<int>(text);
        if (!degrees || *degrees < 0 || *degrees > 270 || *degrees % 90)
            throw std::runtime_error(text + " is not known; there are 0, 90, 180, 270");
        page.quarter_turns = *degrees / 90;
    })->default_str("0");
    add_flag(app, setting::mirror, page.mirrored);
    add_pens(app, settings.pens,
             "Several pens, whose colours mix to the picture's: greys, cmyk, auto:N for the N that suit the "
             "picture, or auto:N:fineliners for N from a palette, each with an optional width, as in "
             "cmyk:0.3mm; or your own as name:#rrggbb:width,name:#rrggbb:width; or a file with one such pen "
             "a line, or JSON; or a palette by its name, such as fineliners, or one saved by the window. The "
             "dots of all pens keep apart, and overlap only in dark areas. With a width all dots are that "
             "wide, plus the dot gain if given, as in 0.3+0.05; measure it with dapple testsheet. cmyk may "
             "end in black=0 to black=1, as in cmyk:0.3:black=0.8: how much grey is drawn in black")
        ->default_str("one");
    add_choice(app, "--pen-order", settings.pens.order,
               "Which of several pens draws first, below the others: lightest, so that no tip picks up a "
               "darker ink; darkest, for inks that cover darker ones; listed, in the order of --pens");
    add_choice(app, setting::pen_ink, settings.pens.ink);
    add_colour(app, setting::ink, settings.ink);
    add_colour(app, setting::paper, settings.paper);
}

void add_arrangement_options(CLI::App& app, std::optional<DotOrder>& order, Sheet& sheet,
                             std::optional<Rectangle<double>>& region) {
    const Heading heading(app, "Page");
    add_choice(
        app, "--order", order,
        "Order of the dots in the file and on the plotter: shortest, a short route, which for a million dots "
        "takes some seconds to find; space, each dot near the one before, found at once; recursion, as "
        "placed, relaxed ones row by row; priority, the first n nearly equal a drawing with n dots, unless "
        "relaxed. Without it, shortest for SVG, G-code, HPGL and DXF of up to a million dots, space up to 5 "
        "million, else recursion. shortest, space, priority and --placer figure8 hold all dots in memory");
    add_text(
        app, "--sheet", "C,R/CxR", [&sheet](const std::string& text) { sheet = parse_sheet(text); },
        "Draws one sheet of a mural: 2,1/3x4 is column 2, row 1 of 3 columns and 4 rows; the page and --dots "
        "are those of the whole");
    add_text(
        app, "--region", "X,Y,WxH|all",
        [&region](const std::string& text) {
            region.reset();
            if (text != "all") region = parse_region(text);
        },
        "Draws only a part of the page: 20,15,100x80 is 100 mm wide and 80 high, 20 from the left and 15 "
        "from the top; also 2cm,15,10cmx80, or 1,1,4x3in, all in inches. The page and --dots are those of "
        "the whole. all: drops the region of the project or of --settings-from");
}

void refuse(const CLI::App& command, std::initializer_list<const char*> options, const std::string& why) {
    for (const char* const option : options)
        if (command.count(option) > 0) throw CLI::ValidationError(option, why);
}

void check_options(const CLI::App& command, DrawingSettings& settings, bool was_automatic) {
    const auto given = [&](const char* name) {
        const CLI::Option* const option = command.get_option_no_throw(name);
        return option && option->count() > 0;
    };
    const auto refuse_if = [&](bool wrong, const char* name, const char* why) {
        if (wrong && given(name)) throw CLI::ValidationError(name, why);
    };
    for (const char* name : {"--black-point", "--white-point", "--contrast", "--brightness", "--gamma"}) {
        if (!given(name)) continue;
        if (given("--tone") && settings.automatic_tone)
            throw CLI::ValidationError("--tone", fmt::format("auto cannot be given together with {}", name));
        settings.automatic_tone = false;
    }
    refuse_if(!settings.automatic_tone, "--tone-strength",
              "applies to automatic tone only; leave it out, or give --tone auto");
    // True light is left as it is.
    if (was_automatic != settings.automatic_tone && !given("--detail"))
        settings.tone.detail = settings.automatic_tone ? kAutoDetail : 0;
    if (was_automatic != settings.automatic_tone && !given("--black")) settings.tone.black.reset();
    const bool by_tone = settings.dot_size.sizing == DotSizing::by_tone;
    for (const char* name : {"--dots", "--scale"})
        refuse_if(by_tone, name,
                  "cannot be given together with two radii, as the number of dots follows from their sizes");
    refuse_if(settings.tone.black && by_tone, "--black",
              "has no effect with two radii: such dots grow until black is solid; leave it out");
    refuse_if(settings.tone.black && settings.style != DrawingStyle::dots, "--black",
              "has no effect on lines; leave it out");
    const bool figure8 = settings.placer == PlacerKind::figure8;
    refuse_if(figure8 && settings.relax.value_or(0) > 0, "--relax",
              "does not apply to the figure8 placer, whose dots stay as placed; leave it out");
    refuse_if(given("--scale"), "--dots", "cannot be given together with --scale");
    // Both make a page of that size.
    PageSetup& page = settings.page;
    if (given("--width") && given("--height")) {
        page.paper = Paper::custom;
    } else if ((given("--width") || given("--height")) && !given("--page")) {
        // If one is given, the other follows from it, whatever a project says.
        page.paper = Paper::as_picture;
        if (given("--width")) page.height_mm.reset();
    }
    if (given("--page")) {
        refuse(command, {"--width", "--height"}, "cannot be given together with --page, which sets it");
    } else if (page.paper == Paper::as_picture && command.get_option_no_throw("--fit")) {
        refuse(command, {"--orientation", "--fit"},
               "has no effect where the page has the picture's shape; give --page, or --width and --height, "
               "too");
    }
    if (settings.tone.black_point >= settings.tone.white_point)
        throw CLI::ValidationError("--black-point", "must be below --white-point");
    refuse_if(figure8, "--ranking",
              "does not apply to the figure8 placer, which has its own order; leave it out");
}

}  // namespace dapple
