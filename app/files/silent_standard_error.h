#pragma once
// For C libraries that print their complaints and cannot be told not to.

namespace dapple {

/// Nothing that the process writes to standard error during its life is seen.
class SilentStandardError {
 public:
    SilentStandardError();
    SilentStandardError(const SilentStandardError&) = delete;
    SilentStandardError& operator=(const SilentStandardError&) = delete;
    ~SilentStandardError();

 private:
    int kept_ = -1;  // where standard error went before
};

}  // namespace dapple
