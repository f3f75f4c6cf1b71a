#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "lab/search/criteria.h"

namespace dapple {

namespace {

// How often two tiles at a lag have the orientations a and b: place 8 a + b.
using Pairs = std::array<double, 64>;

constexpr int kRounds = 200;  // far beyond those in which the orientations of touching tiles settle

int half(int v) {
    return v >= 0 ? v / 2 : -((1 - v) / 2);
}

// The children that a rule gives to a tile of an orientation, by the place they take: bits x, y.
using Children = std::array<std::array<Orientation, 4>, 8>;

Children children_of(const Rule& rule) {
    Children children;
    for (const Orientation g : all_orientations()) {
        for (int q = 0; q < 4; ++q) children[g.index][apply_to_quadrant(g, q)] = compose(g, rule.child[q]);
    }
    return children;
}

// The pairs at a lag among children, from those at the lags of their parents.
template <class At>
Pairs pairs_of_children(const Children& children, int x, int y, At at) {
    Pairs pairs{};
    for (int place = 0; place < 4; ++place) {
        const int bx = (place & 1) + x, by = (place >> 1) + y;
        const int parent_x = half(bx), parent_y = half(by);
        const int other = (bx - 2 * parent_x) + 2 * (by - 2 * parent_y);
        const Pairs& parents = at(parent_x, parent_y);
        for (int a = 0; a < 8; ++a) {
            for (int b = 0; b < 8; ++b) {
                pairs[8 * children[a][place].index + children[b][other].index] += parents[8 * a + b] / 4;
            }
        }
    }
    return pairs;
}

// Pairs at all lags up to a length in each direction.
class LagTable {
 public:
    explicit LagTable(int lags)
        : lags_(lags), pairs_(static_cast<std::size_t>(2 * lags + 1) * (2 * lags + 1)) {}
    Pairs& at(int x, int y) {
        return pairs_[static_cast<std::size_t>((y + lags_) * (2 * lags_ + 1) + x + lags_)];
    }

 private:
    int lags_;
    std::vector<Pairs> pairs_;
};

}  // namespace

std::vector<double> orientation_coincidence(const Rule& rule, int lags) {
    const Children children = children_of(rule);

    // Touching tiles: a fixpoint. It may alternate between levels, so the later half is averaged.
    LagTable touching(1), settled(1);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) touching.at(x, y)[0] = 1;
    }
    for (int round = 0; round < kRounds; ++round) {
        LagTable next(1);
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                next.at(x, y) = pairs_of_children(
                    children, x, y, [&](int px, int py) -> const Pairs& { return touching.at(px, py); });
                if (round < kRounds / 2) continue;
                for (int k = 0; k < 64; ++k)
                    settled.at(x, y)[k] += next.at(x, y)[k] / (kRounds - kRounds / 2);
            }
        }
        touching = next;
    }

    LagTable table(std::max(lags, 1));
    std::vector<double> highest;
    for (int lag = 0; lag <= lags; ++lag) {
        double most = 0;
        for (int y = -lag; y <= lag; ++y) {
            for (int x = -lag; x <= lag; ++x) {
                if (std::max(std::abs(x), std::abs(y)) != lag) continue;
                table.at(x, y) = lag <= 1
                                     ? settled.at(x, y)
                                     : pairs_of_children(children, x, y, [&](int px, int py) -> const Pairs& {
                                           return table.at(px, py);
                                       });
                double equal = 0;
                for (int g = 0; g < 8; ++g) equal += table.at(x, y)[9 * g];
                most = std::max(most, equal);
            }
        }
        if (lag > 0) highest.push_back(most);
    }
    return highest;
}

}  // namespace dapple
