#pragma once
// Which pen draws which dot, so that each pen's own dots are about as even as all of them.

#include <cstdint>
#include <span>
#include <vector>

#include "core/pens/separation.h"
#include "core/placing/dots.h"

namespace dapple {

/// A number for each dot: the place of its pen in the palette.
using PenLabels = std::vector<std::uint8_t>;

/// Dots, what each pen's share of the dots is where each of them lies (in all 1), and how much paper a dot
/// has for itself there, in page units squared.
struct DotsToShare {
    const Dots& dots;
    std::span<const Shares> shares;
    std::span<const float> area;
    std::size_t pens = 1;
};

/// Gives each dot the pen that lags most behind its share on the way through the dots in their order; so
/// every stretch of the way has each pen's share but for a dot. The order should be DotOrder::space.
PenLabels shared_out(const DotsToShare& dots);

/// Dots that lie near each other exchange their pens wherever that lowers the energy of each pen's dots, a
/// sum over pairs of the same pen of exp(-u / 2) + 3 exp(-2 u), u the squared distance over that at which the
/// pen's dots would lie there, times 0.62 squared. So many times through all dots, as far as there is
/// something to gain. Numbers of dots stay. On any number of threads the same; 0: all cores.
void exchange_labels(const DotsToShare& dots, PenLabels& labels, int sweeps, int threads);

}  // namespace dapple
