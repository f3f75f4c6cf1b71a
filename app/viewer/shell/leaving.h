#pragma once
// A drawing is left for another file, or because the window goes: what would be lost by that is asked about
// first.

#include <optional>
#include <string>
#include <utility>

#include "app/viewer/shell/asking.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/file_question.h"

namespace dapple {

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
    std::optional<Successor> draw_changes_question(Document& document, Asking& asking);
    void draw_saving_question(Document& document);

    struct Waiting {
        Successor next;
        bool saving = false;  // its dialog is open
    };
    std::optional<Waiting> waiting_;
    bool asks_about_saving_ = false, closes_once_saved_ = false;
};

}  // namespace dapple
