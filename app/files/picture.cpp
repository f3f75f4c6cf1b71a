#include "app/files/picture.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "app/files/picture_builder.h"
#include "app/files/silent_standard_error.h"
#include "app/grouped.h"
#include "core/image/tone.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUsualPixels = 400'000'000;
constexpr int kBandRows = 64;

// OpenImageIO's own fmt and ours do not agree, so this file joins its sentences by hand.
[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
}

// What a codec says, without its line ends and without the file's name once more.
std::string in_one_line(std::string message, const fs::path& path) {
    for (const std::string& name :
         {" (\"" + path.string() + "\")", "\"" + path.string() + "\"", path.string()}) {
        for (std::size_t at; (at = message.find(name)) != message.npos;) message.erase(at, name.size());
    }
    if (const std::size_t end = message.find('\n'); end != message.npos) message.resize(end);
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
    return message;
}

void check_readable(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) fail(path, "no such file");
    if (fs::is_directory(status)) fail(path, "is a folder, not a picture");
    if (fs::is_regular_file(status) && fs::file_size(path, error) == 0 && !error)
        fail(path, "the file is empty");
}

std::unique_ptr<OIIO::ImageInput> open_picture(const fs::path& path) {
    OIIO::ImageSpec wishes;
    // Colours as stored: dividing 8-bit colours by alpha again would lose them.
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &wishes);
    if (!input) {
        const std::string why = in_one_line(OIIO::geterror(), path);
        fail(path, "not a picture that can be read" + (why.empty() ? "" : " (" + why + ")"));
    }
    // Some files begin with a header that has no picture.
    int picture = 0;
    while (input->spec().width <= 0 || input->spec().height <= 0) {
        if (!input->seek_subimage(++picture, 0)) fail(path, "there is no picture in the file");
    }
    return input;
}

// Which channels of the file are what.
struct Channels {
    std::array<int, 3> colour{};  // three times the same: grey
    std::optional<int> alpha;
    bool grey() const { return colour[0] == colour[1] && colour[1] == colour[2]; }
};

Channels channels_of(const OIIO::ImageSpec& spec) {
    Channels channels;
    if (spec.alpha_channel >= 0 && spec.alpha_channel < spec.nchannels) channels.alpha = spec.alpha_channel;
    const auto named = [&](std::string_view name) {
        const auto same = [&](const std::string& other) {
            return OIIO::Strutil::iequals(other, std::string(name));
        };
        const auto found = std::ranges::find_if(spec.channelnames, same);
        return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
    };
    const int red = named("R"), green = named("G"), blue = named("B"), luminance = named("Y");
    if (red >= 0 && green >= 0 && blue >= 0) {
        channels.colour = {red, green, blue};
    } else if (luminance >= 0) {
        channels.colour = {luminance, luminance, luminance};
    } else {
        std::vector<int> others;
        for (int i = 0; i < spec.nchannels; ++i) {
            if (i != channels.alpha) others.push_back(i);
        }
        if (others.empty()) others.push_back(0);
        if (others.size() >= 3) {
            channels.colour = {others[0], others[1], others[2]};
        } else {
            channels.colour.fill(others[0]);
        }
    }
    if (channels.alpha && *channels.alpha == channels.colour[0]) channels.alpha.reset();
    return channels;
}

// How stored values become light.
struct Encoding {
    enum class Kind { linear, srgb, power } kind = Kind::srgb;
    float gamma = 1;  // of a power

    float light(float stored) const {
        switch (kind) {
            case Kind::linear:
                return stored;
            // Floats that say they are encoded may lie outside 0..1; mirrored and continued, nothing is lost.
            case Kind::srgb:
                return std::copysign(srgb_to_linear(std::abs(stored)), stored);
            case Kind::power:
                return std::copysign(std::pow(std::abs(stored), gamma), stored);
        }
        return stored;
    }
};

Encoding encoding_of(const OIIO::ImageSpec& spec) {
    const std::string name = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
    if (name.starts_with("lin") || name == "scene_linear") return {Encoding::Kind::linear};
    if (name.starts_with("gamma")) {
        // "Gamma2.2", or "GammaCorrected" with the number beside it.
        float gamma = spec.get_float_attribute("oiio:Gamma", 0.0f);
        if (gamma <= 0) gamma = OIIO::Strutil::from_string<float>(name.substr(5));
        if (gamma == 1) return {Encoding::Kind::linear};
        if (gamma > 0) return {Encoding::Kind::power, gamma};
    }
    if (name.empty() && spec.format.is_floating_point()) return {Encoding::Kind::linear};
    return {Encoding::Kind::srgb};
}

// Stored pixels to linear light over white paper.
class Decoder {
 public:
    explicit Decoder(const OIIO::ImageSpec& spec)
        : channels_(channels_of(spec)),
          count_(spec.nchannels),
          encoding_(encoding_of(spec)),
          premultiplied_(channels_.alpha && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0) {
        for (std::size_t i = 0; i < eight_bit_.size(); ++i) {
            eight_bit_[i] = encoding_.light(static_cast<float>(i) / 255.0f);
        }
        tabulated_ = spec.format == OIIO::TypeDesc::UINT8;
    }

    // False if a pixel is no number; the row is unfinished then.
    bool decode(std::span<const float> stored, std::span<glm::vec3> light) const {
        for (std::size_t i = 0; i < light.size(); ++i) {
            light[i] = over_paper(stored.data() + i * count_);
            if (!std::isfinite(light[i].x + light[i].y + light[i].z)) return false;
        }
        return true;
    }

 private:
    glm::vec3 over_paper(const float* pixel) const {
        if (!channels_.alpha) return light_of(pixel, 1);
        const float alpha = std::clamp(pixel[*channels_.alpha], 0.0f, 1.0f);
        if (!premultiplied_) return light_of(pixel, 1) * alpha + (1 - alpha);
        // Linear light is multiplied as light, and may glow where alpha is 0; encoded values as they are.
        if (encoding_.kind == Encoding::Kind::linear) return light_of(pixel, 1) + (1 - alpha);
        return alpha > 0 ? light_of(pixel, 1 / alpha) * alpha + (1 - alpha) : glm::vec3(1);
    }

    glm::vec3 light_of(const float* pixel, float factor) const {
        const auto light = [&](int channel) {
            const float stored = pixel[channel] * factor;
            if (tabulated_ && factor == 1)
                return eight_bit_[static_cast<std::size_t>(stored * 255.0f + 0.5f) & 255];
            return encoding_.light(stored);
        };
        if (channels_.grey()) return glm::vec3(light(channels_.colour[0]));
        return {light(channels_.colour[0]), light(channels_.colour[1]), light(channels_.colour[2])};
    }

    Channels channels_;
    std::size_t count_;
    Encoding encoding_;
    bool premultiplied_;
    bool tabulated_ = false;
    std::array<float, 256> eight_bit_{};
};

[[noreturn]] void fail_not_finite(const fs::path& path, std::span<const float> row,
                                  const OIIO::ImageSpec& spec, int y) {
    const auto bad = std::ranges::find_if(row, [](float v) { return !std::isfinite(v); });
    const bool is_nan = bad != row.end() && std::isnan(*bad);
    const auto x = (bad - row.begin()) / spec.nchannels;
    fail(path, std::string("pixel ") + std::to_string(x) + ", " + std::to_string(y) + " is " +
                   (is_nan ? "not a number (NaN)" : "infinite") +
                   "; repair the picture first, for example with oiiotool --fixnan box3");
}

std::string describe(const OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const Channels& channels) {
    std::string kind = spec.format.is_floating_point()
                           ? "float"
                           : std::to_string(spec.get_int_attribute(
                                 "oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8)) +
                                 "-bit";
    return std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels, " + kind +
           (channels.grey() ? " grey" : " colour") + (channels.alpha ? " with transparency" : "") + " " +
           input.format_name();
}

// Rows [begin, end) of the file as floats.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end, float* pixels) {
    const int subimage = input.current_subimage();
    if (spec.tile_width == 0) {
        return input.read_scanlines(subimage, 0, spec.y + begin, spec.y + end, spec.z, 0, spec.nchannels,
                                    OIIO::TypeDesc::FLOAT, pixels);
    }
    return input.read_tiles(subimage, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end, spec.z,
                            spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels);
}

}  // namespace

Picture read_picture(const fs::path& path, PictureLimit limit) {
    check_readable(path);
    const std::unique_ptr<OIIO::ImageInput> input = open_picture(path);
    const OIIO::ImageSpec spec = input->spec();
    if (limit == PictureLimit::usual && static_cast<std::int64_t>(spec.width) * spec.height > kUsualPixels) {
        fail(path, grouped(static_cast<std::uint64_t>(spec.width)) + " x " +
                       grouped(static_cast<std::uint64_t>(spec.height)) +
                       " pixels are over 400 megapixels; --huge reads it all the same");
    }

    if (spec.get_string_attribute("oiio:ColorSpace") == "color separated") {
        fail(path, "has the inks of a print, which cannot be mixed here; save it as RGB or grey");
    }

    const int orientation = spec.get_int_attribute("Orientation", 1);
    // libpng prints what it finds wrong, which comes as an exception too.
    std::optional<SilentStandardError> silence;
    if (std::string_view(input->format_name()) == "png") silence.emplace();

    PictureBuilder builder(spec.width, spec.height, {orientation});
    const Decoder decoder(spec);
    const std::size_t row_values = static_cast<std::size_t>(spec.width) * spec.nchannels;
    const int band_rows = spec.tile_width == 0 ? kBandRows : spec.tile_height;
    std::vector<float> band(row_values * std::min(band_rows, spec.height));
    std::vector<glm::vec3> colours(spec.width);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        const bool complete = read_rows(*input, spec, begin, end, band.data());
        // The JPEG reader goes on after a file ends too early, but says so.
        if (!complete || input->has_error()) {
            fail(path, "the picture is damaged (" + in_one_line(input->geterror(), path) + ")");
        }
        for (int y = begin; y < end; ++y) {
            const std::span<const float> row(band.data() + (y - begin) * row_values, row_values);
            if (!decoder.decode(row, colours)) fail_not_finite(path, row, spec, y);
            builder.add_row(y, colours);
        }
    }
    return builder.finish(describe(*input, spec, channels_of(spec)));
}

}  // namespace dapple
