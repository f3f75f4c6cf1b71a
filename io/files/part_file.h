#pragma once
// A file that is being written, beside the one that it is going to replace.

#include <filesystem>
#include <optional>

#include "io/descriptor.h"
#include "io/signals.h"

namespace dapple {

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

}  // namespace dapple
