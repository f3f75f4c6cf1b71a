#include "io/files/gcode_template.h"

#include <stdexcept>
#include <string>

#include "core/failure.h"
#include "core/output/gcode.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"

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

}  // namespace dapple
