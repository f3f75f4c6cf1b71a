#pragma once
// Our own file dialog, the same on every desktop: a path to type, a folder to walk.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A kind of file that can be written.
struct FileFormat {
    const char* name;              // "SVG"
    const char* ending;            // ".svg"
    std::string_view others = {};  // an ending that is read the same; none: empty
};

/// What is to be opened.
struct OpenQuestion {
    const char* title = "";
    std::vector<std::string> endings{};  // of the files shown: ".png"; none: all files
    std::filesystem::path start{};       // its folder is opened
};

/// What is to be saved.
struct SaveQuestion {
    const char* title = "";
    std::vector<FileFormat> formats{};  // the first is chosen unless the name's ending says another
    std::filesystem::path start{};      // its folder is opened, its name filled in
    std::filesystem::path own_file{};   // replaced without asking; none: empty
    int option_rows = 0;                // room for draw()'s options, in rows
    const char* button = "Export";
};

class FileDialog {
 public:
    /// Opens it for a file that is there.
    void ask_what_to_open(OpenQuestion question);
    /// Opens it for a file to write. One that is there already is replaced only after it was asked for twice.
    void ask_where_to_save(SaveQuestion question);

    bool is_open() const { return open_; }
    bool saves() const { return saves_; }

    /// Draws what goes with the format chosen, an index into SaveQuestion::formats.
    using DrawOptions = std::function<void(std::size_t format)>;

    /// Draws it while it is open. The path, with a known ending, once the person has chosen one.
    std::optional<std::filesystem::path> draw(const DrawOptions& options = {});

 private:
    void show(const std::filesystem::path& start);
    void enter(const std::filesystem::path& folder);
    std::optional<std::filesystem::path> draw_entries();
    void draw_formats();
    std::optional<std::filesystem::path> draw_buttons();
    std::optional<std::filesystem::path> draw_replace_question();
    std::optional<std::filesystem::path> accept(const std::filesystem::path& path);
    std::vector<std::string> endings() const;
    std::optional<std::size_t> format_of(const std::filesystem::path& path) const;
    std::filesystem::path with_ending(const std::filesystem::path& path) const;

    bool saves_ = false;
    bool open_ = false, just_opened_ = false;
    OpenQuestion open_question_;  // of use if it does not save
    SaveQuestion question_;       // if it does
    std::size_t format_ = 0;
    std::filesystem::path folder_;
    std::string typed_;               // the path box
    std::string trouble_;             // why the path cannot be taken
    std::filesystem::path replaces_;  // what was asked for once and is there already
    std::vector<FolderEntry> entries_;
};

}  // namespace dapple
