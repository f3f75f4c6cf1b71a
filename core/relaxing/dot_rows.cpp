#include "core/relaxing/dot_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/placing/pieces.h"

namespace dapple {

namespace {

constexpr std::int64_t kRowsAtOnce = 16;  // sorted by a thread before it asks for more

std::int64_t row_of(float y) {
    return static_cast<std::int64_t>(y);
}

}  // namespace

void DotRows::assign(const DotPieces& dots, int depth, int threads) {
    Positions from_x, from_y;
    from_x.reserve(dots.size());
    from_y.reserve(dots.size());
    for (const Dots& piece : dots.pieces) {
        from_x.insert(from_x.end(), piece.x.begin(), piece.x.end());
        from_y.insert(from_y.end(), piece.y.begin(), piece.y.end());
    }
    const auto rows_per_unit = static_cast<float>(std::ldexp(1.0, depth));
    for (Positions* positions : {&from_x, &from_y})
        for (float& position : *positions) position *= rows_per_unit;
    numbers.resize(from_x.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint32_t>(i);
    sort_into_rows(from_x, from_y, threads);
}

void DotRows::move(Positions& to_x, Positions& to_y, int threads) {
    sort_into_rows(to_x, to_y, threads);
}

void DotRows::sort_into_rows(Positions& from_x, Positions& from_y, int threads) {
    const std::size_t count = from_x.size();
    x.resize(count);
    y.resize(count);
    begins_.assign(1, 0);
    if (count == 0) return;
    const auto [low, high] = std::ranges::minmax(from_y);
    first_row_ = row_of(low);
    begins_.assign(static_cast<std::size_t>(row_of(high) - first_row_) + 2, 0);
    for (const float position : from_y)
        ++begins_[static_cast<std::size_t>(row_of(position) - first_row_) + 1];
    for (std::size_t row = 1; row < begins_.size(); ++row) begins_[row] += begins_[row - 1];

    from_numbers_.swap(numbers);
    numbers.resize(count);
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t to = next[static_cast<std::size_t>(row_of(from_y[i]) - first_row_)]++;
        x[to] = from_x[i];
        y[to] = from_y[i];
        numbers[to] = from_numbers_[i];
    }

    // Each row by x: non-negative floats are ordered as their bits are.
    const std::int64_t stretches = (rows() + kRowsAtOnce - 1) / kRowsAtOnce;
    for_each_on_threads(static_cast<std::size_t>(stretches), threads_for(threads), [&](std::size_t stretch) {
        std::vector<std::uint64_t> keys;
        const std::int64_t first = static_cast<std::int64_t>(stretch) * kRowsAtOnce;
        for (std::int64_t row = first; row < std::min(first + kRowsAtOnce, rows()); ++row) {
            const std::size_t at = begin(row), length = end(row) - at;
            keys.resize(length);
            for (std::size_t i = 0; i < length; ++i)
                keys[i] = std::uint64_t{std::bit_cast<std::uint32_t>(x[at + i])} << 32 | i;
            std::ranges::sort(keys, [&](std::uint64_t a, std::uint64_t b) {
                if (a >> 32 != b >> 32) return a < b;
                return y[at + static_cast<std::uint32_t>(a)] < y[at + static_cast<std::uint32_t>(b)];
            });
            // Through the places that they came from, which nobody reads any more.
            for (std::size_t i = 0; i < length; ++i) {
                const std::size_t from = at + static_cast<std::uint32_t>(keys[i]);
                from_x[at + i] = x[from];
                from_y[at + i] = y[from];
                from_numbers_[at + i] = numbers[from];
            }
        }
    });
    x.swap(from_x);
    y.swap(from_y);
    numbers.swap(from_numbers_);
}

}  // namespace dapple
