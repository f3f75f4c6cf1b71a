#pragma once
// All that the window can do and all that can be set in it, to be found by typing a few letters of it.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

/// Those whose meaning or keys have every word of the text, in upper or lower case, in their order, but for
/// the palette itself.
std::vector<Shortcut> shortcuts_with(std::string_view text, std::span<const Shortcut> shortcuts);

/// Files that were opened before, the last one first, and what opens one of them.
struct RecentFiles {
    std::span<const std::filesystem::path> files{};
    std::function<void(const std::filesystem::path&)> open{};
};

/// The rows of the panels, and what shows one of them, with one of its values if that is not -1.
struct RowsToFind {
    std::span<const ListedRow> rows{};
    std::function<void(const ListedRow&, int value)> take{};
};
/// A row, or one of its values.
struct FoundRow {
    const ListedRow* row = nullptr;
    int value = -1;

    std::string words() const;  // "Paper size", "Paper size: A4"
};
/// Those whose section, label and value have every word of the text: rows first, then values, of rows that
/// can be used now. None if there is no word.
std::vector<FoundRow> rows_with(std::string_view text, std::span<const ListedRow> rows);

class CommandPalette {
 public:
    void toggle() { open_ = !open_; }
    bool is_open() const { return open_; }

    /// The chosen one is done once the palette is closed.
    void draw(std::span<const Shortcut> shortcuts, const std::function<void(Action)>& act,
              const RecentFiles& recent = {}, const RowsToFind& rows = {});

 private:
    bool open_ = false;
    char typed_[64] = {};
    int chosen_ = 0;
};

}  // namespace dapple
