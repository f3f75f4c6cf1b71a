#include "app/files/standard_input.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/decoding/decoded_image.h"
#include "app/decoding/kept_input.h"
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

void copy_standard_input(int descriptor) {
    if (::isatty(STDIN_FILENO)) fail_input("is a terminal; send a picture to it, as in < cat.jpg");
    try {
        keep_input(STDIN_FILENO, descriptor);
    } catch (const DecodeError& error) {
        fail_input(error.what());
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
    const fs::path folder = temporary_folder();
    const std::optional<PartFile> copy = part_in(folder);
    copy_standard_input(copy->descriptor());
    try {
        return read_picture(copy->path(), limit);
    } catch (const std::runtime_error& failure) {
        // Nobody knows the temporary file's name.
        const std::string what = failure.what(), name = printable(copy->path()) + ": ";
        fail_input(what.starts_with(name) ? what.substr(name.size()) : what);
    }
}

}  // namespace dapple
