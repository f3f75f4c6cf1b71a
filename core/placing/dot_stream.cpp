#include "core/placing/dot_stream.h"

#include <utility>

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

DotStream stream_of(std::shared_ptr<const DotPieces> dots, double scale) {
    DotStream stream = stream_of(*dots, scale);
    stream.for_each_piece = [dots = std::move(dots),
                             each = std::move(stream.for_each_piece)](const TakePiece& take) { each(take); };
    return stream;
}

}  // namespace dapple
