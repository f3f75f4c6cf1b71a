#pragma once
// Dapple's file dialog: a path to type, which Tab completes, and the entries that it may become. Drawings are
// saved by it, with what goes with their format; files are opened by it where the desktop has no dialog.
//
// By keyboard: Tab completes the path, or walks from it to the entries, what is to be chosen, and the
// buttons. Arrows mark an entry, Enter takes it. Escape cancels. Elsewhere than in the list or on a button,
// Enter accepts what the path says.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/viewer/desktop/desktop_programs.h"
#include "app/viewer/widgets/dialog.h"

namespace dapple {

struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};

/// Folders first, then the files whose lower-case extension is in the list (all when it is empty), each by
/// name; hidden ones left out. Empty if the folder cannot be read.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder,
                                     const std::vector<std::string>& extensions);

/// A path that is being typed, with what all those entries of its folder have in common that begin with its
/// last name, in upper or lower case; a folder that alone does gets its slash. As typed where none does.
std::string completed(const std::filesystem::path& typed, const std::vector<FolderEntry>& entries);

/// A kind of file that can be written.
struct FileFormat {
    const char* name;              // "SVG"
    const char* ending;            // ".svg"
    std::string_view others = {};  // an ending that is read the same; none: empty
};

/// What is to be saved.
struct SaveQuestion {
    std::string title{};
    std::vector<FileFormat> formats{};  // the first is chosen unless the name's ending says another
    std::filesystem::path start{};      // its folder is opened, its name filled in
    std::filesystem::path own_file{};   // replaced without asking; none: empty
    std::vector<std::filesystem::path> own_files{};  // that are then; none: itself
    bool has_options = false;                        // draw() is given some, with room as they need it
    const char* button = "Export";
    bool begins_below = false;  // one of its rows has the keys at first (WidgetNotes::reveal), not the name
    /// What is written under a name; none: the file of that name.
    std::function<std::vector<std::filesystem::path>(const std::filesystem::path& name)> files{};
};

/// The index of the format that a file's ending says.
std::optional<std::size_t> format_of(const SaveQuestion& question, const std::filesystem::path& file);

class FileDialog {
 public:
    /// Opens it for a file that is there.
    void ask_what_to_open(const OpenQuestion& question);
    /// Opens it for a file to write. One that is there already is replaced only after it was asked for twice.
    void ask_where_to_save(SaveQuestion question);

    bool is_open() const { return open_; }
    /// What it asks whether to replace; empty: it does not ask that.
    const std::filesystem::path& replaces() const { return replaces_; }

    /// Draws what goes with the format chosen, an index into SaveQuestion::formats, and says why it cannot be
    /// written; empty: it can. Nothing is accepted while it cannot.
    using DrawOptions = std::function<std::string(std::size_t format)>;

    /// Draws it while it is open. The path, with a known ending, once the person has chosen one.
    std::optional<std::filesystem::path> draw(const DrawOptions& options = {});

 private:
    void show();
    void enter(const std::filesystem::path& folder);
    /// After the path became another: lists its folder, and takes back what was said of the last one.
    void read_typed();
    void type_on();
    /// True if its Enter was pressed.
    bool draw_path();
    /// The entry that was pressed.
    std::optional<std::filesystem::path> draw_entries(float height);
    void draw_formats();
    std::string draw_options(const DrawOptions& options, float height);
    /// True if it is to be accepted.
    bool draw_buttons(const std::string& refusal, bool escape);
    std::optional<std::filesystem::path> accept(const std::filesystem::path& chosen,
                                                const std::string& refusal);
    /// Whether the entry may become of what is typed. Of a file to be written, any.
    bool matches(const FolderEntry& entry) const;
    bool saves() const { return !question_.formats.empty(); }
    bool has_formats() const { return question_.formats.size() > 1; }  // to choose from
    /// Those files that are there already of what is written under that name.
    std::vector<std::filesystem::path> files_there(const std::filesystem::path& name) const;

    bool open_ = false;
    bool focus_path_ = false;  // it is to have the keyboard, all of it selected;
    bool path_ends_ = false;   // or it is filled in anew, with the cursor behind it
    bool path_has_keys_ = false;
    int path_turn_ = 0;  // another each time that the field is left by Tab
    ListKeys entry_keys_;
    SaveQuestion question_;             // without formats where a file is opened
    std::vector<std::string> endings_;  // of the files listed; none: all
    std::size_t format_ = 0;
    float options_height_ = 0;        // as they were drawn last
    std::filesystem::path folder_;    // that names without one lie in
    std::string typed_;               // the path box
    std::string trouble_;             // why the path cannot be taken, or what is asked of it
    std::filesystem::path replaces_;  // what was asked for once
    std::filesystem::path listed_;    // the folder of
    std::vector<FolderEntry> entries_;
};

}  // namespace dapple
