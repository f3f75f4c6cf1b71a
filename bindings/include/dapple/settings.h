#pragma once
// Everything that decides how a drawing looks and how it is written.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "dapple/export.h"

namespace dapple {

/// Settings as Dapple's projects hold them, so that a project of the program gives the same drawing here:
///
///     Settings settings(R"({"drawing": {"count": 20000, "pens": "cmyk", "tone": {"contrast": 0.2},
///                                       "page": {"paper": "A4"}},
///                           "saving": {"dpi": 150}})");
///
/// text() lists every field with its usual value. A value that is cheap to copy; moving it copies it.
class DAPPLE_API Settings {
 public:
    /// The usual ones: 40,000 dots, automatic tone, a page 200 mm wide.
    Settings();

    Settings(const Settings&) = default;
    Settings& operator=(const Settings&) = default;

    /// The usual ones but for what the text says: a JSON object with "drawing", "saving" or both. A project's
    /// other fields have no say. Throws as set() does.
    explicit Settings(std::string_view json);

    /// Changes what the text says and leaves the rest. Throws std::runtime_error with one sentence that names
    /// the field, what is wrong and what to give; then nothing is changed. A field that is not known is
    /// wrong.
    void set(std::string_view json);

    /// Exactly so many dots, 1 .. 10,000,000,000: short for {"drawing": {"count": ...}}.
    void set_dots(std::uint64_t count);

    /// All fields as JSON, on many lines.
    std::string text() const;

    /// What the program's window says of each field that has a row there, as JSON, for programs with rows of
    /// their own: {"drawing.tone.contrast": {"row": "Contrast", "tip": "Above 0 parts light from dark, ...",
    /// "least": -1, "most": 1, "from": -1, "to": 1, "format": "%.2f"}, ...}. `from` and `to`: how far a
    /// slider goes, by ratios if "logarithmic" is true; "unit": "mm" of lengths. Of fields that are one of
    /// some words: "choices".
    static std::string rows();

    /// Only those that are not as usual, on one line: what a drawing keeps of them.
    std::string changed() const;

    struct State;

 private:
    friend class Stippler;
    std::shared_ptr<const State> state_;
};

}  // namespace dapple
