#include "core/image/ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/image/density.h"

namespace dapple {

namespace {

// Rows of coverage at loads 0, 0.1, ...: bench/coverage_tables prints them.
constexpr float kLoadStep = 0.1f;
constexpr std::size_t kLoads = 23;
using Row = std::array<float, kLoads>;

// As placed and after 1, 2 and 3 steps, at eighths of the way from one full level to the next.
constexpr std::size_t kPhases = 8;
constexpr std::array<std::array<Row, kPhases>, 4> kByLevel{{
    {{// 0
      {0.0f,    0.1002f, 0.1999f, 0.3002f, 0.3997f, 0.5f,    0.5968f, 0.6871f,
       0.7665f, 0.8323f, 0.8838f, 0.9226f, 0.95f,   0.969f,  0.9817f, 0.9892f,
       0.9938f, 0.9965f, 0.998f,  0.999f,  0.9995f, 0.9997f, 0.9999f},
      {0.0f,    0.1001f, 0.1999f, 0.2988f, 0.3962f, 0.491f,  0.5818f, 0.6675f,
       0.7451f, 0.812f,  0.867f,  0.9098f, 0.9412f, 0.9641f, 0.9789f, 0.9885f,
       0.9942f, 0.9973f, 0.9988f, 0.9995f, 0.9998f, 0.9999f, 1.0f},
      {0.0f,    0.1001f, 0.1998f, 0.2996f, 0.3957f, 0.4874f, 0.573f,  0.6523f,
       0.7255f, 0.7906f, 0.8458f, 0.8905f, 0.9252f, 0.9512f, 0.9691f, 0.9814f,
       0.9895f, 0.9941f, 0.997f,  0.9987f, 0.9994f, 0.9998f, 0.9999f},
      {0.0f,    0.1001f, 0.2001f, 0.3001f, 0.3964f, 0.4868f, 0.5709f, 0.6465f,
       0.7155f, 0.7783f, 0.8325f, 0.8779f, 0.915f,  0.9428f, 0.9627f, 0.9768f,
       0.9863f, 0.9923f, 0.9959f, 0.9979f, 0.999f,  0.9996f, 0.9998f},
      {0.0f,    0.1001f, 0.2001f, 0.2994f, 0.3977f, 0.4884f, 0.5714f, 0.6458f,
       0.7105f, 0.7692f, 0.82f,   0.8644f, 0.9015f, 0.9311f, 0.954f,  0.9706f,
       0.9821f, 0.9892f, 0.9938f, 0.9967f, 0.9982f, 0.9991f, 0.9995f},
      {0.0f,    0.1f,    0.2005f, 0.3001f, 0.3991f, 0.4932f, 0.5771f, 0.6517f,
       0.7158f, 0.7715f, 0.8189f, 0.8594f, 0.8945f, 0.9231f, 0.9465f, 0.9639f,
       0.9771f, 0.9865f, 0.9926f, 0.996f,  0.9979f, 0.999f,  0.9995f},
      {0.0f,    0.0997f, 0.2003f, 0.3004f, 0.3993f, 0.4962f, 0.5847f, 0.6613f,
       0.7264f, 0.7802f, 0.8257f, 0.8625f, 0.8929f, 0.918f,  0.9387f, 0.9558f,
       0.9694f, 0.9798f, 0.9873f, 0.9925f, 0.9959f, 0.998f,  0.999f},
      {0.0f,    0.0999f, 0.2001f, 0.3004f, 0.4004f, 0.4986f, 0.5931f, 0.6773f,
       0.7483f, 0.8063f, 0.8521f, 0.8871f, 0.9142f, 0.9343f, 0.9501f, 0.9626f,
       0.9722f, 0.9799f, 0.9861f, 0.9909f, 0.9945f, 0.9969f, 0.9983f}}},
    {{// 1
      {0.0f,    0.1001f, 0.2002f, 0.3002f, 0.3998f, 0.4999f, 0.5988f, 0.6942f,
       0.7802f, 0.8516f, 0.9062f, 0.9456f, 0.9709f, 0.9853f, 0.9932f, 0.9971f,
       0.9989f, 0.9996f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.1999f, 0.2996f, 0.3995f, 0.499f,  0.5964f, 0.6882f,
       0.7708f, 0.8409f, 0.8967f, 0.9375f, 0.9651f, 0.9823f, 0.9917f, 0.9962f,
       0.9985f, 0.9995f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1003f, 0.2002f, 0.3f,    0.3997f, 0.4992f, 0.595f,  0.6847f,
       0.7643f, 0.8309f, 0.885f,  0.9263f, 0.9555f, 0.975f,  0.9871f, 0.994f,
       0.9973f, 0.9989f, 0.9996f, 0.9998f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2001f, 0.2999f, 0.4f,    0.4993f, 0.5938f, 0.6815f,
       0.76f,   0.8259f, 0.8788f, 0.9193f, 0.9491f, 0.9699f, 0.9831f, 0.9911f,
       0.9955f, 0.9978f, 0.9991f, 0.9996f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2002f, 0.3001f, 0.3995f, 0.4981f, 0.5927f, 0.6798f,
       0.7561f, 0.8211f, 0.8738f, 0.9143f, 0.9445f, 0.9658f, 0.98f,   0.9889f,
       0.9942f, 0.9971f, 0.9987f, 0.9994f, 0.9997f, 0.9999f, 1.0f},
      {0.0f,    0.0999f, 0.2003f, 0.2996f, 0.4f,    0.4987f, 0.5925f, 0.6791f,
       0.7553f, 0.8194f, 0.872f,  0.9125f, 0.9425f, 0.9638f, 0.9788f, 0.9877f,
       0.9934f, 0.9967f, 0.9984f, 0.9993f, 0.9997f, 0.9999f, 1.0f},
      {0.0f,    0.0999f, 0.2003f, 0.3007f, 0.3996f, 0.4981f, 0.5919f, 0.6783f,
       0.7555f, 0.8204f, 0.8718f, 0.9121f, 0.9422f, 0.9631f, 0.9773f, 0.9867f,
       0.9926f, 0.9961f, 0.998f,  0.9992f, 0.9996f, 0.9999f, 1.0f},
      {0.0f,    0.0999f, 0.2f,    0.3004f, 0.4009f, 0.4995f, 0.5957f, 0.6857f,
       0.7654f, 0.8326f, 0.8855f, 0.9251f, 0.9532f, 0.9719f, 0.984f,  0.9913f,
       0.9955f, 0.9978f, 0.999f,  0.9996f, 0.9998f, 0.9999f, 1.0f}}},
    {{// 2
      {0.0f,    0.1001f, 0.2002f, 0.3002f, 0.3999f, 0.5001f, 0.5995f, 0.6972f,
       0.7858f, 0.8591f, 0.9141f, 0.9524f, 0.9759f, 0.9889f, 0.9953f, 0.9981f,
       0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.2996f, 0.4f,    0.4993f, 0.5975f, 0.6926f,
       0.7783f, 0.8505f, 0.9068f, 0.9468f, 0.9722f, 0.9867f, 0.9944f, 0.9979f,
       0.9993f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1001f, 0.1999f, 0.3f,    0.4001f, 0.4998f, 0.5975f, 0.6901f,
       0.7728f, 0.8427f, 0.8988f, 0.9394f, 0.9667f, 0.9832f, 0.9923f, 0.9967f,
       0.9988f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1003f, 0.1995f, 0.3007f, 0.3998f, 0.4994f, 0.5976f, 0.6883f,
       0.7691f, 0.8376f, 0.8928f, 0.9342f, 0.9621f, 0.9795f, 0.9901f, 0.9955f,
       0.9982f, 0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.1995f, 0.2998f, 0.4001f, 0.4995f, 0.5969f, 0.6878f,
       0.7681f, 0.8353f, 0.8891f, 0.93f,   0.9587f, 0.9774f, 0.9886f, 0.9946f,
       0.9976f, 0.999f,  0.9996f, 0.9999f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.1f,   0.1999f, 0.2998f, 0.4001f, 0.5002f, 0.5973f, 0.6889f,
       0.7685f, 0.835f, 0.8878f, 0.9283f, 0.9565f, 0.9755f, 0.9873f, 0.9938f,
       0.9973f, 0.999f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.3002f, 0.3999f, 0.4994f, 0.5974f, 0.6892f,
       0.7703f, 0.8372f, 0.89f,   0.9288f, 0.9558f, 0.974f,  0.9857f, 0.9926f,
       0.9965f, 0.9984f, 0.9995f, 0.9998f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.3001f, 0.4007f, 0.5f,  0.5988f, 0.6931f,
       0.7769f, 0.8464f, 0.8997f, 0.9383f, 0.9638f, 0.98f, 0.9893f, 0.9947f,
       0.9976f, 0.999f,  0.9996f, 0.9999f, 1.0f,    1.0f,  1.0f}}},
    {{// 3
      {0.0f,    0.1f,    0.2003f, 0.3001f, 0.4001f, 0.4999f, 0.5998f, 0.6981f,
       0.788f,  0.8628f, 0.9194f, 0.9577f, 0.9802f, 0.9916f, 0.9966f, 0.9989f,
       0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0996f, 0.1997f, 0.3f,    0.3996f, 0.4992f, 0.5988f, 0.6947f,
       0.7821f, 0.8563f, 0.9129f, 0.9521f, 0.9765f, 0.9897f, 0.9961f, 0.9987f,
       0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1999f, 0.3f,    0.4f,    0.4999f, 0.5991f, 0.6934f,
       0.7789f, 0.8503f, 0.9061f, 0.9461f, 0.9718f, 0.9866f, 0.9945f, 0.9979f,
       0.9993f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.3001f, 0.3998f, 0.5001f, 0.5989f, 0.6927f,
       0.7768f, 0.8468f, 0.9012f, 0.9414f, 0.9677f, 0.9838f, 0.9927f, 0.997f,
       0.9988f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1001f, 0.2001f, 0.2999f, 0.3997f, 0.4998f, 0.5989f, 0.6916f,
       0.7762f, 0.845f,  0.8997f, 0.9396f, 0.9663f, 0.9831f, 0.9919f, 0.9963f,
       0.9987f, 0.9995f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.1999f, 0.3f,    0.4004f, 0.5f,    0.5981f, 0.6919f,
       0.7752f, 0.845f,  0.8995f, 0.9392f, 0.966f,  0.9824f, 0.9917f, 0.9964f,
       0.9986f, 0.9995f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.2002f, 0.2999f, 0.4001f, 0.5002f, 0.5986f, 0.692f,
       0.776f,  0.8457f, 0.9003f, 0.9402f, 0.9661f, 0.982f,  0.9913f, 0.9963f,
       0.9985f, 0.9995f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1997f, 0.3007f, 0.3999f, 0.5004f, 0.5996f, 0.695f,
       0.7802f, 0.8517f, 0.9071f, 0.9464f, 0.9713f, 0.9861f, 0.9936f, 0.9975f,
       0.9991f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f}}},
}};

// From then on it is the same anywhere between two levels, within 0.008: the middle between the extremes.
struct RelaxedRow {
    int steps;
    Row coverage;
};
constexpr std::array<RelaxedRow, 6> kRelaxed{{
    {4, {0.0f,    0.1f,    0.1999f, 0.3002f, 0.4001f, 0.4999f, 0.5993f, 0.6964f,
         0.7844f, 0.858f,  0.9141f, 0.9527f, 0.9768f, 0.9894f, 0.9956f, 0.9983f,
         0.9994f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {5, {0.0f,    0.0999f, 0.1998f, 0.3001f, 0.4f,    0.4999f, 0.5995f, 0.6968f,
         0.7863f, 0.8611f, 0.9175f, 0.9562f, 0.9793f, 0.9911f, 0.9966f, 0.9988f,
         0.9996f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {7, {0.0f,    0.0998f, 0.1999f, 0.3001f, 0.4f,    0.4999f, 0.5998f, 0.698f,
         0.7889f, 0.8649f, 0.9221f, 0.9604f, 0.9825f, 0.9932f, 0.9976f, 0.9993f,
         0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {10, {0.0f,    0.0998f, 0.2001f, 0.3f,    0.3999f, 0.4998f, 0.5999f, 0.6989f,
          0.7909f, 0.8685f, 0.9261f, 0.9643f, 0.9852f, 0.9948f, 0.9985f, 0.9996f,
          1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {20, {0.0f,    0.0999f, 0.2001f, 0.2998f, 0.4f, 0.4999f, 0.6f, 0.699f, 0.7924f, 0.8718f, 0.9307f, 0.9687f,
          0.9884f, 0.9964f, 0.999f,  0.9998f, 1.0f, 1.0f,    1.0f, 1.0f,   1.0f,    1.0f,    1.0f}},
    {50, {0.0f,    0.1f,    0.2f,    0.2999f, 0.4f, 0.5001f, 0.6f, 0.6994f, 0.7946f, 0.877f, 0.9377f, 0.9746f,
          0.9923f, 0.9981f, 0.9996f, 0.9999f, 1.0f, 1.0f,    1.0f, 1.0f,    1.0f,    1.0f,   1.0f}},
}};

// Black is covered to 99.5 % and more, anywhere between two levels.
constexpr std::array<double, 5> kFullLoads{2.05, 1.7, 1.6, 1.5, 1.45};  // after so many steps; and after more

float between(const Row& row, float load) {
    const float at = std::clamp(load / kLoadStep, 0.0f, static_cast<float>(kLoads - 1));
    const auto i = std::min(static_cast<std::size_t>(at), kLoads - 2);
    return row[i] + (row[i + 1] - row[i]) * (at - static_cast<float>(i));
}

float coverage_by_level(int steps, double level, float load) {
    const double phase = (level - std::floor(level)) * kPhases;
    const auto i = std::min(static_cast<std::size_t>(phase), kPhases - 1);
    const auto& rows = kByLevel[static_cast<std::size_t>(steps)];
    const float from = between(rows[i], load), to = between(rows[(i + 1) % kPhases], load);
    return from + (to - from) * static_cast<float>(phase - static_cast<double>(i));
}

float mean_over_levels(int steps, float load) {
    float sum = 0;
    for (const Row& row : kByLevel[static_cast<std::size_t>(steps)]) sum += between(row, load);
    return sum / kPhases;
}

// Between the rows in proportion to 1 / steps, by which relaxation slows down.
float coverage_relaxed(int steps, float load) {
    const auto more =
        std::ranges::find_if(kRelaxed, [&](const RelaxedRow& row) { return row.steps >= steps; });
    if (more == kRelaxed.end()) return between(kRelaxed.back().coverage, load);
    if (more->steps == steps) return between(more->coverage, load);
    const RelaxedRow& fewer = *std::prev(more);
    const float share = (1.0f / static_cast<float>(fewer.steps) - 1.0f / static_cast<float>(steps)) /
                        (1.0f / static_cast<float>(fewer.steps) - 1.0f / static_cast<float>(more->steps));
    const float from = between(fewer.coverage, load), to = between(more->coverage, load);
    return from + (to - from) * share;
}

float coverage_of(const InkedDots& dots, double density, float load) {
    if (!depends_on_level(dots.relaxing_steps)) return coverage_relaxed(dots.relaxing_steps, load);
    if (!dots.level) return mean_over_levels(dots.relaxing_steps, load);
    return coverage_by_level(dots.relaxing_steps, *dots.level + std::log2(density) / 2, load);
}

// The load that covers as much as black does.
double load_of_black(const InkedDots& dots) {
    const double solid =
        kFullLoads[std::min(static_cast<std::size_t>(dots.relaxing_steps), kFullLoads.size() - 1)];
    if (dots.black >= 1 || dots.joined) return solid;
    double low = 0, high = solid;
    for (int i = 0; i < 30; ++i) {
        const double middle = (low + high) / 2;
        (coverage_of(dots, 1, static_cast<float>(middle)) < dots.black ? low : high) = middle;
    }
    return high;
}

}  // namespace

double level_of(double scale, std::size_t tile_size) {
    return std::log2(kDotsPerScale * scale / static_cast<double>(tile_size)) / 2;
}

bool depends_on_level(int relaxing_steps) {
    return relaxing_steps < static_cast<int>(kByLevel.size());
}

double usual_black(double dots) {
    constexpr double kFew = 5'000, kMany = 100'000, kOpen = 0.9;
    const double way = std::log(std::max(dots, 1.0) / kFew) / std::log(kMany / kFew);
    return std::round(100 * std::lerp(kOpen, 1.0, std::clamp(way, 0.0, 1.0))) / 100;
}

InkCurve::InkCurve(const InkedDots& dots) : full_load_(load_of_black(dots)), black_(float(dots.black)) {
    coverage_[0] = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const double density = static_cast<double>(i) / kSteps;
        const double area = dots.smallest_area + (1 - dots.smallest_area) * density;
        const auto load = static_cast<float>(full_load_ * density * area);
        if (dots.joined) {
            coverage_[i] = static_cast<float>(std::sqrt(density));
            continue;
        }
        // More dots cover more, which rounding in the table hides where nearly all is covered.
        coverage_[i] = std::max(coverage_of(dots, density, load), coverage_[i - 1] + 1e-6f);
    }
}

InkCurve::InkCurve(const MeasuredCoverage& measured) {
    const auto& covered = measured.coverage;
    const auto black = std::ranges::find_if(covered, [](float share) { return share >= kBlackCoverage; });
    const std::size_t last =
        black == covered.end() ? covered.size() - 1 : std::size_t(black - covered.begin());
    full_load_ = measured.load_step * double(last);
    coverage_[0] = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const float at = float(last) * float(i) / kSteps;
        const std::size_t below = std::min(std::size_t(at), last - 1);
        const float here = covered[below] + (covered[below + 1] - covered[below]) * (at - float(below));
        coverage_[i] = std::max(here, coverage_[i - 1] + 1e-6f);
    }
}

float InkCurve::coverage(float density) const {
    const float at = std::clamp(density, 0.0f, 1.0f) * kSteps;
    const int i = std::min(static_cast<int>(at), kSteps - 1);
    return coverage_[i] + (coverage_[i + 1] - coverage_[i]) * (at - static_cast<float>(i));
}

float InkCurve::opened(float ink) const {
    if (black_ >= 1) return ink;
    // A power, which bends where it is dark; the darkest tones keep three tenths of their contrast and more.
    constexpr float kHighestPower = 6, kLostContrast = 0.7f;
    const float lost = 1 - black_;
    return ink - lost * std::pow(ink, std::min(kLostContrast / lost, kHighestPower));
}

float InkCurve::density(float coverage) const {
    const auto above = std::ranges::upper_bound(coverage_, coverage);
    if (above == coverage_.begin()) return 0;
    if (above == coverage_.end()) return 1;
    const float low = *(above - 1), high = *above;
    const auto i = static_cast<float>(above - 1 - coverage_.begin());
    return (i + (coverage - low) / (high - low)) / kSteps;
}

double radius_for_tone(double scale, double full_load) {
    // At density 1 there are kDotsPerScale * scale dots on a root square of area 1.
    return std::sqrt(full_load / (std::numbers::pi * kDotsPerScale * std::max(scale, 1e-12)));
}

}  // namespace dapple
