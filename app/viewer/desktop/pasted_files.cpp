#include "app/viewer/desktop/pasted_files.h"

#include <charconv>
#include <sstream>
#include <string>
#include <system_error>

namespace dapple {
namespace {

namespace fs = std::filesystem;

std::string without_percents(std::string_view uri) {
    std::string plain;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        unsigned char byte = 0;
        const std::string_view digits = uri.substr(at + 1, 2);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        const bool coded = uri[at] == '%' && digits.size() == 2 && read.ec == std::errc() &&
                           read.ptr == digits.data() + digits.size();
        plain += coded ? static_cast<char>(byte) : uri[at];
        if (coded) at += 2;
    }
    return plain;
}

std::string_view trimmed_line(std::string_view line) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t from = line.find_first_not_of(kBlank), to = line.find_last_not_of(kBlank);
    return from == line.npos ? std::string_view() : line.substr(from, to - from + 1);
}

}  // namespace

fs::path path_named_by(std::string_view line, const fs::path& home) {
    const bool quoted =
        line.size() > 2 && line.front() == line.back() && (line.front() == '"' || line.front() == '\'');
    if (quoted) line = line.substr(1, line.size() - 2);
    if (line.starts_with("~/")) return home / line.substr(2);
    if (!line.starts_with("file:")) return line;
    line.remove_prefix(5);
    if (line.starts_with("//")) {  // an authority: none, or this computer
        const std::size_t path = line.find('/', 2);
        const std::string_view host = line.substr(2, path == line.npos ? line.npos : path - 2);
        if (path == line.npos || (!host.empty() && host != "localhost")) return {};
        line.remove_prefix(path);
    }
    return without_percents(line);
}

std::vector<fs::path> pasted_files(std::string_view text, const fs::path& home) {
    constexpr std::size_t kMostLetters = 100'000;
    std::vector<fs::path> files;
    std::istringstream lines{std::string(text.substr(0, kMostLetters))};
    for (std::string line; std::getline(lines, line);) {
        const std::string_view whole = trimmed_line(line);
        if (whole.empty() || whole.find('\0') != whole.npos) continue;
        const fs::path path = path_named_by(whole, home);
        std::error_code ignored;
        if (path.is_absolute() && fs::is_regular_file(path, ignored)) files.push_back(path);
    }
    return files;
}

}  // namespace dapple
