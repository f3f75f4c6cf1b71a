#include "io/command_line/remarks.h"

#include <fmt/format.h>

#include <cstdio>

#include "core/text/shown_text.h"

namespace dapple {

void print_remark(const std::filesystem::path& file, const std::string& remark) {
    if (!remark.empty()) fmt::print(stderr, "dapple: {}: {}\n", printable(file.string()), remark);
}

Picture read_with_remark(const std::filesystem::path& file, PictureLimit limit, PictureColours colours) {
    Picture picture = read_picture(file, limit, colours);
    print_remark(file, picture.remark);
    return picture;
}

}  // namespace dapple
