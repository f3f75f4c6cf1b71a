#pragma once
// A small dialog in the middle of the window, above all else.

#include <imgui.h>

#include <exception>

namespace dapple {

/// Where a dialog is: one that grows and shrinks stays at the top.
enum class DialogPlace { middle, top };

/// ImGui::BeginPopupModal() as all dialogs have it: opened if it is not, with a line around, its title above
/// what it holds.
bool begin_dialog(const char* title, bool& open, ImGuiWindowFlags flags,
                  DialogPlace place = DialogPlace::middle);

/// Open while it lives and is true:
///
///     if (const Dialog dialog("Keys", open); dialog) { ... }
///
/// Its cross, Escape and a click beside it set `open` to false.
class Dialog {
 public:
    Dialog(const char* title, bool& open, DialogPlace place = DialogPlace::middle);
    ~Dialog();
    Dialog(const Dialog&) = delete;
    Dialog& operator=(const Dialog&) = delete;

    explicit operator bool() const { return drawn_; }

 private:
    bool& open_;
    bool drawn_ = false;
    int failures_ = std::uncaught_exceptions();
};

}  // namespace dapple
