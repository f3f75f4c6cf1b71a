#pragma once
// The window around a document: its loop, keys, dialogs and reports.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/panels/command_palette.h"
#include "app/viewer/shell/asking.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/kept_drawings.h"
#include "app/viewer/shell/memory.h"
#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

// A drawing is left for another file, or because the window goes: what would be lost by that is asked about
// first.

/// What a drawing is left for.
struct Successor {
    std::optional<FileQuestion::Answer> file = {};  // none: the window goes
};

class Leaving {
 public:
    /// Asks about the changes; to be drawn until it says to go on, or is asked nothing any more.
    void begin(Successor next) { waiting_ = Waiting{.next = std::move(next)}; }
    /// Asks whether the window goes while a file is being saved.
    void ask_about_saving() { asks_about_saving_ = true; }
    /// Whether the window is to go now that nothing is being saved, once.
    bool closes_once_saved() { return std::exchange(closes_once_saved_, false); }

    /// What it asks at present; empty: nothing.
    std::string question() const;
    /// The successor, once changes are saved or given up. Where they are to be saved in a file that has no
    /// name yet, that is asked for first.
    std::optional<Successor> draw(Document& document, Asking& asking);

 private:
    struct Waiting {
        Successor next;
        bool saving = false;  // its dialog is open
    };
    std::optional<Waiting> waiting_;
    bool asks_about_saving_ = false, closes_once_saved_ = false;
};

class Shell {
 public:
    /// Opens the window. Drawings that are not saved are kept in that folder; none: they are not. Throws
    /// std::runtime_error if there is no display.
    Shell(bool log_status, Memory memory, std::filesystem::path unsaved = {});

    const Memory& memory() const { return memory_; }

    /// Shows a document until the window is closed, and returns the exit status.
    int run(std::unique_ptr<Document> document);

 private:
    void frame(Document& document);
    /// Whether the window may go: what is not saved is asked about first.
    bool may_close(std::unique_ptr<Document>& document);
    void go_back(std::unique_ptr<Document>& document);
    void go_on(const Successor& next, Document& document);
    /// About what would be lost; none of the other dialogs is drawn beside these.
    bool draw_questions(Document& document);
    /// What is asked that a key would answer, as no other question is called; empty: nothing.
    struct Question {
        std::string what = {};
        int frames_until_seen = 0;
    };
    Question question() const;
    void act(Action action, Document& document, const Frame& frame);
    /// What was dropped or pasted; see FileQuestion.
    void take_files(std::vector<std::filesystem::path> files, Document& document);
    void draw_file_question(Document& document);
    void paste(Document& document);
    /// What the desktop's programs answered.
    void take_answers(Document& document);
    void take_chosen(const Asking::Chosen& chosen, Document& document);
    /// One of the recent files; one that is gone leaves their list.
    void open_again(const std::filesystem::path& file, Document& document);
    void draw_dialogs(Document& document, const std::function<void(Action)>& act);
    // Lists the rows of the panels and the preferences; the row `taken`, if there is one, takes its `value`.
    void list_rows(Document& document, std::vector<ListedRow>& rows, const ListedRow* taken = nullptr,
                   int value = -1);
    void take_row(const ListedRow& row, int value, Document& document);
    void take_preferences();
    /// What is to be there on the next day, and what went wrong with it.
    void remember(Document& document);
    void save_memory();
    std::filesystem::path folder_to_open() const;

    StatusLog log_;
    std::unique_ptr<Document> before_;  // that the one shown was opened from
    bool goes_back_ = false;
    Memory memory_;
    WidgetNotes widgets_;
    Window window_;
    Asking asking_;
    FileQuestion file_question_;
    Leaving leaving_;
    KeptDrawings kept_;
    bool closing_ = false;     // whatever would be lost
    std::string question_;     // of the last frame,
    int question_frames_ = 0;  // and for how many it was shown, until it is seen
    Background<std::filesystem::path> pasting_;
    bool panels_shown_ = true, help_shown_ = false, preferences_shown_ = false, about_shown_ = false;
    CommandPalette palette_;
    std::filesystem::path file_seen_;
    double last_seconds_ = 0;  // of the last frame
};

}  // namespace dapple
