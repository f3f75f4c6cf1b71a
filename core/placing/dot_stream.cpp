#include "core/placing/dot_stream.h"

namespace dapple {

DotStream stream_of(const Dots& dots, double scale) {
    return {dots.size(), scale, 0, [&dots](const TakePiece& take) { take(dots); }};
}

DotStream stream_of(const DotPieces& dots, double scale) {
    return {dots.size(), scale, 0, [&dots](const TakePiece& take) {
                for (const Dots& piece : dots.pieces) {
                    if (piece.size() > 0 && !take(piece)) return;
                }
            }};
}

}  // namespace dapple
