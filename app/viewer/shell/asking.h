#pragma once
// The file that a person is asked for: by the desktop's dialog or by our own, and what for.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/desktop/desktop_programs.h"
#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/shell/memory.h"
#include "app/viewer/widgets/dialog.h"

namespace dapple {

// What becomes of files that were dropped, pasted or chosen: one is opened, of several one is chosen, and a
// picture that holds the settings it was drawn with is opened as what the person says.

class FileQuestion {
 public:
    /// Whether a file is both: a picture, and settings.
    using IsBoth = std::function<bool(const std::filesystem::path&)>;
    void ask(std::vector<std::filesystem::path> files, const IsBoth& is_both);

    struct Answer {
        std::filesystem::path file;
        bool as_picture = false;  // whatever settings it holds
    };
    /// Draws the question while there is one. The answer, once; to let the dialog go is to open nothing.
    std::optional<Answer> draw(const IsBoth& is_both);
    /// About how many files it asks; 0: it does not ask.
    std::size_t files() const { return is_plain_ ? 0 : offered_.size(); }

 private:
    void draw_several(const IsBoth& is_both);

    std::vector<std::filesystem::path> offered_;  // empty: nothing is asked
    bool is_plain_ = false;                       // one that there is no question about
    ListKeys keys_;
};

// What is asked where changes would be lost.

enum class ChangesAnswer { save, discard, cancel };

/// Asks what to do with the changes to what has that name; none while there is no answer. Return saves, D
/// discards, Escape cancels.
std::optional<ChangesAnswer> ask_about_changes(const std::string& name);

/// Asks whether the window goes once the file of that name is saved (`save`), or without it.
std::optional<ChangesAnswer> ask_about_saving(const std::string& name);

/// Asks what to do with a drawing that was not saved when the program ended; `save` is to bring it back.
/// Cancel leaves it for the next time.
std::optional<ChangesAnswer> ask_about_kept(const std::string& name);

/// What it is to be opened or saved as.
enum class Asked { picture, found_picture, tile, mask, drawing, project, film };

class Asking {
 public:
    Asking();

    /// By the desktop's dialog, where that is the choice and there is one. Nothing while that is open.
    void ask_what_to_open(const OpenQuestion& question, Asked asked, DialogChoice choice);
    /// By our own, whose rows are the format's. None: nothing is asked.
    void ask_where_to_save(std::optional<SaveQuestion> question, Asked asked);

    const FileDialog& dialog() const { return dialog_; }

    struct Chosen {
        std::filesystem::path file;
        Asked asked;
    };
    /// Draws our own dialog while it is open. What was chosen in it, once.
    std::optional<Chosen> draw(const FileDialog::DrawOptions& options);
    /// What was chosen in the desktop's, once. Throws what went wrong with it.
    std::optional<Chosen> answer();

 private:
    FileDialog dialog_;
    Background<std::filesystem::path> desktop_dialog_;
    Asked asked_ = Asked::picture, desktop_asked_ = Asked::picture;
};

}  // namespace dapple
