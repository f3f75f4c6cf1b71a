#pragma once
// Options that commands share, and the one way in which numbers and names are read from the command line.
//
// A value that cannot be is refused while parsing, with a sentence that begins with the option's name.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "core/drawing/settings.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"
#include "core/settings/setting.h"
#include "core/text/names.h"

namespace dapple {

/// What help says of a setting's option, and calls its value.
std::string help_of(const Setting& setting);
std::string unit_of(const Setting& setting);

/// What is wrong with an option's value: `read` throws std::runtime_error, and it is refused.
void told_as(const std::string& option, const std::function<void()>& read);

/// A value that `read` understands, or else throws std::runtime_error saying what is wrong with it. `unit` is
/// what help shows: "PAPER".
using Read = std::function<void(const std::string& text)>;
CLI::Option* add_text(CLI::App& app, const std::string& name, const std::string& unit, const Read& read,
                      const std::string& help);

/// A finite number within a range; of a std::optional none without the option. `unit` is what help shows:
/// "STOPS".
double number_in(const std::string& text, const NumberRange& range);
template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& target, const NumberRange& range,
                        const std::string& unit, const std::string& help) {
    const auto read = [=, &target](const std::string& text) {
        target = static_cast<Number>(number_in(text, range));
    };
    CLI::Option* const option = add_text(app, name, unit, read, help);
    if constexpr (std::is_floating_point_v<Number>) option->default_str(fmt::format("{:g}", target));
    return option;
}

/// A length, in millimetres unless it names another unit; the range is in millimetres.
CLI::Option* add_length(CLI::App& app, const std::string& name, double& target, const NumberRange& range,
                        const std::string& help);

/// The same for a setting that has an option; its help is that of the row, and what else the command has to
/// say.
template <class Number>
CLI::Option* add_number(CLI::App& app, const Setting& setting, Number& target) {
    return add_number(app, setting.names.option, target, setting.range, unit_of(setting), help_of(setting));
}
CLI::Option* add_length(CLI::App& app, const Setting& setting, double& target);
CLI::Option* add_flag(CLI::App& app, const Setting& setting, bool& target);

/// A whole number.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name, int& target, const NumberRange& range,
                              const std::string& help);

/// A whole number of things from 1 to `most`, as people write it: 10000, 10,000, 10k, 1.5M, 1e5. Throws
/// std::runtime_error if it is none.
std::uint64_t count_in(const std::string& text, std::uint64_t most);
template <class Count>
CLI::Option* add_count(CLI::App& app, const std::string& name, Count& target, std::uint64_t most,
                       const std::string& help) {
    return add_text(
        app, name, "N", [&target, most](const std::string& text) { target = count_in(text, most); }, help);
}

/// --memory: bytes that the command may take, whatever is available.
CLI::Option* add_memory(CLI::App& app, std::optional<double>& bytes);

/// --pens: a set of pens, own ones, or a file that lists such.
CLI::Option* add_pens(CLI::App& app, PenChoice& pens, const std::string& help);

/// --page: a paper's name or a size.
CLI::Option* add_paper(CLI::App& app, PageSetup& page, const std::string& help);

/// --seed, any number of 64 bits.
CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help);

/// One of several words; `read` gets its index.
CLI::Option* add_words(CLI::App& app, const std::string& name, std::span<const char* const> words,
                       const std::function<void(std::size_t)>& read, const std::string& help);

/// One of an enumeration's values, by its name.
template <Named Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& target, const std::string& help) {
    const auto read = [&target](std::size_t index) { target = static_cast<Value>(index); };
    return add_words(app, name, names_of(target), read, help)->default_str(std::string(name_of(target)));
}
/// Empty without the option.
template <Named Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::optional<Value>& target,
                        const std::string& help) {
    const auto read = [&target](std::size_t index) { target = static_cast<Value>(index); };
    return add_words(app, name, names_of(Value()), read, help);
}

template <class Choice>
CLI::Option* add_choice(CLI::App& app, const Setting& setting, Choice& target) {
    return add_choice(app, setting.names.option, target, help_of(setting));
}

/// --style, --dot-shape, --pen-width.
void add_style_options(CLI::App& app, DrawingSettings& settings);

/// --ranking, none without it.
CLI::Option* add_ranking(CLI::App& app, std::optional<RankingMethod>& ranking);

/// --tile, a name for tile_named().
CLI::Option* add_tile(CLI::App& app, std::string& tile);

/// Throws CLI::ValidationError, "--option why", for the first of these options that was given: one without
/// effect is refused, rather than left to be wondered about.
void refuse(const CLI::App& command, std::initializer_list<const char*> options, const std::string& why);

/// --dots, --scale, --placer, --tile, --ranking, --relax, --dot-radius, --threads.
void add_dot_options(CLI::App& app, DrawingSettings& settings);

/// --exposure, --tone, --black-point, --white-point, --contrast, --brightness, --gamma, --blur, --detail,
/// --invert.
void add_tone_options(CLI::App& app, DrawingSettings& settings);

/// --page, --orientation, --width, --height, --margin, --fit, --crop, --rotate, --ink, --paper.
void add_page_options(CLI::App& app, DrawingSettings& settings);

/// --order, --sheet, --region.
void add_arrangement_options(CLI::App& app, std::optional<DotOrder>& order, Sheet& sheet,
                             std::optional<Rectangle<double>>& region);

/// What no single option can see: a tone that is set is not automatic. Throws CLI::ValidationError if options
/// of the command contradict each other. To be called after parsing; `was_automatic` says whether the tone
/// was before.
void check_options(const CLI::App& command, DrawingSettings& settings, bool was_automatic = true);

}  // namespace dapple
