#include "app/files/environment.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/image/tone.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostPixels = 400'000'000;
constexpr int kBandRows = 64;

// OpenImageIO's own fmt and ours do not agree, so this file joins its sentences by hand.
[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
}

std::string in_brackets(const std::string& message) {
    const std::string line = message.substr(0, message.find('\n'));
    return line.empty() ? "" : " (" + line + ")";
}

void check_readable(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) fail(path, "no such file");
    if (fs::is_directory(status)) fail(path, "is a folder, not an environment map");
    if (fs::is_regular_file(status) && fs::file_size(path, error) == 0 && !error)
        fail(path, "the file is empty");
}

// Red, green and blue by name, else the first three, else one for all.
std::array<int, 3> colour_channels(const OIIO::ImageSpec& spec) {
    std::array<int, 3> channels{-1, -1, -1};
    for (int i = 0; i < spec.nchannels; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (OIIO::Strutil::iequals(spec.channelnames[static_cast<std::size_t>(i)],
                                       std::string(1, "RGB"[c])))
                channels[c] = i;
        }
    }
    if (std::ranges::find(channels, -1) == channels.end()) return channels;
    return spec.nchannels >= 3 ? std::array{0, 1, 2} : std::array{0, 0, 0};
}

bool is_linear(const OIIO::ImageSpec& spec) {
    const std::string name = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
    return spec.format.is_floating_point() ? name != "srgb" : name == "linear";
}

}  // namespace

EnvironmentMap read_environment(const fs::path& path) {
    check_readable(path);
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
    if (!input) fail(path, "not a picture that can be read" + in_brackets(OIIO::geterror()));
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0) fail(path, "there is no picture in the file");
    if (static_cast<std::int64_t>(spec.width) * spec.height > kMostPixels) {
        fail(path, std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                       " pixels are over 400 megapixels; make the map smaller first");
    }

    const std::array<int, 3> channels = colour_channels(spec);
    const bool linear = is_linear(spec);
    const std::size_t row_values = static_cast<std::size_t>(spec.width) * spec.nchannels;
    const int band_rows = spec.tile_width == 0 ? kBandRows : spec.tile_height;
    std::vector<float> band(row_values * std::min(band_rows, spec.height));
    Grid<glm::vec3> radiance(spec.width, spec.height);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        const int top = spec.y + begin, bottom = spec.y + end;
        const bool complete =
            spec.tile_width == 0
                ? input->read_scanlines(0, 0, top, bottom, spec.z, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                        band.data())
                : input->read_tiles(0, 0, spec.x, spec.x + spec.width, top, bottom, spec.z, spec.z + 1, 0,
                                    spec.nchannels, OIIO::TypeDesc::FLOAT, band.data());
        if (!complete || input->has_error())
            fail(path, "the map is damaged" + in_brackets(input->geterror()));
        for (int y = begin; y < end; ++y) {
            const float* pixel = band.data() + static_cast<std::size_t>(y - begin) * row_values;
            for (int x = 0; x < spec.width; ++x, pixel += spec.nchannels) {
                glm::vec3& light = radiance.at(x, y);
                for (int c = 0; c < 3; ++c) {
                    const float stored = pixel[channels[static_cast<std::size_t>(c)]];
                    light[c] = linear ? stored : srgb_to_linear(stored);
                }
            }
        }
    }
    try {
        return EnvironmentMap(std::move(radiance));
    } catch (const std::runtime_error& error) {
        fail(path, error.what());
    }
}

}  // namespace dapple
