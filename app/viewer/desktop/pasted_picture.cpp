#include "app/viewer/desktop/pasted_picture.h"

#include <fmt/format.h>

#include <unistd.h>
#include <array>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/viewer/desktop/desktop_programs.h"
#include "io/files/atomic_file.h"
#include "io/settings/xdg_folders.h"

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

// The path that a line names: a URI, one that begins with ~/, any other as it is. Empty: of another computer.
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

}  // namespace

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

namespace {

using Words = std::vector<std::string>;

struct ClipboardProgram {
    Words list, get;  // the kinds that are offered; one of them, whose name comes last
};

struct PictureKind {
    const char *kind, *ending;
};
constexpr std::array<PictureKind, 6> kPictureKinds{{{"image/png", ".png"},
                                                    {"image/jpeg", ".jpg"},
                                                    {"image/webp", ".webp"},
                                                    {"image/tiff", ".tif"},
                                                    {"image/bmp", ".bmp"},
                                                    {"image/gif", ".gif"}}};

ClipboardProgram clipboard_program() {
    if (std::getenv("WAYLAND_DISPLAY") && is_in_path("wl-paste"))
        return {{"wl-paste", "--list-types"}, {"wl-paste", "--type"}};
    if (is_in_path("xclip"))
        return {{"xclip", "-selection", "clipboard", "-o", "-t", "TARGETS"},
                {"xclip", "-selection", "clipboard", "-o", "-t"}};
    throw std::runtime_error(
        "Pasting a picture needs xclip, or wl-paste on Wayland: install it, or save the picture and open its "
        "file");
}

const PictureKind* first_picture_in(const std::string& kinds) {
    for (const PictureKind& each : kPictureKinds) {
        std::istringstream lines(kinds);
        for (std::string line; std::getline(lines, line);)
            if (line == each.kind) return &each;
    }
    return nullptr;
}

// "pasted 2026-11-23 120501.png", with a number where that is there already.
fs::path new_file(const fs::path& folder, const char* ending) {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&now, &local);
    std::array<char, 32> moment{};
    std::strftime(moment.data(), moment.size(), "%Y-%m-%d %H%M%S", &local);
    fs::path file = folder / fmt::format("pasted {}{}", moment.data(), ending);
    for (int number = 2; fs::exists(file); ++number)
        file = folder / fmt::format("pasted {} {}{}", moment.data(), number, ending);
    return file;
}

}  // namespace

fs::path file_to_copy() {
    const fs::path state = state_folder();
    return state.empty() ? state : state / fmt::format("picture to copy {}.png", ::getpid());
}

bool copy_picture(const fs::path& png, const std::stop_token& stop) {
    constexpr ChildLimits kLimits{.longest = std::chrono::seconds(30)};
    std::string program;
    if (std::getenv("WAYLAND_DISPLAY") && is_in_path("wl-copy"))
        program = R"(wl-copy --type image/png <"$0")";
    else if (is_in_path("xclip"))
        program = R"(xclip -selection clipboard -t image/png "$0")";
    else
        throw std::runtime_error(
            "Copying a picture needs xclip, or wl-copy on Wayland: install it, or export the drawing as a "
            "PNG");
    // Both go on to hand the picture out, and would keep our pipe open.
    const auto done =
        output_of({"/bin/sh", "-c", "exec " + program + " >/dev/null", png.string()}, kLimits, stop);
    if (done && done->status != 0)
        throw std::runtime_error("The picture could not be copied: no clipboard accepts it");
    return done.has_value();
}

fs::path pasted_folder() {
    const fs::path data = data_folder();
    return data.empty() ? data : data / "pasted";
}

std::optional<fs::path> save_pasted_picture(const fs::path& folder, const std::stop_token& stop) {
    constexpr ChildLimits kKinds{.longest = std::chrono::seconds(5)},
        kPicture{.most_bytes = std::size_t{512} << 20, .longest = std::chrono::seconds(30)};
    const ClipboardProgram program = clipboard_program();
    const auto kinds = output_of(program.list, kKinds, stop);
    if (!kinds) return std::nullopt;
    const PictureKind* const kind = kinds->status == 0 ? first_picture_in(kinds->bytes) : nullptr;
    if (!kind)
        throw std::runtime_error("The clipboard has neither a picture nor a file's path; copy one of them");
    Words get = program.get;
    get.emplace_back(kind->kind);
    const auto picture = output_of(get, kPicture, stop);
    if (!picture) return std::nullopt;
    if (picture->status != 0 || picture->bytes.empty())
        throw std::runtime_error("The picture on the clipboard could not be read from " + get[0] +
                                 "; copy it again, or save it to a file and open that");
    make_folder(folder);
    fs::path file = new_file(folder, kind->ending);
    save_atomically(file, [&](std::ostream& out) { out << picture->bytes; });
    return file;
}

}  // namespace dapple
