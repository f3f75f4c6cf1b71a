#include "io/settings/project.h"

#include "io/files/atomic_file.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr TextKind kProject{"project", 1'000'000};

}  // namespace

std::string text_of_settings(const fs::path& file) {
    return text_of_file(file, kProject);
}

bool ends_as_project(const fs::path& file) {
    return ending_of(file) == kProjectEnding;
}

Project read_project(const fs::path& file, const Describe& describe) {
    Project project;
    project.kept = text_of_settings(file);
    read_settings(project.kept, {file}, [&](Fields& fields) {
        try {
            fields.file("picture", project.picture);
        } catch (const MissingFile& missing) {
            project.why_missing = missing.what();
        }
        describe(fields);
    });
    return project;
}

void save_project(const fs::path& file, Project project, const Describe& describe) {
    const std::string text = settings_text(project.kept, {file}, [&](Fields& fields) {
        if (project.why_missing.empty()) fields.file("picture", project.picture);
        describe(fields);
    });
    save_atomically(file, [&](std::ostream& out) { out << text; });
}

}  // namespace dapple
