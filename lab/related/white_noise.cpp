#include "lab/related/white_noise.h"

#include "core/tile/random.h"
#include "lab/related/bent_square.h"

namespace dapple {

PlainDots white_noise(const DotsWanted& wanted) {
    const BentSquare warp(wanted.density);
    Random random(wanted.seed);
    PlainDots dots;
    dots.reserve(wanted.count);
    while (dots.size() < wanted.count && !wanted.stop.stop_requested()) {
        const double x = random.unit(), y = random.unit();
        dots.push_back(warp({x, y}));
    }
    return wanted.stop.stop_requested() ? PlainDots{} : dots;
}

}  // namespace dapple
