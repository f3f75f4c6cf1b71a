// One point at a time: any processor.

#include <cstddef>
#include <cstdint>

#include "core/placing/kernel.h"

namespace {

constexpr std::size_t kWidth = 1;

struct Lanes {
    float v;
    explicit Lanes(float f) : v(f) {}
    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
    friend bool operator>(Lanes a, Lanes b) { return a.v > b.v; }
};
using Mask = bool;

inline unsigned bits_of(Mask m) {
    return m ? 1 : 0;
}
inline Mask both(Mask a, Mask b) {
    return a && b;
}
inline Mask without(Mask a, Mask b) {
    return a && !b;
}

struct Square4 {
    Lanes v00, v10, v01, v11;
};

inline Lanes load(const float* p) {
    return Lanes(*p);
}
inline void store(float* p, Lanes a) {
    *p = a.v;
}
inline void pack(float* p, Lanes a, Mask) {
    *p = a.v;
}
using Whole = std::int32_t;

struct PixelPosition {
    Whole pixel;  // rounded down; positions are not negative, so that this is cutting off
    Lanes fraction;
};
inline PixelPosition pixel_position(double centre, double half, Lanes point) {
    const double position = centre + half * static_cast<double>(point.v);
    const auto pixel = static_cast<Whole>(position);
    return {pixel, Lanes(static_cast<float>(position - pixel))};
}

struct Block {
    const float* pixels;
};
inline Block load_block(const float* pixels) {
    return {pixels};
}
inline Square4 from_block(const dapple::KernelSquare& s, const Block& block, Whole left, Whole top) {
    // A position rounded up to the last pixel has a neighbour beyond, of no weight.
    const Whole at = (top - s.first_row) * 4 + left - s.first_column;
    const auto pixel = [&](Whole i) { return Lanes(block.pixels[i & 15]); };
    return {pixel(at), pixel(at + 1), pixel(at + 4), pixel(at + 5)};
}
inline Square4 from_picture(const dapple::KernelSquare& s, Whole left, Whole top) {
    const float* p = s.picture + static_cast<std::int64_t>(top - 1) * s.width + (left - 1);
    return {Lanes(p[0]), Lanes(p[1]), Lanes(p[s.width]), Lanes(p[s.width + 1])};
}
inline Whole clamped(Whole i, int count) {
    return i < 0 ? 0 : i < count ? i : count - 1;
}
inline Square4 from_clamped(const dapple::KernelSquare& s, Whole left, Whole top) {
    const Whole x0 = clamped(left - 1, s.width), x1 = clamped(left, s.width);
    const float* row0 = s.picture + static_cast<std::int64_t>(clamped(top - 1, s.height)) * s.width;
    const float* row1 = s.picture + static_cast<std::int64_t>(clamped(top, s.height)) * s.width;
    return {Lanes(row0[x0]), Lanes(row0[x1]), Lanes(row1[x0]), Lanes(row1[x1])};
}

}  // namespace

#include "core/placing/kernel_body.h"

namespace dapple {

const Kernels kPlainKernels{"plain", place_certain, place_square};

}  // namespace dapple
