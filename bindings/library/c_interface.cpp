#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>

#include "core/drawing/stippler.h"
#include "core/settings/settings_json.h"
#include "dapple/dapple.h"

struct dapple_stippler {
    dapple::Stippler stippler;
};

struct dapple_drawing {
    dapple::Drawing drawing;
};

namespace {

// C has no other way to say why.
thread_local std::string last_error;

// What `work` returns, or `failed` if it throws: nothing may leave for C.
template <class Result, class Work>
Result guarded(Result failed, const Work& work) noexcept {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        last_error = "there is not enough memory";
    } catch (const std::exception& error) {
        last_error = error.what();
    } catch (...) {
        last_error = "failed";
    }
    return failed;
}

constexpr int kMostChannels = 4;
constexpr std::int64_t kMostPixels = std::numeric_limits<std::int32_t>::max();

template <class Pointer>
Pointer given(Pointer pointer, const char* what) {
    if (!pointer) throw std::runtime_error(std::string(what) + " is NULL");
    return pointer;
}

std::size_t product(int width, int height, int each = 1) {
    if (width < 1 || height < 1 || each < 1 || each > kMostChannels)
        throw std::runtime_error(fmt::format(
            "a picture of {} x {} pixels with {} channels; sides are 1 or more, and channels 1 to {}", width,
            height, each, kMostChannels));
    if (static_cast<std::int64_t>(width) * height > kMostPixels)
        throw std::runtime_error(fmt::format(
            "{} x {} pixels are more than 2,147 megapixels; make the picture smaller", width, height));
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(each);
}

template <class Value>
Value* copied(const Value* from, std::size_t count) {
    auto* const copy = static_cast<Value*>(std::malloc(count * sizeof(Value)));
    if (!copy) throw std::bad_alloc();
    std::memcpy(copy, from, count * sizeof(Value));
    return copy;
}

char* copied_text(const std::string& text) {
    return copied(text.c_str(), text.size() + 1);
}

dapple::Grid<float> grid_of(const float* values, const char* what, int width, int height) {
    const std::size_t count = product(width, height);
    given(values, what);
    dapple::Grid<float> grid(width, height);
    std::copy_n(values, count, grid.values.begin());
    return grid;
}

int set_density(dapple_stippler* stippler, const float* values, int width, int height,
                dapple::Reading reading) {
    return guarded(-1, [&] {
        dapple::Grid<float> density = grid_of(values, "values", width, height);
        given(stippler, "the stippler")->stippler.set_density(std::move(density), reading);
        return 0;
    });
}

}  // namespace

const char* dapple_error(void) {
    return last_error.c_str();
}

void dapple_free(void* returned) {
    std::free(returned);
}

dapple_stippler* dapple_stippler_new(int threads) {
    return guarded<dapple_stippler*>(nullptr, [&] { return new dapple_stippler{dapple::Stippler(threads)}; });
}

void dapple_stippler_free(dapple_stippler* stippler) {
    delete stippler;
}

int dapple_set_picture(dapple_stippler* stippler, const unsigned char* pixels, int width, int height,
                       int channels) {
    return guarded(-1, [&] {
        const std::span bytes(given(pixels, "pixels"), product(width, height, channels));
        given(stippler, "the stippler")
            ->stippler.set_picture(dapple::picture_of_srgb(bytes, width, height, channels));
        return 0;
    });
}

int dapple_set_light(dapple_stippler* stippler, const float* light, const float* colours, int width,
                     int height) {
    return guarded(-1, [&] {
        dapple::LightPicture picture{grid_of(light, "light", width, height)};
        if (colours) {
            const std::span all(colours, 3 * picture.light.values.size());
            picture.colours = dapple::picture_of_light(all, width, height, 3).colours;
        }
        given(stippler, "the stippler")->stippler.set_picture(std::move(picture));
        return 0;
    });
}

int dapple_set_density(dapple_stippler* stippler, const float* values, int width, int height) {
    return set_density(stippler, values, width, height, dapple::Reading::by_cell);
}

int dapple_set_linear_density(dapple_stippler* stippler, const float* values, int width, int height) {
    return set_density(stippler, values, width, height, dapple::Reading::bilinear);
}

int dapple_set_tile(dapple_stippler* stippler, const char* text) {
    return guarded(-1, [&] {
        given(stippler, "the stippler")->stippler.set_tile(text ? text : "");
        return 0;
    });
}

dapple_drawing* dapple_draw(dapple_stippler* stippler, const char* settings, dapple_progress progress,
                            void* data) {
    return guarded<dapple_drawing*>(nullptr, [&] {
        std::stop_source stop;
        dapple::Watch watch{stop.get_token(), {}};
        if (progress)
            watch.progress = [&](double share) {
                if (progress(share, data) != 0) stop.request_stop();
            };
        std::optional<dapple::Drawing> drawing =
            given(stippler, "the stippler")
                ->stippler.draw(dapple::settings_of(settings ? settings : "{}"), watch);
        if (!drawing) throw std::runtime_error("stopped");
        return new dapple_drawing{*std::move(drawing)};
    });
}

void dapple_drawing_free(dapple_drawing* drawing) {
    delete drawing;
}

char* dapple_usual_settings(void) {
    return guarded<char*>(nullptr, [] { return copied_text(dapple::json_of({})); });
}

size_t dapple_drawing_count(const dapple_drawing* drawing) {
    return drawing ? static_cast<size_t>(drawing->drawing.count) : 0;
}

void dapple_drawing_page_mm(const dapple_drawing* drawing, double* width, double* height) {
    const dapple::PageSize page = drawing ? drawing->drawing.page.whole.size : dapple::PageSize();
    if (width) *width = page.width_mm;
    if (height) *height = page.height_mm;
}

int dapple_drawing_dots(const dapple_drawing* drawing, float* x, float* y, float* radius, int* pen) {
    return guarded(-1, [&] {
        std::size_t at = 0;
        given(drawing, "the drawing")->drawing.for_each_piece([&](const dapple::Dots& dots) {
            if (x) std::ranges::copy(dots.x, x + at);
            if (y) std::ranges::copy(dots.y, y + at);
            if (radius) std::ranges::copy(dots.radius, radius + at);
            if (pen) std::fill_n(pen + at, dots.size(), dots.pen);
            at += dots.size();
            return true;
        });
        return 0;
    });
}

char* dapple_drawing_text(const dapple_drawing* drawing, const char* format, size_t* size) {
    return guarded<char*>(nullptr, [&] {
        std::ostringstream out;
        given(drawing, "the drawing")->drawing.write(out, dapple::text_format(given(format, "the format")));
        const std::string text = std::move(out).str();
        if (size) *size = text.size();
        return copied_text(text);
    });
}

unsigned char* dapple_drawing_pixels(const dapple_drawing* drawing, double dpi, int* width, int* height) {
    return guarded<unsigned char*>(nullptr, [&] {
        const dapple::Grid<glm::u8vec3> pixels = given(drawing, "the drawing")->drawing.pixels(dpi);
        if (width) *width = pixels.width;
        if (height) *height = pixels.height;
        return reinterpret_cast<unsigned char*>(copied(pixels.values.data(), pixels.values.size()));
    });
}
