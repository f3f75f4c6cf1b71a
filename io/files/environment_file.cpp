#include "io/files/environment_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/common.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/text/shown_text.h"
#include "io/decoding/decoded_image.h"
#include "io/decoding/decoder_process.h"

namespace dapple {

namespace {

template <class Number>
void put(std::string& bytes, Number number) {
    static_assert(std::endian::native == std::endian::little);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put_name(std::string& bytes, std::string_view name) {
    bytes.append(name).push_back('\0');
}

// One of the header's attributes.
void put_attribute(std::string& bytes, std::string_view name, std::string_view type, auto... values) {
    put_name(bytes, name);
    put_name(bytes, type);
    std::string value;
    (put(value, values), ...);
    put(bytes, static_cast<std::int32_t>(value.size()));
    bytes += value;
}

}  // namespace

// OpenEXR File Layout, https://openexr.com/en/latest/OpenEXRFileLayout.html: version 2, scan lines.
void write_exr(std::ostream& out, const Grid<float>& values) {
    constexpr std::int32_t kMagic = 20000630, kVersion = 2, kFloat = 2, kOne = 1;
    const std::int32_t right = values.width - 1, bottom = values.height - 1;
    const auto row_bytes = static_cast<std::int32_t>(sizeof(float)) * values.width;
    std::string header;
    put(header, kMagic);
    put(header, kVersion);
    // A channel "Y", its numbers' type, four bytes of no use here, one number a pixel each way; and no other.
    put_attribute(header, "channels", "chlist", 'Y', '\0', kFloat, std::int32_t{0}, kOne, kOne, '\0');
    put_attribute(header, "compression", "compression", '\0');
    for (const std::string_view window : {"dataWindow", "displayWindow"})
        put_attribute(header, window, "box2i", std::int32_t{0}, std::int32_t{0}, right, bottom);
    put_attribute(header, "lineOrder", "lineOrder", '\0');
    put_attribute(header, "pixelAspectRatio", "float", 1.0f);
    put_attribute(header, "screenWindowCenter", "v2f", 0.0f, 0.0f);
    put_attribute(header, "screenWindowWidth", "float", 1.0f);
    header.push_back('\0');
    // Where each row begins, then the rows: its number, its size, its values.
    const std::uint64_t rows =
        header.size() + sizeof(std::uint64_t) * static_cast<std::uint64_t>(values.height);
    for (int y = 0; y < values.height; ++y)
        put(header, rows + static_cast<std::uint64_t>(y) * (8 + static_cast<std::uint64_t>(row_bytes)));
    out << header;
    for (int y = 0; y < values.height; ++y) {
        std::string row;
        put(row, std::int32_t{y});
        put(row, row_bytes);
        out << row;
        out.write(reinterpret_cast<const char*>(values.row(y)), row_bytes);
    }
}

namespace {

class RadianceSink : public ImageSink {
 public:
    void begin(const ImageHeader& header) override {
        header_ = header;
        orientation_ = {header.orientation};
        radiance = orientation_.swaps_sides() ? Grid<glm::vec3>(header.height, header.width)
                                              : Grid<glm::vec3>(header.width, header.height);
    }
    void row(std::span<const glm::vec3> colours) override {
        for (int x = 0; x < header_.width; ++x) {
            const glm::ivec2 to = orientation_.upright(x, row_, header_.width, header_.height);
            radiance.at(to.x, to.y) = colours[static_cast<std::size_t>(x)];
        }
        ++row_;
    }
    const ImageHeader& header() const { return header_; }

    Grid<glm::vec3> radiance;

 private:
    ImageHeader header_;
    ExifOrientation orientation_;
    int row_ = 0;
};

// How many there were.
std::size_t without_below_zero(Grid<glm::vec3>& radiance) {
    std::size_t count = 0;
    for (glm::vec3& light : radiance.values) {
        count += light.x < 0 || light.y < 0 || light.z < 0;
        light = glm::max(light, 0.0f);
    }
    return count;
}

}  // namespace

EnvironmentFile read_environment(const std::filesystem::path& path, LightBelowZero below_zero,
                                 const std::stop_token& stop) {
    RadianceSink sink;
    try {
        // Pixels of directions are no squares.
        decode_file(path, {.over_paper = false, .square_pixels = false}, sink, stop);
        const std::size_t count = below_zero == LightBelowZero::none ? without_below_zero(sink.radiance) : 0;
        const std::size_t pixels = sink.radiance.values.size();
        if (count == pixels)
            throw std::runtime_error("light is below 0 at every pixel; repair the map first");
        const std::string remark =
            pixels == 1 ? "its one pixel is used as even light from all around" : sink.header().remark;
        return {EnvironmentMap(std::move(sink.radiance)), !sink.header().scene_light, count, remark};
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() +
                                 "; make the map smaller first");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what());
    }
}

}  // namespace dapple
