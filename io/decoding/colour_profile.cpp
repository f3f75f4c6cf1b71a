#include "io/decoding/colour_profile.h"

#include <lcms2.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "core/image/tone.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

struct Primaries {
    int number;
    const char* name;
    std::array<glm::dvec2, 3> colours;  // of red, green and blue: CIE x and y
    glm::dvec2 white;
};

constexpr glm::dvec2 kD65{0.3127, 0.3290};
const std::array<Primaries, 4> kPrimaries{{
    {1, "Rec. 709", {{{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}}}, kD65},
    {9, "Rec. 2020", {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}}, kD65},
    {11, "P3 of cinemas", {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}}, {0.314, 0.351}},
    {12, "P3", {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}}, kD65},
}};

struct Transfer {
    int number;
    const char* name;
    Encoding::Kind kind;
};

constexpr std::array<Transfer, 4> kTransfers{{
    {8, "linear", Encoding::Kind::linear},
    {13, "sRGB", Encoding::Kind::srgb},
    {16, "PQ", Encoding::Kind::pq},
    {18, "HLG", Encoding::Kind::hlg},
}};

glm::dvec3 xyz(glm::dvec2 xy) {
    return {xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y};
}

// By the cone responses of Bradford's matrix (Lam 1985), as ICC has it.
glm::dmat3 seen_under_d65(glm::dvec2 white) {
    const glm::dmat3 cones =
        glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 gains = (cones * xyz(kD65)) / (cones * xyz(white));
    const glm::dmat3 scaled(gains.x, 0, 0, 0, gains.y, 0, 0, 0, gains.z);
    return glm::inverse(cones) * scaled * cones;
}

glm::dmat3 to_xyz(const Primaries& primaries) {
    const glm::dmat3 colours(xyz(primaries.colours[0]), xyz(primaries.colours[1]), xyz(primaries.colours[2]));
    const glm::dvec3 shares = glm::inverse(colours) * xyz(primaries.white);
    return seen_under_d65(primaries.white) *
           glm::dmat3(colours[0] * shares.x, colours[1] * shares.y, colours[2] * shares.z);
}

constexpr std::size_t kLevels = 65'536;  // those of 16 bits, and of 8 among them

using Profile = std::unique_ptr<void, decltype(&cmsCloseProfile)>;

Profile linear_light() {
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
    cmsToneCurve* const line = cmsBuildGamma(nullptr, 1);
    std::array<cmsToneCurve*, 3> curves{line, line, line};
    Profile profile(cmsCreateRGBProfile(&white, &primaries, curves.data()), &cmsCloseProfile);
    cmsFreeToneCurve(line);
    return profile;
}

constexpr float kPaperWhite = 203;  // cd/m2

// Rec. 2100, table 4.
float pq_light(float stored) {
    constexpr float m1 = 2610.0f / 16384, m2 = 2523.0f / 4096 * 128, c1 = 3424.0f / 4096,
                    c2 = 2413.0f / 4096 * 32, c3 = 2392.0f / 4096 * 32, kMost = 10'000;
    const float power = portable::pow(std::clamp(stored, 0.0f, 1.0f), 1 / m2);
    return kMost / kPaperWhite * portable::pow(std::max(power - c1, 0.0f) / (c2 - c3 * power), 1 / m1);
}

// Table 5.
float hlg_light(float stored) {
    constexpr float a = 0.17883277f, b = 0.28466892f, c = 0.55991073f;
    const float value = std::clamp(stored, 0.0f, 1.0f);
    return value <= 0.5f ? value * value / 3 : (portable::exp((value - c) / a) + b) / 12;
}

std::size_t level_of(float value) {
    return static_cast<std::size_t>(std::clamp(value, 0.0f, 1.0f) * (kLevels - 1) + 0.5f);
}

}  // namespace

std::optional<CodedColours> coded_colours(const CodePoints& points) {
    const auto primaries = std::ranges::find(kPrimaries, points.primaries, &Primaries::number);
    const auto transfer = std::ranges::find(kTransfers, points.transfer, &Transfer::number);
    if (primaries == kPrimaries.end() || transfer == kTransfers.end() || points.matrix != 0 ||
        !points.full_range)
        return std::nullopt;
    CodedColours colours{.encoding = {transfer->kind},
                         .to_srgb = std::nullopt,
                         .name = std::string(transfer->name) + ", " + primaries->name};
    if (primaries != kPrimaries.begin())
        colours.to_srgb = glm::mat3(glm::inverse(to_xyz(kPrimaries.front())) * to_xyz(*primaries));
    return colours;
}

float Encoding::light(float stored) const {
    switch (kind) {
        case Kind::linear:
            return stored;
        // Floats that say they are encoded may lie outside 0..1; mirrored and continued, nothing is lost.
        case Kind::srgb:
            return std::copysign(srgb_to_linear(std::abs(stored)), stored);
        case Kind::power:
            return std::copysign(portable::pow(std::abs(stored), gamma), stored);
        case Kind::pq:
            return pq_light(stored);
        case Kind::hlg:
            return hlg_light(stored);
    }
    return stored;
}

glm::vec3 shown_hlg(glm::vec3 seen) {
    constexpr float kScreen = 1000, kGamma = 1.2f;
    constexpr glm::vec3 kLuminance{0.2126f, 0.7152f, 0.0722f};
    const float luminance = std::max(glm::dot(seen, kLuminance), 0.0f);
    return seen * (kScreen / kPaperWhite * portable::pow(luminance, kGamma - 1));
}

ColourProfile::ColourProfile(std::string_view icc, int values, const Encoding& usual) {
    if (icc.empty()) return;
    const Profile own(cmsOpenProfileFromMem(icc.data(), static_cast<cmsUInt32Number>(icc.size())),
                      &cmsCloseProfile);
    if (!own || cmsGetColorSpace(own.get()) != (values == 1 ? cmsSigGrayData : cmsSigRgbData)) return;
    transform_ =
        cmsCreateTransform(own.get(), values == 1 ? TYPE_GRAY_FLT : TYPE_RGB_FLT, linear_light().get(),
                           TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE);
    if (!transform_) return;
    if (says_the_same(values, usual)) {
        cmsDeleteTransform(transform_);
        transform_ = nullptr;
        return;
    }
    if (values == 3 && !cmsIsMatrixShaper(own.get())) return;
    const auto count = static_cast<std::size_t>(values);
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<float> stored(kLevels * count, 0.0f);
        for (std::size_t i = 0; i < kLevels; ++i)
            stored[i * count + k] = static_cast<float>(i) / (kLevels - 1);
        transform(stored, parts_.emplace_back(kLevels));
        // All parts have black in them; it is to count once.
        const glm::vec3 black = parts_[k][0];
        if (k > 0)
            for (glm::vec3& part : parts_[k]) part -= black;
    }
}

ColourProfile::~ColourProfile() {
    if (transform_) cmsDeleteTransform(transform_);
}

bool ColourProfile::says_the_same(int values, const Encoding& usual) const {
    constexpr int kSteps = 8;
    constexpr float kSame = 0.004f;  // a step of 8 bits where there are fewest
    std::vector<float> stored;
    for (int i = 0; i < (values == 1 ? kSteps : kSteps * kSteps * kSteps); ++i)
        for (int k = 0, digits = i; k < values; ++k, digits /= kSteps)
            stored.push_back(static_cast<float>(digits % kSteps) / (kSteps - 1));
    std::vector<glm::vec3> light(stored.size() / static_cast<std::size_t>(values));
    to_light(stored, light);
    for (std::size_t i = 0; i < light.size() * 3; ++i) {
        const std::size_t value = values == 1 ? i / 3 : i;
        const float own = light[i / 3][static_cast<int>(i % 3)];
        if (std::abs(own - usual.light(stored[value])) > kSame) return false;
    }
    return true;
}

void ColourProfile::transform(std::span<const float> stored, std::span<glm::vec3> light) const {
    cmsDoTransform(transform_, stored.data(), light.data(), static_cast<cmsUInt32Number>(light.size()));
}

void ColourProfile::to_light(std::span<const float> stored, std::span<glm::vec3> light) const {
    if (parts_.empty()) {
        transform(stored, light);
    } else {
        for (glm::vec3& colour : light) {
            colour = glm::vec3(0);
            for (std::size_t k = 0; k < parts_.size(); ++k) colour += parts_[k][level_of(stored[k])];
            stored = stored.subspan(parts_.size());
        }
    }
    for (glm::vec3& colour : light) colour = glm::max(colour, 0.0f);
}

}  // namespace dapple
