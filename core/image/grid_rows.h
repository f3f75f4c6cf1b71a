#pragma once
// Work on a grid's rows, on all cores.

#include <tbb/parallel_for.h>

#include <algorithm>

namespace dapple {

/// Calls body(row) for each row, some of them at a time on a thread.
template <class Body>
void for_each_row(int rows, const Body& body) {
    constexpr int kAtOnce = 16;
    tbb::parallel_for(0, (rows + kAtOnce - 1) / kAtOnce, [&](int stretch) {
        for (int y = stretch * kAtOnce; y < std::min((stretch + 1) * kAtOnce, rows); ++y) body(y);
    });
}

}  // namespace dapple
