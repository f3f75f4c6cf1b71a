#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "lab/search/criteria.h"

namespace dapple {

namespace {

// How often two tiles at a lag are of the kinds a and b: place kinds * a + b.
using Pairs = std::vector<double>;

constexpr int kRounds = 200;  // far beyond those in which the kinds of touching tiles settle

int half(int v) {
    return v >= 0 ? v / 2 : -((1 - v) / 2);
}

// The pairs at a lag among children, from those at the lags of their parents.
template <class At>
Pairs pairs_of_children(const NextKinds& next, int x, int y, At at) {
    const std::size_t kinds = next.size();
    Pairs pairs(kinds * kinds, 0.0);
    for (int place = 0; place < 4; ++place) {
        const int bx = (place & 1) + x, by = (place >> 1) + y;
        const int parent_x = half(bx), parent_y = half(by);
        const auto q = static_cast<std::size_t>(place);
        const auto r = static_cast<std::size_t>((bx - 2 * parent_x) + 2 * (by - 2 * parent_y));
        const Pairs& parents = at(parent_x, parent_y);
        for (std::size_t a = 0; a < kinds; ++a) {
            double* const row = &pairs[next[a][q] * kinds];
            for (std::size_t b = 0; b < kinds; ++b) row[next[b][r]] += parents[a * kinds + b] / 4;
        }
    }
    return pairs;
}

// Pairs at all lags up to a length in each direction.
class LagTable {
 public:
    explicit LagTable(int lags)
        : lags_(lags),
          pairs_(static_cast<std::size_t>(2 * lags + 1) * static_cast<std::size_t>(2 * lags + 1)) {}
    Pairs& at(int x, int y) {
        return pairs_[static_cast<std::size_t>((y + lags_) * (2 * lags_ + 1) + x + lags_)];
    }

 private:
    int lags_;
    std::vector<Pairs> pairs_;
};

}  // namespace

std::vector<double> kind_coincidence(const NextKinds& next, int lags) {
    const std::size_t kinds = next.size();
    // Touching tiles: a fixpoint. It may alternate between levels, so the later half is averaged.
    LagTable touching(1), settled(1);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            touching.at(x, y).assign(kinds * kinds, 0.0);
            touching.at(x, y)[0] = 1;
            settled.at(x, y).assign(kinds * kinds, 0.0);
        }
    }
    for (int round = 0; round < kRounds; ++round) {
        LagTable children(1);
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                Pairs& pairs = children.at(x, y);
                pairs = pairs_of_children(
                    next, x, y, [&](int px, int py) -> const Pairs& { return touching.at(px, py); });
                if (round < kRounds / 2) continue;
                for (std::size_t k = 0; k < pairs.size(); ++k)
                    settled.at(x, y)[k] += pairs[k] / (kRounds - kRounds / 2);
            }
        }
        touching = std::move(children);
    }

    // Nothing is asked again of lags beyond half of the longest.
    LagTable table(std::max((lags + 1) / 2, 1));
    std::vector<double> highest;
    for (int lag = 1; lag <= lags; ++lag) {
        double most = 0;
        for (int y = -lag; y <= lag; ++y) {
            for (int x = -lag; x <= lag; ++x) {
                if (std::max(std::abs(x), std::abs(y)) != lag) continue;
                Pairs pairs = lag == 1 ? settled.at(x, y)
                                       : pairs_of_children(next, x, y, [&](int px, int py) -> const Pairs& {
                                             return table.at(px, py);
                                         });
                double equal = 0;
                for (std::size_t k = 0; k < kinds; ++k) equal += pairs[k * (kinds + 1)];
                most = std::max(most, equal);
                if (lag <= std::max((lags + 1) / 2, 1)) table.at(x, y) = std::move(pairs);
            }
        }
        highest.push_back(most);
    }
    return highest;
}

double page_coincidence(const NextKinds& next, int divisions) {
    std::size_t side = 1;
    std::vector<std::uint16_t> page{0};
    for (int i = 0; i < divisions; ++i) {
        std::vector<std::uint16_t> finer(4 * page.size());
        for (std::size_t y = 0; y < 2 * side; ++y)
            for (std::size_t x = 0; x < 2 * side; ++x)
                finer[y * 2 * side + x] = next[page[y / 2 * side + x / 2]][y % 2 * 2 + x % 2];
        page = std::move(finer);
        side *= 2;
    }
    std::size_t most = 0;
    for (std::size_t move = 1; move < page.size(); ++move) {
        std::size_t alike = 0;
        for (std::size_t i = 0; i < page.size(); ++i) {
            const std::size_t x = (i + move) % side, y = (i / side + move / side) % side;
            alike += page[i] == page[y * side + x];
        }
        most = std::max(most, alike);
    }
    return static_cast<double>(most) / static_cast<double>(page.size());
}

}  // namespace dapple
