#pragma once
// Settings as a text: JSON with a version, strictly read.

#include <functional>
#include <map>
#include <string>

#include "core/settings/fields.h"

namespace dapple {

/// The field that says which version of the format a text is in.
inline constexpr const char* kVersionField = "dapple";

/// What is read or written: the fields of the whole text.
using Describe = std::function<void(Fields&)>;

/// Reads what the text has; the rest stays as it is. Throws std::runtime_error with one sentence that names
/// the file, and the field or line that is wrong, whatever the text is.
void read_settings(const std::string& text, const SettingsPlace& place, const Describe& describe);

/// All fields, indented, with a line end. What `kept` has beside them stays where it is: text that was read
/// by read_settings(), perhaps written by a Dapple that knows more, or empty.
std::string settings_text(const std::string& kept, const SettingsPlace& place, const Describe& describe);

/// Only the fields that differ from those of `usual`, on one line, in ASCII without <, > and &.
std::string changed_settings(const SettingsPlace& place, const Describe& describe, const Describe& usual);

/// What there is to say of the fields that rows change, by a field's whole name as in "drawing.tone.gamma".
std::map<std::string, FieldNote> notes_of(const Describe& describe);

}  // namespace dapple
