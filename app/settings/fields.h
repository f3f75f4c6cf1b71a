#pragma once
// Settings as JSON: each field is described once, by its name and its member, and that description both reads
// and writes it.
//
//     void describe(Fields& fields, SavingChoice& saving) {
//         auto& [order, dpi] = saving;  // fails to compile when a field is added and not described
//         fields.choice("order", order, {DotOrder::recursion, DotOrder::priority, DotOrder::space});
//         fields.number("dpi", dpi, {1, 100'000});
//     }
//
// Names in files last: a member may be renamed, the name of its field may not.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/mask.h"

namespace dapple {

/// Both ends are included.
struct FieldRange {
    double least = 0;
    double most = std::numeric_limits<double>::max();
};

/// A value of an enumeration that has no name_of().
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

    /// Of a JSON object, which is changed only when writing, and then only where it has these fields: what
    /// else it holds stays. What is read and not there leaves its member as it is; null stands for an empty
    /// optional.
    ///
    /// Reading throws std::runtime_error with a sentence that names file, field and what is wrong.
    Fields(nlohmann::ordered_json& object, Way way, SettingsPlace place);

    void flag(const char* name, bool& value);
    void number(const char* name, double& value, FieldRange range);
    void number(const char* name, float& value, FieldRange range);
    void number(const char* name, std::optional<double>& value, FieldRange range);
    void whole(const char* name, int& value, FieldRange range);
    void whole(const char* name, std::optional<int>& value, FieldRange range);
    void whole(const char* name, std::optional<std::uint64_t>& value, std::uint64_t least,
               std::uint64_t most);
    void colour(const char* name, glm::vec3& value);
    /// A text that `take` understands, or else throws std::runtime_error saying what is wrong with it.
    void text(const char* name, const std::string& value,
              const std::function<void(const std::string& text)>& take);
    /// {"width": 512, "height": 341, "levels": see packed_levels()}; an empty one is null.
    void mask(const char* name, Mask& value);
    /// A name for tile_named(). Of a tile's file, its path.
    void tile(const char* name, std::string& value);
    /// A file; none is null. Reading throws MissingFile if it is not there, as tile() does.
    void file(const char* name, std::optional<std::filesystem::path>& value);
    /// Absolute names of files that may be gone meanwhile, at most so many; those that are not UTF-8 are left
    /// out.
    void remembered_files(const char* name, std::vector<std::filesystem::path>& value, std::size_t most);

    template <class Value>
    void choice(const char* name, Value& value, std::initializer_list<NamedValue<Value>> values) {
        std::vector<std::string_view> names;
        std::optional<std::size_t> chosen;
        for (const NamedValue<Value>& each : values) {
            if (each.value == value) chosen = names.size();
            names.emplace_back(each.name);
        }
        word(name, chosen, names, Empty::refused);
        if (chosen) value = (values.begin() + *chosen)->value;
    }
    /// By their titles, in the order of the enumeration.
    template <class Value>
    void choice(const char* name, Value& value, std::span<const char* const> titles) {
        const std::vector<std::string_view> names(titles.begin(), titles.end());
        std::optional<std::size_t> chosen = static_cast<std::size_t>(value);
        word(name, chosen, names, Empty::refused);
        if (chosen) value = static_cast<Value>(*chosen);
    }
    /// By the names that name_of() gives them.
    template <class Value>
    void choice(const char* name, Value& value, std::initializer_list<Value> values) {
        std::optional<Value> chosen = value;
        choose(name, chosen, values, Empty::refused);
        value = chosen.value_or(value);
    }
    template <class Value>
    void choice(const char* name, std::optional<Value>& value, std::initializer_list<Value> values) {
        choose(name, value, values, Empty::allowed);
    }

    /// Settings within settings, by a describe() of their own.
    template <class Settings>
    void group(const char* name, Settings& settings) {
        group(name, [&](Fields& fields) { describe(fields, settings); });
    }
    void group(const char* name, const std::function<void(Fields&)>& describe_it);

    /// Whether the object has such a field.
    bool has(const char* name) const;

    /// For what no single field can see: throws std::runtime_error about one of them. "must be below
    /// white_point".
    [[noreturn]] void refuse(const char* name, const std::string& why) const;
    Way way() const { return way_; }

 private:
    enum class Empty { refused, allowed };

    template <class Value>
    void choose(const char* name, std::optional<Value>& value, std::initializer_list<Value> values,
                Empty empty) {
        std::vector<std::string_view> names;
        std::optional<std::size_t> chosen;
        for (const Value each : values) {
            if (each == value) chosen = names.size();
            names.push_back(name_of(each));
        }
        word(name, chosen, names, empty);
        value.reset();
        if (chosen) value = *(values.begin() + *chosen);
    }

    /// An index into `names`.
    void word(const char* name, std::optional<std::size_t>& chosen, std::span<const std::string_view> names,
              Empty empty);
    /// Null if it isn't there, or writing.
    const nlohmann::ordered_json* read(const char* name) const;
    nlohmann::ordered_json& written(const char* name);
    double whole_in(const char* name, const nlohmann::ordered_json& value, FieldRange range,
                    const char* or_else = "") const;
    double number_in(const char* name, const nlohmann::ordered_json& value, FieldRange range) const;
    std::string sentence(const char* name, const std::string& why) const;
    [[noreturn]] void refuse_value(const char* name, const nlohmann::ordered_json& value,
                                   const std::string& wanted) const;
    std::filesystem::path file_in(const char* name, const nlohmann::ordered_json& value) const;
    nlohmann::ordered_json file_of(const char* name, const std::filesystem::path& file) const;

    nlohmann::ordered_json& object_;
    Way way_;
    SettingsPlace place_;
    std::string prefix_ = {};  // "drawing.tone."
};

}  // namespace dapple
