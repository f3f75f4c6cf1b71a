#pragma once
// Options that commands share, and the one way in which numbers and names are read from the command line.
//
// A value that cannot be is refused while parsing, with a sentence that begins with the option's name.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "app/drawing_settings.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"

namespace dapple {

struct NumberRange {
    double least = 0;
    double most = std::numeric_limits<double>::max();
    enum class Least { included, excluded } at_least = Least::included;
};

/// A finite number within a range. `unit` is what help shows: "STOPS".
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const NumberRange& range,
                        const std::string& unit, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, float& target, const NumberRange& range,
                        const std::string& unit, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const NumberRange& range, const std::string& unit, const std::string& help);

/// A length, in millimetres unless it names another unit; the range is in millimetres.
CLI::Option* add_length(CLI::App& app, const std::string& name, double& target, const NumberRange& range,
                        const std::string& help);

/// A whole number.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name, int& target, const NumberRange& range,
                              const std::string& help);

/// A whole number of things from 1 to `most`, as people write it: 10000, 10,000, 10k, 1.5M, 1e5. Throws
/// CLI::ValidationError beginning with the option's name.
std::uint64_t count_in(const std::string& name, const std::string& text, std::uint64_t most);

/// --pens: a set of pens, own ones, or a file that lists such.
CLI::Option* add_pens(CLI::App& app, PenChoice& pens, const std::string& help);

/// --page: a paper's name or a size.
CLI::Option* add_paper(CLI::App& app, PageSetup& page, const std::string& help);

/// --seed, any number of 64 bits.
CLI::Option* add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help);

/// One of several values, by the name that name_of() gives them. The target is a Value, or a
/// std::optional<Value> that stays empty without the option.
template <class Target, class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target,
                        std::initializer_list<Value> values, const std::string& help) {
    const auto names = [](const std::vector<Value>& all, const char* separator) {
        std::string text;
        for (const Value value : all) text += (text.empty() ? "" : separator) + std::string(name_of(value));
        return text;
    };
    const auto read = [=, &target, all = std::vector<Value>(values)](const std::string& text) {
        const auto found = std::ranges::find_if(all, [&](Value value) { return name_of(value) == text; });
        if (found == all.end())
            throw CLI::ValidationError(name, text + " is not known; there are " + names(all, ", "));
        target = *found;
    };
    CLI::Option* const option =
        app.add_option_function<std::string>(name, read, help)->type_name(names(values, "|"));
    if constexpr (std::is_same_v<Target, Value>) option->default_str(std::string(name_of(target)));
    return option;
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
