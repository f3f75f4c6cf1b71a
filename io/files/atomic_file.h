#pragma once
// Saving so that a file is either the old one or the new one, whole.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "io/descriptor.h"
#include "io/signals.h"

namespace dapple {

// A file that is being written, beside the one that it is going to replace.

/// A new, empty file with a hidden name, ".dapple-1a2b3c4d.part", locked by who writes it. It is gone at the
/// end of its scope or with the program, unless it was renamed; a program that is killed leaves it, and
/// remove_abandoned_parts() finds it.
class PartFile {
 public:
    /// In the folder of `target`. Throws std::system_error if that cannot be.
    explicit PartFile(const std::filesystem::path& target);

    int descriptor() const { return file_.get(); }
    const char* path() const { return name_->path(); }
    /// Gives it the name of `target`, which it takes the place of. 0, or the system's number of what is
    /// wrong.
    int rename_to(const std::filesystem::path& target);

 private:
    std::optional<RemovedOnSignal> name_;
    Descriptor file_;  // closed first, since the lock is to last as long as the file has its name
};

/// Removes the parts in a folder that nobody writes any more, because the program was killed or the machine
/// stopped. Who writes one holds a lock on it, which the system lets go of when it ends, and which is seen
/// from other containers too. Over a network not every system passes locks on: there, nothing may have been
/// written for a day, by the clock of the server. Those of other people stay. Never throws; what cannot be
/// removed stays.
void remove_abandoned_parts(const std::filesystem::path& folder);

/// Calls `write` with a stream into a temporary file beside `target`, then brings it to disk and renames it.
/// If anything goes wrong, or Ctrl+C or SIGTERM ends the program meanwhile, the temporary file is removed and
/// an existing `target` stays as it was. If it is killed, an existing `target` stays too, and the next save
/// into that folder removes the temporary file. It has the mode of the old one, without the bits by which
/// it would run as somebody else, and its owner where the system lets us. Links are followed, to files that
/// are not there yet too; what exists and is no regular file (a pipe, /dev/null) is written to directly. In a
/// regular file the stream can go back to what was written.
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
