#pragma once
// What short ways are measured against: 2-opt as it is written in textbooks (Croes 1958).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/placing/dots.h"

namespace dapple {

/// An order of the dots, from their own on: all pairs of edges are tried again and again until none helps.
/// Each round is quadratic, so for few dots.
inline std::vector<std::uint32_t> plain_two_opt(const Dots& dots) {
    std::vector<std::uint32_t> order(dots.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto between = [&](std::size_t i, std::size_t k) {
        const double x = double(dots.x[order[i]]) - dots.x[order[k]],
                     y = double(dots.y[order[i]]) - dots.y[order[k]];
        return std::sqrt(x * x + y * y);
    };
    for (bool better = true; better;) {
        better = false;
        for (std::size_t i = 0; i + 3 < order.size(); ++i) {
            for (std::size_t k = i + 2; k + 1 < order.size(); ++k) {
                if (between(i, i + 1) + between(k, k + 1) - between(i, k) - between(i + 1, k + 1) < 1e-9)
                    continue;
                std::reverse(order.begin() + long(i) + 1, order.begin() + long(k) + 1);
                better = true;
            }
        }
    }
    return order;
}

}  // namespace dapple
