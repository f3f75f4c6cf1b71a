#include "app/settings/project.h"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "app/files/atomic_file.h"
#include "app/files/file_ending.h"
#include "app/files/text_file.h"
#include "app/shown_text.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestBytes = 1'000'000;

}  // namespace

std::string text_of_settings(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    const bool regular = fs::is_regular_file(status);
    if (fs::exists(status) && !fs::is_directory(status) && !regular)
        throw std::runtime_error(fmt::format("{}: not a regular file", printable(file.native())));
    if (regular && fs::file_size(file, error) > kLargestBytes)
        throw std::runtime_error(
            fmt::format("{}: larger than 1 MB, as no project is", printable(file.native())));
    return text_of_file(file);
}

bool ends_as_project(const fs::path& file) {
    return ending_of(file) == kProjectEnding;
}

Project read_project(const fs::path& file, const Describe& describe) {
    Project project;
    project.kept = text_of_settings(file);
    read_settings(project.kept, {file}, [&](Fields& fields) {
        fields.file("picture", project.picture);
        describe(fields);
    });
    return project;
}

void save_project(const fs::path& file, Project project, const Describe& describe) {
    const std::string text = settings_text(project.kept, {file}, [&](Fields& fields) {
        fields.file("picture", project.picture);
        describe(fields);
    });
    save_atomically(file, [&](std::ostream& out) { out << text; });
}

}  // namespace dapple
