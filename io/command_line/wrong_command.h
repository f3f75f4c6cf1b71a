#pragma once
// What was mistyped: a command, as opposed to the name of a picture, or an option.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

namespace dapple {

/// What is wrong with a first word that was meant as a command: "rendr" for "render". Nothing if it is one,
/// or may be a picture.
std::optional<std::string> wrong_command(const CLI::App& app, std::span<char* const> words);

/// The same for the first option that does not exist: "--dotz" for "--dots".
std::optional<std::string> wrong_option(const CLI::App& app, std::span<char* const> words);

}  // namespace dapple
