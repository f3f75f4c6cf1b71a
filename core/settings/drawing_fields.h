#pragma once
// What a drawing's settings are called in files. A new field of one of these structs doesn't compile until it
// is named here.

#include "core/drawing/settings.h"
#include "core/settings/fields.h"

namespace dapple {

void describe(Fields& fields, DrawingSettings& drawing);
void describe(Fields& fields, SavingChoice& saving);

/// Both, as "drawing" and "saving".
void describe_drawing(Fields& fields, DrawingSettings& drawing, SavingChoice& saving);

/// What of both differs from what is usual: see changed_settings().
std::string changed_drawing_settings(const SettingsPlace& place, DrawingSettings drawing,
                                     SavingChoice saving);

}  // namespace dapple
