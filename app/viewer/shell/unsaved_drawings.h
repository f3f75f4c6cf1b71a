#pragma once
// Drawings that were not saved when a window ended without being asked: each window keeps its own in a file,
// for as long as it lasts.
//
//     FOLDER/1764070000-4711.dapple   a project
//     FOLDER/1764070000-4711.lock     locked while the window lives that keeps it

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/descriptor.h"

namespace dapple {

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

}  // namespace dapple
