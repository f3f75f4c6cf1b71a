#include "io/files/png_file.h"

#include <zlib.h>

#include <cmath>
#include <exception>
#include <stdexcept>

#include "io/decoding/png_calls.h"

namespace dapple {
namespace {

constexpr double kMetresPerInch = 0.0254;

class PngWriter {
 public:
    explicit PngWriter(std::ostream& out) : out_(out) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint_, &PngComplaint::fail,
                                       &PngComplaint::ignore);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_) throw std::bad_alloc();
        png_set_write_fn(png_, this, &PngWriter::put, &PngWriter::flush);
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png_, info_ ? &info_ : nullptr); }

    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

    template <class Calls>
    void call(const Calls& calls) {
        if (png_calls(png_, calls)) return;
        if (thrown_) std::rethrow_exception(thrown_);
        throw std::runtime_error("the PNG cannot be written: " + complaint_.message);
    }

 private:
    // A stream may throw, but not through the C library in between: it is kept until that has been left.
    static void put(png_structp png, png_bytep bytes, png_size_t size) {
        auto* const self = static_cast<PngWriter*>(png_get_io_ptr(png));
        if (!self->write(bytes, size)) png_error(png, "the stream failed");
    }
    static void flush(png_structp) {}

    bool write(png_bytep bytes, png_size_t size) {
        try {
            out_.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
            return true;
        } catch (...) {
            thrown_ = std::current_exception();
            return false;
        }
    }

    std::ostream& out_;
    PngComplaint complaint_;
    std::exception_ptr thrown_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

// Rows of the file from rows of pixels. PNG has the high byte of 16 bits first.
template <class Channel>
class PngRows {
 public:
    PngRows(int width, bool grey)
        : grey_(grey), bytes_(static_cast<std::size_t>(width) * (grey ? 1 : 3) * sizeof(Channel)) {}

    const png_byte* row(const glm::vec<3, Channel>* colours) {
        if constexpr (sizeof(Channel) == 1)
            if (!grey_) return &colours->x;
        png_byte* to = bytes_.data();
        for (const glm::vec<3, Channel>* colour = colours; to != bytes_.data() + bytes_.size(); ++colour) {
            for (int i = 0; i < (grey_ ? 1 : 3); ++i) {
                const Channel value = (*colour)[i];
                if constexpr (sizeof(Channel) == 2) *to++ = static_cast<png_byte>(value >> 8);
                *to++ = static_cast<png_byte>(value & 0xff);
            }
        }
        return bytes_.data();
    }

 private:
    bool grey_;
    std::vector<png_byte> bytes_;
};

}  // namespace

template <class Channel>
void write_png(std::ostream& out, const PngHeader& header,
               const std::type_identity_t<DrawInto<Channel>>& draw) {
    PngWriter file(out);
    png_structp const png = file.png();
    png_infop const info = file.info();
    const bool grey = header.colours == PngColours::grey;
    const auto width = static_cast<png_uint_32>(header.width),
               height = static_cast<png_uint_32>(header.height),
               pixels_per_metre = static_cast<png_uint_32>(std::lround(header.dpi / kMetresPerInch));
    file.call([&] {
        // libpng's own limit is a million.
        png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_IHDR(png, info, width, height, 8 * sizeof(Channel),
                     grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_set_pHYs(png, info, pixels_per_metre, pixels_per_metre, PNG_RESOLUTION_METER);
        for (const PngText& said : header.texts) {
            if (said.text.empty()) continue;
            png_text text{};
            text.compression = PNG_TEXT_COMPRESSION_NONE;
            text.key = const_cast<png_charp>(said.keyword);  // only read
            text.text = const_cast<png_charp>(said.text.c_str());
            text.text_length = said.text.size();
            png_set_text(png, info, &text, 1);
        }
        // Pages are even paper and even ink for the most part: the filters, made for photographs, only cost
        // time. In grey each run of it is of one byte: to look for those alone takes a fifth of the time, and
        // the file gets smaller.
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
        if (grey && sizeof(Channel) == 1) png_set_compression_strategy(png, Z_RLE);
        png_write_info(png, info);
    });
    PngRows<Channel> rows(header.width, grey);
    draw([&](const Grid<glm::vec<3, Channel>>& band) {
        for (int y = 0; y < band.height; ++y) {
            const png_byte* const row = rows.row(band.row(y));
            file.call([&] { png_write_row(png, row); });
        }
    });
    file.call([&] { png_write_end(png, nullptr); });
}

template void write_png<std::uint8_t>(std::ostream&, const PngHeader&, const DrawInto<std::uint8_t>&);
template void write_png<std::uint16_t>(std::ostream&, const PngHeader&, const DrawInto<std::uint16_t>&);

}  // namespace dapple
