#pragma once
// How far a writer has come.

#include <cstdint>
#include <functional>

namespace dapple {

/// Told now and then how much of a file is written, 0..1. What it throws passes through the writer, which is
/// how writing is stopped.
using WritingProgress = std::function<void(double share)>;

/// Tells of every 2^15th dot: a few times a second at least.
class DotsReport {
 public:
    DotsReport(std::uint64_t count, const WritingProgress& progress)
        : count_(static_cast<double>(count)), progress_(progress) {}

    /// Before each dot.
    void next() {
        if (progress_ && done_ % kDotsPerReport == 0) progress_(static_cast<double>(done_) / count_);
        ++done_;
    }

 private:
    static constexpr std::uint64_t kDotsPerReport = 1 << 15;

    double count_;
    const WritingProgress& progress_;
    std::uint64_t done_ = 0;
};

}  // namespace dapple
