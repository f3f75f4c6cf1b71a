#include "app/files/png_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <exception>
#include <stdexcept>

#include "app/files/silent_standard_error.h"

namespace dapple {
namespace {

constexpr int kNoFilter = 8;  // PNG_FILTER_NONE

// OpenImageIO's way into a stream. It may not throw through the C library in between, so it keeps what is
// thrown.
class StreamProxy : public OIIO::Filesystem::IOProxy {
 public:
    explicit StreamProxy(std::ostream& out) : IOProxy("", Write), out_(out) {}

    const char* proxytype() const override { return "stream"; }

    std::size_t write(const void* bytes, std::size_t size) override {
        if (thrown_) return 0;
        try {
            out_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
        } catch (...) {
            thrown_ = std::current_exception();
            return 0;
        }
        m_pos += static_cast<std::int64_t>(size);
        return size;
    }

    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

 private:
    std::ostream& out_;
    std::exception_ptr thrown_;
};

}  // namespace

void write_png(std::ostream& out, const PngHeader& header,
               const std::function<void(const PixelSink&)>& draw) {
    StreamProxy proxy(out);
    const auto check = [&](bool good, const OIIO::ImageOutput& file) {
        proxy.rethrow();
        if (!good) throw std::runtime_error("the PNG cannot be written: " + file.geterror());
    };

    const bool grey = header.colours == PngColours::grey;
    OIIO::ImageSpec spec(header.width, header.height, grey ? 1 : 3, OIIO::TypeDesc::UINT8);
    spec.attribute("XResolution", static_cast<float>(header.dpi));
    spec.attribute("YResolution", static_cast<float>(header.dpi));
    spec.attribute("ResolutionUnit", "inch");
    spec.attribute("oiio:ColorSpace", "sRGB");
    // Pages are even paper and even ink for the most part: the filters, made for photographs, only cost time.
    spec.attribute("png:filter", kNoFilter);

    // "png" is the format by name: the stream has none.
    std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create("png", &proxy);
    if (!file) throw std::runtime_error("the PNG cannot be written: " + OIIO::geterror());
    check(file->open("picture.png", spec), *file);
    int row = 0;
    try {
        draw([&](const Grid<glm::u8vec3>& band) {
            // Of a grey picture every third byte, which is its red.
            const auto step = static_cast<OIIO::stride_t>(sizeof(glm::u8vec3));
            check(file->write_scanlines(row, row + band.height, 0, OIIO::TypeDesc::UINT8, band.values.data(),
                                        step, step * band.width),
                  *file);
            row += band.height;
        });
    } catch (...) {
        // Closed before its last row, the library prints what the caller is about to say.
        const SilentStandardError silence;
        file.reset();
        throw;
    }
    check(file->close(), *file);
}

}  // namespace dapple
