#pragma once
// A file that is gone when the program is: at the end of its scope, or on Ctrl+C, SIGTERM or SIGHUP.

#include <filesystem>

namespace dapple {

class RemovedOnSignal {
 public:
    /// The file may be made after this. Throws std::runtime_error if the path is too long.
    explicit RemovedOnSignal(const std::filesystem::path& path);
    RemovedOnSignal(const RemovedOnSignal&) = delete;
    RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;
    ~RemovedOnSignal();

    const char* path() const;

 private:
    std::size_t slot_;
};

/// A hidden name in the same folder that nobody uses.
std::filesystem::path unused_name_beside(const std::filesystem::path& file);

}  // namespace dapple
