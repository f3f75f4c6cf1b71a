#pragma once
// The file that a person is asked for: by the desktop's dialog or by our own, and what for.

#include <filesystem>
#include <optional>

#include "app/viewer/background/background.h"
#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/shell/memory.h"

namespace dapple {

/// What it is to be opened or saved as.
enum class Asked { picture, found_picture, tile, mask, drawing, project, film };

class Asking {
 public:
    Asking();

    /// By the desktop's dialog, where that is the choice and there is one. Nothing while that is open.
    void ask_what_to_open(OpenQuestion question, Asked asked, DialogChoice choice);
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
