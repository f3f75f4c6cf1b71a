// Eight points at a time. Compiled for AVX2: called only after the processor was asked.

#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include "core/placing/kernel.h"

namespace {

constexpr std::size_t kWidth = 8;

struct Lanes {
    __m256 v;
    explicit Lanes(float f) : v(_mm256_set1_ps(f)) {}
    explicit Lanes(__m256 w) : v(w) {}
    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(_mm256_add_ps(a.v, b.v)); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(_mm256_sub_ps(a.v, b.v)); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(_mm256_mul_ps(a.v, b.v)); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(_mm256_div_ps(a.v, b.v)); }
    friend unsigned operator>(Lanes a, Lanes b) {
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)));
    }
};
using Mask = unsigned;

inline unsigned bits_of(Mask m) {
    return m;
}
inline Mask both(Mask a, Mask b) {
    return a & b;
}
inline Mask without(Mask a, Mask b) {
    return a & ~b;
}

struct Square4 {
    Lanes v00, v10, v01, v11;
};

// For each of 256 masks the lanes it keeps, moved to the front.
struct PackOrder {
    alignas(32) std::uint32_t lane[256][8];
    constexpr PackOrder() : lane{} {
        for (unsigned mask = 0; mask < 256; ++mask) {
            unsigned kept = 0;
            for (unsigned i = 0; i < 8; ++i) {
                if (mask >> i & 1) lane[mask][kept++] = i;
            }
        }
    }
};
constexpr PackOrder kPackOrder;

inline Lanes load(const float* p) {
    return Lanes(_mm256_loadu_ps(p));
}
inline void store(float* p, Lanes a) {
    _mm256_storeu_ps(p, a.v);
}
inline void pack(float* p, Lanes a, Mask keep) {
    const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(kPackOrder.lane[keep]));
    _mm256_storeu_ps(p, _mm256_permutevar8x32_ps(a.v, order));
}
struct Whole {
    __m256i v;
};
inline Whole operator-(Whole a, int b) {
    return {_mm256_sub_epi32(a.v, _mm256_set1_epi32(b))};
}

struct PixelPosition {
    Whole pixel;  // rounded down; positions are not negative, so that this is cutting off
    Lanes fraction;
};
inline PixelPosition pixel_position(double centre, double half, Lanes point) {
    struct Four {
        __m128i pixel;
        __m128 fraction;
    };
    const auto four = [&](__m128 points) {
        const __m256d offset = _mm256_mul_pd(_mm256_set1_pd(half), _mm256_cvtps_pd(points));
        const __m256d position = _mm256_add_pd(_mm256_set1_pd(centre), offset);
        const __m128i pixel = _mm256_cvttpd_epi32(position);
        return Four{pixel, _mm256_cvtpd_ps(_mm256_sub_pd(position, _mm256_cvtepi32_pd(pixel)))};
    };
    const Four low = four(_mm256_castps256_ps128(point.v)), high = four(_mm256_extractf128_ps(point.v, 1));
    return {{_mm256_set_m128i(high.pixel, low.pixel)}, Lanes(_mm256_set_m128(high.fraction, low.fraction))};
}

struct Block {
    __m256 upper, lower;  // two rows of four each
};
inline Block load_block(const float* pixels) {
    return {_mm256_loadu_ps(pixels), _mm256_loadu_ps(pixels + 8)};
}
inline Lanes pixel_of(const Block& block, __m256i at) {
    const __m256 in_lower = _mm256_castsi256_ps(_mm256_slli_epi32(at, 28));  // bit 3 to the sign
    return Lanes(_mm256_blendv_ps(_mm256_permutevar8x32_ps(block.upper, at),
                                  _mm256_permutevar8x32_ps(block.lower, at), in_lower));
}
inline Square4 from_block(const dapple::KernelSquare& s, const Block& block, Whole left, Whole top) {
    const Whole row = top - s.first_row, column = left - s.first_column;
    const __m256i at = _mm256_add_epi32(_mm256_slli_epi32(row.v, 2), column.v);
    return {pixel_of(block, at), pixel_of(block, _mm256_add_epi32(at, _mm256_set1_epi32(1))),
            pixel_of(block, _mm256_add_epi32(at, _mm256_set1_epi32(4))),
            pixel_of(block, _mm256_add_epi32(at, _mm256_set1_epi32(5)))};
}

// Pixel by pixel: gathering takes longer. The two rows' pairs of four points at a time, then their transpose.
inline Square4 from_picture(const dapple::KernelSquare& s, Whole left, Whole top) {
    const __m256i row = _mm256_mullo_epi32((top - 1).v, _mm256_set1_epi32(s.width));
    alignas(32) std::uint32_t at[kWidth];
    _mm256_store_si256(reinterpret_cast<__m256i*>(at), _mm256_add_epi32(row, (left - 1).v));
    const float* const upper = s.picture;
    const float* const lower = s.picture + s.width;
    const auto around = [&](int lane) {
        const __m128i pair = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(upper + at[lane]));
        return _mm_loadh_pi(_mm_castsi128_ps(pair), reinterpret_cast<const __m64*>(lower + at[lane]));
    };
    const auto around_two = [&](int first) { return _mm256_set_m128(around(first + 4), around(first)); };
    const __m256 a = around_two(0), b = around_two(1), c = around_two(2), d = around_two(3);
    const __m256 upper_ab = _mm256_unpacklo_ps(a, b), lower_ab = _mm256_unpackhi_ps(a, b);
    const __m256 upper_cd = _mm256_unpacklo_ps(c, d), lower_cd = _mm256_unpackhi_ps(c, d);
    constexpr int kLeft = 0x44, kRight = 0xEE;
    return {Lanes(_mm256_shuffle_ps(upper_ab, upper_cd, kLeft)),
            Lanes(_mm256_shuffle_ps(upper_ab, upper_cd, kRight)),
            Lanes(_mm256_shuffle_ps(lower_ab, lower_cd, kLeft)),
            Lanes(_mm256_shuffle_ps(lower_ab, lower_cd, kRight))};
}
inline __m256i clamped(__m256i i, int count) {
    return _mm256_min_epi32(_mm256_max_epi32(i, _mm256_setzero_si256()), _mm256_set1_epi32(count - 1));
}
inline Square4 from_clamped(const dapple::KernelSquare& s, Whole left, Whole top) {
    const __m256i one = _mm256_set1_epi32(1), width = _mm256_set1_epi32(s.width);
    const __m256i column = (left - 1).v, row = (top - 1).v;
    const __m256i x0 = clamped(column, s.width), x1 = clamped(_mm256_add_epi32(column, one), s.width);
    const __m256i y0 = _mm256_mullo_epi32(clamped(row, s.height), width);
    const __m256i y1 = _mm256_mullo_epi32(clamped(_mm256_add_epi32(row, one), s.height), width);
    const auto pixel = [&](__m256i y, __m256i x) {
        return Lanes(_mm256_i32gather_ps(s.picture, _mm256_add_epi32(y, x), 4));
    };
    return {pixel(y0, x0), pixel(y0, x1), pixel(y1, x0), pixel(y1, x1)};
}

}  // namespace

#include "core/placing/kernel_body.h"

namespace dapple {

extern const Kernels kAvx2Kernels;
const Kernels kAvx2Kernels{"avx2", place_certain, place_square};

}  // namespace dapple
