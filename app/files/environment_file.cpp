#include "app/files/environment_file.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/decoding/decoder_process.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

class RadianceSink : public ImageSink {
 public:
    void begin(const ImageHeader& header) override { radiance = {header.width, header.height}; }
    void row(std::span<const glm::vec3> colours) override {
        std::ranges::copy(colours, &radiance.at(0, row_++));
    }

    Grid<glm::vec3> radiance;

 private:
    int row_ = 0;
};

}  // namespace

EnvironmentMap read_environment(const std::filesystem::path& path, const std::stop_token& stop) {
    RadianceSink sink;
    try {
        decode_file(path, {.over_paper = false}, sink, stop);
        return EnvironmentMap(std::move(sink.radiance));
    } catch (const TooManyPixels& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what() +
                                 "; make the map smaller first");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(printable(path.string()) + ": " + error.what());
    }
}

}  // namespace dapple
