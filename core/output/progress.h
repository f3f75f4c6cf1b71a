#pragma once
// How far a writer has come, and a last check of the numbers that it writes.

#include <cstdint>
#include <functional>

#include "core/placing/page.h"

namespace dapple {

/// Told now and then how much of a file is written, 0..1. What it throws passes through the writer, which is
/// how writing is stopped.
using WritingProgress = std::function<void(double share)>;

/// Goes along with what is written: dots, or the points of strokes.
class DotsReport {
 public:
    DotsReport(std::uint64_t count, const PageSize& page, const WritingProgress& progress);

    /// Before each, at so many millimetres from the page's corner. Throws std::runtime_error if a number is
    /// not finite, or lies beyond the page by more than a page: a machine would do what it says. Tells of
    /// every 2^15th: a few times a second at least.
    void next(double x_mm, double y_mm, double radius_mm = 0) {
        // Written so that what is not a number fails.
        if (!(x_mm >= low_ && x_mm <= high_ && y_mm >= low_ && y_mm <= high_ && radius_mm >= 0 &&
              radius_mm <= high_))
            refuse(x_mm, y_mm, radius_mm);
        if (progress_ && done_ % kDotsPerReport == 0) progress_(static_cast<double>(done_) / count_);
        ++done_;
    }

 private:
    static constexpr std::uint64_t kDotsPerReport = 1 << 15;

    [[noreturn]] static void refuse(double x_mm, double y_mm, double radius_mm);

    double count_, low_, high_;
    const WritingProgress& progress_;
    std::uint64_t done_ = 0;
};

}  // namespace dapple
