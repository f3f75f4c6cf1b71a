#pragma once
// The window around a document: its loop, keys, dialogs and reports.

#include <memory>
#include <string>

#include "app/viewer/canvas/entry_pictures.h"
#include "app/viewer/model/background.h"
#include "app/viewer/panels/command_palette.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/shell/file_question.h"
#include "app/viewer/shell/memory.h"
#include "app/viewer/shell/status_log.h"
#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

class Shell {
 public:
    /// Opens the window. Throws std::runtime_error if there is no display.
    Shell(bool log_status, Memory memory);

    const Memory& memory() const { return memory_; }

    /// Shows a document until the window is closed, and returns the exit status.
    int run(std::unique_ptr<Document> document);

 private:
    void frame(Document& document);
    void act(Action action, Document& document, const Frame& frame);
    /// What the dialog that is open asks for.
    enum class Asked { picture, found_picture, tile, mask, drawing, project, film };
    /// What was dropped or pasted; see file_question.h.
    void take_files(std::vector<std::filesystem::path> files, Document& document);
    void draw_file_question(Document& document);
    void ask_what_to_open(OpenQuestion question, Asked asked);
    void paste(Document& document);
    /// What the desktop's programs answered.
    void take_answers(Document& document);
    void take_chosen(const std::filesystem::path& path, Asked asked, Document& document);
    /// One of the recent files; one that is gone leaves their list.
    void open_again(const std::filesystem::path& file, Document& document);
    void ask_where_to_save(std::optional<SaveQuestion> question, Asked asked);
    EntryPicture thumbnail(const std::filesystem::path& file);
    void draw_dialogs(Document& document, const std::function<void(Action)>& act);
    void report_outside(const Document& document);
    /// What is to be there on the next day, and what went wrong with it.
    void remember(Document& document);
    void save_memory();
    std::filesystem::path folder_to_open() const;

    bool log_status_;
    Memory memory_;
    WidgetPlaces widgets_;
    Window window_;
    FileDialog dialog_;
    EntryPictures thumbnails_;  // of its entries
    Asked asked_ = Asked::picture;
    bool panels_shown_ = true, help_shown_ = false, preferences_shown_ = false, about_shown_ = false;
    CommandPalette palette_;
    std::filesystem::path file_seen_;
    FileQuestion file_question_;
    bool ready_ = false;
    double last_seconds_ = 0;  // of the last frame
    std::string logged_;
    HealthInfo health_;
    Asked desktop_asked_ = Asked::picture;  // of the desktop's dialog
    Background<std::filesystem::path> desktop_dialog_, pasting_;
};

}  // namespace dapple
