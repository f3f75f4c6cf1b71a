#include "io/command_line/wrapped_help.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace dapple {
namespace {

constexpr std::size_t kNarrowest = 60;

// Where a line's second column begins; npos: it has none.
std::size_t second_column(std::string_view line) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == line.npos) return line.npos;
    const std::size_t gap = line.find("  ", first);
    // A name that is too long to have the second column beside it stands in the line before.
    if (gap == line.npos) return first >= 10 ? first : line.npos;
    return line.find_first_not_of(' ', gap);
}

void add_wrapped(std::string& result, std::string_view line, std::size_t width) {
    const std::size_t column = second_column(line);
    const bool as_it_is = line.starts_with(' ') && column == line.npos;
    const std::size_t indent = column == line.npos || column > width / 2 ? 0 : column;
    std::size_t before = 0;  // columns that are taken already, and where no line may end
    for (std::size_t kept = indent; !as_it_is && before + line.size() > width; kept = 0, before = indent) {
        std::size_t end = line.rfind(' ', width - before);
        if (end == line.npos || end < std::max(kept, std::size_t{1})) end = line.find(' ', width - before);
        if (end == line.npos) break;
        result += line.substr(0, end);
        result += '\n';
        result.append(indent, ' ');
        line.remove_prefix(std::min(line.find_first_not_of(' ', end), line.size()));
    }
    result += line;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
    std::string result;
    for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
        end = text.find('\n');
        add_wrapped(result, text.substr(0, end), width);
        if (end == text.npos) break;
        result += '\n';
        ++end;
    }
    return result;
}

std::size_t terminal_columns() {
    winsize size{};
    return ::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string WrappedHelp::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
    const std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
    const std::size_t columns = terminal_columns();
    return columns == 0 ? help : wrapped(help, std::max(columns, kNarrowest));
}

}  // namespace dapple
