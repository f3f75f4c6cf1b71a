#pragma once
// Nothing is lost where the program ends unasked: the drawing that is not saved is kept in a file, at most
// every ten seconds, and a window that begins asks about those that others left behind.

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/shell/document.h"
#include "io/descriptor.h"

namespace dapple {

// Drawings that were not saved when a window ended without being asked: each window keeps its own in a file,
// for as long as it lasts.
//
//     FOLDER/1764070000-4711.dapple   a project
//     FOLDER/1764070000-4711.lock     locked while the window lives that keeps it

class UnsavedDrawings {
 public:
    /// No folder: nothing is kept or found.
    explicit UnsavedDrawings(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

    /// The file to keep this window's drawing in; empty: there is none. The folder is made if it is not
    /// there. Throws std::runtime_error if it cannot be.
    std::filesystem::path own_file();
    /// Nothing is unsaved: the own file goes.
    void forget();

    /// Those that windows left which are no more, the newest first.
    std::vector<std::filesystem::path> left_behind() const;
    /// One of them was taken over, or is not wanted.
    static void remove(const std::filesystem::path& left);

 private:
    std::filesystem::path folder_, own_;
    Descriptor lock_;
};

/// The name of the picture that a kept drawing is of; "a drawing" where the file does not say.
std::string picture_of_kept(const std::filesystem::path& kept);

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
