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

// As placed and after 1 to 4 steps, at eighths of the way from one full level to the next.
constexpr std::size_t kPhases = 8;
constexpr std::array<std::array<Row, kPhases>, 5> kByLevel{
    {{{// 0
       {0.0000f, 0.1002f, 0.1999f, 0.2999f, 0.4003f, 0.4997f, 0.5953f, 0.6827f,
        0.7590f, 0.8229f, 0.8739f, 0.9131f, 0.9416f, 0.9620f, 0.9760f, 0.9852f,
        0.9912f, 0.9950f, 0.9973f, 0.9985f, 0.9992f, 0.9996f, 0.9998f},
       {0.0000f, 0.1001f, 0.2001f, 0.2995f, 0.3982f, 0.4937f, 0.5847f, 0.6694f,
        0.7447f, 0.8093f, 0.8625f, 0.9044f, 0.9359f, 0.9586f, 0.9745f, 0.9851f,
        0.9916f, 0.9955f, 0.9977f, 0.9989f, 0.9995f, 0.9998f, 0.9999f},
       {0.0000f, 0.1000f, 0.2001f, 0.2996f, 0.3967f, 0.4891f, 0.5757f, 0.6561f,
        0.7292f, 0.7931f, 0.8470f, 0.8904f, 0.9243f, 0.9497f, 0.9678f, 0.9804f,
        0.9885f, 0.9936f, 0.9966f, 0.9983f, 0.9992f, 0.9996f, 0.9998f},
       {0.0000f, 0.1002f, 0.2000f, 0.2999f, 0.3972f, 0.4883f, 0.5720f, 0.6488f,
        0.7182f, 0.7801f, 0.8338f, 0.8779f, 0.9137f, 0.9410f, 0.9610f, 0.9752f,
        0.9849f, 0.9912f, 0.9951f, 0.9973f, 0.9986f, 0.9994f, 0.9997f},
       {0.0000f, 0.1000f, 0.2002f, 0.3001f, 0.3977f, 0.4896f, 0.5729f, 0.6475f,
        0.7139f, 0.7726f, 0.8240f, 0.8679f, 0.9040f, 0.9326f, 0.9547f, 0.9707f,
        0.9817f, 0.9891f, 0.9937f, 0.9966f, 0.9982f, 0.9991f, 0.9996f},
       {0.0000f, 0.1001f, 0.2003f, 0.3003f, 0.3991f, 0.4922f, 0.5770f, 0.6516f,
        0.7168f, 0.7726f, 0.8210f, 0.8619f, 0.8967f, 0.9252f, 0.9478f, 0.9649f,
        0.9776f, 0.9863f, 0.9920f, 0.9957f, 0.9977f, 0.9988f, 0.9994f},
       {0.0000f, 0.0999f, 0.2001f, 0.3002f, 0.3999f, 0.4952f, 0.5828f, 0.6602f,
        0.7257f, 0.7813f, 0.8270f, 0.8648f, 0.8962f, 0.9218f, 0.9427f, 0.9594f,
        0.9726f, 0.9822f, 0.9890f, 0.9935f, 0.9965f, 0.9982f, 0.9991f},
       {0.0000f, 0.0996f, 0.2003f, 0.3002f, 0.4000f, 0.4981f, 0.5901f, 0.6721f,
        0.7424f, 0.8003f, 0.8469f, 0.8835f, 0.9115f, 0.9333f, 0.9503f, 0.9632f,
        0.9733f, 0.9811f, 0.9872f, 0.9917f, 0.9948f, 0.9969f, 0.9983f}}},
     {{// 1
       {0.0000f, 0.0998f, 0.2000f, 0.2999f, 0.3999f, 0.4995f, 0.5977f, 0.6894f,
        0.7707f, 0.8382f, 0.8919f, 0.9316f, 0.9590f, 0.9800f, 0.9899f, 0.9953f,
        0.9980f, 0.9992f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.1999f, 0.3003f, 0.3997f, 0.4988f, 0.5958f, 0.6862f,
        0.7662f, 0.8336f, 0.8876f, 0.9282f, 0.9567f, 0.9788f, 0.9892f, 0.9950f,
        0.9979f, 0.9992f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.1998f, 0.2999f, 0.3999f, 0.4985f, 0.5939f, 0.6816f,
        0.7591f, 0.8251f, 0.8784f, 0.9193f, 0.9490f, 0.9741f, 0.9863f, 0.9933f,
        0.9969f, 0.9987f, 0.9995f, 0.9998f, 0.9999f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.1999f, 0.3000f, 0.3997f, 0.4986f, 0.5925f, 0.6778f,
        0.7532f, 0.8172f, 0.8700f, 0.9114f, 0.9425f, 0.9699f, 0.9833f, 0.9913f,
        0.9957f, 0.9981f, 0.9992f, 0.9997f, 0.9999f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.1997f, 0.3000f, 0.4002f, 0.4987f, 0.5919f, 0.6763f,
        0.7500f, 0.8122f, 0.8641f, 0.9055f, 0.9365f, 0.9657f, 0.9802f, 0.9892f,
        0.9945f, 0.9974f, 0.9988f, 0.9995f, 0.9998f, 0.9999f, 1.0000f},
       {0.0000f, 0.1002f, 0.2001f, 0.2995f, 0.3999f, 0.4985f, 0.5914f, 0.6753f,
        0.7486f, 0.8107f, 0.8615f, 0.9014f, 0.9321f, 0.9624f, 0.9772f, 0.9871f,
        0.9932f, 0.9965f, 0.9983f, 0.9992f, 0.9997f, 0.9998f, 0.9999f},
       {0.0000f, 0.1000f, 0.2000f, 0.2997f, 0.3995f, 0.4987f, 0.5929f, 0.6780f,
        0.7520f, 0.8140f, 0.8643f, 0.9034f, 0.9329f, 0.9622f, 0.9767f, 0.9864f,
        0.9924f, 0.9960f, 0.9980f, 0.9991f, 0.9996f, 0.9998f, 0.9999f},
       {0.0000f, 0.1000f, 0.1999f, 0.3000f, 0.3997f, 0.4992f, 0.5948f, 0.6823f,
        0.7594f, 0.8236f, 0.8749f, 0.9139f, 0.9426f, 0.9692f, 0.9818f, 0.9898f,
        0.9945f, 0.9972f, 0.9987f, 0.9994f, 0.9998f, 0.9999f, 1.0000f}}},
     {{// 2
       {0.0000f, 0.1000f, 0.2004f, 0.3004f, 0.4004f, 0.5001f, 0.5998f, 0.6957f,
        0.7810f, 0.8525f, 0.9075f, 0.9468f, 0.9718f, 0.9875f, 0.9947f, 0.9980f,
        0.9993f, 0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.2003f, 0.3002f, 0.4003f, 0.5001f, 0.5998f, 0.6938f,
        0.7781f, 0.8490f, 0.9039f, 0.9432f, 0.9693f, 0.9862f, 0.9941f, 0.9977f,
        0.9992f, 0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1002f, 0.2002f, 0.3004f, 0.4004f, 0.5003f, 0.5985f, 0.6911f,
        0.7742f, 0.8436f, 0.8984f, 0.9383f, 0.9651f, 0.9838f, 0.9926f, 0.9969f,
        0.9988f, 0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.1999f, 0.3002f, 0.4005f, 0.5000f, 0.5979f, 0.6897f,
        0.7710f, 0.8395f, 0.8933f, 0.9338f, 0.9613f, 0.9817f, 0.9912f, 0.9961f,
        0.9985f, 0.9994f, 0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.2003f, 0.3003f, 0.4000f, 0.5000f, 0.5971f, 0.6881f,
        0.7690f, 0.8367f, 0.8906f, 0.9304f, 0.9583f, 0.9796f, 0.9899f, 0.9954f,
        0.9981f, 0.9992f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.2003f, 0.3004f, 0.4000f, 0.4994f, 0.5963f, 0.6868f,
        0.7670f, 0.8343f, 0.8879f, 0.9284f, 0.9567f, 0.9788f, 0.9893f, 0.9950f,
        0.9978f, 0.9991f, 0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.2000f, 0.3006f, 0.4000f, 0.4995f, 0.5967f, 0.6875f,
        0.7679f, 0.8353f, 0.8893f, 0.9294f, 0.9576f, 0.9792f, 0.9893f, 0.9950f,
        0.9978f, 0.9991f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1003f, 0.1998f, 0.2998f, 0.4001f, 0.5001f, 0.5982f, 0.6906f,
        0.7727f, 0.8418f, 0.8956f, 0.9355f, 0.9624f, 0.9821f, 0.9912f, 0.9960f,
        0.9984f, 0.9994f, 0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f}}},
     {{// 3
       {0.0000f, 0.1001f, 0.2001f, 0.2998f, 0.3999f, 0.5000f, 0.5995f, 0.6960f,
        0.7834f, 0.8564f, 0.9121f, 0.9509f, 0.9754f, 0.9899f, 0.9960f, 0.9986f,
        0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.1998f, 0.2999f, 0.3998f, 0.4995f, 0.5989f, 0.6954f,
        0.7819f, 0.8538f, 0.9097f, 0.9490f, 0.9737f, 0.9889f, 0.9956f, 0.9985f,
        0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.2001f, 0.2999f, 0.4001f, 0.4999f, 0.5992f, 0.6939f,
        0.7798f, 0.8506f, 0.9061f, 0.9455f, 0.9711f, 0.9873f, 0.9946f, 0.9980f,
        0.9993f, 0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0997f, 0.2000f, 0.2999f, 0.4004f, 0.5001f, 0.5989f, 0.6931f,
        0.7772f, 0.8474f, 0.9022f, 0.9420f, 0.9684f, 0.9858f, 0.9937f, 0.9975f,
        0.9991f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.2000f, 0.2999f, 0.3999f, 0.5001f, 0.5985f, 0.6924f,
        0.7760f, 0.8452f, 0.9000f, 0.9397f, 0.9662f, 0.9842f, 0.9929f, 0.9972f,
        0.9989f, 0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.1999f, 0.3001f, 0.4001f, 0.4994f, 0.5986f, 0.6923f,
        0.7757f, 0.8448f, 0.8994f, 0.9392f, 0.9658f, 0.9841f, 0.9926f, 0.9969f,
        0.9988f, 0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0999f, 0.2002f, 0.3003f, 0.4000f, 0.4998f, 0.5987f, 0.6925f,
        0.7761f, 0.8455f, 0.9006f, 0.9400f, 0.9662f, 0.9841f, 0.9926f, 0.9968f,
        0.9988f, 0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0998f, 0.1999f, 0.2996f, 0.3998f, 0.5003f, 0.5988f, 0.6936f,
        0.7791f, 0.8497f, 0.9046f, 0.9438f, 0.9694f, 0.9860f, 0.9937f, 0.9975f,
        0.9991f, 0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}}},
     {{// 4
       {0.0000f, 0.1001f, 0.1999f, 0.3000f, 0.4001f, 0.5001f, 0.5998f, 0.6956f,
        0.7829f, 0.8553f, 0.9114f, 0.9505f, 0.9752f, 0.9921f, 0.9971f, 0.9991f,
        0.9997f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.1999f, 0.3001f, 0.4001f, 0.5001f, 0.5989f, 0.6952f,
        0.7818f, 0.8532f, 0.9089f, 0.9484f, 0.9736f, 0.9915f, 0.9968f, 0.9990f,
        0.9998f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.2001f, 0.3000f, 0.4004f, 0.5002f, 0.5989f, 0.6941f,
        0.7796f, 0.8501f, 0.9054f, 0.9451f, 0.9708f, 0.9905f, 0.9964f, 0.9988f,
        0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0997f, 0.1999f, 0.2999f, 0.4003f, 0.5005f, 0.5987f, 0.6928f,
        0.7766f, 0.8468f, 0.9015f, 0.9419f, 0.9686f, 0.9896f, 0.9959f, 0.9986f,
        0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1000f, 0.2003f, 0.3000f, 0.4002f, 0.4996f, 0.5984f, 0.6922f,
        0.7757f, 0.8449f, 0.8992f, 0.9394f, 0.9664f, 0.9888f, 0.9955f, 0.9984f,
        0.9995f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.0997f, 0.2000f, 0.3004f, 0.4002f, 0.4991f, 0.5983f, 0.6919f,
        0.7749f, 0.8445f, 0.8990f, 0.9391f, 0.9660f, 0.9887f, 0.9954f, 0.9983f,
        0.9995f, 0.9998f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.2000f, 0.3001f, 0.3999f, 0.4998f, 0.5991f, 0.6926f,
        0.7756f, 0.8453f, 0.8998f, 0.9398f, 0.9665f, 0.9887f, 0.9953f, 0.9983f,
        0.9995f, 0.9998f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f},
       {0.0000f, 0.1001f, 0.1999f, 0.2996f, 0.3998f, 0.5002f, 0.5991f, 0.6937f,
        0.7785f, 0.8491f, 0.9042f, 0.9436f, 0.9695f, 0.9897f, 0.9959f, 0.9987f,
        0.9996f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}}}}};

// From then on it is the same anywhere between two levels, within 0.006: the middle between the extremes.
struct RelaxedRow {
    int steps;
    Row coverage;
};
constexpr std::array<RelaxedRow, 5> kRelaxed{{
    {5, {0.0000f, 0.1000f, 0.2000f, 0.3000f, 0.4000f, 0.5000f, 0.5993f, 0.6948f,
         0.7807f, 0.8524f, 0.9073f, 0.9470f, 0.9723f, 0.9914f, 0.9968f, 0.9989f,
         0.9997f, 0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}},
    {7, {0.0000f, 0.1001f, 0.2000f, 0.3000f, 0.4001f, 0.5002f, 0.5996f, 0.6967f,
         0.7849f, 0.8582f, 0.9140f, 0.9532f, 0.9773f, 0.9937f, 0.9979f, 0.9994f,
         0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}},
    {10, {0.0000f, 0.1001f, 0.2000f, 0.2999f, 0.4001f, 0.5002f, 0.5996f, 0.6980f,
          0.7882f, 0.8628f, 0.9192f, 0.9577f, 0.9804f, 0.9954f, 0.9987f, 0.9997f,
          0.9999f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}},
    {20, {0.0000f, 0.0999f, 0.2000f, 0.2999f, 0.4000f, 0.4998f, 0.5999f, 0.6992f,
          0.7923f, 0.8701f, 0.9274f, 0.9648f, 0.9857f, 0.9973f, 0.9993f, 0.9999f,
          1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}},
    {50, {0.0000f, 0.0999f, 0.2000f, 0.3000f, 0.4000f, 0.5000f, 0.6001f, 0.6996f,
          0.7955f, 0.8769f, 0.9356f, 0.9720f, 0.9904f, 0.9985f, 0.9997f, 1.0000f,
          1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f, 1.0000f}},
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
