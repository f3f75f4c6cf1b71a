// Sixteen points at a time. Compiled for AVX-512F: called only after the processor was asked.

#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include "core/placing/kernel.h"

namespace {

constexpr std::size_t kWidth = 16;

struct Lanes {
    __m512 v;
    explicit Lanes(float f) : v(_mm512_set1_ps(f)) {}
    explicit Lanes(__m512 w) : v(w) {}
    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(_mm512_add_ps(a.v, b.v)); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(_mm512_sub_ps(a.v, b.v)); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(_mm512_mul_ps(a.v, b.v)); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(_mm512_div_ps(a.v, b.v)); }
    friend __mmask16 operator>(Lanes a, Lanes b) { return _mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ); }
};
using Mask = __mmask16;

inline unsigned bits_of(Mask m) {
    return m;
}
inline Mask both(Mask a, Mask b) {
    return static_cast<Mask>(a & b);
}
inline Mask without(Mask a, Mask b) {
    return static_cast<Mask>(a & ~b);
}

struct Square4 {
    Lanes v00, v10, v01, v11;
};

inline Lanes load(const float* p) {
    return Lanes(_mm512_loadu_ps(p));
}
inline void store(float* p, Lanes a) {
    _mm512_storeu_ps(p, a.v);
}
inline void pack(float* p, Lanes a, Mask keep) {
    // To a register, then whole to memory: compressing straight to memory is very slow on some processors.
    _mm512_storeu_ps(p, _mm512_maskz_compress_ps(keep, a.v));
}
struct Whole {
    __m512i v;
};
inline Whole operator-(Whole a, int b) {
    return {_mm512_sub_epi32(a.v, _mm512_set1_epi32(b))};
}

struct PixelPosition {
    Whole pixel;  // rounded down; positions are not negative, so that this is cutting off
    Lanes fraction;
};
inline PixelPosition pixel_position(double centre, double half, Lanes point) {
    struct Eight {
        __m256i pixel;
        __m256 fraction;
    };
    const auto eight = [&](__m256 points) {
        const __m512d offset = _mm512_mul_pd(_mm512_set1_pd(half), _mm512_cvtps_pd(points));
        const __m512d position = _mm512_add_pd(_mm512_set1_pd(centre), offset);
        const __m256i pixel = _mm512_cvttpd_epi32(position);
        return Eight{pixel, _mm512_cvtpd_ps(_mm512_sub_pd(position, _mm512_cvtepi32_pd(pixel)))};
    };
    const __m256d upper_half = _mm512_extractf64x4_pd(_mm512_castps_pd(point.v), 1);
    const Eight low = eight(_mm512_castps512_ps256(point.v)), high = eight(_mm256_castpd_ps(upper_half));
    const __m512d fractions = _mm512_insertf64x4(_mm512_castps_pd(_mm512_castps256_ps512(low.fraction)),
                                                 _mm256_castps_pd(high.fraction), 1);
    return {{_mm512_inserti64x4(_mm512_castsi256_si512(low.pixel), high.pixel, 1)},
            Lanes(_mm512_castpd_ps(fractions))};
}

struct Block {
    __m512 pixels;  // four rows of four
};
inline Block load_block(const float* pixels) {
    return {_mm512_loadu_ps(pixels)};
}
inline Square4 from_block(const dapple::KernelSquare& s, const Block& block, Whole left, Whole top) {
    const Whole row = top - s.first_row, column = left - s.first_column;
    const __m512i at = _mm512_add_epi32(_mm512_slli_epi32(row.v, 2), column.v);
    const auto pixel = [&](int further) {
        return Lanes(_mm512_permutexvar_ps(_mm512_add_epi32(at, _mm512_set1_epi32(further)), block.pixels));
    };
    return {pixel(0), pixel(1), pixel(4), pixel(5)};
}

// Pixel by pixel: gathering takes longer. The two rows' pairs of four points at a time, then their transpose.
inline Square4 from_picture(const dapple::KernelSquare& s, Whole left, Whole top) {
    const __m512i row = _mm512_mullo_epi32((top - 1).v, _mm512_set1_epi32(s.width));
    alignas(64) std::uint32_t at[kWidth];
    _mm512_store_si512(at, _mm512_add_epi32(row, (left - 1).v));
    const float* const upper = s.picture;
    const float* const lower = s.picture + s.width;
    const auto around = [&](int lane) {
        const __m128i pair = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(upper + at[lane]));
        return _mm_loadh_pi(_mm_castsi128_ps(pair), reinterpret_cast<const __m64*>(lower + at[lane]));
    };
    const auto around_four = [&](int first) {
        __m512 four = _mm512_castps128_ps512(around(first));
        four = _mm512_insertf32x4(four, around(first + 4), 1);
        four = _mm512_insertf32x4(four, around(first + 8), 2);
        return _mm512_insertf32x4(four, around(first + 12), 3);
    };
    const __m512 a = around_four(0), b = around_four(1), c = around_four(2), d = around_four(3);
    const __m512 upper_ab = _mm512_unpacklo_ps(a, b), lower_ab = _mm512_unpackhi_ps(a, b);
    const __m512 upper_cd = _mm512_unpacklo_ps(c, d), lower_cd = _mm512_unpackhi_ps(c, d);
    constexpr int kLeft = 0x44, kRight = 0xEE;
    return {Lanes(_mm512_shuffle_ps(upper_ab, upper_cd, kLeft)),
            Lanes(_mm512_shuffle_ps(upper_ab, upper_cd, kRight)),
            Lanes(_mm512_shuffle_ps(lower_ab, lower_cd, kLeft)),
            Lanes(_mm512_shuffle_ps(lower_ab, lower_cd, kRight))};
}
inline __m512i clamped(__m512i i, int count) {
    return _mm512_min_epi32(_mm512_max_epi32(i, _mm512_setzero_si512()), _mm512_set1_epi32(count - 1));
}
inline Square4 from_clamped(const dapple::KernelSquare& s, Whole left, Whole top) {
    const __m512i one = _mm512_set1_epi32(1), width = _mm512_set1_epi32(s.width);
    const __m512i column = (left - 1).v, row = (top - 1).v;
    const __m512i x0 = clamped(column, s.width), x1 = clamped(_mm512_add_epi32(column, one), s.width);
    const __m512i y0 = _mm512_mullo_epi32(clamped(row, s.height), width);
    const __m512i y1 = _mm512_mullo_epi32(clamped(_mm512_add_epi32(row, one), s.height), width);
    const auto pixel = [&](__m512i y, __m512i x) {
        return Lanes(_mm512_i32gather_ps(_mm512_add_epi32(y, x), s.picture, 4));
    };
    return {pixel(y0, x0), pixel(y0, x1), pixel(y1, x0), pixel(y1, x1)};
}

}  // namespace

#include "core/placing/kernel_body.h"

namespace dapple {

extern const Kernels kAvx512Kernels;
const Kernels kAvx512Kernels{"avx512", place_certain, place_square};

}  // namespace dapple
