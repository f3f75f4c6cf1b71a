#pragma once
// A small dialog in the middle of the window, above all else.

#include <imgui.h>
#include <exception>
#include <optional>
#include <string_view>

#include "app/viewer/widgets/row.h"

namespace dapple {

// A list by keyboard: one stop on Tab's way (row_keys.h). The arrows mark one of its entries, and a letter
// marks the next that begins with it.
//
//     keys.begin("files", low, high);
//     for (const std::string& file : files) {
//         const bool clicked = ImGui::Selectable(file.c_str(), keys.next_is_marked());
//         if (keys.end_entry(file).press || clicked) open(file);
//     }

class ListKeys {
 public:
    /// Before the entries, in the ImGui window that the list lies in; from `low` to `high` as row_keys() has
    /// it.
    void begin(const char* name, ImVec2 low, ImVec2 high);

    /// Whether the entry that is drawn next is the marked one, and the list has the keys.
    bool next_is_marked() const { return keys_.focused && drawn_ == marked_; }

    /// After each entry: scrolls to it and outlines it if it is marked, and what the keys then ask of it.
    /// Without a name no letter finds it.
    RowKeys end_entry(std::string_view name = {});

    /// For another list: its first entry is marked.
    void forget() { marked_ = 0; }

 private:
    RowKeys keys_;
    int marked_ = 0, drawn_ = 0;
    int letter_ = 0;                        // that was typed in this frame
    std::optional<int> first_{}, after_{};  // that begin with it, of all and behind the marked one
    bool moved_ = false;
};

/// What notes in WidgetPlaces the entry that is marked.
inline constexpr char kMarkedEntry[] = "Marked entry";

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
    Dialog& operator=(Dialog&&) = delete;

    explicit operator bool() const { return drawn_; }

 private:
    bool& open_;
    bool drawn_ = false;
    int failures_ = std::uncaught_exceptions();
};

}  // namespace dapple
