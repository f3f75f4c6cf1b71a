// Any format but PNG. OpenImageIO's headers come with an fmt of their own: nothing else of it here.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/decoding/bmp_runs.h"
#include "io/decoding/changed_beginning.h"
#include "io/decoding/decode.h"
#include "io/decoding/psd_picture.h"
#include "io/decoding/radiance_header.h"
#include "io/decoding/stored_pixels.h"
#include "io/decoding/tiff_doubles.h"

namespace dapple {
namespace {

constexpr int kBandRows = 64;
constexpr const char* kWholeOnly = "is read as a whole only";

// `what`, and in brackets what a codec says, without its line ends and without the descriptor that it took
// for the file's name.
DecodeError error_of(const std::string& what, std::string message, const std::string& name) {
    // Some codecs catch it and say its name.
    if (message.find("bad_alloc") != message.npos) return DecodeError(kTooMuchMemory);
    for (const std::string& part :
         {" (\"" + name + "\")", " \"" + name + "\"", "\"" + name + "\"", " " + name, name}) {
        for (std::size_t at; (at = message.find(part)) != message.npos;) message.erase(at, part.size());
    }
    if (const std::size_t end = message.find('\n'); end != message.npos) message.resize(end);
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) message.pop_back();
    message.erase(0, message.find_first_not_of(' '));
    return DecodeError(message.empty() ? what : what + " (" + message + ")");
}

// Some readers take memory for a whole picture to look at its header: its size is judged before.
void expect_stated_size(int file, PictureFormat format, const DecodeRequest& request,
                        const BeforePixels& before_pixels) {
    constexpr int kChannels = 4;
    std::array<unsigned char, kFormatBytes> beginning{};
    const ssize_t got = ::pread(file, beginning.data(), beginning.size(), 0);
    if (got < 0) return;
    const auto size = stated_size(format, {beginning.data(), static_cast<std::size_t>(got)});
    if (!size) return;
    check_size(size->width, size->height, kChannels, request);
    const auto row = static_cast<std::uint64_t>(size->width * kChannels),
               bytes = row * static_cast<std::uint64_t>(size->height);
    before_pixels({.in_memory = bytes + row * kBandRows * sizeof(float), .in_all = bytes});
}

// `halved`: a raw file's picture in half its size, for which no colours are guessed between the sensor's.
// `from`: what it is read from instead of the file of that name, if there is any.
std::unique_ptr<OIIO::ImageInput> open_picture(const std::string& name, PictureFormat format, bool halved,
                                               OIIO::Filesystem::IOProxy* from) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(std::string(reader_of(format)));
    if (!input) throw DecodeError("cannot be read: " + OIIO::geterror());
    if (from) input->set_ioproxy(from);
    OIIO::ImageSpec spec, wishes;
    // Colours as stored: dividing 8-bit colours by alpha again would lose them.
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    if (halved) wishes.attribute("raw:half_size", 1);
    if (!input->open(name, spec, wishes))
        throw error_of("not a picture that can be read", input->geterror(), name);
    // Some files begin with a header that has no picture.
    int picture = 0;
    while (input->spec().width <= 0 || input->spec().height <= 0) {
        if (!input->seek_subimage(++picture, 0)) throw DecodeError("there is no picture in the file");
    }
    return input;
}

Channels channels_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    Channels channels;
    const auto named = [&](std::string_view name) {
        const auto same = [&](const std::string& other) {
            return OIIO::Strutil::iequals(other, std::string(name));
        };
        const auto found = std::ranges::find_if(spec.channelnames, same);
        return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
    };
    // Where OpenImageIO says that it is none of the channels, as of GIF, it has its name. Grey TGA has none
    // either.
    const int alpha = spec.alpha_channel >= 0 && spec.alpha_channel < spec.nchannels ? spec.alpha_channel
                      : format == PictureFormat::targa && spec.nchannels == 2        ? 1
                                                                                     : named("A");
    if (alpha >= 0) channels.alpha = alpha;
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

Encoding encoding_of(const OIIO::ImageSpec& spec) {
    const std::string name = OIIO::Strutil::lower(spec.get_string_attribute("oiio:ColorSpace"));
    if (name.starts_with("lin") || name == "scene_linear") return {Encoding::Kind::linear};
    const bool srgb = name.starts_with("srgb");
    // "Gamma2.2", or some name for it, with the number beside it; release 3 says "g22_rec709_scene".
    float gamma = srgb ? 0 : spec.get_float_attribute("oiio:Gamma", 0.0f);
    if (gamma <= 0 && name.starts_with("gamma")) gamma = OIIO::Strutil::from_string<float>(name.substr(5));
    if (gamma == 1) return {Encoding::Kind::linear};
    if (gamma > 0) return {Encoding::Kind::power, gamma};
    // PFM's floats are light, though OpenImageIO takes them for encoded as PPM's integers are.
    if (spec.format.is_floating_point() && !srgb) return {Encoding::Kind::linear};
    return {Encoding::Kind::srgb};
}

// The ICC profile of integer pixels; floats are light, whatever profile they are shown by.
std::string profile_of(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const icc = spec.find_attribute("ICCProfile");
    if (!icc || icc->type().basetype != OIIO::TypeDesc::UINT8 || spec.format.is_floating_point()) return {};
    return {static_cast<const char*>(icc->data()), static_cast<std::size_t>(icc->datasize())};
}

// Whether colours come multiplied by alpha. Readers that leave them alone do not all say so.
bool is_premultiplied(const OIIO::ImageSpec& spec, PictureFormat format) {
    constexpr int kPremultipliedTarga = 4;
    if (spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0) return false;
    if (format == PictureFormat::targa)
        return spec.get_int_attribute("targa:alpha_type", 0) == kPremultipliedTarga;
    return format != PictureFormat::bmp && format != PictureFormat::gif && format != PictureFormat::jpeg2000;
}

PixelLayout layout_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    PixelLayout layout;
    layout.channels = channels_of(spec, format);
    layout.count = spec.nchannels;
    layout.encoding = encoding_of(spec);
    layout.profile = profile_of(spec);
    layout.premultiplied = layout.channels.alpha && is_premultiplied(spec, format);
    layout.eight_bit = spec.format == OIIO::TypeDesc::UINT8;
    return layout;
}

std::string kind_of(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return "float";
    const int bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(spec.format.size()) * 8);
    return std::to_string(bits) + "-bit";
}

// Goes to the smallest of the picture's copies in the file whose longer side is long enough: mipmaps, and in
// TIFF pages that are said to be such. Throws DecodeError if there is none of half its size or less.
void go_to_smaller(OIIO::ImageInput& input, int enough_side) {
    constexpr int kMostCopies = 31;  // each is half as large
    const OIIO::ImageSpec whole = input.spec();
    const auto longer_side = [](const OIIO::ImageSpec& spec) { return std::max(spec.width, spec.height); };
    const int picture = input.current_subimage();
    int smallest = longer_side(whole) / 2 + 1, found_in = -1, found_level = 0;
    const auto look = [&](int subimage, int level) {
        const OIIO::ImageSpec& copy = input.spec();
        const int side = longer_side(copy);
        const std::int64_t skew =
            std::int64_t{copy.width} * whole.height - std::int64_t{copy.height} * whole.width;
        if (side < enough_side || side >= smallest || std::abs(skew) > longer_side(whole)) return;
        smallest = side;
        found_in = subimage;
        found_level = level;
    };
    for (int level = 1; level <= kMostCopies && input.seek_subimage(picture, level); ++level)
        look(picture, level);
    const auto is_copy = [&] { return (input.spec().get_int_attribute("tiff:subfiletype") & 1) != 0; };
    for (int page = picture + 1; page <= picture + kMostCopies && input.seek_subimage(page, 0) && is_copy();
         ++page)
        look(page, 0);
    static_cast<void>(input.geterror());  // of the copy after the last
    if (found_in < 0 || !input.seek_subimage(found_in, found_level)) throw DecodeError(kWholeOnly);
}

// How many rows are read at a time: whole tiles or strips where their library has to be asked for them.
int band_rows_of(const OIIO::ImageSpec& spec, bool whole_strips) {
    int rows = kBandRows;
    if (spec.tile_width != 0) {
        rows = spec.tile_height;
    } else if (whole_strips) {
        const int strip = std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, spec.height);
        rows = strip * std::max(1, kBandRows / strip);
    }
    return std::min(rows, spec.height);
}

// Rows [begin, end) of the file as floats.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end, float* pixels) {
    const int subimage = input.current_subimage(), level = input.current_miplevel();
    if (spec.tile_width == 0) {
        return input.read_scanlines(subimage, level, spec.y + begin, spec.y + end, spec.z, 0, spec.nchannels,
                                    OIIO::TypeDesc::FLOAT, pixels);
    }
    return input.read_tiles(subimage, level, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end,
                            spec.z, spec.z + 1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels);
}

// In formats of Windows' the fourth byte of a pixel is often of no use, and then 0 everywhere: a picture that
// is transparent all over nobody would keep.
void forget_unused_alpha(PixelLayout& layout, const OIIO::ImageSpec& spec, int band_rows,
                         std::span<const float> band, const std::function<void(int, int)>& read) {
    if (!layout.channels.alpha) return;
    const auto alpha = static_cast<std::size_t>(*layout.channels.alpha),
               count = static_cast<std::size_t>(spec.nchannels);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        read(begin, end);
        const std::size_t values = count * static_cast<std::size_t>(spec.width) * (end - begin);
        for (std::size_t i = alpha; i < values; i += count)
            if (band[i] > 0) return;
    }
    layout.channels.alpha.reset();
    layout.premultiplied = false;
}

// How wide a pixel is for its height, by the resolutions across and down. Those of JFIF are read here:
// OpenImageIO leaves some of them out, and has others the wrong way round.
float pixel_aspect_of(const OIIO::ImageSpec& spec, int file, PictureFormat format) {
    std::array<unsigned char, 18> jfif{};
    if (format == PictureFormat::jpeg && ::pread(file, jfif.data(), jfif.size(), 0) == 18 &&
        std::string_view(reinterpret_cast<const char*>(jfif.data()) + 6, 4) == "JFIF") {
        const int across = jfif[14] << 8 | jfif[15], down = jfif[16] << 8 | jfif[17];
        return across > 0 && down > 0 ? static_cast<float>(down) / static_cast<float>(across) : 1;
    }
    const float across = spec.get_float_attribute("XResolution", 0),
                down = spec.get_float_attribute("YResolution", 0);
    if (across > 0 && down > 0) return down / across;
    return format == PictureFormat::jpeg ? 1 : spec.get_float_attribute("PixelAspectRatio", 1);
}

// The picture's window, where that is not just what is stored. Only these two formats have one: what
// OpenImageIO says of TGA and JPEG 2000 are places on a screen or a grid.
std::optional<DisplayWindow> window_of(const OIIO::ImageSpec& spec, PictureFormat format) {
    if ((format != PictureFormat::openexr && format != PictureFormat::tiff) ||
        OIIO::Strutil::starts_with(spec.get_string_attribute("textureformat"), "CubeFace"))
        return std::nullopt;
    const DisplayWindow window{.width = spec.full_width,
                               .height = spec.full_height,
                               .x = std::int64_t{spec.x} - spec.full_x,
                               .y = std::int64_t{spec.y} - spec.full_y};
    if (window.x == 0 && window.y == 0 && window.width == spec.width && window.height == spec.height)
        return std::nullopt;
    return window;
}

// What is read in place of a file that OpenImageIO reads wrong.
std::unique_ptr<ChangedBeginning> changed(int file, std::vector<unsigned char> beginning,
                                          std::uint64_t rest) {
    return std::make_unique<ChangedBeginning>(std::move(beginning), file, rest);
}

}  // namespace

void decode(int file, PictureFormat format, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink) {
    expect_stated_size(file, format, request, before_pixels);
    std::unique_ptr<ChangedBeginning> from;
    std::optional<RadianceHeader> radiance;
    std::optional<PsdPicture> psd;
    if (format == PictureFormat::radiance) {
        radiance = radiance_header(file);
        from = changed(file, {radiance->plain.begin(), radiance->plain.end()}, radiance->size);
    } else if (format == PictureFormat::psd) {
        psd.emplace(file);
        from = changed(file, psd->beginning(), psd->rest());
    } else if (format == PictureFormat::bmp) {
        if (auto plain = bmp_without_runs(file)) from = changed(file, std::move(*plain), INT64_MAX);
    }
    const std::string name = "/dev/fd/" + std::to_string(file);
    const bool halved = format == PictureFormat::raw && request.enough_side > 0;
    const std::unique_ptr<OIIO::ImageInput> input = open_picture(name, format, halved, from.get());
    OIIO::ImageSpec whole = input->spec();
    const std::optional<DisplayWindow> window = window_of(whole, format);
    if (window) check_size(window->width, window->height, whole.nchannels, request);
    if (window && request.enough_side > 0) throw DecodeError(kWholeOnly);
    if (halved) {
        if (std::max(whole.width, whole.height) < request.enough_side) throw DecodeError(kWholeOnly);
        whole.width *= 2;
        whole.height *= 2;
    }
    check_size(whole.width, whole.height, whole.nchannels, request);
    if (request.enough_side > 0 && !halved) go_to_smaller(*input, request.enough_side);
    OIIO::ImageSpec spec = input->spec();
    if (psd && psd->has_transparency()) {
        spec.nchannels = psd->channels();
        spec.alpha_channel = spec.nchannels - 1;
        spec.channelnames.resize(static_cast<std::size_t>(spec.nchannels), "A");
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    check_size(spec.width, spec.height, spec.nchannels, request);
    if (spec.get_string_attribute("oiio:ColorSpace") == "color separated")
        throw DecodeError(
            "is in inks for print, such as CMYK, which cannot be read here; save it as RGB or grey");

    const std::size_t row_values = static_cast<std::size_t>(spec.width) * spec.nchannels;
    const bool in_doubles = format == PictureFormat::tiff && spec.format == OIIO::TypeDesc::DOUBLE;
    const int band_rows = band_rows_of(spec, in_doubles);
    const std::size_t stored = row_values * spec.height * std::max<std::size_t>(spec.format.size(), 1);
    before_pixels({.in_memory = stored + row_values * band_rows * sizeof(float), .in_all = stored});
    std::vector<float> band(row_values * band_rows);
    std::optional<TiffDoubles> doubles;
    // A page is one that OpenImageIO takes for a picture of the file's or for a copy of the first.
    const int page = input->current_subimage() + input->current_miplevel();
    if (in_doubles) doubles.emplace(file, page, spec.width, spec.height, spec.nchannels);
    const auto read = [&](int begin, int end) {
        if (doubles) return doubles->read(begin, end, band.data());
        if (psd && psd->has_transparency()) return psd->read(begin, end, band.data());
        // The JPEG reader goes on after a file ends too early, but says so.
        if (!read_rows(*input, spec, begin, end, band.data()) || input->has_error())
            throw error_of("the picture is damaged", input->geterror(), name);
    };

    PixelLayout layout = layout_of(spec, format);
    if (radiance) layout.to_srgb = radiance->light;
    if (format == PictureFormat::bmp || format == PictureFormat::targa)
        forget_unused_alpha(layout, spec, band_rows, band, read);
    const int orientation = radiance ? radiance->orientation : whole.get_int_attribute("Orientation", 1);
    const int width = window ? window->width : whole.width, height = window ? window->height : whole.height;
    const ImageHeader header{
        .width = spec.width,
        .height = spec.height,
        .orientation = orientation >= 1 && orientation <= 8 ? orientation : 1,
        .grey = layout.channels.grey(),
        .description = describe(width, height, kind_of(whole), layout.channels, input->format_name()),
        .scene_light = spec.format.is_floating_point() && layout.encoding.kind == Encoding::Kind::linear,
        .pixel_aspect = radiance ? radiance->pixel_aspect : pixel_aspect_of(whole, file, format),
        .window = window};
    layout.over_paper = request.over_paper;
    StoredPixels decoder(layout);
    std::vector<glm::vec3> colours(spec.width);
    for (int begin = 0; begin < spec.height; begin += band_rows) {
        const int end = std::min(begin + band_rows, spec.height);
        read(begin, end);
        if (begin == 0) sink.begin(header);
        for (int y = begin; y < end; ++y) {
            decoder.decode({band.data() + (y - begin) * row_values, row_values}, y, colours);
            sink.row(colours);
        }
    }
}

}  // namespace dapple
