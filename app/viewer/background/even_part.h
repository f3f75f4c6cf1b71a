#pragma once
// A part of a drawing's dots that is itself an even drawing, for where there is no time for all of them.

#include <cstddef>
#include <vector>

#include "core/placing/dots.h"

namespace dapple {

/// A drawing's dots that appear first are the lighter drawing. Relaxing moves dots by less than the lighter
/// drawing has between them, so that theirs are about as even.
class EvenPart {
 public:
    /// Looks at some ten thousand of the dots. Without Dots::critical it knows of no part.
    explicit EvenPart(const DotPieces& dots);

    bool is_known() const { return !sample_.empty(); }
    /// Those with a critical scale up to this are about one dot in so many, everywhere on the page.
    float limit(double every) const;

 private:
    std::vector<float> sample_;  // of their critical scales, rising
};

}  // namespace dapple
