#pragma once
// All that the window can do, to be found by typing a few letters of it.

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "app/viewer/panels/shortcuts.h"

namespace dapple {

/// Those whose meaning or keys have every word of the text, in upper or lower case, in their order. Nothing
/// that acts only while a key is held.
std::vector<Shortcut> shortcuts_with(std::string_view text, std::span<const Shortcut> shortcuts);

/// Files that were opened before, the last one first, and what opens one of them.
struct RecentFiles {
    std::span<const std::filesystem::path> files{};
    std::function<void(const std::filesystem::path&)> open{};
};
/// Those whose path has every word of the text.
std::vector<std::filesystem::path> recent_with(std::string_view text,
                                               std::span<const std::filesystem::path> files);

class CommandPalette {
 public:
    void toggle() { open_ = !open_; }

    /// The chosen one is done once the palette is closed.
    void draw(std::span<const Shortcut> shortcuts, const std::function<void(Action)>& act,
              const RecentFiles& recent = {});

 private:
    bool open_ = false;
    char typed_[64] = {};
    int chosen_ = 0;
};

}  // namespace dapple
