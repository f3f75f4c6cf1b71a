#pragma once
// Our own file dialog, the same on every desktop: a path to type, a folder to walk.

#include <filesystem>
#include <optional>
#include <string>
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

class FileDialog {
 public:
    enum class Purpose { open_picture, save_drawing };

    /// Opens it in the folder of `start`, with start's file name filled in when saving.
    void show(Purpose purpose, const std::filesystem::path& start);
    bool is_open() const { return open_; }
    Purpose purpose() const { return purpose_; }

    /// Draws it while it is open. The path, once the person has chosen one.
    std::optional<std::filesystem::path> draw();

 private:
    void enter(const std::filesystem::path& folder);
    std::optional<std::filesystem::path> draw_entries();
    void draw_formats();
    std::optional<std::filesystem::path> accept(const std::filesystem::path& path);

    Purpose purpose_ = Purpose::open_picture;
    bool open_ = false, just_opened_ = false;
    std::filesystem::path folder_;
    std::string typed_;    // the path box
    std::string trouble_;  // why the path cannot be taken
    std::vector<FolderEntry> entries_;
};

}  // namespace dapple
