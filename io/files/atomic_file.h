#pragma once
// Saving so that a file is either the old one or the new one, whole.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace dapple {

/// Calls `write` with a stream into a new file beside `target`, then brings it to disk and gives it that
/// name. Whatever goes wrong, or ends the program meanwhile, an existing `target` stays as it was. On Linux's
/// own file systems the new file has no name until it is whole, and nothing is left of it. On others it is a
/// hidden one, ".dapple-1a2b3c4d.part", which is removed if writing fails and stays if the program is ended.
/// It has the mode of the old one, without the bits by which it would run as somebody else, and its owner
/// where the system lets us. Links are followed, to files that are not there yet too; what exists and is no
/// regular file (a pipe, /dev/null) is written to directly. In a regular file the stream can go back to what
/// was written.
///
/// Throws std::runtime_error naming the target and what is wrong: its folder is missing or read-only, it is a
/// folder, read-only itself or a link to itself, the disk is full, nobody reads the pipe. What `write` throws
/// passes through.
void save_atomically(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write);

/// Calls `save`, which saves one of several files that belong together; `before` of them are saved. What it
/// throws as std::runtime_error then also says that those stay.
void save_next(std::size_t before, const std::function<void()>& save);

/// Calls `write` with the standard output as a stream, which cannot go back. Throws std::runtime_error with
/// one sentence if nobody reads it any more or the disk is full. What `write` throws passes through.
void write_to_standard_output(const std::function<void(std::ostream&)>& write);

/// Throws what save_atomically() would throw before it calls `write`, so that hours of work don't end at a
/// misspelt folder.
void check_can_save(const std::filesystem::path& target);

/// Makes a folder that files go into, and those around it, unless it is there. Throws std::runtime_error
/// naming it and why it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// A file that is read or written, and what to call it in a sentence: "the picture".
struct FileInUse {
    std::filesystem::path path;
    std::string what;
};

/// Throws std::runtime_error if one of the files that are written is one of those read, or one written
/// before it, however its name is written ("./a.svg" is "a.svg", and a link is what it leads to): saving it
/// would destroy the other. "-" is the standard input or output. No file need exist yet. Pipes and devices
/// are never in each other's way.
void check_apart(const std::vector<FileInUse>& written, const std::vector<FileInUse>& read);

}  // namespace dapple
