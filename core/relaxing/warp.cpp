#include "core/relaxing/warp.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

#include "core/image/detail.h"

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

namespace {

constexpr float kCellsApart = 3;  // from dot to dot, on the mean
constexpr int kMostCells = 2048;  // along a side, about
constexpr float kBlur = 1;        // mean spacings

// The curve is vertical at black, where more and more dots would be sent for a last bit of light.
constexpr float kMostAtOnce = 0.3f;  // of what there should be
constexpr float kLeastLight = 0.004f, kFadeOfLight = 0.03f;
constexpr int kStepsOfLight = 4096;

constexpr float kLeastWarpedDensity = 0.03f;  // of the mean: sparse dots are not sent far

constexpr float kWhole = 1 << 10;  // counts of dots are in so many parts: sums do not depend on their order

// The sum of body(row) over all rows, in their order.
template <class Body>
double sum_over_rows(int rows, const Body& body) {
    std::vector<double> sums(static_cast<std::size_t>(rows));
    for_each_row(rows, [&](int y) { sums[static_cast<std::size_t>(y)] = body(y); });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double sum_of_row(const Grid<float>& grid, int y) {
    return std::accumulate(grid.row(y), grid.row(y) + grid.width, 0.0);
}

// What a density's pixels bring to one of so many cells along an axis: the mean of what it covers, or where
// it is smaller than a pixel, between two of them.
struct Taps {
    int first;
    std::vector<float> shares;

    Taps(int cell, int cells, int pixels, bool between) {
        const double side = static_cast<double>(pixels) / cells, from = cell * side, to = from + side;
        if (side < 1 && between) {
            const double at = std::clamp((from + to) / 2 - 0.5, 0.0, pixels - 1.0);
            first = static_cast<int>(at);
            const auto next = static_cast<float>(at - first);
            shares = {1 - next};
            if (next > 0) shares.push_back(next);
            return;
        }
        first = std::min(static_cast<int>(from), pixels - 1);
        for (int pixel = first; pixel < std::min(pixels, static_cast<int>(std::ceil(to))); ++pixel)
            shares.push_back(static_cast<float>(
                std::max(std::min(to, pixel + 1.0) - std::max(from, static_cast<double>(pixel)), 0.0) /
                side));
    }
};

// A place between the middles of four cells, and their shares in it.
struct Between {
    int column, row, right, below;
    float across, down;

    Between(float x, float y, int width, int height) {
        x = std::clamp(x, 0.0f, static_cast<float>(width - 1));
        y = std::clamp(y, 0.0f, static_cast<float>(height - 1));
        column = static_cast<int>(x);
        row = static_cast<int>(y);
        right = std::min(column + 1, width - 1);
        below = std::min(row + 1, height - 1);
        across = x - static_cast<float>(column);
        down = y - static_cast<float>(row);
    }

    float of(const Grid<float>& grid) const {
        const float *const upper = grid.row(row), *const lower = grid.row(below);
        const float above = upper[column] + across * (upper[right] - upper[column]);
        const float under = lower[column] + across * (lower[right] - lower[column]);
        return above + down * (under - above);
    }
};

}  // namespace

glm::vec2 Displacement::at(float x, float y) const {
    if (across_.empty()) return glm::vec2(0);
    x /= cell_.x;
    y /= cell_.y;
    return {Between(x, y - 0.5f, across_.width, across_.height).of(across_),
            Between(x - 0.5f, y, down_.width, down_.height).of(down_)};
}

Warp::Warp(const Density& density, const WarpRequest& request)
    : page_(density, request.scale), ink_(request.ink), cut_off_(request.cut_off) {
    spacing_ = std::sqrt(page_.width * page_.height / static_cast<float>(std::max(request.dots, 1.0)));
    const float longer = std::max(page_.width, page_.height);
    const float side = std::max(spacing_ / kCellsApart, longer / kMostCells);
    width_ = cells_along(static_cast<double>(page_.width / side));
    height_ = cells_along(static_cast<double>(page_.height / side));
    cell_ = {page_.width / static_cast<float>(width_), page_.height / static_cast<float>(height_)};
    if (ink_) {
        radius_ =
            static_cast<float>(std::ldexp(radius_for_tone(request.scale, ink_->full_load()), page_.depth));
        for (int i = 0; i <= kStepsOfLight; ++i)
            loads_.push_back(ink_->load(ink_->density(1 - static_cast<float>(i) / kStepsOfLight)));
        loads_.push_back(loads_.back());
    }
    wanted_ = wanted(density, request.areas);
    if (!ink_) return;
    most_ = wanted_;
    take_loads(wanted_);
    for_each_row(height_, [&](int y) {
        float* const most = most_.row(y);
        const float* const load = wanted_.row(y);
        for (int x = 0; x < width_; ++x)
            most[x] = kMostAtOnce * load[x] * std::clamp((most[x] - kLeastLight) / kFadeOfLight, 0.0f, 1.0f);
    });
}

// Light, or dots in a cell, blurred.
Grid<float> Warp::wanted(const Density& density, const DotAreas& areas) const {
    const Grid<float>& values = density.values();
    const double longer = density.longer_side();
    const float on_black = cell_.x * cell_.y / (page_.spacing * page_.spacing);
    const bool between = density.reading() == Reading::bilinear;
    std::vector<Taps> across, down;
    for (int x = 0; x < width_; ++x) across.emplace_back(x, width_, values.width, between);
    for (int y = 0; y < height_; ++y) down.emplace_back(y, height_, values.height, between);
    const auto ink_of = [&](float value, int x, int y) {
        if (!areas.differ()) return ink_ ? 1 - ink_->coverage(value) : on_black * value;
        const glm::dvec2 place = glm::dvec2(x + 0.5, y + 0.5) / longer;
        return ink_ ? 1 - ink_->coverage(areas.of_tone(value, place))
                    : on_black * value * areas.at(value, place);
    };
    Grid<float> inks(values.width, values.height);
    for_each_row(values.height, [&](int y) {
        const float* const from = values.row(y);
        float* const to = inks.row(y);
        for (int x = 0; x < values.width; ++x) to[x] = ink_of(from[x], x, y);
    });
    Grid<float> cells(width_, height_);
    for_each_row(height_, [&](int y) {
        const Taps& taps = down[static_cast<std::size_t>(y)];
        std::vector<float> line(static_cast<std::size_t>(values.width));
        for (std::size_t k = 0; k < taps.shares.size(); ++k) {
            const float* const from = inks.row(taps.first + static_cast<int>(k));
            for (std::size_t x = 0; x < line.size(); ++x) line[x] += taps.shares[k] * from[x];
        }
        float* const to = cells.row(y);
        for (int x = 0; x < width_; ++x) {
            const Taps& columns = across[static_cast<std::size_t>(x)];
            for (std::size_t i = 0; i < columns.shares.size(); ++i)
                to[x] += columns.shares[i] * line[static_cast<std::size_t>(columns.first) + i];
        }
    });
    return blurred(std::move(cells), static_cast<double>(kBlur * spacing_ / cell_.x));
}

// From light to the load that leaves it.
void Warp::take_loads(Grid<float>& light) const {
    for_each_row(height_, [&](int y) {
        float* const row = light.row(y);
        for (int x = 0; x < width_; ++x) {
            const float at = kStepsOfLight * std::clamp(row[x], 0.0f, 1.0f);
            const auto i = static_cast<std::size_t>(at);
            row[x] = loads_[i] + (at - static_cast<float>(i)) * (loads_[i + 1] - loads_[i]);
        }
    });
}

Grid<float> Warp::light_of(const DotRows& dots) const {
    constexpr int kAtOnce = 16;  // rows of cells
    Grid<float> light(width_, height_);
    const glm::vec2 bit = cell_ / static_cast<float>(CoveredBits::kSide);
    tbb::parallel_for(0, (height_ + kAtOnce - 1) / kAtOnce, [&](int stretch) {
        const int first = stretch * kAtOnce, end = std::min(first + kAtOnce, height_);
        const float top = static_cast<float>(first) * cell_.y, bottom = static_cast<float>(end) * cell_.y;
        const auto begin_at = [&](float y) {
            const auto row = static_cast<std::int64_t>(std::floor(y)) - dots.first_row();
            return dots.begin(std::clamp<std::int64_t>(row, 0, dots.rows()));
        };
        CoveredBits bits(width_, end - first);
        for (std::size_t i = begin_at(top - radius_); i < begin_at(bottom + radius_ + 1); ++i) {
            const float radius = dots.areas.empty() ? radius_ : radius_ * std::sqrt(dots.areas[i]);
            bits.cover(glm::vec2(dots.x[i], dots.y[i] - top) / bit, radius / bit);
        }
        for (int y = first; y < end; ++y) bits.bare(y - first, light.row(y));
    });
    return light;
}

Displacement Warp::displacement(const DotRows& dots) const {
    if (ink_) return displacement_for(light_of(dots));
    Count count(*this);
    for (std::size_t i = 0; i < dots.size(); ++i)
        count.add(dots.x[i], dots.y[i], dots.areas.empty() ? 1 : dots.areas[i]);
    return count.displacement();
}

Displacement Warp::displacement_for(Grid<float> excess) const {
    excess = blurred(std::move(excess), static_cast<double>(kBlur * spacing_ / cell_.x));
    if (ink_) take_loads(excess);
    const double all = sum_over_rows(height_, [&](int y) { return sum_of_row(wanted_, y); });
    // Counted dots are as many as they are.
    const double present = ink_ ? all : sum_over_rows(height_, [&](int y) { return sum_of_row(excess, y); });
    const auto times = static_cast<float>(present / std::max(all, 1e-30));
    const double too_much = sum_over_rows(height_, [&](int y) {
        const float away_y =
            std::min(static_cast<float>(y) + 0.5f, static_cast<float>(height_ - y) - 0.5f) * cell_.y;
        float* const r = excess.row(y);
        const float* const wanted = wanted_.row(y);
        for (int x = 0; x < width_; ++x) {
            r[x] -= times * wanted[x];
            if (ink_) r[x] = std::clamp(r[x], -most_.row(y)[x], most_.row(y)[x]);
            if (cut_off_) continue;
            const float away_x =
                std::min(static_cast<float>(x) + 0.5f, static_cast<float>(width_ - x) - 0.5f) * cell_.x;
            r[x] *= std::min(std::min(away_x, away_y) / spacing_, 1.0f);
        }
        return sum_of_row(excess, y);
    });
    const auto share = static_cast<float>(too_much / std::max(all, 1e-30));
    for_each_row(height_, [&](int y) {
        for (int x = 0; x < width_; ++x) excess.row(y)[x] -= share * wanted_.row(y)[x];
    });
    const Grid<float> phi = poisson(std::move(excess), cell_);
    const auto least = static_cast<float>(static_cast<double>(kLeastWarpedDensity) * all / width_ / height_);
    const auto through = [&](float from, float to, float one, float other, float length) {
        return (to - from) / (length * times * std::max((one + other) / 2, least));
    };
    Grid<float> across(width_ + 1, height_), down(width_, height_ + 1);
    for_each_row(height_, [&](int y) {
        const float *const here = phi.row(y), *const wanted = wanted_.row(y);
        for (int x = 1; x < width_; ++x)
            across.row(y)[x] = through(here[x - 1], here[x], wanted[x - 1], wanted[x], cell_.x);
        if (y == 0) return;
        const float *const above = phi.row(y - 1), *const wanted_above = wanted_.row(y - 1);
        for (int x = 0; x < width_; ++x)
            down.row(y)[x] = through(above[x], here[x], wanted_above[x], wanted[x], cell_.y);
    });
    return {std::move(across), std::move(down), cell_};
}

Warp::Count::Count(const Warp& warp)
    : warp_(warp), sums_(static_cast<std::size_t>(warp.width_) * static_cast<std::size_t>(warp.height_)) {}

void Warp::Count::add(float x, float y, float area) {
    const Between at(x / warp_.cell_.x - 0.5f, y / warp_.cell_.y - 0.5f, warp_.width_, warp_.height_);
    const float whole = kWhole * area;
    const auto put = [&](int column, int row, float share) {
        sums_[static_cast<std::size_t>(row) * static_cast<std::size_t>(warp_.width_) +
              static_cast<std::size_t>(column)] += static_cast<std::uint32_t>(whole * share + 0.5f);
    };
    put(at.column, at.row, (1 - at.across) * (1 - at.down));
    put(at.right, at.row, at.across * (1 - at.down));
    put(at.column, at.below, (1 - at.across) * at.down);
    put(at.right, at.below, at.across * at.down);
}

Displacement Warp::Count::displacement() const {
    Grid<float> counts(warp_.width_, warp_.height_);
    for (std::size_t i = 0; i < sums_.size(); ++i) counts.values[i] = static_cast<float>(sums_[i]) / kWhole;
    return warp_.displacement_for(std::move(counts));
}

}  // namespace dapple
