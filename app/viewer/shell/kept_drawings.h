#pragma once
// Nothing is lost where the program ends unasked: the drawing that is not saved is kept in a file, at most
// every ten seconds, and a window that begins asks about those that others left behind. Each window keeps its
// own, for as long as it lasts.
//
//     FOLDER/1764070000-4711.dapple   a project
//     FOLDER/1764070000-4711.lock     locked while the window lives that keeps it

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "app/viewer/shell/document.h"
#include "io/descriptor.h"

namespace dapple {

class KeptDrawings {
 public:
    /// Finds those that windows left which are no more. No folder: nothing is kept or found.
    explicit KeptDrawings(std::filesystem::path folder = {});

    /// The file to keep this window's drawing in; empty: there is none. The folder is made if it is not
    /// there. Throws std::runtime_error if it cannot be.
    std::filesystem::path own_file();
    /// Keeps the document's changes, if there are any that are not kept and the time has come.
    void keep(Document& document);
    /// Until then; an hour where there is nothing to keep.
    double seconds_until_kept(Document& document) const;
    /// Nothing is unsaved: the own file goes.
    void forget();

    /// Whether there is a question about those that were left behind.
    bool asks() const { return !left_behind_.empty(); }
    /// The one that it asks about; only while it asks.
    const std::filesystem::path& asked() const { return left_behind_.front(); }
    /// One after the other, until one is brought back. What is cancelled is asked about the next time.
    void draw_question(Document& document);

 private:
    std::filesystem::path folder_, own_;
    Descriptor lock_;
    std::vector<std::filesystem::path> left_behind_;  // the newest first
    std::filesystem::path brought_back_;              // and not kept since; none: empty
    int changes_kept_ = -1;                           // see Session::changes(); none yet
    std::chrono::steady_clock::time_point kept_{};
};

/// The name of the picture that a kept drawing is of; "a drawing" where the file does not say.
std::string picture_of_kept(const std::filesystem::path& kept);

}  // namespace dapple
