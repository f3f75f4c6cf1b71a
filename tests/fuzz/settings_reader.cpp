#include "tests/fuzz/settings_reader.h"

#include <cstdlib>
#include <stdexcept>

#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"

namespace dapple {
namespace {

struct AllSettings {
    DrawingSettings drawing = {};
    SavingChoice saving = {};
    bool operator==(const AllSettings&) const = default;
};

Describe all_fields(AllSettings& settings) {
    return [&settings](Fields& fields) { describe_drawing(fields, settings.drawing, settings.saving); };
}

}  // namespace

void read_any_settings(const std::string& text) {
    const SettingsPlace place{"fuzzed.dapple"};
    AllSettings settings, again;
    try {
        read_settings(text, place, all_fields(settings));
    } catch (const std::runtime_error&) {
        return;
    }
    read_settings(settings_text(text, place, all_fields(settings)), place, all_fields(again));
    if (again != settings) std::abort();
}

}  // namespace dapple
