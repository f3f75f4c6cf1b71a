// JPEG XL, which OpenImageIO 2.4 does not read. The library turns a picture upright itself, whatever an EXIF
// beside it says.
#include <jxl/decode.h>
#include <jxl/version.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "io/decoding/colour_profile.h"
#include "io/decoding/decoded_image.h"
#include "io/decoding/stored_pixels.h"

namespace dapple {
namespace {

// Release 0.9 left out an argument that was of no use.
#if JPEGXL_NUMERIC_VERSION < JPEGXL_COMPUTE_NUMERIC_VERSION(0, 9, 0)
#define DAPPLE_NO_FORMAT nullptr,
#else
#define DAPPLE_NO_FORMAT
#endif

[[noreturn]] void fail_damaged() {
    throw DecodeError("the picture is damaged");
}

class JxlReader {
 public:
    explicit JxlReader(int file) : file_(file), decoder_(JxlDecoderCreate(nullptr), &JxlDecoderDestroy) {
        if (!decoder_ ||
            JxlDecoderSubscribeEvents(decoder_.get(), JXL_DEC_BASIC_INFO | JXL_DEC_COLOR_ENCODING |
                                                          JXL_DEC_FULL_IMAGE) != JXL_DEC_SUCCESS)
            throw DecodeError(kTooMuchMemory);
    }

    JxlDecoder* get() const { return decoder_.get(); }

    /// What comes next, once all that it takes of the file was given.
    JxlDecoderStatus next() {
        for (;;) {
            const JxlDecoderStatus status = JxlDecoderProcessInput(decoder_.get());
            if (status != JXL_DEC_NEED_MORE_INPUT) return status;
            give_more();
        }
    }
    void expect(JxlDecoderStatus event, const char* otherwise) {
        if (next() != event) throw DecodeError(otherwise);
    }

 private:
    void give_more() {
        constexpr std::size_t kMore = 1 << 18;
        const std::size_t left = JxlDecoderReleaseInput(decoder_.get());
        input_.erase(input_.begin(), input_.end() - static_cast<std::ptrdiff_t>(left));
        input_.resize(left + kMore);
        const ssize_t got = ::read(file_, input_.data() + left, kMore);
        if (got <= 0) throw DecodeError("the picture is damaged (the file ends too early)");
        input_.resize(left + static_cast<std::size_t>(got));
        JxlDecoderSetInput(decoder_.get(), input_.data(), input_.size());
    }

    int file_;
    std::unique_ptr<JxlDecoder, decltype(&JxlDecoderDestroy)> decoder_;
    std::vector<unsigned char> input_;
};

// Of what the decoder gives: named, with the numbers of ITU-T H.273, or else by a profile.
void set_colours(JxlDecoder* decoder, PixelLayout& layout) {
    constexpr JxlColorProfileTarget target = JXL_COLOR_PROFILE_TARGET_DATA;
    JxlColorEncoding named{};
    if (JxlDecoderGetColorAsEncodedProfile(decoder, DAPPLE_NO_FORMAT target, &named) == JXL_DEC_SUCCESS) {
        constexpr int kP3OfScreens = 12;
        const bool p3 = named.primaries == JXL_PRIMARIES_P3 && named.white_point == JXL_WHITE_POINT_D65;
        const bool grey = named.color_space == JXL_COLOR_SPACE_GRAY;
        const auto colours = coded_colours({.primaries = grey ? 1
                                                         : p3 ? kP3OfScreens
                                                              : named.primaries,
                                            .transfer = named.transfer_function});
        const bool known =
            grey || p3 || named.primaries == JXL_PRIMARIES_P3 || named.white_point == JXL_WHITE_POINT_D65;
        if (colours && known) {
            layout.encoding = colours->encoding;
            layout.to_srgb = colours->to_srgb;
            return;
        }
    }
    std::size_t size = 0;
    if (JxlDecoderGetICCProfileSize(decoder, DAPPLE_NO_FORMAT target, &size) != JXL_DEC_SUCCESS) return;
    std::vector<unsigned char> icc(size);
    if (JxlDecoderGetColorAsICCProfile(decoder, DAPPLE_NO_FORMAT target, icc.data(), size) == JXL_DEC_SUCCESS)
        layout.profile.assign(icc.begin(), icc.end());
}

// Numbers as they are stored.
float value_at(const unsigned char* bytes, JxlDataType type, std::size_t i) {
    if (type == JXL_TYPE_UINT8) return static_cast<float>(bytes[i]) / 255.0f;
    if (type == JXL_TYPE_UINT16) {
        std::uint16_t number;
        std::memcpy(&number, bytes + i * sizeof number, sizeof number);
        return static_cast<float>(number) / 65535.0f;
    }
    float number;
    std::memcpy(&number, bytes + i * sizeof number, sizeof number);
    return number;
}

}  // namespace

void decode(int file, PictureFormat, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink) {
    JxlReader reader(file);
    reader.expect(JXL_DEC_BASIC_INFO, "not a picture that can be read");
    JxlBasicInfo info{};
    if (JxlDecoderGetBasicInfo(reader.get(), &info) != JXL_DEC_SUCCESS) fail_damaged();
    check_size(info.xsize, info.ysize, static_cast<int>(info.num_color_channels + info.num_extra_channels),
               request);
    const bool floats = info.exponent_bits_per_sample > 0;
    const int colours = static_cast<int>(info.num_color_channels);
    const JxlDataType type = floats || info.bits_per_sample > 16 ? JXL_TYPE_FLOAT
                             : info.bits_per_sample > 8          ? JXL_TYPE_UINT16
                                                                 : JXL_TYPE_UINT8;
    const std::size_t value_bytes = type == JXL_TYPE_FLOAT ? 4 : type == JXL_TYPE_UINT16 ? 2 : 1;
    const std::uint64_t pixels = std::uint64_t{info.xsize} * info.ysize;

    PixelLayout layout;
    layout.channels.colour = {0, colours == 1 ? 0 : 1, colours == 1 ? 0 : 2};
    layout.count = colours + (info.alpha_bits > 0 ? 1 : 0);
    if (info.alpha_bits > 0) layout.channels.alpha = colours;
    layout.premultiplied = info.alpha_premultiplied != 0;
    layout.eight_bit = type == JXL_TYPE_UINT8;
    layout.over_paper = request.over_paper;
    // The library's own planes of floats are there beside what it gives.
    constexpr std::uint64_t kOwnBytes = 4;
    const std::size_t row_values = std::size_t{info.xsize} * static_cast<std::size_t>(layout.count),
                      row_bytes = row_values * value_bytes;
    const std::uint64_t bytes = std::uint64_t{row_bytes} * info.ysize,
                        own = pixels * kOwnBytes * (3 + info.num_extra_channels);
    before_pixels({.in_memory = bytes + 2 * own, .in_all = bytes + own});

    reader.expect(JXL_DEC_COLOR_ENCODING, "the picture is damaged");
    set_colours(reader.get(), layout);
    reader.expect(JXL_DEC_NEED_IMAGE_OUT_BUFFER, "the picture is damaged");
    const JxlPixelFormat format{static_cast<std::uint32_t>(layout.count), type, JXL_NATIVE_ENDIAN, 0};
    std::vector<unsigned char> stored(bytes);
    std::size_t needed = 0;
    if (JxlDecoderImageOutBufferSize(reader.get(), &format, &needed) != JXL_DEC_SUCCESS || needed > bytes ||
        JxlDecoderSetImageOutBuffer(reader.get(), &format, stored.data(), stored.size()) != JXL_DEC_SUCCESS)
        fail_damaged();
    reader.expect(JXL_DEC_FULL_IMAGE, "the picture is damaged");

    const ImageHeader header{
        .width = static_cast<int>(info.xsize),
        .height = static_cast<int>(info.ysize),
        .grey = layout.channels.grey(),
        .description = describe(static_cast<int>(info.xsize), static_cast<int>(info.ysize),
                                floats ? "float" : std::to_string(info.bits_per_sample) + "-bit",
                                layout.channels, "jxl"),
        .scene_light = floats && layout.encoding.kind == Encoding::Kind::linear && layout.profile.empty()};
    StoredPixels decoder(layout);
    std::vector<float> values(row_values);
    std::vector<glm::vec3> light(info.xsize);
    sink.begin(header);
    for (int y = 0; y < header.height; ++y) {
        const unsigned char* const row = stored.data() + static_cast<std::size_t>(y) * row_bytes;
        for (std::size_t i = 0; i < row_values; ++i) values[i] = value_at(row, type, i);
        decoder.decode(values, y, light);
        sink.row(light);
    }
}

}  // namespace dapple
