#include "io/settings/palettes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/failure.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"
#include "io/settings/project.h"

namespace dapple {

namespace {

using Json = nlohmann::json;

constexpr std::array kFields{"name", "colour", "width_mm", "gap_mm", "gain_mm"};

std::runtime_error wrong(const std::string& field, const std::string& why) {
    return failure("{}: {}", field, why);
}

std::string shown(const Json& value) {
    return shortened(printable(value.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

std::string text_in(const Json& object, const char* field, const char* example) {
    if (!object.contains(field)) throw wrong(field, fmt::format("is missing; give one, such as {}", example));
    if (!object[field].is_string())
        throw wrong(field,
                    fmt::format("{} is not a text; give one, such as {}", shown(object[field]), example));
    return object[field].get<std::string>();
}

// 0 where it is not there.
double length_in(const Json& object, const char* field, double most) {
    if (!object.contains(field)) return 0;
    const Json& value = object[field];
    const double length = value.is_number() ? value.get<double>() : -1;
    if (!std::isfinite(length) || length < 0 || length > most)
        throw wrong(field, fmt::format("{} is not possible; give millimetres, a number from 0 to {:g}",
                                       shown(value), most));
    return length;
}

Pen pen_of(const Json& object) {
    if (!object.is_object())
        throw std::runtime_error(
            shown(object) +
            R"( is no pen; write one as {"name": "Sky", "colour": "#3aa0d8", "width_mm": 0.3})");
    for (const auto& [field, value] : object.items())
        if (std::ranges::find(kFields, field) == kFields.end())
            throw wrong(printable(field),
                        "is not known; there are name, colour, width_mm, gap_mm and gain_mm");
    Pen pen{.name = text_in(object, "name", R"("Sky")")};
    if (!is_pen_name(pen.name))
        throw wrong(
            "name",
            fmt::format("{} is not possible; give up to 40 plain letters, digits, spaces and - _ . ( )",
                        shown(object["name"])));
    const std::string colour = text_in(object, "colour", R"("#3aa0d8")");
    try {
        pen.colour = parse_colour(colour);
    } catch (const std::runtime_error& error) {
        throw wrong("colour", error.what());
    }
    pen.width_mm = length_in(object, "width_mm", kWidestPenMm);
    if (pen.width_mm > 0 && pen.width_mm < kFinestPenMm)
        throw wrong("width_mm", fmt::format("{} is finer than any pen; give at least {:g}",
                                            shown(object["width_mm"]), kFinestPenMm));
    pen.gap_mm = length_in(object, "gap_mm", kWidestPenMm);
    pen.gain_mm = length_in(object, "gain_mm", kMostGainMm);
    for (const char* field : {"gap_mm", "gain_mm"})
        if (pen.width_mm == 0 && object.contains(field) && object[field] != 0)
            throw wrong(field, "applies to a pen with a width only; give width_mm too");
    return pen;
}

Palette pens_in(const std::string& text) {
    Json json;
    try {
        // What is deeper is no pen, and telling of it would need as deep a stack.
        json = Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
            if (depth > 8) throw std::runtime_error("has brackets within brackets, deeper than pens go");
            return true;
        });
    } catch (const Json::parse_error& error) {
        throw failure(
            "is not JSON from byte {} on; write an array of pens, as in "
            R"([{{"name": "Sky", "colour": "#3aa0d8", "width_mm": 0.3}}])",
            error.byte);
    } catch (const Json::exception&) {  // a number that is none of this world
        throw std::runtime_error("is not JSON: a number in it is too large");
    }
    if (!json.is_array())
        throw std::runtime_error(
            R"(has no array of pens; write [ and ] around {"name": "Sky", "colour": "#3aa0d8"})");
    Palette pens;
    for (std::size_t i = 0; i < json.size(); ++i) {
        try {
            pens.push_back(pen_of(json[i]));
        } catch (const std::runtime_error& error) {
            throw failure("pen {}: {}", i + 1, error.what());
        }
    }
    return pens;
}

}  // namespace

PenChoice read_pens(const std::filesystem::path& file) {
    const std::string text = text_of_file(file, {"list of pens", 1'000'000});
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const bool json = first != std::string::npos && (text[first] == '[' || text[first] == '{');
    try {
        return json ? own_pens(pens_in(text)) : parse_pen_list(text);
    } catch (const std::runtime_error& error) {
        throw failure("{}: {}", file.string(), error.what());
    }
}

namespace {

namespace fs = std::filesystem;

// A file in JSON, of which read_pens() makes these pens again; their colours in 8 bits.
std::string pens_text(const Palette& pens) {
    std::string text;
    for (const Pen& pen : pens) {
        nlohmann::ordered_json json{{"name", pen.name}, {"colour", hex_of(pen.colour)}};
        // Without a width a pen has neither.
        if (pen.width_mm > 0) json["width_mm"] = std::max(pen.width_mm, kFinestPenMm);
        if (pen.width_mm > 0 && pen.gap_mm > 0) json["gap_mm"] = pen.gap_mm;
        if (pen.width_mm > 0 && pen.gain_mm > 0) json["gain_mm"] = pen.gain_mm;
        text += (text.empty() ? "[" : ",\n ") + json.dump();
    }
    return text + "]\n";
}

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

NamedFiles palette_files(const fs::path& folder) {
    NamedFiles files{.folder = folder, .what = "palette", .ending = ".json"};
    for (const NamedPalette& palette : built_in_palettes()) files.built_in.push_back(palette.name);
    return files;
}

}  // namespace

const std::vector<NamedPalette>& built_in_palettes() {
    static const std::vector<NamedPalette> palettes = made_palettes();
    return palettes;
}

std::vector<std::string> own_palettes(const fs::path& folder) {
    std::vector<std::string> names = palette_files(folder).names();
    std::erase_if(names, [](const std::string& name) { return !names_a_palette(name); });
    return names;
}

NamedPalette palette_named(const std::string& name, const fs::path& folder) {
    const auto& built_in = built_in_palettes();
    const auto found = std::ranges::find(built_in, name, &NamedPalette::name);
    if (found != built_in.end()) return *found;
    const fs::path file = names_a_palette(name) ? palette_files(folder).find(name) : fs::path();
    if (!file.empty()) return {name, "", read_pens(file).own};
    std::vector<std::string> names;
    for (const NamedPalette& palette : built_in) names.push_back(palette.name);
    std::ranges::copy(own_palettes(folder), std::back_inserter(names));
    throw failure("there is no file or palette \"{}\"; palettes are {}", printable(name),
                  fmt::join(names, ", "));
}

void save_palette(const std::string& name, const Palette& pens, const fs::path& folder) {
    if (!names_a_palette(name))
        throw failure(
            "\"{}\" cannot be a palette's name; give up to 40 plain letters, digits, spaces and - _ . ( ), "
            "but not the name of a set, such as cmyk",
            printable(name));
    palette_files(folder).save(name, pens_text(own_pens(pens).own));
}

void remove_palette(const std::string& name, const fs::path& folder) {
    palette_files(folder).remove(name);
}

}  // namespace dapple
