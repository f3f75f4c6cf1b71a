#include "app/files/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace dapple {

std::string text_of_file(const std::filesystem::path& file) {
    const auto fail = [&](const std::string& what) {
        throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) fail("no such file");
    if (std::filesystem::is_directory(status)) fail("is a folder, not a file");

    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!in) fail(fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    std::string text;
    char part[1 << 16];
    while (const std::size_t size = std::fread(part, 1, sizeof part, in.get())) text.append(part, size);
    if (std::ferror(in.get())) fail("cannot be read to its end");
    return text;
}

}  // namespace dapple
