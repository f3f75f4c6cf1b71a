#pragma once
// Palettes: pens of one's own, by a name, for --pens NAME and the window's row "Palette". Some come with the
// program; a person's own are files of pens, as pen_file.h has them, in
// $XDG_CONFIG_HOME/dapple/palettes/NAME.json.

#include <filesystem>
#include <string>
#include <vector>

#include "core/pens/pen.h"

namespace dapple {

// Pens of one's own in a file, for --pens FILE.
//
//     [{"name": "Sky",  "colour": "#3aa0d8", "width_mm": 0.3, "gap_mm": 0.6, "gain_mm": 0.05},
//      {"name": "Ochre", "colour": "#c08a2e"}]
//
// or a line for each, as --pens itself takes them: see parse_pen_list().

/// What begins with [ or { is read as JSON. Throws std::runtime_error with a sentence that names the file,
/// the pen and the field that is wrong; one that is not known is wrong too.
PenChoice read_pens(const std::filesystem::path& file);

struct NamedPalette {
    std::string name;   // "ballpoints"
    std::string about;  // "four of 0.4 mm"; empty: a person's own
    Palette pens;
};

/// Sets that many people own, with the width that they draw; in the order to show them.
const std::vector<NamedPalette>& built_in_palettes();

/// The names of the person's own, sorted; none without a folder. A file is not read before it is used.
std::vector<std::string> own_palettes(const std::filesystem::path& folder);

/// Throws std::runtime_error with one sentence if there is none of that name, naming those there are, or if
/// its file is wrong.
NamedPalette palette_named(const std::string& name, const std::filesystem::path& folder);

/// Writes one of the person's own, in the place of one that has that name. Throws std::runtime_error with a
/// sentence if the name is none for a palette, a built-in one's or a set's, as "cmyk" is; if own_pens()
/// refuses the pens; and as save_atomically().
void save_palette(const std::string& name, const Palette& pens, const std::filesystem::path& folder);

/// Throws std::runtime_error if it is not there or stays.
void remove_palette(const std::string& name, const std::filesystem::path& folder);

}  // namespace dapple
