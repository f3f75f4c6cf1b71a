#include "io/settings/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "core/failure.h"
#include "core/output/drawing_format.h"
#include "core/settings/drawing_fields.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"

namespace dapple {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 60;

bool names_a_file(const std::string& name) {
    const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
    return !name.empty() && name.size() <= kLongestName && name.front() != '.' &&
           name.find('/') == name.npos && std::ranges::none_of(name, is_control) && printable(name) == name;
}

}  // namespace

std::vector<std::string> NamedFiles::names() const {
    std::vector<std::string> found;
    std::error_code error;
    if (folder.empty()) return found;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().stem().string();
        const bool is_one = entry->path().extension() == ending && names_a_file(name);
        if (is_one && std::ranges::count(built_in, name) == 0) found.push_back(name);
    }
    std::ranges::sort(found);
    return found;
}

fs::path NamedFiles::path_of(const std::string& name) const {
    return folder / (name + ending);
}

fs::path NamedFiles::find(const std::string& name) const {
    std::error_code ignored;
    const bool there = !folder.empty() && names_a_file(name) && fs::exists(path_of(name), ignored);
    return there ? path_of(name) : fs::path();
}

void NamedFiles::save(const std::string& name, const std::string& text) const {
    if (!names_a_file(name))
        throw failure(
            "\"{}\" cannot be a {}'s name; give 1 to {} letters without /, not beginning with a point",
            printable(name), what, kLongestName);
    if (std::ranges::count(built_in, name) > 0)
        throw failure("the {} {} is built in and cannot be changed; give another name", what, name);
    if (folder.empty()) throw failure("there is no home folder for {}s; set HOME to one", what);
    make_folder(folder);
    save_atomically(path_of(name), [&](std::ostream& out) { out << text; });
}

void NamedFiles::remove(const std::string& name) const {
    std::error_code error;
    const bool could = !folder.empty() && names_a_file(name);
    if (!could || !fs::remove(path_of(name), error))
        throw failure("the {} {} cannot be removed, {}", what, printable(name),
                      error ? error.message() : "as there is none of that name");
}

namespace {

// Ours come first in both kinds of files, and are short.
constexpr TextKind kDrawing{.what = "drawing", .most_bytes = 1'000'000, .beginning = true};

// Programs that save an SVG again may write a quote so.
std::string without_entities(std::string_view text) {
    constexpr std::string_view kQuote = "&quot;";
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const bool quote = text.substr(at).starts_with(kQuote);
        plain += quote ? '"' : text[at];
        at += quote ? kQuote.size() : 1;
    }
    return plain;
}

std::optional<std::string> settings_in_svg(std::string_view bytes) {
    const std::size_t element = bytes.find(fmt::format("<{}", kSvgSettingsElement));
    if (element == bytes.npos) return std::nullopt;
    const std::size_t from = bytes.find('>', element), to = bytes.find("</", element);
    if (from == bytes.npos || to == bytes.npos || to < from) return std::nullopt;
    return without_entities(bytes.substr(from + 1, to - from - 1));
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

// Chunks are a length, a name of four letters, so many bytes and a checksum of four.
std::optional<std::string> settings_in_png(std::string_view bytes) {
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    const std::string begin = std::string(kPngSettingsKeyword) + '\0';
    if (!bytes.starts_with(kSignature)) return std::nullopt;
    bytes.remove_prefix(kSignature.size());
    while (bytes.size() >= 12) {
        const std::size_t size = big_endian(bytes);
        const std::string_view name = bytes.substr(4, 4);
        if (name == "IDAT" || size > bytes.size() - 12) return std::nullopt;
        const std::string_view content = bytes.substr(8, size);
        if (name == "tEXt" && content.starts_with(begin)) return std::string(content.substr(begin.size()));
        bytes.remove_prefix(size + 12);
    }
    return std::nullopt;
}

bool is_drawing(const fs::path& file) {
    const std::string ending = ending_of(file);
    return ending == ".svg" || ending == ".png";
}

std::optional<std::string> settings_in_drawing(const fs::path& file) {
    const std::string bytes = text_of_file(file, kDrawing);
    return ending_of(file) == ".svg" ? settings_in_svg(bytes) : settings_in_png(bytes);
}

}  // namespace

std::string embedded_settings(const fs::path& drawing_file, const DrawingSettings& drawing,
                              const SavingChoice& saving) {
    try {
        return changed_drawing_settings({drawing_file, FileNames::relative}, drawing, saving);
    } catch (const std::runtime_error&) {
        return {};
    }
}

std::optional<std::string> settings_inside(const fs::path& file) {
    try {
        return is_drawing(file) ? settings_in_drawing(file) : std::nullopt;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

SavedSettings settings_from(const fs::path& file) {
    SavedSettings settings;
    const Describe describe_it = [&](Fields& fields) {
        describe_drawing(fields, settings.drawing, settings.saving);
    };
    if (!is_drawing(file)) {
        read_settings(text_of_settings(file), {file}, describe_it);
        return settings;
    }
    const std::optional<std::string> inside = settings_in_drawing(file);
    if (!inside)
        throw std::runtime_error(printable(file.native()) +
                                 ": has no Dapple settings; choose a project or a drawing made with Dapple");
    read_settings(*inside, {file}, describe_it);
    return settings;
}

namespace {

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
