#pragma once
// An open file of the system, closed at the end of its scope.

#include <unistd.h>

#include <utility>

namespace dapple {

class Descriptor {
 public:
    /// What open() gave; less than 0 if it failed.
    explicit Descriptor(int value = -1) : value_(value) {}
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }

    explicit operator bool() const { return value_ >= 0; }
    int get() const { return value_; }
    /// As close() does: 0 if all went well.
    int close() { return ::close(std::exchange(value_, -1)); }

 private:
    int value_;
};

}  // namespace dapple
