#pragma once
// Settings as JSON: each field is described once, by its name and its member, and that description both reads
// and writes it.
//
//     void describe(Fields& fields, SavingChoice& saving) {
//         auto& [order, dpi] = saving;  // fails to compile when a field is added and not described
//         fields.choice(setting::order, order);
//         fields.number(setting::dpi, dpi);
//     }
//
// Names in files last: a member may be renamed, the name of its field may not.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/grid.h"
#include "core/image/mask.h"
#include "core/settings/setting.h"
#include "core/text/names.h"

namespace dapple {

// A file's name from the root on.

/// Lexically normal. A relative one stays as it is where the working folder is gone. Does not throw.
std::filesystem::path whole_path(const std::filesystem::path& path);

// A mask within settings: its levels and its finenesses, each packed and written in letters.

/// The levels, row after row from the top, as zlib packs them (RFC 1950), in base64.
std::string packed_levels(const Grid<std::uint8_t>& levels);

/// Throws std::runtime_error with what is wrong, "are not ...", if the text is not so many levels.
Grid<std::uint8_t> unpacked_levels(std::string_view text, int width, int height);

/// What a field is called in files, and the row that undo speaks of.
struct FieldName {
    FieldName(const char* in_files, const char* in_rows = "") : field(in_files), row(in_rows) {}
    FieldName(const Setting& entry) : FieldName(entry, entry.names.row) {}
    FieldName(const Setting& entry, const char* in_rows)
        : field(entry.names.field), row(in_rows), setting(&entry) {}

    const char *field, *row;
    const Setting* setting = nullptr;  // its entry in the table; none: it has none
};

/// What there is to say of a field, whatever its value.
struct FieldNote {
    std::string row = {};                   // the row that changes it
    const Setting* setting = nullptr;       // as FieldName has it
    std::vector<const char*> choices = {};  // of a field that is one of some words
};

/// A value by a name that it has in files alone.
template <class Value>
struct NamedValue {
    const char* name;
    Value value;
};
template <class Value>
NamedValue(const char*, Value) -> NamedValue<Value>;

/// How files that a setting names are written.
enum class FileNames {
    relative,               // to the folder of the file that the settings are in
    relative_and_absolute,  // that one first, and then the absolute one, for when the file was moved alone
};

/// Where the settings are: what sentences name, and where relative names begin.
struct SettingsPlace {
    std::filesystem::path file;
    FileNames names = FileNames::relative_and_absolute;
};

/// Settings that are right, but for a file that they name and that is not there.
struct MissingFile : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Fields {
 public:
    enum class Way { read, write };

    /// Reads or writes the fields of a JSON object. It is changed only when writing, and then only where it
    /// has these fields: what else it holds stays. A field that is not there to be read leaves its member as
    /// it is; null stands for an empty optional.
    ///
    /// Reading throws std::runtime_error with a sentence that names file, field and what is wrong.
    Fields(nlohmann::ordered_json& object, Way way, SettingsPlace place);

    void flag(FieldName name, bool& value);
    void number(FieldName name, double& value, NumberRange range);
    void number(FieldName name, float& value, NumberRange range);
    void number(FieldName name, std::optional<double>& value, NumberRange range);
    template <class Number>
    void number(const Setting& setting, Number& value) {
        number(setting, value, setting.range);
    }
    void whole(FieldName name, int& value, NumberRange range);
    void whole(FieldName name, std::optional<int>& value, NumberRange range);
    void whole(FieldName name, std::optional<std::uint64_t>& value, NumberRange range);
    template <class Number>
    void whole(const Setting& setting, Number& value) {
        whole(setting, value, setting.range);
    }
    void colour(FieldName name, glm::vec3& value);
    /// A text that `take` understands, or else throws std::runtime_error saying what is wrong with it.
    void text(FieldName name, const std::string& value,
              const std::function<void(const std::string& text)>& take);
    /// {"width": 512, "height": 341, "levels": see packed_levels()}, and "fineness" as these where dots are
    /// finer; an empty one is null.
    void mask(FieldName name, Mask& value);
    /// A name for tile_named(); for a tile in a file, its path.
    void tile(FieldName name, std::string& value);
    /// A file; none is null. Reading throws MissingFile if it is not there, as tile() does.
    void file(FieldName name, std::optional<std::filesystem::path>& value);
    /// Absolute names of files that may be gone meanwhile, at most so many; those that are not UTF-8 are left
    /// out.
    void remembered_files(FieldName name, std::vector<std::filesystem::path>& value, std::size_t most);

    template <class Value>
    void choice(FieldName name, Value& value, std::initializer_list<NamedValue<Value>> values) {
        std::vector<const char*> names;
        std::optional<std::size_t> chosen;
        for (const NamedValue<Value>& each : values) {
            if (each.value == value) chosen = names.size();
            names.emplace_back(each.name);
        }
        word(name, chosen, names, Empty::refused);
        if (chosen) value = (values.begin() + *chosen)->value;
    }
    /// By their names.
    template <Named Value>
    void choice(FieldName name, Value& value) {
        std::optional<std::size_t> chosen = static_cast<std::size_t>(value);
        word(name, chosen, names_of(value), Empty::refused);
        if (chosen) value = static_cast<Value>(*chosen);
    }
    template <Named Value>
    void choice(FieldName name, std::optional<Value>& value) {
        std::optional<std::size_t> chosen;
        if (value) chosen = static_cast<std::size_t>(*value);
        word(name, chosen, names_of(Value()), Empty::allowed);
        value.reset();
        if (chosen) value = static_cast<Value>(*chosen);
    }

    /// Settings within settings, by a describe() of their own.
    template <class Settings>
    void group(FieldName name, Settings& settings) {
        group(name, [&](Fields& fields) { describe(fields, settings); });
    }
    void group(FieldName name, const std::function<void(Fields&)>& describe_it);
    /// The same of settings that may be none, which is null.
    template <class Settings>
    void optional_group(FieldName name, std::optional<Settings>& settings) {
        bool some = settings.has_value();
        presence(name, some);
        if (!some) return settings.reset();
        if (!settings) settings.emplace();
        group(name, *settings);
    }

    /// Whether the object has such a field.
    bool has(FieldName name) const;

    /// For what no single field can see: throws std::runtime_error about one of them. "must be below
    /// white_point".
    [[noreturn]] void refuse(FieldName name, const std::string& why) const;
    Way way() const { return way_; }

    /// Writing also notes each field that a row says there, under its whole name: "drawing.tone.gamma".
    void note(std::map<std::string, FieldNote>& notes) { notes_ = &notes; }

 private:
    enum class Empty { refused, allowed };

    /// Whether the field is an object rather than null.
    void presence(FieldName name, bool& some);

    /// An index into `names`.
    void word(FieldName name, std::optional<std::size_t>& chosen, std::span<const char* const> names,
              Empty empty);
    /// Writes that, or takes what is there.
    template <class Take>
    void field(FieldName name, nlohmann::ordered_json value, const Take& take);
    /// Null if it isn't there, or writing.
    const nlohmann::ordered_json* read(FieldName name) const;
    nlohmann::ordered_json& written(FieldName name);
    double whole_in(FieldName name, const nlohmann::ordered_json& value, NumberRange range,
                    const char* or_else = "") const;
    double number_in(FieldName name, const nlohmann::ordered_json& value, NumberRange range) const;
    std::string sentence(FieldName name, const std::string& why) const;
    [[noreturn]] void refuse_value(FieldName name, const nlohmann::ordered_json& value,
                                   const std::string& wanted) const;
    std::filesystem::path file_in(FieldName name, const nlohmann::ordered_json& value) const;
    nlohmann::ordered_json file_of(FieldName name, const std::filesystem::path& file) const;

    nlohmann::ordered_json& object_;
    Way way_;
    SettingsPlace place_;
    std::string prefix_ = {};  // "drawing.tone."
    std::map<std::string, FieldNote>* notes_ = nullptr;
};

// Settings as a text: JSON with a version, strictly read.

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
