#pragma once
// What was changed, in a word or two: what a button offers to undo.

#include <string>

#include "app/viewer/model/viewer_settings.h"

namespace dapple {

/// The names of the rows that say it: "Contrast", "Dot size and 2 more"; empty if they are equal in all that
/// is saved.
std::string change_in_words(const ViewerSettings& before, const ViewerSettings& after);

}  // namespace dapple
