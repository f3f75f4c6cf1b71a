#include "core/placing/dots.h"

#include <sys/mman.h>
#include <algorithm>
#include <cmath>

#include "core/image/density.h"

#if defined(DAPPLE_LINUX)
#endif

namespace dapple {

namespace {

constexpr std::align_val_t kHugePage{2 << 20};

}  // namespace

void* allocate_large(std::size_t bytes) {
    void* const memory = ::operator new(bytes, kHugePage);
#if defined(DAPPLE_LINUX)
    madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: without, it is memory as well
#endif
    return memory;
}

void deallocate_large(void* memory) {
    ::operator delete(memory, kHugePage);
}

void Dots::resize(std::size_t count, bool thresholds) {
    for (FloatBuffer* column : {&x, &y}) column->resize(count);
    for (FloatBuffer* column : {&threshold, &critical}) column->resize(thresholds ? count : 0);
    radius.clear();
}

void Dots::reserve(std::size_t count, bool thresholds) {
    for (FloatBuffer* column : {&x, &y}) column->reserve(count);
    if (!thresholds) return;
    for (FloatBuffer* column : {&threshold, &critical}) column->reserve(count);
}

void append(Dots& to, const Dots& more) {
    for (const auto column : kDotColumns)
        (to.*column).insert((to.*column).end(), (more.*column).begin(), (more.*column).end());
}

std::size_t DotPieces::size() const {
    std::size_t count = 0;
    for (const Dots& piece : pieces) count += piece.size();
    return count;
}

DotPieces in_one_piece(Dots dots) {
    DotPieces result;
    result.pieces.push_back(std::move(dots));
    return result;
}

TileRank tile_rank_of(float threshold, std::size_t tile_size) {
    double rank = threshold * kDotsPerScale;
    const auto n = static_cast<double>(tile_size);
    int level = 0;
    for (; rank >= (level == 0 ? n : 4 * n); ++level) {
        if (level > 0) rank /= 4;
    }
    return {level, static_cast<int>(rank)};
}

TileRank figure8_rank_of(float threshold, std::size_t tile_size) {
    const int level = tile_rank_of(threshold, tile_size).level, n = static_cast<int>(tile_size);
    const double rank = (std::ldexp(threshold * kDotsPerScale, 2 * (1 - level)) - n) / 3;
    return {level, std::clamp(static_cast<int>(rank), 0, n - 1)};
}

}  // namespace dapple
