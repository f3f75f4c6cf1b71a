#include "core/image/ink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/image/density.h"
#include "core/maths/portable_math.h"

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
      {0.0f,    0.1001f, 0.2001f, 0.2994f, 0.3976f, 0.4929f, 0.584f,  0.6691f,
       0.7449f, 0.81f,   0.8637f, 0.9058f, 0.9373f, 0.96f,   0.9756f, 0.986f,
       0.9921f, 0.9958f, 0.9979f, 0.999f,  0.9996f, 0.9998f, 0.9999f},
      {0.0f,    0.1f,    0.2001f, 0.2993f, 0.3959f, 0.4878f, 0.5746f, 0.6553f,
       0.729f,  0.7933f, 0.8478f, 0.8918f, 0.9258f, 0.9513f, 0.9693f, 0.9816f,
       0.9893f, 0.9942f, 0.997f,  0.9986f, 0.9993f, 0.9997f, 0.9999f},
      {0.0f,    0.1002f, 0.2001f, 0.2996f, 0.3962f, 0.4869f, 0.5707f, 0.6478f,
       0.7177f, 0.7799f, 0.8339f, 0.8785f, 0.9145f, 0.942f,  0.9621f, 0.9761f,
       0.9857f, 0.9919f, 0.9955f, 0.9976f, 0.9988f, 0.9994f, 0.9997f},
      {0.0f,    0.1f,    0.2002f, 0.3f,    0.3971f, 0.4885f, 0.5715f, 0.6461f,
       0.7128f, 0.7719f, 0.8235f, 0.8676f, 0.9039f, 0.9327f, 0.9548f, 0.971f,
       0.9821f, 0.9894f, 0.994f,  0.9968f, 0.9983f, 0.9992f, 0.9996f},
      {0.0f,    0.1001f, 0.2002f, 0.3002f, 0.3988f, 0.4914f, 0.5759f, 0.6504f,
       0.7157f, 0.7716f, 0.8201f, 0.8611f, 0.896f,  0.9248f, 0.9474f, 0.9647f,
       0.9773f, 0.9863f, 0.992f,  0.9956f, 0.9977f, 0.9988f, 0.9994f},
      {0.0f,    0.0999f, 0.2002f, 0.3002f, 0.3999f, 0.4951f, 0.5824f, 0.6597f,
       0.7251f, 0.7808f, 0.8265f, 0.8643f, 0.8957f, 0.9212f, 0.9422f, 0.959f,
       0.9723f, 0.9819f, 0.9888f, 0.9934f, 0.9965f, 0.9982f, 0.9991f},
      {0.0f,    0.0996f, 0.2003f, 0.3001f, 0.3999f, 0.498f,  0.59f,   0.6719f,
       0.7423f, 0.8001f, 0.8466f, 0.8833f, 0.9113f, 0.9331f, 0.9501f, 0.963f,
       0.9731f, 0.9809f, 0.987f,  0.9916f, 0.9948f, 0.9969f, 0.9983f}}},
    {{// 1
      {0.0f,    0.0996f, 0.2002f, 0.3f,    0.3996f, 0.4991f, 0.5959f, 0.6859f,
       0.7658f, 0.8333f, 0.8874f, 0.9284f, 0.9574f, 0.982f,  0.9913f, 0.9961f,
       0.9984f, 0.9994f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1999f, 0.3001f, 0.3997f, 0.498f,  0.5936f, 0.6819f,
       0.7606f, 0.8276f, 0.882f,  0.9237f, 0.9535f, 0.9801f, 0.9904f, 0.9957f,
       0.9982f, 0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2f,    0.3001f, 0.3998f, 0.4974f, 0.5904f, 0.6766f,
       0.7533f, 0.8187f, 0.8726f, 0.9146f, 0.9454f, 0.9756f, 0.9872f, 0.9938f,
       0.9972f, 0.9988f, 0.9995f, 0.9998f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.1f,    0.1999f, 0.3f,    0.399f,  0.4967f, 0.5887f, 0.6727f,
       0.7471f, 0.811f,  0.8641f, 0.9065f, 0.9387f, 0.9716f, 0.9843f, 0.9919f,
       0.9961f, 0.9982f, 0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.1001f, 0.2f,    0.3f,    0.3997f, 0.4969f, 0.588f,  0.6708f,
       0.7439f, 0.8063f, 0.8589f, 0.9011f, 0.9334f, 0.9683f, 0.9818f, 0.9903f,
       0.995f,  0.9976f, 0.9989f, 0.9996f, 0.9998f, 0.9999f, 1.0f},
      {0.0f,    0.1f,    0.1998f, 0.2995f, 0.3995f, 0.4965f, 0.5874f, 0.6697f,
       0.7423f, 0.8045f, 0.8565f, 0.8976f, 0.9295f, 0.9661f, 0.9802f, 0.9889f,
       0.9941f, 0.9971f, 0.9986f, 0.9993f, 0.9997f, 0.9999f, 1.0f},
      {0.0f,    0.1f,    0.1998f, 0.2996f, 0.3991f, 0.497f,  0.5891f, 0.672f,
       0.7454f, 0.8077f, 0.859f,  0.8996f, 0.931f,  0.9669f, 0.9804f, 0.9891f,
       0.9942f, 0.997f,  0.9986f, 0.9994f, 0.9997f, 0.9999f, 1.0f},
      {0.0f,    0.0998f, 0.2f,    0.2999f, 0.3999f, 0.4976f, 0.5911f, 0.6767f,
       0.7524f, 0.817f,  0.8696f, 0.9106f, 0.9411f, 0.9727f, 0.9848f, 0.992f,
       0.996f,  0.9982f, 0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f}}},
    {{// 2
      {0.0f,    0.1002f, 0.2f,    0.2999f, 0.4001f, 0.5002f, 0.5984f, 0.6922f,
       0.7764f, 0.8474f, 0.9027f, 0.9426f, 0.9689f, 0.9843f, 0.9927f, 0.9968f,
       0.9987f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2f,    0.3001f, 0.3999f, 0.4991f, 0.5972f, 0.6905f,
       0.7732f, 0.8432f, 0.8987f, 0.9389f, 0.9661f, 0.9832f, 0.9921f, 0.9967f,
       0.9987f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2f,    0.3003f, 0.4005f, 0.4994f, 0.5959f, 0.6868f,
       0.7682f, 0.8371f, 0.8922f, 0.9332f, 0.9614f, 0.9805f, 0.9905f, 0.9958f,
       0.9982f, 0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2002f, 0.2999f, 0.3999f, 0.499f,  0.5951f, 0.6847f,
       0.7644f, 0.8318f, 0.8865f, 0.9282f, 0.9575f, 0.9781f, 0.9891f, 0.995f,
       0.9979f, 0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2001f, 0.3f,    0.3998f, 0.4987f, 0.5941f, 0.6828f,
       0.7621f, 0.8291f, 0.8833f, 0.925f,  0.9542f, 0.9759f, 0.9875f, 0.994f,
       0.9973f, 0.9989f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2f,    0.3001f, 0.3994f, 0.4984f, 0.5932f, 0.6816f,
       0.7599f, 0.8268f, 0.8809f, 0.9219f, 0.952f,  0.9734f, 0.9856f, 0.9929f,
       0.9967f, 0.9985f, 0.9994f, 0.9998f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2003f, 0.3003f, 0.3998f, 0.4984f, 0.5935f, 0.6822f,
       0.7616f, 0.8287f, 0.8829f, 0.9242f, 0.9535f, 0.9733f, 0.9854f, 0.9925f,
       0.9964f, 0.9984f, 0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.3f,    0.3997f, 0.4993f, 0.596f, 0.6868f,
       0.7674f, 0.8358f, 0.89f,   0.9303f, 0.9582f, 0.9762f, 0.987f, 0.9934f,
       0.9968f, 0.9986f, 0.9994f, 0.9998f, 0.9999f, 1.0f,    1.0f}}},
    {{// 3
      {0.0f,    0.1001f, 0.1999f, 0.3f,    0.4001f, 0.5003f, 0.599f, 0.6943f,
       0.7797f, 0.8515f, 0.9071f, 0.9469f, 0.9725f, 0.9899f, 0.996f, 0.9986f,
       0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2001f, 0.2999f, 0.3999f, 0.4998f, 0.5983f, 0.6933f,
       0.7779f, 0.8486f, 0.9041f, 0.9443f, 0.9703f, 0.989f,  0.9956f, 0.9985f,
       0.9995f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0998f, 0.2f,    0.3f,    0.4003f, 0.4998f, 0.598f,  0.6912f,
       0.7744f, 0.8444f, 0.8995f, 0.9398f, 0.9667f, 0.9873f, 0.9947f, 0.998f,
       0.9993f, 0.9998f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0997f, 0.1999f, 0.3001f, 0.4002f, 0.5f,    0.5979f, 0.6898f,
       0.771f,  0.8401f, 0.8947f, 0.9356f, 0.9635f, 0.9859f, 0.9938f, 0.9976f,
       0.9991f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.1f,    0.2f,    0.3f,    0.4f,    0.4998f, 0.5971f, 0.6886f,
       0.7695f, 0.8375f, 0.8921f, 0.9328f, 0.9609f, 0.9844f, 0.993f,  0.9972f,
       0.999f,  0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.1998f, 0.3001f, 0.4001f, 0.4995f, 0.5966f, 0.688f,
       0.7687f, 0.8364f, 0.8905f, 0.9314f, 0.9598f, 0.9842f, 0.9927f, 0.9969f,
       0.9988f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2001f, 0.3001f, 0.4002f, 0.4998f, 0.5967f, 0.6882f,
       0.7694f, 0.8376f, 0.8923f, 0.9328f, 0.9607f, 0.9843f, 0.9927f, 0.997f,
       0.9988f, 0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f},
      {0.0f,    0.0999f, 0.2f,    0.2997f, 0.3999f, 0.4999f, 0.5983f, 0.6906f,
       0.7732f, 0.8427f, 0.8975f, 0.9376f, 0.9646f, 0.9861f, 0.9938f, 0.9975f,
       0.9992f, 0.9997f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f}}},
}};

// From then on it is the same anywhere between two levels, within 0.007: the middle between the extremes.
struct RelaxedRow {
    int steps;
    Row coverage;
};
constexpr std::array<RelaxedRow, 6> kRelaxed{{
    {4, {0.0f,    0.0999f, 0.2001f, 0.3f,    0.4001f, 0.4998f, 0.5991f, 0.6938f,
         0.7789f, 0.8499f, 0.9052f, 0.9448f, 0.9706f, 0.9904f, 0.9962f, 0.9987f,
         0.9996f, 0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {5, {0.0f,    0.1f,    0.2f,    0.3f,   0.4f,    0.5f,    0.5993f, 0.6948f,
         0.7807f, 0.8524f, 0.9073f, 0.947f, 0.9723f, 0.9914f, 0.9968f, 0.9989f,
         0.9997f, 0.9999f, 1.0f,    1.0f,   1.0f,    1.0f,    1.0f}},
    {7,
     {0.0f,   0.1001f, 0.1999f, 0.3f,    0.4f,    0.5f, 0.5995f, 0.6964f, 0.7841f, 0.8569f, 0.9125f, 0.9515f,
      0.976f, 0.9936f, 0.9978f, 0.9994f, 0.9999f, 1.0f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {10, {0.0f,    0.1001f, 0.2f,    0.2999f, 0.4001f, 0.5001f, 0.5999f, 0.6978f,
          0.7876f, 0.8621f, 0.9182f, 0.9568f, 0.9798f, 0.9953f, 0.9986f, 0.9997f,
          0.9999f, 1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {20, {0.0f,    0.0999f, 0.2f,    0.3f,    0.4001f, 0.4999f, 0.5999f, 0.6993f,
          0.7923f, 0.8699f, 0.9271f, 0.9646f, 0.9855f, 0.9973f, 0.9993f, 0.9999f,
          1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f,    1.0f}},
    {50, {0.0f,    0.0999f, 0.2001f, 0.3f, 0.4f, 0.4997f, 0.6f, 0.6996f, 0.7955f, 0.8769f, 0.9356f, 0.972f,
          0.9904f, 0.9985f, 0.9997f, 1.0f, 1.0f, 1.0f,    1.0f, 1.0f,    1.0f,    1.0f,    1.0f}},
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
    return coverage_by_level(dots.relaxing_steps, *dots.level + portable::log2(density) / 2, load);
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
    return portable::log2(kDotsPerScale * scale / static_cast<double>(tile_size)) / 2;
}

bool depends_on_level(int relaxing_steps) {
    return relaxing_steps < static_cast<int>(kByLevel.size());
}

double usual_black(double dots) {
    constexpr double kFew = 5'000, kMany = 100'000, kOpen = 0.9;
    const double way = portable::log(std::max(dots, 1.0) / kFew) / portable::log(kMany / kFew);
    return std::round(100 * std::lerp(kOpen, 1.0, std::clamp(way, 0.0, 1.0))) / 100;
}

float covered(const InkedDots& dots, double load) {
    return coverage_of(dots, 1, static_cast<float>(load));
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
    const float at = std::clamp(density, 0.0f, 1.0f) * kSteps;
    const int i = std::min(static_cast<int>(at), kSteps - 1);
    return coverage_[i] + (coverage_[i + 1] - coverage_[i]) * (at - static_cast<float>(i));
}

float InkCurve::opened(float ink) const {
    if (black_ >= 1) return ink;
    // A power, which bends where it is dark; the darkest tones keep three tenths of their contrast and more.
    constexpr float kHighestPower = 6, kLostContrast = 0.7f;
    const float lost = 1 - black_;
    return ink - lost * portable::pow(ink, std::min(kLostContrast / lost, kHighestPower));
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
