#include "app/files/standard_input.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "app/files/part_file.h"
#include "app/shown_text.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_input(const std::string& why) {
    throw std::runtime_error("the standard input: " + why);
}

std::string words_of(int error) {
    return std::generic_category().message(error);
}

void write_whole(int descriptor, const char* bytes, std::size_t size, const fs::path& folder) {
    while (size > 0) {
        const ssize_t written = ::write(descriptor, bytes, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0)
            fail_input(fmt::format("cannot be kept in {}: {}", folder.string(), words_of(errno)));
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
}

void copy_standard_input(int descriptor, const fs::path& folder) {
    if (::isatty(STDIN_FILENO)) fail_input("is a terminal; send a picture to it, as in < cat.jpg");
    std::vector<char> buffer(std::size_t{1} << 18);
    for (;;) {
        const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail_input(fmt::format("cannot be read: {}", words_of(errno)));
        if (count == 0) return;
        write_whole(descriptor, buffer.data(), static_cast<std::size_t>(count), folder);
    }
}

std::optional<PartFile> part_in(const fs::path& folder) {
    try {
        return std::optional<PartFile>(std::in_place, folder / "picture");
    } catch (const std::system_error& error) {
        fail_input(fmt::format("cannot be kept in {}: {}", folder.string(), words_of(error.code().value())));
    }
}

}  // namespace

Picture read_picture_from_standard_input(PictureLimit limit) {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error) folder = "/tmp";
    const std::optional<PartFile> copy = part_in(folder);
    copy_standard_input(copy->descriptor(), folder);
    try {
        return read_picture(copy->path(), limit);
    } catch (const std::runtime_error& failure) {
        // Nobody knows the temporary file's name.
        const std::string what = failure.what(), name = printable(copy->path()) + ": ";
        fail_input(what.starts_with(name) ? what.substr(name.size()) : what);
    }
}

}  // namespace dapple
