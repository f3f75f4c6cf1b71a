#pragma once
// What light a picture's stored values stand for: by a usual encoding, or by its own ICC profile.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

struct Encoding {
    /// PQ and HLG are those of Rec. 2100.
    enum class Kind { linear, srgb, power, pq, hlg } kind = Kind::srgb;
    float gamma = 1;  // of a power

    /// The linear light of a stored value. With PQ, 1 is 203 cd/m2, the white of a sheet of paper in Rec.
    /// BT.2408; with HLG it is what a camera saw: see shown_hlg().
    float light(float stored) const;
};

/// Light of HLG, of sRGB's primaries, as a screen of 1000 cd/m2 shows it: 1 is the same white.
glm::vec3 shown_hlg(glm::vec3 seen);

class ColourProfile {
 public:
    /// `icc`: the profile's bytes, if there are any. `values`: how many a pixel has, 1 in a grey picture,
    /// otherwise 3. A profile for another number of values, or a damaged one, counts for nothing, and so does
    /// one that says what the usual encoding says, as most do.
    ColourProfile(std::string_view icc, int values, const Encoding& usual);
    ColourProfile& operator=(ColourProfile&&) = delete;
    ~ColourProfile();

    /// Whether it counts.
    explicit operator bool() const { return transform_; }

    /// Turns stored values, 0..1, of as many pixels as there are colours into linear light of sRGB's
    /// primaries, 0 where that would be below.
    void to_light(std::span<const float> stored, std::span<glm::vec3> light) const;

 private:
    void transform(std::span<const float> stored, std::span<glm::vec3> light) const;
    bool says_the_same(int values, const Encoding& usual) const;

    void* transform_ = nullptr;
    // Most profiles add what each value brings: by value, what that is. Empty: this one does not.
    std::vector<std::vector<glm::vec3>> parts_;
};

// What colours are, by the numbers of ITU-T H.273, which PNG's chunk cICP has.

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
