#pragma once
// Tells the next window that one ended before it could draw, as by settings that crash it.

#include <filesystem>

#include "io/descriptor.h"

namespace dapple {

/// A file that is there from the window's start to its first drawing. Held by one window at a time; of others
/// that begin meanwhile nothing is known.
class StartMark {
 public:
    StartMark() = default;
    explicit StartMark(const std::filesystem::path& folder);
    StartMark(StartMark&&) = default;
    StartMark& operator=(StartMark&&) = default;
    /// A window that ends in good order, as where there is no display, leaves none.
    ~StartMark() { begun(); }

    /// There was one that no window holds any more.
    bool was_left() const { return was_left_; }
    void begun();

 private:
    std::filesystem::path file_;
    Descriptor held_;
    bool was_left_ = false;
};

}  // namespace dapple
