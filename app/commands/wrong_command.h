#pragma once
// What was mistyped: a command, told from the name of a picture, or an option.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

namespace dapple {

/// What is wrong with a first word that was meant as a command: "rendr" for "render". Nothing if it is one,
/// or may be a picture.
std::optional<std::string> wrong_command(const CLI::App& app, std::span<char* const> words);

/// The same of the first option that there is not: "--dotz" for "--dots".
std::optional<std::string> wrong_option(const CLI::App& app, std::span<char* const> words);

}  // namespace dapple
