#include "core/image/tone.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/image/detail.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

// One light value through the tone's settings, as the light that is to be seen.
float toned(float light, const Tone& tone) {
    float v = linear_to_srgb(light);
    v = (v - tone.black_point) / std::max(tone.white_point - tone.black_point, 1e-4f);
    v = std::clamp(v, 0.0f, 1.0f);
    // A straight line about mid-grey: level at -1, upright at 1.
    const float slope = portable::tan((std::min(tone.contrast, 0.999f) + 1) * std::numbers::pi_v<float> / 4);
    v = std::clamp((v - 0.5f) * slope + 0.5f + tone.brightness, 0.0f, 1.0f);
    v = portable::pow(v, 1 / tone.gamma);
    return srgb_to_linear(v);
}

// The share of paper that ink covers, for that light to be seen.
float ink_for(float light, const Tone& tone) {
    return tone.invert ? light : 1 - light;
}

// Values at equal steps of the square root of light, along which tone curves bend least.
class ToneCurve {
 public:
    // `value_of` takes the square root.
    template <class ValueOf>
    explicit ToneCurve(const ValueOf& value_of) {
        for (int i = 0; i <= kSteps; ++i) value_[i] = value_of(static_cast<float>(i) / kSteps);
        value_[kSteps + 1] = value_[kSteps];
    }

    float operator()(float light) const {
        // In this order NaN becomes white, and neither step is a branch.
        const float at_most_1 = light < 1 ? light : 1.0f;
        const float clamped = at_most_1 > 0 ? at_most_1 : 0.0f;
        const float at = std::sqrt(clamped) * kSteps;
        const int i = static_cast<int>(at);
        return value_[i] + (value_[i + 1] - value_[i]) * (at - static_cast<float>(i));
    }

 private:
    static constexpr int kSteps = 4096;
    std::array<float, kSteps + 2> value_;
};

}  // namespace

float srgb_to_linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : portable::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * portable::pow(linear, 1 / 2.4f) - 0.055f;
}

namespace {

std::uint8_t rounded_srgb(float linear) {
    return static_cast<std::uint8_t>(std::lround(linear_to_srgb(linear) * 255.0f));
}

// The byte of each light in steps so small that one byte more at most is reached within a step, and the light
// from which each byte is reached.
class SrgbBytes {
 public:
    SrgbBytes() {
        for (int i = 0; i <= kSteps; ++i)
            below_[i] = rounded_srgb(static_cast<float>(i) / static_cast<float>(kSteps));
        // The bits of floats from 0 on are ordered as they are.
        for (int byte = 1; byte < 256; ++byte) {
            std::uint32_t too_dark = 0, enough = std::bit_cast<std::uint32_t>(1.0f);
            while (enough - too_dark > 1) {
                const std::uint32_t middle = too_dark + (enough - too_dark) / 2;
                (rounded_srgb(std::bit_cast<float>(middle)) >= byte ? enough : too_dark) = middle;
            }
            least_[byte] = std::bit_cast<float>(enough);
        }
        least_[256] = std::numeric_limits<float>::infinity();
    }
    std::uint8_t operator()(float linear) const {
        const float light = linear > 0 ? std::min(linear, 1.0f) : 0.0f;
        const int byte = below_[static_cast<std::size_t>(light * kSteps)];
        return static_cast<std::uint8_t>(byte + (light >= least_[byte + 1] ? 1 : 0));
    }

 private:
    static constexpr int kSteps = 4096;
    std::array<std::uint8_t, kSteps + 1> below_;
    std::array<float, 257> least_{};
};

}  // namespace

std::uint8_t srgb_byte(float linear) {
    static const SrgbBytes bytes;
    return bytes(linear);
}

namespace {

Grid<float> through_curve(Grid<float> light, const Tone& tone, const ToneCurve& curve) {
    if (tone.blur > 0) {
        for (float& v : light.values)
            v = v < 1 ? (v > 0 ? v : 0.0f) : 1.0f;  // clamped as below: NaN would spread
        light = blurred(std::move(light), tone.blur / 1000.0 * std::max(light.width, light.height));
    }
    tbb::parallel_for(0, light.height, [&](int y) {
        float* const row = light.row(y);
        for (int x = 0; x < light.width; ++x) row[x] = curve(row[x]);
    });
    return light;
}

}  // namespace

Grid<float> density_of(Grid<float> light, const Tone& tone, const InkCurve& ink) {
    return through_curve(std::move(light), tone, ToneCurve([&](float root) {
                             return ink.density_for(ink_for(toned(root * root, tone), tone));
                         }));
}

Grid<float> toned_light(Grid<float> light, const Tone& tone) {
    return through_curve(std::move(light), tone,
                         ToneCurve([&](float root) { return toned(root * root, tone); }));
}

}  // namespace dapple
