#include "io/files/tiff_file.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace dapple {
namespace {

constexpr double kMostClassicBytes = 3.5e9;  // offsets have 32 bits, and LZW may make noise larger

// The library's own view of a file, on a stream. A stream may throw, but not through the C library in
// between: what it throws is kept until that has been left.
class TiffStream {
 public:
    explicit TiffStream(std::ostream& out) : out_(out) {}

    static tmsize_t read(thandle_t, void*, tmsize_t) { return 0; }
    static tmsize_t write(thandle_t self, void* bytes, tmsize_t size) {
        return static_cast<TiffStream*>(self)->put(static_cast<const char*>(bytes), size);
    }
    static toff_t seek(thandle_t self, toff_t offset, int from) {
        return static_cast<TiffStream*>(self)->go(offset, from);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t self) { return static_cast<TiffStream*>(self)->end_; }
    static int complain(TIFF*, void* self, const char*, const char* words, va_list values) {
        char text[512];
        std::vsnprintf(text, sizeof text, words, values);
        static_cast<TiffStream*>(self)->complaint_ = text;
        return 1;
    }
    static int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

    /// Leaves the file as it is: what the library writes from now on is dropped.
    void give_up() { dropped_ = true; }

    [[noreturn]] void fail() const {
        if (thrown_) std::rethrow_exception(thrown_);
        throw std::runtime_error("the TIFF cannot be written: " + complaint_);
    }
    void check(bool well) const {
        if (!well || thrown_) fail();
    }

 private:
    tmsize_t put(const char* bytes, tmsize_t size) {
        if (dropped_ || thrown_) return 0;
        try {
            out_.write(bytes, size);
        } catch (...) {
            thrown_ = std::current_exception();
            return 0;
        }
        at_ += static_cast<toff_t>(size);
        end_ = std::max(end_, at_);
        return size;
    }
    toff_t go(toff_t offset, int from) {
        const toff_t base = from == SEEK_CUR ? at_ : from == SEEK_END ? end_ : 0;
        if (dropped_ || thrown_) return base + offset;
        try {
            // The end of what is still in the stream's buffer is the end of the file.
            if (base + offset != at_) out_.seekp(static_cast<std::streamoff>(base + offset));
        } catch (...) {
            thrown_ = std::current_exception();
        }
        return at_ = base + offset;
    }

    std::ostream& out_;
    toff_t at_ = 0, end_ = 0;
    bool dropped_ = false;
    std::string complaint_;
    std::exception_ptr thrown_;
};

struct OptionsDeleter {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

class TiffWriter {
 public:
    TiffWriter(std::ostream& out, bool big) : stream_(out) {
        const std::unique_ptr<TIFFOpenOptions, OptionsDeleter> options(TIFFOpenOptionsAlloc());
        if (!options) throw std::bad_alloc();
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &TiffStream::complain, &stream_);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &TiffStream::ignore, nullptr);
        tiff_ = TIFFClientOpenExt("drawing", big ? "w8" : "w", &stream_, &TiffStream::read,
                                  &TiffStream::write, &TiffStream::seek, &TiffStream::close,
                                  &TiffStream::size, nullptr, nullptr, options.get());
        stream_.check(tiff_);
    }
    TiffWriter(const TiffWriter&) = delete;
    TiffWriter& operator=(const TiffWriter&) = delete;
    ~TiffWriter() {
        stream_.give_up();
        if (tiff_) TIFFClose(tiff_);
    }

    template <class... Value>
    void set(std::uint32_t tag, Value... value) {
        stream_.check(TIFFSetField(tiff_, tag, value...));
    }
    template <class Channel>
    void row(std::vector<Channel>& samples, std::uint32_t y) {
        stream_.check(TIFFWriteScanline(tiff_, samples.data(), y) == 1);
    }
    std::uint32_t usual_strip() { return TIFFDefaultStripSize(tiff_, 0); }
    void finish() { stream_.check(TIFFWriteDirectory(tiff_) == 1); }

 private:
    TiffStream stream_;
    TIFF* tiff_ = nullptr;
};

}  // namespace

template <class Channel>
void write_tiff(std::ostream& out, const PngHeader& header, const DrawInto<Channel>& draw) {
    if (out.tellp() != std::ostream::pos_type(0)) {
        throw std::runtime_error("a TIFF cannot go to a pipe; name a file, or write a PNG");
    }
    const bool grey = header.colours == PngColours::grey;
    const int channels = grey ? 1 : 3;
    const double bytes = static_cast<double>(header.width) * header.height * channels * sizeof(Channel);
    TiffWriter file(out, bytes > kMostClassicBytes);
    file.set(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(header.width));
    file.set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(header.height));
    file.set(TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * sizeof(Channel)));
    file.set(TIFFTAG_SAMPLESPERPIXEL, channels);
    file.set(TIFFTAG_PHOTOMETRIC, grey ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
    file.set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    file.set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    file.set(TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    file.set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    file.set(TIFFTAG_XRESOLUTION, header.dpi);
    file.set(TIFFTAG_YRESOLUTION, header.dpi);
    file.set(TIFFTAG_SOFTWARE, "Dapple");
    file.set(TIFFTAG_ROWSPERSTRIP, std::max(file.usual_strip(), std::uint32_t{1}));
    std::vector<Channel> samples(static_cast<std::size_t>(header.width) * static_cast<std::size_t>(channels));
    std::uint32_t next_row = 0;
    draw([&](const Grid<glm::vec<3, Channel>>& band) {
        for (int y = 0; y < band.height; ++y) {
            const glm::vec<3, Channel>* const colours = band.row(y);
            std::size_t at = 0;
            for (int x = 0; x < band.width; ++x)
                for (int c = 0; c < channels; ++c) samples[at++] = colours[x][c];
            file.row(samples, next_row++);
        }
    });
    file.finish();
}

template void write_tiff(std::ostream&, const PngHeader&, const DrawInto<std::uint8_t>&);
template void write_tiff(std::ostream&, const PngHeader&, const DrawInto<std::uint16_t>&);

}  // namespace dapple
