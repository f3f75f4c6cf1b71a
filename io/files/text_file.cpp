#include "io/files/text_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include "core/failure.h"
#include "core/output/gcode.h"
#include "core/text/shown_text.h"
#include "io/descriptor.h"

namespace dapple {

OwnTemplate read_gcode_template(const std::filesystem::path& file) {
    constexpr TextKind kTemplate{"template", 64'000};  // far more than a machine needs
    const std::string name = printable(file.native());
    OwnTemplate own{.text = text_of_file(file, kTemplate), .file = name};
    try {
        static_cast<void>(parse_gcode_template(own.text));
    } catch (const std::runtime_error& error) {
        throw failure("{}: {}", name, error.what());
    }
    // Projects are UTF-8.
    if (!is_utf8(own.text)) throw failure("{}: is not text in UTF-8; save it as UTF-8", name);
    return own;
}

namespace {

[[noreturn]] void fail_input(const std::string& why) {
    throw std::runtime_error("the standard input: " + why);
}

}  // namespace

Picture read_picture_from_standard_input(PictureLimit limit, PictureColours colours) {
    if (::isatty(STDIN_FILENO)) fail_input("is a terminal; send a picture to it, as in < cat.jpg");
    const std::string file = "/dev/stdin";
    try {
        return read_picture(file, limit, colours);
    } catch (const std::runtime_error& failure) {
        const std::string what = failure.what();
        fail_input(what.starts_with(file + ": ") ? what.substr(file.size() + 2) : what);
    }
}

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string ending_of(const std::filesystem::path& file) {
    return lower_case(file.extension().string());
}

namespace {

std::string in_large_units(std::uintmax_t bytes) {
    if (bytes >= 1'000'000'000) return fmt::format("{} GB", bytes / 1'000'000'000);
    return bytes >= 1'000'000 ? fmt::format("{} MB", bytes / 1'000'000) : fmt::format("{} kB", bytes / 1000);
}

}  // namespace

std::string text_of_file(const std::filesystem::path& file, const TextKind& kind) {
    const auto fail = [&](const std::string& what) {
        throw failure("{}: {}", printable(file.native()), what);
    };
    const auto fail_to_read = [&] {
        fail(fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    };
    const auto fail_by_size = [&] {
        fail(fmt::format("larger than {}, as no {} is", in_large_units(kind.most_bytes), kind.what));
    };
    // Told by what was opened, as another may have its name a moment later.
    const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | (kind.may_wait ? 0 : O_NONBLOCK)));
    if (!in && (errno == ENOENT || errno == ENOTDIR)) fail("no such file");
    if (!in) fail_to_read();
    struct stat status {};
    if (::fstat(in.get(), &status) != 0) fail_to_read();
    if (S_ISDIR(status.st_mode)) fail("is a folder, not a file");
    if (!S_ISREG(status.st_mode) && !kind.may_wait)
        fail(fmt::format("is not a regular file, as a {} has to be", kind.what));
    if (!kind.beginning && S_ISREG(status.st_mode) &&
        static_cast<std::uintmax_t>(status.st_size) > kind.most_bytes)
        fail_by_size();

    std::string text;
    std::array<char, 1 << 16> part;
    while (true) {
        const ssize_t size = ::read(in.get(), part.data(), part.size());
        if (size == 0) break;
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) fail_to_read();
        text.append(part.data(), static_cast<std::size_t>(size));
        if (text.size() <= kind.most_bytes) continue;
        if (!kind.beginning) fail_by_size();
        text.resize(kind.most_bytes);
        break;
    }
    // Sentences about it would end there.
    if (!kind.beginning && !kind.binary && text.find('\0') != text.npos)
        fail("is not text in UTF-8, as it has bytes of value 0");
    return text;
}

}  // namespace dapple
