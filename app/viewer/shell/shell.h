#pragma once
// The window around a document: its loop, keys, dialogs and reports.

#include <memory>
#include <string>

#include "app/viewer/panels/command_palette.h"
#include "app/viewer/shell/document.h"
#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/shell/status_log.h"
#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

class Shell {
 public:
    /// Opens the window. Throws std::runtime_error if there is no display.
    explicit Shell(bool log_status);

    /// Shows a document until the window is closed, and returns the exit status.
    int run(std::unique_ptr<Document> document);

 private:
    void frame(Document& document);
    void act(Action action, Document& document, const Frame& frame);
    /// What the dialog that is open asks for.
    enum class Asked { picture, tile, drawing, project };
    void ask_where_to_save(std::optional<SaveQuestion> question, Asked asked);
    void draw_dialogs(Document& document, const std::function<void(Action)>& act);
    void report_outside(const Document& document);

    bool log_status_;
    WidgetPlaces widgets_;
    Window window_;
    FileDialog dialog_;
    Asked asked_ = Asked::picture;
    bool panels_shown_ = true, help_shown_ = false, preferences_shown_ = false, about_shown_ = false;
    CommandPalette palette_;
    Appearance appearance_;
    bool ready_ = false;
    double last_seconds_ = 0;  // of the last frame
    std::string logged_;
    HealthInfo health_;
};

}  // namespace dapple
