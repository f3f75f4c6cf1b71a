#include "io/film/save_film.h"

#include <fmt/format.h>

#include <webp/encode.h>
#include <webp/mux.h>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"

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
    WebpPixels& operator=(WebpPixels&&) = delete;
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

namespace {

namespace fs = std::filesystem;

bool is_film(const fs::path& path) {
    return ending_of(path) == ".webp";
}

// Where in the film a picture lies, 0..1.
double share_of(int frame, int frames) {
    return frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1;
}

fs::path frame_file(const fs::path& folder, int frame) {
    return folder / fmt::format("frame-{:04}.png", frame + 1);
}

bool save_frames(const fs::path& folder, const FilmFrame& frame, int frames, const Watch& watch) {
    make_folder(folder);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        const Grid<glm::u8vec3> pixels = frame(share_of(i, frames));
        save_next(static_cast<std::size_t>(i), [&] {
            save_atomically(frame_file(folder, i), [&](std::ostream& out) {
                write_png(out, {.width = pixels.width, .height = pixels.height, .dpi = 96},
                          [&](const PixelSink& sink) { sink(pixels); });
            });
        });
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    return true;
}

}  // namespace

void check_film_path(const fs::path& path) {
    std::error_code ignored;
    const bool folder = !path.has_filename() || fs::is_directory(path, ignored);
    if (folder) return;
    if (is_film(path)) return check_can_save(path);
    throw std::runtime_error(printable(path.string()) +
                             ": a film's name ends in .webp, and in / for a folder of numbered PNG files");
}

std::vector<fs::path> files_of(const fs::path& path, const FilmChoice& choice) {
    if (is_film(path)) return {path};
    std::vector<fs::path> frames;
    for (int i = 0; i < frames_of(choice); ++i) frames.push_back(frame_file(path, i));
    return frames;
}

bool save_film(const fs::path& path, const FilmFrame& frame, const FilmChoice& choice, const Watch& watch) {
    check_film_path(path);
    const int frames = frames_of(choice);
    if (!is_film(path)) return save_frames(path, frame, frames, watch);
    WebpFilm film(choice.frames_per_second);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        film.add(frame(share_of(i, frames)));
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    save_atomically(path, [&](std::ostream& out) { film.write(out); });
    return true;
}

}  // namespace dapple
