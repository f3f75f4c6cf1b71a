#pragma once
// Which pens' dots are looked at. A way of looking, as the zoom is: files have all pens, and it is neither
// saved nor undone.

#include <cstdint>
#include <set>
#include <span>
#include <string>

#include "core/pens/pen.h"

namespace dapple {

/// By their names, so that it stays with a pen while others come and go.
struct ShownPens {
    std::set<std::string> hidden = {};
    std::string only =
        {};  // this one alone, hidden or not; empty, or no longer there: all that are not hidden

    bool operator==(const ShownPens&) const = default;
};

/// A bit for each of the pens that is not to be seen, as Dots::pen counts them.
std::uint32_t hidden_among(std::span<const Pen> pens, const ShownPens& shown);

}  // namespace dapple
