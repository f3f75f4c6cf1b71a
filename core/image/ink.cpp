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
      {0.0f,    0.1002f, 0.1999f, 0.2999f, 0.4003f, 0.4997f, 0.5953f, 0.6827f,
       0.759f,  0.8229f, 0.8739f, 0.9131f, 0.9416f, 0.962f,  0.976f,  0.9852f,
       0.9912f, 0.995f,  0.9973f, 0.9985f, 0.9992f, 0.9996f, 0.9998f},
      {0.0f,    0.1001f, 0.2001f, 0.2995f, 0.3982f, 0.4937f, 0.5847f, 0.6694f,
       0.7447f, 0.8093f, 0.8625f, 0.9044f, 0.9359f, 0.9586f, 0.9745f, 0.9851f,
       0.9916f, 0.9955f, 0.9977f, 0.9989f, 0.9995f, 0.9998f, 0.9999f},
      {0.0f,    0.1f,    0.2001f, 0.2996f, 0.3967f, 0.4891f, 0.5757f, 0.6561f,
       0.7292f, 0.7931f, 0.847f,  0.8904f, 0.9243f, 0.9497f, 0.9678f, 0.9804f,
       0.9885f, 0.9936f, 0.9966f, 0.9983f, 0.9992f, 0.9996f, 0.9998f},
      {0.0f,    0.1002f, 0.2f,    0.2999f, 0.3972f, 0.4883f, 0.572f, 0.6488f,
       0.7182f, 0.7801f, 0.8338f, 0.8779f, 0.9137f, 0.941f,  0.961f, 0.9752f,
       0.9849f, 0.9912f, 0.9951f, 0.9973f, 0.9986f, 0.9994f, 0.9997f},
      {0.0f,    0.1f,    0.2002f, 0.3001f, 0.3977f, 0.4896f, 0.5729f, 0.6475f,
       0.7139f, 0.7726f, 0.824f,  0.8679f, 0.904f,  0.9326f, 0.9547f, 0.9707f,
       0.9817f, 0.9891f, 0.9937f, 0.9966f, 0.9982f, 0.9991f, 0.9996f},
      {0.0f,    0.1001f, 0.2003f, 0.3003f, 0.3991f, 0.4922f, 0.577f,  0.6516f,
       0.7168f, 0.7726f, 0.821f,  0.8619f, 0.8967f, 0.9252f, 0.9478f, 0.9649f,
       0.9776f, 0.9863f, 0.992f,  0.9957f, 0.9977f, 0.9988f, 0.9994f},
      {0.0f,    0.0999f, 0.2001f, 0.3002f, 0.3999f, 0.4952f, 0.5828f, 0.6602f,
       0.7257f, 0.7813f, 0.827f,  0.8648f, 0.8962f, 0.9218f, 0.9427f, 0.9594f,
       0.9726f, 0.9822f, 0.989f,  0.9935f, 0.9965f, 0.9982f, 0.9991f},
      {0.0f,    0.0996f, 0.2003f, 0.3002f, 0.4f,    0.4981f, 0.5901f, 0.6721f,
       0.7424f, 0.8003f, 0.8469f, 0.8835f, 0.9115f, 0.9333f, 0.9503f, 0.9632f,
       0.9733f, 0.9811f, 0.9872f, 0.9917f, 0.9948f, 0.9969f, 0.9983f}}},
    {{// 1
      {0.0f,    0.1f,    0.2002f, 0.3002f, 0.4f,    0.5f,    0.5984f, 0.6925f,
       0.7764f, 0.8466f, 0.9009f, 0.9405f, 0.9668f, 0.9825f, 0.9916f, 0.9962f,
       0.9984f, 0.9994f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2f,    0.3003f, 0.3999f, 0.4994f, 0.5971f, 0.6892f,
       0.7714f, 0.8412f, 0.8964f, 0.9366f, 0.9638f, 0.981f,  0.9908f, 0.9959f,
       0.9983f, 0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2f,    0.3f,    0.4001f, 0.4989f, 0.5953f, 0.6858f,
       0.7657f, 0.8335f, 0.8877f, 0.9285f, 0.9572f, 0.976f,  0.9874f, 0.9938f,
       0.9972f, 0.9988f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.2002f, 0.2997f, 0.3997f, 0.4985f, 0.5946f, 0.683f,
       0.7617f, 0.8275f, 0.8803f, 0.9213f, 0.9511f, 0.971f,  0.984f,  0.9917f,
       0.996f,  0.9982f, 0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.1001f, 0.2f,    0.3001f, 0.3996f, 0.4987f, 0.5936f, 0.6811f,
       0.7582f, 0.823f,  0.8756f, 0.9163f, 0.9462f, 0.9671f, 0.9811f, 0.9898f,
       0.9948f, 0.9975f, 0.9988f, 0.9995f, 0.9998f, 0.9999f, 1.0f},
      {0.0f,    0.0999f, 0.2004f, 0.3004f, 0.3998f, 0.4983f, 0.5929f, 0.6804f,
       0.7569f, 0.8217f, 0.8738f, 0.9145f, 0.944f,  0.9649f, 0.9789f, 0.9881f,
       0.9936f, 0.9968f, 0.9985f, 0.9993f, 0.9997f, 0.9999f, 1.0f},
      {0.0f,    0.1001f, 0.2003f, 0.3004f, 0.4f,    0.4985f, 0.593f,  0.6805f,
       0.7578f, 0.8226f, 0.8752f, 0.9152f, 0.9446f, 0.9653f, 0.9792f, 0.9879f,
       0.9933f, 0.9966f, 0.9984f, 0.9992f, 0.9997f, 0.9999f, 0.9999f},
      {0.0f,    0.1f,    0.2f,    0.3004f, 0.3998f, 0.4995f, 0.5954f, 0.6851f,
       0.7641f, 0.8308f, 0.8839f, 0.924f,  0.9526f, 0.9715f, 0.9837f, 0.991f,
       0.9953f, 0.9976f, 0.9989f, 0.9995f, 0.9998f, 0.9999f, 1.0f}}},
    {{// 2
      {0.0f,    0.0999f, 0.1999f, 0.3001f, 0.3999f, 0.5001f, 0.5991f, 0.6938f,
       0.7789f, 0.8499f, 0.9046f, 0.944f,  0.9696f, 0.9869f, 0.9941f, 0.9976f,
       0.9991f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.1999f, 0.2998f, 0.4f,    0.4999f, 0.5982f, 0.6912f,
       0.775f,  0.8452f, 0.9007f, 0.9408f, 0.9678f, 0.9865f, 0.9941f, 0.9977f,
       0.9992f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2f,    0.2997f, 0.4f,    0.4996f, 0.597f,  0.6885f,
       0.7695f, 0.8381f, 0.893f,  0.9342f, 0.9624f, 0.9836f, 0.9925f, 0.9969f,
       0.9989f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.2002f, 0.3f,    0.3995f, 0.4992f, 0.5962f, 0.686f,
       0.7651f, 0.832f,  0.8863f, 0.9278f, 0.9574f, 0.9809f, 0.9908f, 0.996f,
       0.9985f, 0.9994f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1999f, 0.3f,    0.4002f, 0.4994f, 0.5953f, 0.6841f,
       0.762f,  0.8278f, 0.8814f, 0.9227f, 0.9525f, 0.9782f, 0.9891f, 0.995f,
       0.9979f, 0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1001f, 0.2005f, 0.3005f, 0.4f,    0.4992f, 0.5951f, 0.6839f,
       0.7616f, 0.8272f, 0.8802f, 0.9208f, 0.9501f, 0.9763f, 0.9876f, 0.994f,
       0.9973f, 0.9989f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2002f, 0.3005f, 0.4005f, 0.4988f, 0.5947f, 0.6839f,
       0.7631f, 0.8289f, 0.8818f, 0.9217f, 0.9505f, 0.9761f, 0.9872f, 0.9936f,
       0.9971f, 0.9987f, 0.9995f, 0.9998f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.0997f, 0.2005f, 0.3001f, 0.4001f, 0.5f,    0.5969f, 0.6882f,
       0.7689f, 0.8368f, 0.8901f, 0.9301f, 0.9577f, 0.9798f, 0.9893f, 0.9948f,
       0.9977f, 0.999f,  0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f}}},
    {{// 3
      {0.0f,    0.1f,    0.2f,    0.3f,    0.4001f, 0.5001f, 0.5992f, 0.6944f,
       0.7797f, 0.8509f, 0.9059f, 0.9452f, 0.9708f, 0.9898f, 0.9959f, 0.9985f,
       0.9995f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.2f,    0.2999f, 0.4001f, 0.5f,    0.5987f, 0.6923f,
       0.7766f, 0.8469f, 0.9022f, 0.9426f, 0.9691f, 0.9892f, 0.9957f, 0.9985f,
       0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1001f, 0.2001f, 0.2998f, 0.4001f, 0.4997f, 0.5979f, 0.6901f,
       0.7718f, 0.8406f, 0.8953f, 0.9367f, 0.9641f, 0.9872f, 0.9945f, 0.998f,
       0.9993f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1002f, 0.2001f, 0.3001f, 0.3996f, 0.4996f, 0.5969f, 0.6877f,
       0.7674f, 0.835f,  0.8894f, 0.9304f, 0.9595f, 0.9849f, 0.9933f, 0.9973f,
       0.9991f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1997f, 0.2998f, 0.4002f, 0.4995f, 0.5963f, 0.6861f,
       0.7644f, 0.8309f, 0.8846f, 0.9256f, 0.9552f, 0.983f,  0.992f,  0.9967f,
       0.9987f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2005f, 0.3006f, 0.4f,    0.4993f, 0.5961f, 0.6855f,
       0.7642f, 0.8304f, 0.8835f, 0.9239f, 0.9531f, 0.9824f, 0.9914f, 0.9962f,
       0.9985f, 0.9994f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2002f, 0.3007f, 0.4005f, 0.4992f, 0.5956f, 0.6857f,
       0.7654f, 0.8318f, 0.8852f, 0.9252f, 0.9537f, 0.9831f, 0.9919f, 0.9964f,
       0.9986f, 0.9995f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0995f, 0.2003f, 0.3002f, 0.4003f, 0.4998f, 0.5973f, 0.6893f,
       0.7704f, 0.8387f, 0.8929f, 0.9327f, 0.9603f, 0.9856f, 0.9934f, 0.9973f,
       0.999f,  0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f}}},
}};

// From then on it is the same anywhere between two levels, within 0.009: the middle between the extremes.
struct RelaxedRow {
    int steps;
    Row coverage;
};
constexpr std::array<RelaxedRow, 6> kRelaxed{{
    {4, {0.0f,    0.0999f, 0.2002f, 0.3003f, 0.4002f, 0.4999f, 0.5985f, 0.6928f,
         0.777f,  0.8475f, 0.9025f, 0.9423f, 0.9683f, 0.9886f, 0.9952f, 0.9982f,
         0.9994f, 0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {5, {0.0f,    0.0999f, 0.2003f, 0.3002f, 0.4002f, 0.5001f, 0.5987f, 0.6932f,
         0.7776f, 0.8483f, 0.9034f, 0.9432f, 0.9691f, 0.9905f, 0.9962f, 0.9987f,
         0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {7, {0.0f,    0.0998f, 0.2001f, 0.3f,    0.4001f, 0.5002f, 0.5991f, 0.6952f,
         0.7812f, 0.8533f, 0.9091f, 0.9485f, 0.9737f, 0.9927f, 0.9974f, 0.9992f,
         0.9998f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {10,
     {0.0f,   0.0999f, 0.2001f, 0.3002f, 0.4f,    0.5f, 0.5995f, 0.6963f, 0.7842f, 0.8571f, 0.9133f, 0.9528f,
      0.977f, 0.9946f, 0.9983f, 0.9996f, 0.9999f, 1.0f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {20,
     {0.0f,    0.1f,    0.2002f, 0.3001f, 0.4001f, 0.5f, 0.5997f, 0.6983f, 0.7887f, 0.8638f, 0.9208f, 0.9595f,
      0.9821f, 0.9969f, 0.9992f, 0.9999f, 1.0f,    1.0f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {50, {0.0f,    0.1f,    0.2f,    0.3f, 0.4f, 0.5002f, 0.6f, 0.6994f, 0.7929f, 0.8712f, 0.9287f, 0.9664f,
          0.9871f, 0.9985f, 0.9997f, 1.0f, 1.0f, 1.0f,    1.0f, 1.0f,    1.0f,    1.0f,    1.0f}},
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

InkCurve::InkCurve(const InkedDots& dots) : InkCurve(dots, load_of_black(dots)) {}

InkCurve::InkCurve(const InkedDots& dots, double full_load)
    : full_load_(full_load), smallest_area_(dots.smallest_area), black_(float(dots.black)) {
    coverage_[0] = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const float density = static_cast<float>(i) / kSteps;
        if (dots.joined) {
            coverage_[i] = static_cast<float>(std::sqrt(static_cast<double>(density)));
            continue;
        }
        // More dots cover more, which rounding in the table hides where nearly all is covered.
        coverage_[i] = std::max(coverage_of(dots, density, load(density)), coverage_[i - 1] + 1e-6f);
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

float InkCurve::load(float density) const {
    return static_cast<float>(full_load_ * density * (smallest_area_ + (1 - smallest_area_) * density));
}

float InkCurve::coverage(float density) const {
    const float at = density > 0 ? std::min(density, 1.0f) * kSteps : 0;  // nor is what is not a number
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
