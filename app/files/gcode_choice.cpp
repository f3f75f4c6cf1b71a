#include "app/files/gcode_choice.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "app/files/text_file.h"
#include "app/shown_text.h"

namespace dapple {

OwnTemplate read_gcode_template(const std::filesystem::path& file) {
    constexpr TextKind kTemplate{"template", 64'000};  // far more than a machine needs
    const std::string name = printable(file.native());
    OwnTemplate own{.text = text_of_file(file, kTemplate), .file = name};
    try {
        static_cast<void>(parse_gcode_template(own.text));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", name, error.what()));
    }
    // Projects are UTF-8.
    if (!is_utf8(own.text)) throw std::runtime_error(fmt::format("{}: is not UTF-8; save it as that", name));
    return own;
}

GcodeStyle gcode_style_of(const SavingChoice& saving) {
    const std::string_view text =
        saving.gcode_template.text.empty() ? gcode_template_of(saving.tool) : saving.gcode_template.text;
    return {.lines = parse_gcode_template(text),
            .feed_mm_per_min = saving.feed_mm_per_min,
            .dwell_s = saving.dwell_s};
}

}  // namespace dapple
