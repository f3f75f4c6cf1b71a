#pragma once
// A drawing's dots on their way into a file: handed over in pieces, so that a drawing of any size needs the
// memory of a piece.

#include <cstdint>
#include <functional>
#include <memory>

#include "core/placing/placer.h"

namespace dapple {

struct DotStream {
    std::uint64_t count = 0;       // of dots in all
    double scale = 0;              // all of them exist at it
    std::uint64_t duplicates = 0;  // of the whole page's dots, Figure 8's only

    /// Hands over all dots, from the first on each time that it is called.
    std::function<void(const TakePiece& take)> for_each_piece = [](const TakePiece&) {};
};

/// Dots in memory, which have to outlive the stream.
DotStream stream_of(const Dots& dots, double scale = 0);
DotStream stream_of(const DotPieces& dots, double scale = 0);
/// Dots in memory that the stream owns.
DotStream stream_of(std::shared_ptr<const DotPieces> dots, double scale = 0);

}  // namespace dapple
