// JPEG, smaller than it is stored: blocks of 8 x 8 pixels are transformed into fewer, which takes a fraction
// of the time. For a first look; all of the picture is read by OpenImageIO.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

// After <cstdio>, which it needs.
#include <jpeglib.h>

#include "io/decoding/decoded_image.h"
#include "io/decoding/stored_pixels.h"

namespace dapple {
namespace {

constexpr unsigned kEighths = 8;  // a picture is made so many eighths as large

// libjpeg's errors leave by longjmp(), and so never through code with destructors of its own.
struct JpegComplaint {
    jpeg_error_mgr manager{};  // first: libjpeg gives a pointer to it back
    std::jmp_buf back{};
    std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void leave_jpeg(j_common_ptr jpeg) {
    auto* const complaint = reinterpret_cast<JpegComplaint*>(jpeg->err);
    jpeg->err->format_message(jpeg, complaint->message.data());
    std::longjmp(complaint->back, 1);
}

// It goes on after what is damaged, and counts; here one is enough.
void leave_at_damage(j_common_ptr jpeg, int level) {
    if (level < 0) leave_jpeg(jpeg);
}

class JpegReader {
 public:
    explicit JpegReader(int file) : file_(::fdopen(::dup(file), "rb")) {
        if (!file_) throw DecodeError("cannot be read");
        jpeg_.err = jpeg_std_error(&complaint_.manager);
        complaint_.manager.error_exit = &leave_jpeg;
        complaint_.manager.emit_message = &leave_at_damage;
        jpeg_create_decompress(&jpeg_);
        jpeg_stdio_src(&jpeg_, file_);
        for (const int marker : {JPEG_APP0 + 1, JPEG_APP0 + 2}) jpeg_save_markers(&jpeg_, marker, 0xffff);
    }
    JpegReader& operator=(JpegReader&&) = delete;
    ~JpegReader() {
        jpeg_destroy_decompress(&jpeg_);
        std::fclose(file_);
    }

    jpeg_decompress_struct& jpeg() { return jpeg_; }

    /// `calls` has no destructors to run.
    template <class Calls>
    void call(const Calls& calls, const char* otherwise) {
        if (setjmp(complaint_.back) != 0)
            throw DecodeError(std::string(otherwise) + " (" + complaint_.message.data() + ")");
        calls(jpeg_);
    }

 private:
    std::FILE* file_;
    JpegComplaint complaint_;
    jpeg_decompress_struct jpeg_{};
};

int orientation_of(const jpeg_decompress_struct& jpeg) {
    constexpr std::array<unsigned char, 6> kExif{'E', 'x', 'i', 'f', 0, 0};
    for (const jpeg_marker_struct* marker = jpeg.marker_list; marker; marker = marker->next) {
        const std::span data(marker->data, marker->data_length);
        if (data.size() > kExif.size() && std::ranges::equal(data.first(kExif.size()), kExif))
            return orientation_in(data.subspan(kExif.size()));
    }
    return 1;
}

std::string profile_of(JpegReader& reader) {
    JOCTET* bytes = nullptr;
    unsigned size = 0;
    reader.call([&bytes, &size](jpeg_decompress_struct& j) { jpeg_read_icc_profile(&j, &bytes, &size); },
                "not a picture that can be read");
    if (!bytes) return {};
    const std::string profile(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return profile;
}

// The fewest eighths whose longer side is at least so long.
unsigned eighths_for(int enough_side, unsigned longer) {
    unsigned eighths = 1;
    while (eighths < kEighths && longer * eighths / kEighths < static_cast<unsigned>(enough_side)) ++eighths;
    return eighths;
}

}  // namespace

void decode(int file, PictureFormat, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink) {
    JpegReader reader(file);
    jpeg_decompress_struct& jpeg = reader.jpeg();
    reader.call([](jpeg_decompress_struct& j) { jpeg_read_header(&j, TRUE); },
                "not a picture that can be read");
    check_size(jpeg.image_width, jpeg.image_height, jpeg.num_components, request);
    if (jpeg.num_components != 1 && jpeg.num_components != 3)
        throw DecodeError(
            "is in inks for print, such as CMYK, which cannot be read here; save it as RGB or grey");
    const bool grey = jpeg.num_components == 1;
    const unsigned eighths =
        request.enough_side > 0
            ? eighths_for(request.enough_side, std::max(jpeg.image_width, jpeg.image_height))
            : kEighths;
    if (request.enough_side > 0 && eighths > kEighths / 2) throw DecodeError("is hardly larger than that");

    PixelLayout layout;
    layout.count = jpeg.num_components;
    layout.channels.colour = {0, grey ? 0 : 1, grey ? 0 : 2};
    layout.eight_bit = true;
    layout.profile = profile_of(reader);
    const std::string description =
        describe(static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height), "8-bit",
                 layout.channels, "jpeg");
    // A progressive file is kept whole as it is read, two bytes for each pixel of each channel.
    const std::uint64_t bytes = std::uint64_t{jpeg.image_width} * jpeg.image_height * layout.count;
    before_pixels({.in_memory = 3 * bytes, .in_all = bytes});
    reader.call(
        [=](jpeg_decompress_struct& j) {
            j.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
            j.scale_num = eighths;
            j.scale_denom = kEighths;
            jpeg_start_decompress(&j);
        },
        "the picture is damaged");
    const bool has_densities = jpeg.saw_JFIF_marker && jpeg.X_density > 0 && jpeg.Y_density > 0;
    const ImageHeader header{
        .width = static_cast<int>(jpeg.output_width),
        .height = static_cast<int>(jpeg.output_height),
        .orientation = orientation_of(jpeg),
        .grey = grey,
        .description = description,
        .pixel_aspect =
            has_densities ? static_cast<float>(jpeg.Y_density) / static_cast<float>(jpeg.X_density) : 1};
    StoredPixels decoder(layout);
    std::vector<unsigned char> row(std::size_t{jpeg.output_width} * layout.count);
    std::vector<float> values(row.size());
    std::vector<glm::vec3> colours(jpeg.output_width);
    for (int y = 0; y < header.height; ++y) {
        unsigned char* rows = row.data();
        reader.call([&rows](jpeg_decompress_struct& j) { jpeg_read_scanlines(&j, &rows, 1); },
                    "the picture is damaged");
        if (y == 0) sink.begin(header);
        std::ranges::transform(row, values.begin(),
                               [](unsigned char stored) { return static_cast<float>(stored) / 255; });
        decoder.decode(values, y, colours);
        sink.row(colours);
    }
}

}  // namespace dapple
