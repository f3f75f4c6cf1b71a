#pragma once
// What the window's settings are called in files. A new field of one of these structs doesn't compile until
// it is named here.

#include "app/viewer/model/viewer_settings.h"
#include "core/settings/fields.h"

namespace dapple {

/// "drawing", "saving" and, for the window alone, "view".
void describe(Fields& fields, ViewerSettings& settings);

}  // namespace dapple
