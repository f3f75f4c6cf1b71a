// The library for JavaScript in a browser: numbers and texts in WebAssembly's memory. One picture and one
// drawing at a time. What fails returns 0 or null, and engine_error() then says why in one sentence.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/analysis/autocorrelation.h"
#include "core/analysis/periodogram.h"
#include "core/drawing/stippler.h"
#include "core/settings/settings_json.h"
#include "core/tile/tile_file.h"

namespace {

using Json = nlohmann::ordered_json;

// The page's one engine, in its worker.
dapple::Stippler stippler;
std::optional<dapple::Drawing> drawing;
std::string error, text;
std::vector<float> dots, tiles;
dapple::Grid<glm::u8vec3> pixels;

// What a page shows without keeping somebody waiting, and its memory holds.
constexpr std::uint64_t kMostDots = 2'000'000;

// See CMakeLists.txt.
bool is_left_out(const std::string& tile) {
    return tile == "aperiodic1024" || tile == "aperiodic4096";
}

void check_count(std::uint64_t count) {
    if (count > kMostDots)
        throw std::runtime_error("these settings ask for " + std::to_string(count) +
                                 " dots, and this page draws " + std::to_string(kMostDots) +
                                 " at most; take fewer, or draw them with the program");
}

// Throws std::runtime_error if the drawing needs something that is left out, or has too many dots.
void check(const dapple::DrawingSettings& drawing) {
    if (dapple::has_inking(drawing))
        throw std::runtime_error(
            "this page draws neither contours nor solid blacks, which these settings ask for; draw them with "
            "the program");
    if (!drawing.edits.empty())
        throw std::runtime_error(
            "this page does not retouch, as these settings do; draw them with the program");
    if (drawing.placing.count && drawing.dot_size.sizing != dapple::DotSizing::by_tone)
        check_count(*drawing.placing.count);
    const std::string tile = dapple::tile_in_use(drawing);
    if (is_left_out(tile))
        throw std::runtime_error(
            "this page leaves out the tile " + tile +
            ", which these settings need; take another tile, or draw them with the program");
}

template <class Work>
auto guarded(const Work& work) noexcept -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception& failed) {
        error = failed.what();
        return {};
    }
}

// Valid until the next text.
const char* kept(std::string said) {
    text = std::move(said);
    return text.c_str();
}

const dapple::Drawing& drawn() {
    if (!drawing) throw std::runtime_error("there is no drawing");
    return *drawing;
}

// Four values a dot: x, y and radius in millimetres, and the pen.
void collect_dots() {
    dots.clear();
    dots.reserve(4 * drawing->count);
    drawing->for_each_piece([](const dapple::Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i)
            dots.insert(dots.end(), {piece.x[i], piece.y[i], piece.radius[i], static_cast<float>(piece.pen)});
        return true;
    });
}

// Five values a tile: x, y and side in millimetres, level and kind.
void collect_tiles() {
    tiles.clear();
    for (const dapple::PlacedTile& tile : drawn().tiles())
        for (const double value :
             {tile.x, tile.y, tile.side, double(tile.level), static_cast<double>(tile.kind.value_or(0))})
            tiles.push_back(static_cast<float>(value));
}

// The dots whose spectrum tells of the drawing: all of them or, of too many, those in the page's middle.
struct MeasuredDots {
    std::vector<glm::dvec2> dots;
    dapple::Domain page;  // what they lie in, millimetres
};
MeasuredDots measured_dots() {
    constexpr std::size_t kMost = 50'000;
    const dapple::PageSize& page = drawn().page.whole.size;
    MeasuredDots measured;
    for (double share = 1;; share *= 0.95) {
        measured = {{}, {share * page.width_mm, share * page.height_mm, dapple::Topology::window}};
        const auto& [width, height, ignored] = measured.page;
        const double left = (page.width_mm - width) / 2, top = (page.height_mm - height) / 2;
        for (std::size_t i = 0; i < dots.size(); i += 4) {
            const double x = dots[i] - left, y = dots[i + 1] - top;
            if (x >= 0 && y >= 0 && x <= width && y <= height) measured.dots.emplace_back(x, y);
        }
        if (measured.dots.size() <= kMost) return measured;
    }
}

}  // namespace

extern "C" {

const char* engine_error() {
    return error.c_str();
}

/// See json_of() and rows_json().
const char* engine_usual_settings() {
    return guarded([] { return kept(dapple::json_of({})); });
}
const char* engine_rows() {
    return guarded([] { return kept(dapple::rows_json()); });
}

/// Those that are here, with a space between.
const char* engine_tile_names() {
    return guarded([] {
        std::string names;
        for (const std::string name : dapple::built_in_tile_names())
            if (!is_left_out(name)) names += (names.empty() ? "" : " ") + name;
        return kept(std::move(names));
    });
}

unsigned engine_most_dots() {
    return kMostDots;
}

/// Those of a project or a drawing that are not as usual, checked.
const char* engine_changed(const char* settings) {
    return guarded([&] { return kept(dapple::settings_of(settings).embedded); });
}

/// Red, green, blue and alpha, sRGB-encoded.
int engine_set_picture(const std::uint8_t* rgba, int width, int height) {
    return guarded([&] {
        drawing.reset();
        const std::span bytes(rgba, 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        stippler.set_picture(dapple::picture_of_srgb(bytes, width, height, 4));
        return 1;
    });
}

/// What was drawn, as report_json() has it; its dots are then at engine_dots().
const char* engine_draw(const char* json) {
    return guarded([&] {
        drawing.reset();  // nobody saves what was there before
        const dapple::Settings settings = dapple::settings_of(json);
        check(settings.drawing);
        check_count(static_cast<std::uint64_t>(stippler.plan(settings.drawing).dots()));
        drawing = stippler.draw(settings);
        collect_dots();
        return kept(dapple::report_json(*drawing));
    });
}
const float* engine_dots() {
    return dots.data();
}

/// How many of the drawing's tiles are then at engine_tiles().
int engine_find_tiles() {
    return guarded([] {
        collect_tiles();
        return static_cast<int>(tiles.size() / 5);
    });
}
const float* engine_tiles() {
    return tiles.data();
}

/// A file of the drawing: "svg" or "csv".
const char* engine_file(const char* format) {
    return guarded([&] {
        std::ostringstream out;
        drawn().write(out, dapple::text_format(format));
        return kept(std::move(out).str());
    });
}

/// How many of the drawing's dots were measured, and how much they repeat after the tile, as JSON; their
/// spectrum is then at engine_spectrum_pixels(), as large as the functions below say.
const char* engine_spectrum() {
    return guarded([] {
        const auto [points, page] = measured_dots();
        pixels = dapple::spectrum_picture(dapple::periodogram(points, page));
        // To see one repeat takes two tiles beside each other.
        const double period = drawing->period_mm();
        const bool two = 2 * period <= std::min(page.width, page.height) * (1 + 1e-9);
        const Json measured{
            {"dots", points.size()},
            {"period", two ? Json(period) : Json()},
            {"periodicity",
             two ? Json(dapple::periodicity(points, page, glm::dvec2(period)).value) : Json()}};
        return kept(measured.dump());
    });
}
const std::uint8_t* engine_spectrum_pixels() {
    return &pixels.values[0].r;
}

/// Red, green and blue; gone after the next call.
const std::uint8_t* engine_pixels(double dpi) {
    return guarded([&]() -> const std::uint8_t* {
        pixels = drawn().pixels(dpi);
        return &pixels.values[0].r;
    });
}
int engine_pixels_height() {
    return pixels.height;
}
int engine_pixels_width() {
    return pixels.width;
}

}  // extern "C"
