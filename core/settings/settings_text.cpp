#include "core/settings/settings_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/failure.h"
#include "core/text/shown_text.h"

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

}  // namespace dapple
