#include "io/files/environment_file.h"

#include <algorithm>
#include <glm/common.hpp>
#include <stdexcept>
#include <utility>

#include "core/text/shown_text.h"
#include "io/decoding/decoder_process.h"
#include "io/decoding/exif_orientation.h"

namespace dapple {
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
            pixels == 1 ? "its one pixel is taken as even light from all around" : sink.header().remark;
        return {EnvironmentMap(std::move(sink.radiance)), !sink.header().scene_light, count, remark};
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() +
                                 "; make the map smaller first");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what());
    }
}

}  // namespace dapple
