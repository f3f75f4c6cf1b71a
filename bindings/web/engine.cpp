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

#include "dapple/analysis.h"
#include "dapple/drawing.h"
#include "dapple/tile.h"

namespace {

using Json = nlohmann::ordered_json;

// The page's one engine, in its worker.
dapple::Stippler stippler;
std::optional<dapple::Drawing> drawing;
std::string error, text;
std::vector<float> dots, tiles;
dapple::PagePixels pixels;

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

// Throws std::runtime_error if the drawing needs a tile that is left out, or has too many dots.
void check(const dapple::Settings& settings) {
    const Json drawing = Json::parse(settings.text()).at("drawing");
    if (drawing["count"].is_number() && drawing["dot_size"]["sizing"] != "by_tone")
        check_count(drawing["count"]);
    std::string tile = drawing.at("tile");
    // The usual tile's points have one ranking; for others, this one takes its place.
    const bool is_ranked = drawing["ranking"].is_string() && drawing["ranking"] != "energy";
    if (tile == "kinds4096" && drawing["placer"] == "exact" && is_ranked) tile = "aperiodic4096";
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

Json pens_of(const std::vector<dapple::DrawingPen>& pens) {
    Json list = Json::array();
    for (const dapple::DrawingPen& pen : pens)
        list.push_back({{"name", pen.name}, {"colour", {pen.red, pen.green, pen.blue}}});
    return list;
}

const dapple::Drawing& drawn() {
    if (!drawing) throw std::runtime_error("there is no drawing");
    return *drawing;
}

// Four values a dot: x, y and radius in millimetres, and the pen.
void collect_dots() {
    dots.clear();
    dots.reserve(4 * drawing->count());
    drawing->for_each([](const dapple::DotSpan& span) {
        for (std::size_t i = 0; i < span.x.size(); ++i)
            dots.insert(dots.end(), {span.x[i], span.y[i], span.radius[i], static_cast<float>(span.pen)});
        return true;
    });
}

// Five values a tile: x, y and side in millimetres, level and kind.
void collect_tiles() {
    tiles.clear();
    for (const dapple::DrawnTile& tile : drawn().tiles())
        for (const double value :
             {tile.x, tile.y, tile.side, double(tile.level), static_cast<double>(tile.kind)})
            tiles.push_back(static_cast<float>(value));
}

// The dots whose spectrum tells of the drawing: all of them or, of too many, those in the page's middle.
struct MeasuredDots {
    std::vector<double> x, y;
    double width = 0, height = 0;  // what they lie in, millimetres
};
MeasuredDots measured_dots() {
    constexpr std::size_t kMost = 50'000;
    const double page_width = drawn().page_width_mm(), page_height = drawn().page_height_mm();
    MeasuredDots measured;
    for (double share = 1;; share *= 0.95) {
        measured = {{}, {}, share * page_width, share * page_height};
        const double left = (page_width - measured.width) / 2, top = (page_height - measured.height) / 2;
        for (std::size_t i = 0; i < dots.size(); i += 4) {
            const double x = dots[i] - left, y = dots[i + 1] - top;
            if (x < 0 || y < 0 || x > measured.width || y > measured.height) continue;
            measured.x.push_back(x);
            measured.y.push_back(y);
        }
        if (measured.x.size() <= kMost) return measured;
    }
}

}  // namespace

extern "C" {

const char* engine_error() {
    return error.c_str();
}

/// See Settings::text() and Settings::rows().
const char* engine_usual_settings() {
    return guarded([] { return kept(dapple::Settings().text()); });
}
const char* engine_rows() {
    return guarded([] { return kept(dapple::Settings::rows()); });
}

/// Those that are here, with a space between.
const char* engine_tile_names() {
    return guarded([] {
        std::string names;
        for (const std::string& name : dapple::tile_names())
            if (!is_left_out(name)) names += (names.empty() ? "" : " ") + name;
        return kept(std::move(names));
    });
}

unsigned engine_most_dots() {
    return kMostDots;
}

/// Those of a project or a drawing, checked, as changed() has them.
const char* engine_changed(const char* settings) {
    return guarded([&] { return kept(dapple::Settings(settings).changed()); });
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

/// What was drawn, as JSON; its dots are then at engine_dots().
const char* engine_draw(const char* json) {
    return guarded([&] {
        drawing.reset();  // nobody saves what was there before
        const dapple::Settings settings{std::string_view(json)};
        check(settings);
        const dapple::Plan plan = stippler.plan(settings);
        check_count(plan.dots);
        drawing = stippler.draw(settings);
        collect_dots();
        const Json drawn{{"dots", drawing->count()},
                         {"steps", plan.steps},
                         {"width", drawing->page_width_mm()},
                         {"height", drawing->page_height_mm()},
                         {"radius", plan.radius_mm},
                         {"pens", pens_of(drawing->pens())},
                         {"tone",
                          {{"black_point", plan.black_point},
                           {"white_point", plan.white_point},
                           {"contrast", plan.contrast},
                           {"brightness", plan.brightness},
                           {"gamma", plan.gamma},
                           {"black", plan.black}}}};
        return kept(drawn.dump());
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
        drawn().write(out,
                      std::string_view(format) == "svg" ? dapple::FileFormat::svg : dapple::FileFormat::csv);
        return kept(std::move(out).str());
    });
}

/// How many of the drawing's dots were measured, and how much they repeat after the tile, as JSON; their
/// spectrum is then at engine_spectrum_pixels(), as large as the functions below say.
const char* engine_spectrum() {
    return guarded([] {
        using enum dapple::PointEdges;
        const auto [x, y, width, height] = measured_dots();
        dapple::SpectrumPicture picture = dapple::spectrum_of(x, y, width, height, unknown);
        pixels = {picture.width, picture.height, std::move(picture.rgb)};
        // To see one repeat takes two tiles beside each other.
        const double period = drawing->period_mm();
        const bool two = 2 * period <= std::min(width, height) * (1 + 1e-9);
        const Json measured{
            {"dots", x.size()},
            {"period", two ? Json(period) : Json()},
            {"periodicity",
             two ? Json(dapple::periodicity_of(x, y, width, height, period, unknown)) : Json()}};
        return kept(measured.dump());
    });
}
const std::uint8_t* engine_spectrum_pixels() {
    return pixels.rgb.data();
}

/// Red, green and blue; gone after the next call.
const std::uint8_t* engine_pixels(double dpi) {
    return guarded([&]() -> const std::uint8_t* {
        pixels = drawn().pixels(dpi);
        return pixels.rgb.data();
    });
}
int engine_pixels_height() {
    return pixels.height;
}
int engine_pixels_width() {
    return pixels.width;
}

}  // extern "C"
