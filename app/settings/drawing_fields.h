#pragma once
// What a drawing's settings are called in files. A new field of one of these structs doesn't compile until it
// is named here.

#include "app/settings/fields.h"
#include "core/drawing/settings.h"

namespace dapple {

void describe(Fields& fields, DrawingSettings& drawing);
void describe(Fields& fields, SavingChoice& saving);

/// Both, as "drawing" and "saving".
void describe_drawing(Fields& fields, DrawingSettings& drawing, SavingChoice& saving);

}  // namespace dapple
