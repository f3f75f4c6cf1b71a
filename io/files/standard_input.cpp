#include "io/files/standard_input.h"

#include <unistd.h>

#include <stdexcept>
#include <string>

namespace dapple {
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

}  // namespace dapple
