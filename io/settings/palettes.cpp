#include "io/settings/palettes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <stdexcept>

#include "core/text/shown_text.h"
#include "io/settings/named_files.h"
#include "io/settings/pen_file.h"
#include "io/settings/xdg_folders.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

// The common pens of these names, all of that width.
Palette of_width(double width_mm, std::initializer_list<const char*> names) {
    Palette pens;
    for (const char* const name : names) {
        const auto found = std::ranges::find(common_pens(), name, &Pen::name);
        pens.push_back(*found);
        pens.back().width_mm = width_mm;
    }
    return pens;
}

std::vector<NamedPalette> made_palettes() {
    return {
        {"ballpoints", "four of 0.4 mm", of_width(0.4, {"Black", "Blue", "Red", "Green"})},
        {"technical-pens", "four of 0.35 mm", of_width(0.35, {"Black", "Ultramarine", "Crimson", "Green"})},
        {"fineliners", "ten of 0.4 mm",
         of_width(0.4, {"Black", "Blue", "Cyan", "Green", "Leaf green", "Yellow", "Orange", "Red", "Pink",
                        "Purple"})},
        {"felt-tips", "twelve of 1 mm",
         of_width(1, {"Black", "Grey", "Blue", "Cyan", "Green", "Leaf green", "Yellow", "Orange", "Red",
                      "Pink", "Purple", "Brown"})},
        {"earth-tones", "five of 0.3 mm", of_width(0.3, {"Black", "Brown", "Sienna", "Ochre", "Grey"})},
    };
}

// Words that may stand for a palette where a list of pens may: see parse_pens().
bool names_a_palette(const std::string& name) {
    return is_pen_name(name) && !names_pen_set(name);
}

NamedFiles files_in(const fs::path& folder) {
    NamedFiles files{.folder = folder, .what = "palette", .ending = ".json"};
    for (const NamedPalette& palette : built_in_palettes()) files.built_in.push_back(palette.name);
    return files;
}

}  // namespace

const std::vector<NamedPalette>& built_in_palettes() {
    static const std::vector<NamedPalette> palettes = made_palettes();
    return palettes;
}

fs::path palettes_folder() {
    const fs::path ours = config_folder();
    return ours.empty() ? ours : ours / "palettes";
}

std::vector<std::string> own_palettes(const fs::path& folder) {
    std::vector<std::string> names = files_in(folder).names();
    std::erase_if(names, [](const std::string& name) { return !names_a_palette(name); });
    return names;
}

NamedPalette palette_named(const std::string& name, const fs::path& folder) {
    const auto& built_in = built_in_palettes();
    const auto found = std::ranges::find(built_in, name, &NamedPalette::name);
    if (found != built_in.end()) return *found;
    const fs::path file = names_a_palette(name) ? files_in(folder).find(name) : fs::path();
    if (!file.empty()) return {name, "", read_pens(file).own};
    std::vector<std::string> names;
    for (const NamedPalette& palette : built_in) names.push_back(palette.name);
    std::ranges::copy(own_palettes(folder), std::back_inserter(names));
    throw std::runtime_error(fmt::format("there is no file or palette \"{}\"; palettes are {}",
                                         printable(name), fmt::join(names, ", ")));
}

void save_palette(const std::string& name, const Palette& pens, const fs::path& folder) {
    if (!names_a_palette(name))
        throw std::runtime_error(
            fmt::format("\"{}\" is no name for a palette; give up to 40 plain letters, digits, spaces and - "
                        "_ . ( ), and not the name of a set, such as cmyk",
                        printable(name)));
    files_in(folder).save(name, pens_text(own_pens(pens).own));
}

void remove_palette(const std::string& name, const fs::path& folder) {
    files_in(folder).remove(name);
}

}  // namespace dapple
