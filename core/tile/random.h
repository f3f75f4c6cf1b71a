#pragma once
// Random numbers that are the same everywhere: the standard's distributions differ from library to library.

#include <cstddef>
#include <cstdint>
#include <random>

namespace dapple {

class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// A whole number 0..n-1; n from 1 to 2^32.
    std::uint32_t below(std::size_t n) {
        return static_cast<std::uint32_t>(((engine_() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
    std::mt19937_64 engine_;
};

}  // namespace dapple
