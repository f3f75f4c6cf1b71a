#pragma once
// Nothing is lost where the program ends unasked: the drawing that is not saved is kept in a file, at most
// every ten seconds, and a window that begins asks about those that others left behind.

#include <chrono>
#include <filesystem>
#include <vector>

#include "app/viewer/shell/document.h"
#include "app/viewer/shell/unsaved_drawings.h"

namespace dapple {

class KeptDrawings {
 public:
    explicit KeptDrawings(UnsavedDrawings unsaved);

    /// Keeps the document's changes, if there are any that are not kept and the time has come.
    void keep(Document& document);
    /// Until then; an hour where there is nothing to keep.
    double seconds_until_kept(Document& document) const;
    /// The window ends as it should: nothing is unsaved.
    void forget() { unsaved_.forget(); }

    /// Whether there is a question about those that were left behind.
    bool asks() const { return asks_; }
    /// The one that it asks about; only while it asks.
    const std::filesystem::path& asked() const { return left_behind_.front(); }
    void draw_question(Document& document);

 private:
    UnsavedDrawings unsaved_;
    // Asked about one after the other, from the first on; or the first brought back and not kept since.
    std::vector<std::filesystem::path> left_behind_;
    bool asks_ = false;
    int changes_kept_ = -1;  // see Session::changes(); none yet
    std::chrono::steady_clock::time_point kept_{};
};

}  // namespace dapple
