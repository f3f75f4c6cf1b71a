#pragma once
// A reader as in readers.h, for projects and other settings.

#include <string>

namespace dapple {

/// What can be read is written again and has to read the same.
void read_any_settings(const std::string& text);

}  // namespace dapple
