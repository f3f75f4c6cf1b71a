#pragma once
// A project as the command line draws it.

#include <filesystem>
#include <optional>

#include "core/drawing/settings.h"

namespace dapple {

struct ProjectInput {
    std::optional<std::filesystem::path> picture;  // none: the built-in sample
    DrawingSettings drawing;
    SavingChoice saving;
};

/// Throws std::runtime_error naming the file if it cannot be read, or shows a plain density, which the window
/// alone draws.
ProjectInput read_project_input(const std::filesystem::path& file);

}  // namespace dapple
