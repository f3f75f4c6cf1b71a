#pragma once
// Texts that a person keeps by name, each in a file of a folder, beside those that come with the program.

#include <filesystem>
#include <string>
#include <vector>

namespace dapple {

struct NamedFiles {
    std::filesystem::path folder;            // empty: nothing is there, and nothing can be kept
    const char* what = "";                   // "preset", in sentences
    const char* ending = "";                 // of the files' names, ".dapple"
    std::vector<std::string> built_in = {};  // names of those that come with the program

    /// The names of the person's own, sorted. No file is read.
    std::vector<std::string> names() const;
    /// Where the file of that name is, if it is one of names(); otherwise empty.
    std::filesystem::path find(const std::string& name) const;
    /// Where it would be.
    std::filesystem::path path_of(const std::string& name) const;

    /// In the place of one that has that name. Throws std::runtime_error with a sentence if the name is a
    /// built-in one's or none for a file, and as save_atomically().
    void save(const std::string& name, const std::string& text) const;
    /// Throws std::runtime_error if it is not there or stays.
    void remove(const std::string& name) const;
};

}  // namespace dapple
