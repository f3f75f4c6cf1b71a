#include "core/dot_stream.h"

namespace dapple {

DotStream stream_of(const Dots& dots, double scale) {
    return {dots.size(), scale, [&dots](const TakePiece& take) { take(dots); }};
}

}  // namespace dapple
