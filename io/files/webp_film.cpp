#include "io/files/webp_film.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

namespace dapple {
namespace {

[[noreturn]] void fail(const std::string& why) {
    throw std::runtime_error("the film cannot be encoded as WebP: " + why);
}

struct WebpPixels : WebPPicture {
    explicit WebpPixels(const Grid<glm::u8vec3>& frame) : WebPPicture{} {
        if (!WebPPictureInit(this)) fail("libwebp is of another version");
        use_argb = 1;
        width = frame.width;
        height = frame.height;
        if (!WebPPictureImportRGB(this, &frame.values.front().x, 3 * frame.width)) throw std::bad_alloc();
    }
    WebpPixels(const WebpPixels&) = delete;
    WebpPixels& operator=(const WebpPixels&) = delete;
    ~WebpPixels() { WebPPictureFree(this); }
};

}  // namespace

struct WebpFilm::Encoder {
    WebPAnimEncoder* webp = nullptr;
    WebPConfig config{};
    double frame_ms = 0;
    int frames = 0;

    ~Encoder() { WebPAnimEncoderDelete(webp); }
    int now_ms() const { return static_cast<int>(std::lround(frames * frame_ms)); }
    void check(int done) const {
        if (!done) fail(WebPAnimEncoderGetError(webp));
    }
};

WebpFilm::WebpFilm(int frames_per_second) : encoder_(std::make_unique<Encoder>()) {
    encoder_->frame_ms = 1000.0 / frames_per_second;
    // Dots are sharp, and their few colours are small without loss; more effort saves little.
    constexpr int kFastest = 1;
    if (!WebPConfigInit(&encoder_->config) || !WebPConfigLosslessPreset(&encoder_->config, kFastest))
        fail("libwebp is of another version");
}

WebpFilm::~WebpFilm() = default;

void WebpFilm::add(const Grid<glm::u8vec3>& frame) {
    if (!encoder_->webp) {
        encoder_->webp = WebPAnimEncoderNew(frame.width, frame.height, nullptr);
        if (!encoder_->webp) throw std::bad_alloc();
    }
    WebpPixels pixels(frame);
    encoder_->check(WebPAnimEncoderAdd(encoder_->webp, &pixels, encoder_->now_ms(), &encoder_->config));
    ++encoder_->frames;
}

void WebpFilm::write(std::ostream& out) {
    encoder_->check(WebPAnimEncoderAdd(encoder_->webp, nullptr, encoder_->now_ms(), nullptr));
    struct Bytes : WebPData {
        Bytes() : WebPData{} { WebPDataInit(this); }
        ~Bytes() { WebPDataClear(this); }
    } bytes;
    encoder_->check(WebPAnimEncoderAssemble(encoder_->webp, &bytes));
    out.write(reinterpret_cast<const char*>(bytes.bytes), static_cast<std::streamsize>(bytes.size));
}

}  // namespace dapple
