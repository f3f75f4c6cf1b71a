#include "app/files/environment_file.h"

#include <algorithm>
#include <glm/common.hpp>
#include <stdexcept>
#include <utility>

#include "app/decoding/decoder_process.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

class RadianceSink : public ImageSink {
 public:
    void begin(const ImageHeader& header) override {
        radiance = {header.width, header.height};
        ends_at_white = !header.scene_light;
    }
    void row(std::span<const glm::vec3> colours) override {
        std::ranges::copy(colours, &radiance.at(0, row_++));
    }

    Grid<glm::vec3> radiance;
    bool ends_at_white = false;

 private:
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
        decode_file(path, {.over_paper = false}, sink, stop);
        const std::size_t count = below_zero == LightBelowZero::none ? without_below_zero(sink.radiance) : 0;
        return {EnvironmentMap(std::move(sink.radiance)), sink.ends_at_white, count};
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() +
                                 "; make the map smaller first");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what());
    }
}

}  // namespace dapple
