#include "io/settings/named_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"

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
        throw std::runtime_error(fmt::format(
            "\"{}\" is no name for a {}; give one of 1 to {} letters that has no / and does not begin with a "
            "point",
            printable(name), what, kLongestName));
    if (std::ranges::count(built_in, name) > 0)
        throw std::runtime_error(
            fmt::format("the {} {} comes with the program and stays; give another name", what, name));
    if (folder.empty())
        throw std::runtime_error(
            fmt::format("there is no home folder to keep {}s in; set HOME to one", what));
    make_folder(folder);
    save_atomically(path_of(name), [&](std::ostream& out) { out << text; });
}

void NamedFiles::remove(const std::string& name) const {
    std::error_code error;
    const bool could = !folder.empty() && names_a_file(name);
    if (!could || !fs::remove(path_of(name), error))
        throw std::runtime_error(fmt::format("the {} {} cannot be removed, {}", what, printable(name),
                                             error ? error.message() : "there is none of that name"));
}

}  // namespace dapple
