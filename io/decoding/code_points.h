#pragma once
// What colours are, by the numbers of ITU-T H.273, which PNG's chunk cICP has.

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "io/decoding/colour_profile.h"

namespace dapple {

struct CodePoints {
    int primaries = 1, transfer = 13, matrix = 0;
    bool full_range = true;
};

struct CodedColours {
    Encoding encoding;
    std::optional<glm::mat3> to_srgb;  // from light of these primaries; none: they are sRGB's
    std::string name;                  // "PQ, Rec. 2020"
};

/// For linear light, sRGB's curve, PQ and HLG, of the primaries of Rec. 709, Rec. 2020 and P3, of which white
/// is that of Rec. 709. Nothing: others, or no RGB of the full range.
std::optional<CodedColours> coded_colours(const CodePoints& points);

}  // namespace dapple
