#include "core/image/ink.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

#include "core/image/density.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

// Rows of coverage in ten-thousandths at loads 0, 0.1, ...: bench/coverage_tables prints them.
constexpr float kLoadStep = 0.1f;
constexpr std::size_t kLoads = 23;
constexpr float kPartsOfOne = 10'000;
using Row = std::array<std::uint16_t, kLoads>;

// As placed and after 1 to 4 steps, at eighths of the way from one full level to the next.
constexpr std::size_t kPhases = 8;
constexpr std::array<std::array<Row, kPhases>, 5> kByLevel{
    {{{// 0
       {0,    1002, 1999, 2999, 4003, 4997, 5953, 6827, 7590, 8229, 8739, 9131,
        9416, 9620, 9760, 9852, 9912, 9950, 9973, 9985, 9992, 9996, 9998},
       {0,    1001, 2001, 2995, 3982, 4937, 5847, 6694, 7447, 8093, 8625, 9044,
        9359, 9586, 9745, 9851, 9916, 9955, 9977, 9989, 9995, 9998, 9999},
       {0,    1000, 2001, 2996, 3967, 4891, 5757, 6561, 7292, 7931, 8470, 8904,
        9243, 9497, 9678, 9804, 9885, 9936, 9966, 9983, 9992, 9996, 9998},
       {0,    1002, 2000, 2999, 3972, 4883, 5720, 6488, 7182, 7801, 8338, 8779,
        9137, 9410, 9610, 9752, 9849, 9912, 9951, 9973, 9986, 9994, 9997},
       {0,    1000, 2002, 3001, 3977, 4896, 5729, 6475, 7139, 7726, 8240, 8679,
        9040, 9326, 9547, 9707, 9817, 9891, 9937, 9966, 9982, 9991, 9996},
       {0,    1001, 2003, 3003, 3991, 4922, 5770, 6516, 7168, 7726, 8210, 8619,
        8967, 9252, 9478, 9649, 9776, 9863, 9920, 9957, 9977, 9988, 9994},
       {0,    999,  2001, 3002, 3999, 4952, 5828, 6602, 7257, 7813, 8270, 8648,
        8962, 9218, 9427, 9594, 9726, 9822, 9890, 9935, 9965, 9982, 9991},
       {0,    996,  2003, 3002, 4000, 4981, 5901, 6721, 7424, 8003, 8469, 8835,
        9115, 9333, 9503, 9632, 9733, 9811, 9872, 9917, 9948, 9969, 9983}}},
     {{// 1
       {0,    998,  2000, 2999, 3999, 4995, 5977, 6894, 7707,  8382,  8919, 9316,
        9590, 9800, 9899, 9953, 9980, 9992, 9997, 9999, 10000, 10000, 10000},
       {0,    999,  1999, 3003, 3997, 4988, 5958, 6862, 7662,  8336,  8876, 9282,
        9567, 9788, 9892, 9950, 9979, 9992, 9997, 9999, 10000, 10000, 10000},
       {0,    999,  1998, 2999, 3999, 4985, 5939, 6816, 7591, 8251,  8784, 9193,
        9490, 9741, 9863, 9933, 9969, 9987, 9995, 9998, 9999, 10000, 10000},
       {0,    999,  1999, 3000, 3997, 4986, 5925, 6778, 7532, 8172,  8700, 9114,
        9425, 9699, 9833, 9913, 9957, 9981, 9992, 9997, 9999, 10000, 10000},
       {0,    1001, 1997, 3000, 4002, 4987, 5919, 6763, 7500, 8122, 8641, 9055,
        9365, 9657, 9802, 9892, 9945, 9974, 9988, 9995, 9998, 9999, 10000},
       {0,    1002, 2001, 2995, 3999, 4985, 5914, 6753, 7486, 8107, 8615, 9014,
        9321, 9624, 9772, 9871, 9932, 9965, 9983, 9992, 9997, 9998, 9999},
       {0,    1000, 2000, 2997, 3995, 4987, 5929, 6780, 7520, 8140, 8643, 9034,
        9329, 9622, 9767, 9864, 9924, 9960, 9980, 9991, 9996, 9998, 9999},
       {0,    1000, 1999, 3000, 3997, 4992, 5948, 6823, 7594, 8236, 8749, 9139,
        9426, 9692, 9818, 9898, 9945, 9972, 9987, 9994, 9998, 9999, 10000}}},
     {{// 2
       {0,    1000, 2004, 3004, 4004, 5001, 5998, 6957,  7810,  8525,  9075, 9468,
        9718, 9875, 9947, 9980, 9993, 9998, 9999, 10000, 10000, 10000, 10000},
       {0,    1000, 2003, 3002, 4003, 5001, 5998, 6938,  7781,  8490,  9039, 9432,
        9693, 9862, 9941, 9977, 9992, 9998, 9999, 10000, 10000, 10000, 10000},
       {0,    1002, 2002, 3004, 4004, 5003, 5985, 6911,  7742,  8436,  8984, 9383,
        9651, 9838, 9926, 9969, 9988, 9996, 9999, 10000, 10000, 10000, 10000},
       {0,    1001, 1999, 3002, 4005, 5000, 5979, 6897, 7710,  8395,  8933, 9338,
        9613, 9817, 9912, 9961, 9985, 9994, 9998, 9999, 10000, 10000, 10000},
       {0,    1001, 2003, 3003, 4000, 5000, 5971, 6881, 7690,  8367,  8906, 9304,
        9583, 9796, 9899, 9954, 9981, 9992, 9997, 9999, 10000, 10000, 10000},
       {0,    999,  2003, 3004, 4000, 4994, 5963, 6868, 7670,  8343,  8879, 9284,
        9567, 9788, 9893, 9950, 9978, 9991, 9996, 9999, 10000, 10000, 10000},
       {0,    1000, 2000, 3006, 4000, 4995, 5967, 6875, 7679,  8353,  8893, 9294,
        9576, 9792, 9893, 9950, 9978, 9991, 9997, 9999, 10000, 10000, 10000},
       {0,    1003, 1998, 2998, 4001, 5001, 5982, 6906, 7727,  8418,  8956, 9355,
        9624, 9821, 9912, 9960, 9984, 9994, 9998, 9999, 10000, 10000, 10000}}},
     {{// 3
       {0,    1001, 2001, 2998, 3999, 5000, 5995,  6960,  7834,  8564,  9121, 9509,
        9754, 9899, 9960, 9986, 9996, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    999,  1998, 2999, 3998, 4995, 5989,  6954,  7819,  8538,  9097, 9490,
        9737, 9889, 9956, 9985, 9996, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    1001, 2001, 2999, 4001, 4999, 5992, 6939,  7798,  8506,  9061, 9455,
        9711, 9873, 9946, 9980, 9993, 9998, 9999, 10000, 10000, 10000, 10000},
       {0,    997,  2000, 2999, 4004, 5001, 5989, 6931,  7772,  8474,  9022, 9420,
        9684, 9858, 9937, 9975, 9991, 9997, 9999, 10000, 10000, 10000, 10000},
       {0,    1000, 2000, 2999, 3999, 5001, 5985, 6924,  7760,  8452,  9000, 9397,
        9662, 9842, 9929, 9972, 9989, 9996, 9999, 10000, 10000, 10000, 10000},
       {0,    999,  1999, 3001, 4001, 4994, 5986, 6923,  7757,  8448,  8994, 9392,
        9658, 9841, 9926, 9969, 9988, 9996, 9999, 10000, 10000, 10000, 10000},
       {0,    999,  2002, 3003, 4000, 4998, 5987, 6925,  7761,  8455,  9006, 9400,
        9662, 9841, 9926, 9968, 9988, 9996, 9999, 10000, 10000, 10000, 10000},
       {0,    998,  1999, 2996, 3998, 5003, 5988, 6936,  7791,  8497,  9046, 9438,
        9694, 9860, 9937, 9975, 9991, 9997, 9999, 10000, 10000, 10000, 10000}}},
     {{// 4
       {0,    1001, 1999, 3000, 4001, 5001,  5998,  6956,  7829,  8553,  9114, 9505,
        9752, 9921, 9971, 9991, 9997, 10000, 10000, 10000, 10000, 10000, 10000},
       {0,    1000, 1999, 3001, 4001, 5001, 5989,  6952,  7818,  8532,  9089, 9484,
        9736, 9915, 9968, 9990, 9998, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    1000, 2001, 3000, 4004, 5002, 5989,  6941,  7796,  8501,  9054, 9451,
        9708, 9905, 9964, 9988, 9997, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    997,  1999, 2999, 4003, 5005, 5987,  6928,  7766,  8468,  9015, 9419,
        9686, 9896, 9959, 9986, 9996, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    1000, 2003, 3000, 4002, 4996, 5984,  6922,  7757,  8449,  8992, 9394,
        9664, 9888, 9955, 9984, 9995, 9999, 10000, 10000, 10000, 10000, 10000},
       {0,    997,  2000, 3004, 4002, 4991, 5983,  6919,  7749,  8445,  8990, 9391,
        9660, 9887, 9954, 9983, 9995, 9998, 10000, 10000, 10000, 10000, 10000},
       {0,    1001, 2000, 3001, 3999, 4998, 5991,  6926,  7756,  8453,  8998, 9398,
        9665, 9887, 9953, 9983, 9995, 9998, 10000, 10000, 10000, 10000, 10000},
       {0,    1001, 1999, 2996, 3998, 5002, 5991,  6937,  7785,  8491,  9042, 9436,
        9695, 9897, 9959, 9987, 9996, 9999, 10000, 10000, 10000, 10000, 10000}}}}};

// From then on it is the same anywhere between two levels, within 0.006: the middle between the extremes.
struct RelaxedRow {
    int steps;
    Row coverage;
};
constexpr std::array<RelaxedRow, 5> kRelaxed{{
    {5, {0,    1000, 2000, 3000, 4000, 5000, 5993,  6948,  7807,  8524,  9073, 9470,
         9723, 9914, 9968, 9989, 9997, 9999, 10000, 10000, 10000, 10000, 10000}},
    {7, {0,    1001, 2000, 3000, 4001, 5002,  5996,  6967,  7849,  8582,  9140, 9532,
         9773, 9937, 9979, 9994, 9999, 10000, 10000, 10000, 10000, 10000, 10000}},
    {10, {0,    1001, 2000, 2999, 4001, 5002,  5996,  6980,  7882,  8628,  9192, 9577,
          9804, 9954, 9987, 9997, 9999, 10000, 10000, 10000, 10000, 10000, 10000}},
    {20, {0,    999,  2000, 2999, 4000,  4998,  5999,  6992,  7923,  8701,  9274, 9648,
          9857, 9973, 9993, 9999, 10000, 10000, 10000, 10000, 10000, 10000, 10000}},
    {50, {0,    999,  2000, 3000,  4000,  5000,  6001,  6996,  7955,  8769,  9356, 9720,
          9904, 9985, 9997, 10000, 10000, 10000, 10000, 10000, 10000, 10000, 10000}},
}};

// Black is covered to 99.5 % and more, anywhere between two levels.
constexpr std::array<double, 5> kFullLoads{2.05, 1.7, 1.6, 1.5, 1.45};  // after so many steps; and after more

float between(const Row& row, float load) {
    const float at = std::clamp(load / kLoadStep, 0.0f, static_cast<float>(kLoads - 1));
    const auto i = std::min(static_cast<std::size_t>(at), kLoads - 2);
    const float from = row[i] / kPartsOfOne, to = row[i + 1] / kPartsOfOne;
    return from + (to - from) * (at - static_cast<float>(i));
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
