#pragma once
// Options that commands share, and the one way in which numbers and names are read from the command line.
//
// A value that cannot be is refused while parsing, with a sentence that begins with the option's name.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing_settings.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"

namespace dapple {

/// Of a page, 100 m: longer ones are slips of the keyboard, or of a picture one pixel wide.
inline constexpr double kLongestSideMm = 100'000;
/// Of a page, a region, or what a margin leaves: finer than any pen.
inline constexpr double kShortestSideMm = 0.01;

struct NumberRange {
    double least = 0;
    double most = std::numeric_limits<double>::max();
    enum class Least { included, excluded } at_least = Least::included;
};

/// A finite number within a range. `unit` is what help shows: "MM".
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, const NumberRange& range,
                        const std::string& unit, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, float& target, const NumberRange& range,
                        const std::string& unit, const std::string& help);
CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& target,
                        const NumberRange& range, const std::string& unit, const std::string& help);

/// A whole number.
CLI::Option* add_whole_number(CLI::App& app, const std::string& name, int& target, const NumberRange& range,
                              const std::string& help);

/// A whole number of things from 1 to `most`, as people write it: 10000, 10,000, 10k, 1.5M, 1e5. Throws
/// CLI::ValidationError beginning with the option's name.
std::uint64_t count_in(const std::string& name, const std::string& text, std::uint64_t most);

/// One of several values, by the name that name_of() gives them.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& target, std::vector<Value> values,
                        const std::string& help) {
    const auto read = [name, &target, values](const std::string& text) {
        std::string names;
        for (const Value value : values) {
            if (name_of(value) == text) {
                target = value;
                return;
            }
            names += (names.empty() ? "" : ", ") + std::string(name_of(value));
        }
        throw CLI::ValidationError(name, text + " is not known; there are " + names);
    };
    std::string type;
    for (const Value value : values) type += (type.empty() ? "" : "|") + std::string(name_of(value));
    return app.add_option_function<std::string>(name, read, help)
        ->type_name(type)
        ->default_str(std::string(name_of(target)));
}

/// --ranking, none without it.
CLI::Option* add_ranking(CLI::App& app, std::optional<RankingOrder>& ranking);

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

/// --width, --ink, --paper.
void add_page_options(CLI::App& app, DrawingSettings& settings);

/// --order, --sheet, --region.
void add_arrangement_options(CLI::App& app, std::optional<DotOrder>& order, Sheet& sheet,
                             std::optional<Region>& region);

/// What no single option can see: a tone that is set is not automatic. Throws CLI::ValidationError if options
/// of the command contradict each other. To be called after parsing.
void check_options(const CLI::App& command, DrawingSettings& settings);

}  // namespace dapple
