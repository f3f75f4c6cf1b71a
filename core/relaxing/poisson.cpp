#include "core/relaxing/poisson.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace dapple {

namespace {

// Cells along a side of the coarsest grid: from so many to twice as many.
constexpr int kCoarsest = 4;

// One grid, and the coarser ones below it.
class Multigrid {
 public:
    Multigrid(Grid<float> excess, glm::vec2 cell)
        : across_(1 / (cell.x * cell.x)),
          down_(1 / (cell.y * cell.y)),
          excess_(std::move(excess)),
          phi_(excess_.width, excess_.height),
          other_(excess_.width, excess_.height) {
        const auto halved = [](int cells) { return cells % 2 == 0 && cells >= 2 * kCoarsest ? 2 : 1; };
        times_ = {halved(excess_.width), halved(excess_.height)};
        if (times_ != glm::ivec2(1))
            coarser_ = std::make_unique<Multigrid>(
                Grid<float>(excess_.width / times_.x, excess_.height / times_.y), cell * glm::vec2(times_));
    }

    void cycle() {
        constexpr int kSweeps = 3, kSweepsOfCoarsest = 60;
        for (int i = 0; i < (coarser_ ? kSweeps : kSweepsOfCoarsest); ++i) sweep();
        if (!coarser_) return;
        give_residual();
        coarser_->cycle();
        take_correction();
        for (int i = 0; i < kSweeps; ++i) sweep();
    }

    Grid<float> take_phi() { return std::move(phi_); }

 private:
    // Calls take(column, laplace(phi) - excess) for each cell of a row.
    template <class Take>
    void for_each_residual(int row, const Take& take) const {
        const int last = phi_.width - 1;
        const float* const here = phi_.row(row);
        const float* const above = phi_.row(std::max(row - 1, 0));
        const float* const below = phi_.row(std::min(row + 1, phi_.height - 1));
        const float* const excess = excess_.row(row);
        const auto at = [&](int x, float left, float right) {
            take(x, across_ * (left + right - 2 * here[x]) + down_ * (above[x] + below[x] - 2 * here[x]) -
                        excess[x]);
        };
        at(0, here[0], here[std::min(1, last)]);
        for (int x = 1; x < last; ++x) at(x, here[x - 1], here[x + 1]);
        if (last > 0) at(last, here[last - 1], here[last]);
    }

    // Jacobi's, damped so that waves of two to four cells go fastest.
    void sweep() {
        const float stride = 0.8f / (2 * (across_ + down_));
        for_each_row(phi_.height, [&](int y) {
            const float* const here = phi_.row(y);
            float* const to = other_.row(y);
            for_each_residual(y, [&](int x, float residual) { to[x] = here[x] + stride * residual; });
        });
        std::swap(phi_.values, other_.values);
    }

    // What is still missing becomes the coarser grid's excess: the mean of what a cell there covers.
    void give_residual() {
        const float share = -1 / static_cast<float>(times_.x * times_.y);
        for_each_row(phi_.height, [&](int y) {
            float* const to = other_.row(y);
            for_each_residual(y, [&](int x, float residual) { to[x] = share * residual; });
        });
        std::ranges::fill(coarser_->phi_.values, 0.0f);
        Grid<float>& excess = coarser_->excess_;
        for_each_row(excess.height, [&](int y) {
            float* const to = excess.row(y);
            std::fill_n(to, excess.width, 0.0f);
            for (int k = 0; k < times_.y; ++k) {
                const float* const from = other_.row(y * times_.y + k);
                if (times_.x == 1)
                    for (int x = 0; x < excess.width; ++x) to[x] += from[x];
                else
                    for (int x = 0; x < excess.width; ++x) to[x] += from[2 * x] + from[2 * x + 1];
            }
        });
    }

    // The coarser grid's answer, bilinear between its cells.
    void take_correction() {
        const Grid<float>& coarse = coarser_->phi_;
        // The cell that one lies in, and the nearest of the others along one axis.
        const auto near = [](int at, int times, int cells) {
            if (times == 1) return std::pair(at, at);
            return std::pair(at / 2, std::clamp(at / 2 + (at % 2 == 0 ? -1 : 1), 0, cells - 1));
        };
        for_each_row(phi_.height, [&](int y) {
            const auto [row, next_row] = near(y, times_.y, coarse.height);
            const float *const own = coarse.row(row), *const next = coarse.row(next_row);
            float* const to = phi_.row(y);
            for (int x = 0; x < phi_.width; ++x) {
                const auto [column, beside] = near(x, times_.x, coarse.width);
                to[x] += 0.75f * (0.75f * own[column] + 0.25f * own[beside]) +
                         0.25f * (0.75f * next[column] + 0.25f * next[beside]);
            }
        });
    }

    float across_, down_;
    Grid<float> excess_, phi_, other_;
    glm::ivec2 times_{1};  // as many cells to one of the coarser grid
    std::unique_ptr<Multigrid> coarser_;
};

}  // namespace

int cells_along(double length) {
    int halvings = 0;
    for (; length >= 2 * kCoarsest; length /= 2) ++halvings;
    return std::max(static_cast<int>(std::lround(length)), 1) << halvings;
}

Grid<float> poisson(Grid<float> excess, glm::vec2 cell, int cycles) {
    Multigrid grid(std::move(excess), cell);
    for (int i = 0; i < cycles; ++i) grid.cycle();
    return grid.take_phi();
}

}  // namespace dapple
