// PNG. By itself, since libraries for all the other formats take a quarter of a second to load.
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/decoding/colour_profile.h"
#include "io/decoding/decoded_image.h"
#include "io/decoding/png_calls.h"
#include "io/decoding/stored_pixels.h"

namespace dapple {
namespace {

constexpr png_byte kCodePoints[] = "cICP";

// Reads from a file descriptor.
void read_bytes(png_structp png, png_bytep bytes, png_size_t size) {
    const int file = *static_cast<const int*>(png_get_io_ptr(png));
    while (size > 0) {
        const ssize_t got = ::read(file, bytes, size);
        if (got <= 0) png_error(png, "the file ends too early");
        bytes += got;
        size -= static_cast<png_size_t>(got);
    }
}

class PngReader {
 public:
    explicit PngReader(int file) : file_(file) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, &PngComplaint::fail,
                                      &PngComplaint::ignore);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) throw DecodeError("there is not enough memory to read it");
        // Sizes are ours to judge; single chunks, such as colour profiles, stay small.
        constexpr png_alloc_size_t kLargestChunk = 64 << 20;
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_chunk_malloc_max(png_, kLargestChunk);
        // Newer releases of libpng know it, older ones do not.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS, kCodePoints, 1);
        png_set_read_fn(png_, &file_, &read_bytes);
    }
    PngReader& operator=(PngReader&&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr); }

    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

    template <class Calls>
    void call(const Calls& calls, const char* otherwise) {
        if (!png_calls(png_, calls))
            throw DecodeError(std::string(otherwise) + " (" + complaint_.message + ")");
    }

 private:
    int file_;
    PngComplaint complaint_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

Encoding encoding_of(png_structp png, png_infop info) {
    double gamma = 0;
    if (png_get_valid(png, info, PNG_INFO_sRGB) || !png_get_gAMA(png, info, &gamma) || !(gamma > 0))
        return {Encoding::Kind::srgb};
    if (std::abs(gamma - 1) < 1e-3) return {Encoding::Kind::linear};
    return {Encoding::Kind::power, static_cast<float>(1 / gamma)};
}

std::optional<CodePoints> code_points_of(png_structp png, png_infop info) {
    png_unknown_chunkp chunks = nullptr;
    const int count = png_get_unknown_chunks(png, info, &chunks);
    for (const png_unknown_chunk& chunk : std::span(chunks, static_cast<std::size_t>(std::max(count, 0))))
        if (std::ranges::equal(chunk.name, kCodePoints) && chunk.size == 4)
            return CodePoints{chunk.data[0], chunk.data[1], chunk.data[2], chunk.data[3] == 1};
    return std::nullopt;
}

std::string profile_of(png_structp png, png_infop info) {
    png_charp name = nullptr;
    png_bytep bytes = nullptr;
    int packing = 0;
    png_uint_32 size = 0;
    if (png_get_iCCP(png, info, &name, &packing, &bytes, &size) == 0) return {};
    return {reinterpret_cast<const char*>(bytes), size};
}

int orientation_of(png_structp png, png_infop info) {
#ifdef PNG_eXIf_SUPPORTED
    png_uint_32 size = 0;
    png_bytep exif = nullptr;
    if (png_get_eXIf_1(png, info, &size, &exif) && exif) return orientation_in({exif, size});
#else
    (void)png, (void)info;
#endif
    return 1;
}

}  // namespace

void decode(int file, PictureFormat, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink) {
    PngReader reader(file);
    png_structp const png = reader.png();
    png_infop const info = reader.info();
    reader.call([&] { png_read_info(png, info); }, "not a picture that can be read");
    const auto width = static_cast<std::int64_t>(png_get_image_width(png, info)),
               height = static_cast<std::int64_t>(png_get_image_height(png, info));
    check_size(width, height, png_get_channels(png, info), request);
    const int stored_bits = png_get_bit_depth(png, info);

    // Palettes, fewer bits than 8 and a transparent colour become channels of their own.
    int passes = 1;
    reader.call(
        [&] {
            png_set_expand(png);
            if (stored_bits == 16 && std::endian::native == std::endian::little) png_set_swap(png);
            passes = png_set_interlace_handling(png);
            png_read_update_info(png, info);
        },
        "not a picture that can be read");
    const int channels = png_get_channels(png, info);
    const bool wide = png_get_bit_depth(png, info) == 16;

    PixelLayout layout;
    layout.count = channels;
    const int last_colour = channels < 3 ? 0 : 2;
    layout.channels.colour = {0, last_colour == 0 ? 0 : 1, last_colour};
    if (channels % 2 == 0) layout.channels.alpha = channels - 1;
    layout.encoding = encoding_of(png, info);
    layout.profile = profile_of(png, info);
    layout.eight_bit = !wide;
    std::string described = describe(static_cast<int>(width), static_cast<int>(height),
                                     std::to_string(stored_bits) + "-bit", layout.channels, "png");
    // Counts for more than all else that is said of colours.
    if (const auto points = code_points_of(png, info)) {
        if (const auto colours = coded_colours(*points)) {
            layout.encoding = colours->encoding;
            layout.to_srgb = colours->to_srgb;
            layout.profile.clear();
            described += ", " + colours->name;
        } else {
            described += ", whose cICP " + std::to_string(points->primaries) + "/" +
                         std::to_string(points->transfer) + " is not known here";
        }
    }
    const ImageHeader header{.width = static_cast<int>(width),
                             .height = static_cast<int>(height),
                             .orientation = orientation_of(png, info),
                             .grey = layout.channels.grey(),
                             .description = std::move(described),
                             .pixel_aspect = png_get_pixel_aspect_ratio(png, info)};
    layout.over_paper = request.over_paper;
    StoredPixels decoder(layout);

    // An interlaced picture has to be there as a whole; else a row at a time.
    const std::size_t row_bytes = png_get_rowbytes(png, info),
                      row_values = static_cast<std::size_t>(width) * channels;
    const std::size_t kept_rows = passes > 1 ? static_cast<std::size_t>(height) : 1;
    before_pixels({.in_memory = row_bytes * kept_rows + row_values * sizeof(float),
                   .in_all = row_bytes * static_cast<std::size_t>(height)});
    // As calloc() gives it: no memory is taken for rows that never come.
    const std::unique_ptr<unsigned char, decltype(&std::free)> kept(
        static_cast<unsigned char*>(std::calloc(kept_rows, row_bytes)), &std::free);
    if (!kept) throw std::bad_alloc();
    for (int pass = 0; pass + 1 < passes; ++pass) {
        reader.call(
            [&] {
                for (std::size_t y = 0; y < kept_rows; ++y)
                    png_read_row(png, kept.get() + y * row_bytes, nullptr);
            },
            "the picture is damaged");
    }
    std::vector<float> values(row_values);
    std::vector<glm::vec3> colours(static_cast<std::size_t>(width));
    for (int y = 0; y < static_cast<int>(height); ++y) {
        unsigned char* const row = kept.get() + (passes > 1 ? static_cast<std::size_t>(y) * row_bytes : 0);
        reader.call([&] { png_read_row(png, row, nullptr); }, "the picture is damaged");
        if (y == 0) sink.begin(header);
        const auto* const wide_row = reinterpret_cast<const std::uint16_t*>(row);
        for (std::size_t i = 0; i < row_values; ++i)
            values[i] =
                wide ? static_cast<float>(wide_row[i]) / 65535.0f : static_cast<float>(row[i]) / 255.0f;
        decoder.decode(values, y, colours);
        sink.row(colours);
    }
}

}  // namespace dapple
