#pragma once
// Our own file dialog, the same on every desktop: a path to type, a folder to walk.
//
// By keyboard: Tab walks from the path to the lists, what is to be chosen, and the buttons. Arrows mark an
// entry of a list, Enter opens it; Space takes a file's name into the path. Escape cancels. Elsewhere than in
// a list or on a button, Enter accepts what the path says.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/viewer/widgets/dialog.h"

namespace dapple {

struct FolderEntry {
    std::string name;
    bool folder = false;
    bool operator==(const FolderEntry&) const = default;
};

/// A path that is being typed, in that folder or whole, with what all entries have in common that begin with
/// its last name, in upper or lower case; a folder that alone does gets its slash. As typed where none does.
std::string completed(const std::string& typed, const std::filesystem::path& folder,
                      const std::vector<std::string>& extensions);

/// Folders first, then the files whose lower-case extension is in the list (all when it is empty), each by
/// name; hidden ones left out. Empty if the folder cannot be read.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder,
                                     const std::vector<std::string>& extensions);

/// A kind of file that can be written.
struct FileFormat {
    const char* name;              // "SVG"
    const char* ending;            // ".svg"
    std::string_view others = {};  // an ending that is read the same; none: empty
};

/// What is to be opened.
struct OpenQuestion {
    const char* title = "";
    std::vector<std::string> endings{};           // of the files shown: ".png"; none: all files
    std::filesystem::path start{};                // its folder is opened
    std::vector<std::filesystem::path> recent{};  // opened before: shown beside the folder
    std::vector<std::filesystem::path> places{};  // folders to go to at once
};

/// What is to be saved.
struct SaveQuestion {
    const char* title = "";
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
    void ask_what_to_open(OpenQuestion question);
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
    void show(const std::filesystem::path& start);
    void enter(const std::filesystem::path& folder);
    /// What the path field, the lists and the buttons ask to be accepted, if anything.
    using Wanted = std::optional<std::filesystem::path>;
    /// True if its Enter was pressed.
    bool draw_path();
    Wanted draw_lists();
    Wanted draw_places();
    /// Where a click on a place leads; empty: none was clicked.
    std::filesystem::path draw_folders(const std::vector<std::filesystem::path>& folders);
    Wanted draw_entries();
    void take_name(const std::filesystem::path& file);
    /// What is typed was changed by hand.
    void follow_typed();
    bool has_formats() const;  // to choose from
    void draw_formats();
    /// Below the formats. In a low window they scroll, so that some of the folder is left to be seen.
    std::string draw_options(const DrawOptions& options);
    float options_room() const;
    Wanted draw_buttons(const std::string& refusal, bool escape);
    std::optional<std::filesystem::path> draw_replace_question(bool enter, bool escape);
    std::optional<std::filesystem::path> accept(const std::filesystem::path& path,
                                                const std::string& refusal);
    std::vector<std::string> endings() const;
    /// Those files that are there already of what is written under that name.
    std::vector<std::filesystem::path> files_there(const std::filesystem::path& name) const;
    /// When a file is to be opened: the folder's first entry whose name begins as what is typed; null: none
    /// does.
    const FolderEntry* entry_begun() const;
    std::filesystem::path with_ending(const std::filesystem::path& path) const;

    bool saves_ = false;
    bool open_ = false;
    bool focus_path_ = false;  // it is to have the keyboard,
    bool path_ends_ = false;   // with the cursor behind what is there, instead of all of it selected
    bool path_has_keys_ = false;
    bool jumps_ = false;  // to the entry that begins as what was typed
    int path_turn_ = 0;   // another each time that the field is left by Tab
    ListKeys place_keys_, entry_keys_;
    OpenQuestion open_question_;  // of use if it does not save
    SaveQuestion question_;       // if it does
    std::size_t format_ = 0;
    float options_height_ = 0;  // as they were drawn last
    std::filesystem::path folder_;
    std::string typed_;                            // the path box
    std::string filter_;                           // letters that listed entries have
    std::string trouble_;                          // why the path cannot be taken
    std::filesystem::path replaces_;               // what was asked for once,
    std::vector<std::filesystem::path> replaced_;  // of whose files these are there already
    std::vector<FolderEntry> entries_;
};

}  // namespace dapple
