#include "io/decoding/code_points.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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

}  // namespace dapple
