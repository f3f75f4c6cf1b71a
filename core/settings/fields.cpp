#include "core/settings/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <zlib.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/failure.h"
#include "core/image/colour.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "core/text/text_lines.h"
#include "core/tile/tile_file.h"

namespace dapple {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
// Ours are three deep.
constexpr int kDeepest = 32;

// Ours are a hundred. Each is compared with all of its object before it is kept, in their order.
constexpr int kMostFields = 5000;

struct TooDeep {};
struct TooMany {};

[[noreturn]] void fail_to_read(const SettingsPlace& place, const std::string& what) {
    throw failure("{}: {}", printable(place.file.native()), what);
}

Json parsed_settings(const std::string& text, const SettingsPlace& place) {
    const auto watch_size = [fields = 0](int depth, Json::parse_event_t event, Json&) mutable {
        if (depth > kDeepest) throw TooDeep();
        if (event == Json::parse_event_t::key && ++fields > kMostFields) throw TooMany();
        return true;
    };
    try {
        return Json::parse(text, watch_size);
    } catch (const TooDeep&) {
        fail_to_read(place, "has brackets within brackets, deeper than any settings have them");
    } catch (const TooMany&) {
        fail_to_read(place, fmt::format("more than {} fields, as no settings have", kMostFields));
    } catch (const Json::parse_error& error) {
        const std::size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        fail_to_read(place, fmt::format("line {} is not JSON: a quote, comma, bracket or value is missing, "
                                        "or one is too many",
                                        line));
    } catch (const Json::out_of_range&) {
        fail_to_read(place, "has a number too large for any computer");
    }
}

void check_version(const Json& document, const SettingsPlace& place) {
    const auto version = document.is_object() ? document.find(kVersionField) : document.end();
    if (!document.is_object() || version == document.end() || !version->is_number())
        fail_to_read(place,
                     fmt::format("not Dapple settings, which have \"{}\": {}", kVersionField, kVersion));
    const double number = version->get<double>();
    if (number > kVersion)
        fail_to_read(place, fmt::format("written by a newer Dapple, in version {:g} of the format; this one "
                                        "reads version {}",
                                        number, kVersion));
    if (number != kVersion) fail_to_read(place, fmt::format("there is no version {:g} of settings", number));
}

Json document_of(const std::string& kept, const SettingsPlace& place, const Describe& describe) {
    Json document = kept.empty() ? Json{{kVersionField, kVersion}} : parsed_settings(kept, place);
    Fields fields(document, Fields::Way::write, place);
    describe(fields);
    return document;
}

// Takes out of an object what is the same in another.
void take_out_same(Json& object, const Json& other) {
    for (auto field = object.begin(); field != object.end();) {
        const auto same = other.find(field.key());
        if (same != other.end() && field->is_object() && same->is_object()) take_out_same(*field, *same);
        const bool emptied = field->is_object() && field->empty();
        field = same != other.end() && (emptied || *field == *same) ? object.erase(field) : std::next(field);
    }
}

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestShown = 40;

std::string value_in_words(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > kLongestShown) text = text.substr(0, kLongestShown) + "...";
    return printable(text);
}

bool file_is_there(const fs::path& file) {
    std::error_code ignored;
    return !file.empty() && fs::exists(file, ignored);
}

// A device may have no end, and a pipe may never begin.
bool is_read_at_once(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored);
}

fs::path folder_holding(const fs::path& file) {
    return whole_path(file).parent_path();
}

}  // namespace

void read_settings(const std::string& text, const SettingsPlace& place, const Describe& describe) {
    Json document = parsed_settings(text, place);
    check_version(document, place);
    Fields fields(document, Fields::Way::read, place);
    describe(fields);
}

std::string settings_text(const std::string& kept, const SettingsPlace& place, const Describe& describe) {
    return document_of(kept, place, describe).dump(2) + "\n";
}

std::string changed_settings(const SettingsPlace& place, const Describe& describe, const Describe& usual) {
    Json changed = document_of("", place, describe);
    Json same = document_of("", place, usual);
    same.erase(kVersionField);
    take_out_same(changed, same);
    // In JSON these stand in strings only, where they may be written so.
    std::string text;
    for (const char c : changed.dump(-1, ' ', true)) {
        if (c == '<' || c == '>' || c == '&')
            text += fmt::format("\\u{:04x}", c);
        else
            text += c;
    }
    return text;
}

std::map<std::string, FieldNote> notes_of(const Describe& describe) {
    Json document = Json::object();
    std::map<std::string, FieldNote> notes;
    Fields fields(document, Fields::Way::write, {});
    fields.note(notes);
    describe(fields);
    return notes;
}

std::filesystem::path whole_path(const std::filesystem::path& path) {
    std::error_code gone;
    const std::filesystem::path whole = std::filesystem::absolute(path, gone);
    return (gone ? path : whole).lexically_normal();
}

std::string packed_levels(const Grid<std::uint8_t>& grid) {
    const std::vector<std::uint8_t>& levels = grid.values;
    uLongf size = compressBound(static_cast<uLong>(levels.size()));
    std::string packed(size, '\0');
    const int outcome = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, levels.data(),
                                  static_cast<uLong>(levels.size()), Z_BEST_COMPRESSION);
    if (outcome != Z_OK) throw std::runtime_error("no memory to pack a mask");
    packed.resize(size);
    return base64_of(packed);
}

Grid<std::uint8_t> unpacked_levels(std::string_view text, int width, int height) {
    const std::string packed = bytes_of_base64(text);
    Grid<std::uint8_t> levels(width, height);
    uLongf size = static_cast<uLongf>(levels.values.size());
    const int outcome = uncompress(levels.values.data(), &size, reinterpret_cast<const Bytef*>(packed.data()),
                                   static_cast<uLong>(packed.size()));
    if (outcome != Z_OK || size != levels.values.size())
        throw std::runtime_error("are not as many as width and height say, or damaged");
    return levels;
}

bool NumberRange::holds(double number) const {
    const bool excluded = at_least == Least::excluded && number == least;
    return number >= least && number <= most && !excluded;
}

std::string NumberRange::in_words(const char* kind) const {
    const bool open = most == std::numeric_limits<double>::max();
    if (at_least == Least::excluded)
        return fmt::format("{} over {:.12g}", kind, least) +
               (open ? "" : fmt::format(", up to {:.12g}", most));
    return fmt::format("{} from {:.12g} ", kind, least) + (open ? "up" : fmt::format("to {:.12g}", most));
}

Fields::Fields(Json& object, Way way, SettingsPlace place)
    : object_(object), way_(way), place_(std::move(place)) {
    assert(object_.is_object());
}

const Json* Fields::read(FieldName name) const {
    if (way_ == Way::write) return nullptr;
    const auto found = object_.find(name.field);
    return found == object_.end() ? nullptr : &*found;
}

Json& Fields::written(FieldName name) {
    if (notes_ && *name.row) (*notes_)[prefix_ + name.field] = {.row = name.row, .setting = name.setting};
    return object_[name.field];
}

bool Fields::has(FieldName name) const {
    return object_.contains(name.field);
}

void Fields::refuse(FieldName name, const std::string& why) const {
    throw std::runtime_error(sentence(name, why));
}

std::string Fields::sentence(FieldName name, const std::string& why) const {
    return fmt::format("{}: {}{} {}", printable(place_.file.native()), prefix_, name.field, why);
}

void Fields::refuse_value(FieldName name, const Json& value, const std::string& wanted) const {
    refuse(name, fmt::format("is {}; give {}", value_in_words(value), wanted));
}

double Fields::number_in(FieldName name, const Json& value, NumberRange range) const {
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (!range.holds(number)) refuse_value(name, value, range.in_words("a number"));
    return number;
}

double Fields::whole_in(FieldName name, const Json& value, NumberRange range, const char* or_else) const {
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (!range.holds(number) || number != std::floor(number))
        refuse_value(name, value, range.in_words("a whole number") + or_else);
    return number;
}

template <class Take>
void Fields::field(FieldName name, Json value, const Take& take) {
    if (way_ == Way::write)
        written(name) = std::move(value);
    else if (const Json* const found = read(name))
        take(*found);
}

void Fields::flag(FieldName name, bool& value) {
    field(name, value, [&](const Json& found) {
        if (!found.is_boolean()) refuse_value(name, found, "true or false");
        value = found.get<bool>();
    });
}

void Fields::number(FieldName name, double& value, NumberRange range) {
    field(name, value, [&](const Json& found) { value = number_in(name, found, range); });
}

void Fields::number(FieldName name, float& value, NumberRange range) {
    // The shortest digits that mean this float: 0.1, and not the 0.10000000149 that it is.
    field(name, number_of<double>(fmt::format("{}", value)).value_or(value),
          [&](const Json& found) { value = static_cast<float>(number_in(name, found, range)); });
}

void Fields::number(FieldName name, std::optional<double>& value, NumberRange range) {
    field(name, value ? Json(*value) : Json(), [&](const Json& found) {
        value.reset();
        if (!found.is_null()) value = number_in(name, found, range);
    });
}

void Fields::whole(FieldName name, std::optional<std::uint64_t>& value, NumberRange range) {
    field(name, value ? Json(*value) : Json(), [&](const Json& found) {
        value.reset();
        if (!found.is_null()) value = static_cast<std::uint64_t>(whole_in(name, found, range, ", or null"));
    });
}

void Fields::whole(FieldName name, std::optional<int>& value, NumberRange range) {
    field(name, value ? Json(*value) : Json(), [&](const Json& found) {
        value.reset();
        if (!found.is_null()) value = static_cast<int>(whole_in(name, found, range));
    });
}

void Fields::whole(FieldName name, int& value, NumberRange range) {
    field(name, value, [&](const Json& found) { value = static_cast<int>(whole_in(name, found, range)); });
}

void Fields::colour(FieldName name, glm::vec3& value) {
    field(name, hex_of(value), [&](const Json& found) {
        try {
            value = parse_colour(found.is_string() ? found.get<std::string>() : "");
        } catch (const std::runtime_error&) {
            refuse_value(name, found, "a colour such as \"#1a2b3c\"");
        }
    });
}

void Fields::mask(FieldName name, Mask& value) {
    if (way_ == Way::write) {
        Json& there = written(name);
        there = Json();
        if (!value.empty())
            there = {{"width", value.levels().width},
                     {"height", value.levels().height},
                     {"levels", packed_levels(value.levels())}};
        if (value.has_finer()) there["fineness"] = packed_levels(value.fineness());
        return;
    }
    const Json* const found = read(name);
    if (!found) return;
    value = {};
    if (found->is_null()) return;
    const auto side = [&](const char* which) {
        const auto at = found->find(which);
        const bool whole = at != found->end() && at->is_number_integer();
        const double pixels = whole ? at->get<double>() : 0;
        if (!(pixels >= 1 && pixels <= kMostMaskSide))
            refuse(name, fmt::format("has no {} of 1 to {}", which, kMostMaskSide));
        return static_cast<int>(pixels);
    };
    if (!found->is_object()) refuse_value(name, *found, "a mask, in braces, or null");
    const int width = side("width"), height = side("height");
    const auto unpacked = [&](const char* which) {
        const auto text = found->find(which);
        if (text == found->end() || !text->is_string()) refuse(name, fmt::format("has no {}", which));
        try {
            return unpacked_levels(text->get_ref<const std::string&>(), width, height);
        } catch (const std::runtime_error& error) {
            refuse(name, fmt::format("has {} that {}", which, error.what()));
        }
    };
    Grid<std::uint8_t> levels = unpacked("levels");
    value =
        found->contains("fineness") ? Mask(std::move(levels), unpacked("fineness")) : Mask(std::move(levels));
}

Json Fields::file_of(FieldName name, const fs::path& file) const {
    const fs::path whole = whole_path(file);
    if (!is_utf8(whole.string())) {
        refuse(name,
               fmt::format("is {}, whose name is not UTF-8, as all names in it have to be; rename that file",
                           printable(file.native())));
    }
    Json value{{"file", whole.lexically_proximate(folder_holding(place_.file)).generic_string()}};
    if (place_.names == FileNames::relative_and_absolute) value["absolute"] = whole.generic_string();
    return value;
}

fs::path Fields::file_in(FieldName name, const Json& value) const {
    const auto text_at = [&](const char* part) {
        const auto found = value.find(part);
        return found != value.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    const std::string given = value.is_string() ? value.get<std::string>() : text_at("file");
    if (given.empty() || given.find('\0') != std::string::npos)
        refuse_value(name, value, "the name of a file");
    const fs::path beside = (folder_holding(place_.file) / given).lexically_normal();
    const fs::path absolute = value.is_object() ? text_at("absolute") : "";
    for (const fs::path& file : {beside, absolute}) {
        if (!file_is_there(file)) continue;
        if (is_read_at_once(file)) return file;
        refuse(name,
               fmt::format("is {}, which is not a regular file; name one that is", printable(file.native())));
    }
    const std::string where =
        absolute.empty() || absolute == beside
            ? fmt::format("{} is not there", beside.string())
            : fmt::format("neither {} nor {} is there", beside.string(), absolute.string());
    throw MissingFile(sentence(
        name, fmt::format("cannot be found, {}; put that file back, or name another", printable(where))));
}

void Fields::text(FieldName name, const std::string& value,
                  const std::function<void(const std::string& text)>& take) {
    field(name, value, [&](const Json& found) {
        if (!found.is_string()) refuse_value(name, found, "a text in quotes");
        try {
            take(found.get<std::string>());
        } catch (const std::runtime_error& error) {
            refuse(name, fmt::format("is wrong: {}", error.what()));
        }
    });
}

void Fields::tile(FieldName name, std::string& value) {
    if (way_ == Way::write) {
        written(name) = is_tile_file_name(value) ? file_of(name, value) : Json(value);
    } else if (const Json* const found = read(name)) {
        const bool is_name = found->is_string() && !is_tile_file_name(found->get<std::string>());
        value = is_name ? found->get<std::string>() : file_in(name, *found).string();
    }
}

void Fields::file(FieldName name, std::optional<fs::path>& value) {
    if (way_ == Way::write) {
        written(name) = value ? file_of(name, *value) : Json();
    } else if (const Json* const found = read(name)) {
        value.reset();
        if (!found->is_null()) value = file_in(name, *found);
    }
}

void Fields::remembered_files(FieldName name, std::vector<fs::path>& value, std::size_t most) {
    if (way_ == Way::write) {
        Json& list = written(name) = Json::array();
        for (const fs::path& file : value)
            if (list.size() < most && is_utf8(file.string())) list.push_back(file.string());
        return;
    }
    const Json* const found = read(name);
    if (!found) return;
    value.clear();
    const auto is_file = [](const Json& each) {
        return each.is_string() && fs::path(each.get<std::string>()).is_absolute() &&
               each.get<std::string>().find('\0') == std::string::npos;
    };
    if (!found->is_array() || found->size() > most || !std::ranges::all_of(*found, is_file))
        refuse_value(name, *found, fmt::format("a list of at most {} whole names of files", most));
    for (const Json& each : *found) value.emplace_back(each.get<std::string>());
}

void Fields::word(FieldName name, std::optional<std::size_t>& chosen, std::span<const char* const> names,
                  Empty empty) {
    assert(way_ == Way::read || chosen || empty == Empty::allowed);
    field(name, chosen ? Json(names[*chosen]) : Json(), [&](const Json& found) {
        chosen.reset();
        if (found.is_null() && empty == Empty::allowed) return;
        const auto at =
            std::ranges::find(names, found.is_string() ? found.get_ref<const std::string&>() : std::string());
        if (at == names.end())
            refuse_value(name, found,
                         fmt::format("one of {}{}", fmt::join(names, ", "),
                                     empty == Empty::allowed ? ", or null" : ""));
        chosen = static_cast<std::size_t>(at - names.begin());
    });
    if (notes_ && *name.row) (*notes_)[prefix_ + name.field].choices.assign(names.begin(), names.end());
}

void Fields::presence(FieldName name, bool& some) {
    if (way_ == Way::write && !some)
        written(name) = Json();
    else if (const Json* const found = read(name))
        some = !found->is_null();
}

void Fields::group(FieldName name, const std::function<void(Fields&)>& describe_it) {
    if (way_ == Way::read && !has(name)) return;
    Json& inner = written(name);
    if (way_ == Way::write && !inner.is_object()) inner = Json::object();
    if (!inner.is_object()) refuse_value(name, inner, "an object, in braces");
    Fields fields(inner, way_, place_);
    fields.prefix_ = prefix_ + name.field + ".";
    fields.notes_ = notes_;
    describe_it(fields);
}

}  // namespace dapple
