#pragma once
// A project: a picture and all that decides how it is drawn and shown, in a file NAME.dapple.
//
//     {
//       "dapple": 1,
//       "picture": {"file": "cat.jpg", "absolute": "/home/ada/cat.jpg"},
//       "drawing": {"count": 40000, "tone": {...}, ...},
//       "saving": {"dpi": 300, ...},
//       "view": {...}
//     }
//
// The picture, and a tile that is a file, are looked for from the project's folder and then where they were.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/drawing/settings.h"
#include "core/settings/fields.h"

namespace dapple {

// Texts that a person keeps by name, each in a file of a folder, beside those that come with the program.

struct NamedFiles {
    std::filesystem::path folder;            // empty: nothing is there, and nothing can be kept
    const char* what = "";                   // "preset", in sentences
    const char* ending = "";                 // of the files' names, ".dapple"
    std::vector<std::string> built_in = {};  // names of those that come with the program

    /// The names of the person's own, sorted. No file is read.
    std::vector<std::string> names() const;
    /// Where the file of that name is, if it is one of names(); otherwise empty.
    std::filesystem::path find(const std::string& name) const;
    /// Where it would be.
    std::filesystem::path path_of(const std::string& name) const;

    /// In the place of one that has that name. Throws std::runtime_error with a sentence if the name is a
    /// built-in one's or none for a file, and as save_atomically().
    void save(const std::string& name, const std::string& text) const;
    /// Throws std::runtime_error if it is not there or stays.
    void remove(const std::string& name) const;
};

// The settings that a drawing was made with, inside the drawing: in an SVG's <metadata>, in a PNG's text.

/// For a drawing to be saved there: what differs from the usual settings, in ASCII without <, > and &. Empty
/// if it cannot be said, as with a tile whose name is not UTF-8.
std::string embedded_settings(const std::filesystem::path& drawing_file, const DrawingSettings& drawing,
                              const SavingChoice& saving);

/// What a file has inside it, if it is an SVG or PNG of ours; none for any other file, whatever is in it.
std::optional<std::string> settings_inside(const std::filesystem::path& file);

struct SavedSettings {
    DrawingSettings drawing;
    SavingChoice saving;
};

/// Those of a drawing of ours, or of a project; what it does not say is as usual. Throws std::runtime_error
/// with one sentence if the file has none, or some that are wrong.
SavedSettings settings_from(const std::filesystem::path& file);

inline constexpr const char* kProjectEnding = ".dapple";
/// Whether the name of a file ends so, in small letters or capitals.
bool ends_as_project(const std::filesystem::path& file);

/// The text of a file of settings. Throws std::runtime_error if it cannot be read or is far too large.
std::string text_of_settings(const std::filesystem::path& file);

struct Project {
    std::optional<std::filesystem::path> picture = {};  // none: the built-in sample
    std::string why_missing = {};  // a sentence, if the picture it names is not there; that name is then kept
    std::string kept = {};         // as it was read: what is not known here is saved again
};

/// Throws std::runtime_error with one sentence that names the file and what is wrong in it. `describe` says
/// what is read beside the picture.
Project read_project(const std::filesystem::path& file, const Describe& describe);

/// Throws as save_atomically(), and if the picture's name cannot be written.
void save_project(const std::filesystem::path& file, Project project, const Describe& describe);

}  // namespace dapple
