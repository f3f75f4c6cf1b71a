#pragma once
// What is fuzzed: each takes any bytes. A refusal in a sentence is as it should be; whatever else goes wrong
// ends the process.

#include <string>

namespace dapple {

void read_any_tile(const std::string& text);
void read_any_points(const std::string& text);
/// Also fills it in for a few dots.
void read_any_gcode_template(const std::string& text);
void read_any_pens(const std::string& text);

}  // namespace dapple
