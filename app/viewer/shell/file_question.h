#pragma once
// What becomes of files that were dropped, pasted or chosen: one is opened, of several one is chosen, and a
// picture that holds the settings it was drawn with is opened as what the person says.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/viewer/widgets/list_keys.h"

namespace dapple {

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
    std::optional<Answer> draw_both();
    void draw_several(const IsBoth& is_both);

    std::vector<std::filesystem::path> offered_;  // empty: nothing is asked
    bool is_plain_ = false;                       // one that there is no question about
    ListKeys keys_;
};

}  // namespace dapple
