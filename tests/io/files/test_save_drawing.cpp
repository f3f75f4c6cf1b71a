// Saving a drawing while someone watches it.

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

#include "io/files/save_drawing.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

Dots many_dots() {
    Dots dots;
    for (int i = 0; i < 150'000; ++i) {
        dots.x.push_back(static_cast<float>(i % 500) / 500);
        dots.y.push_back(static_cast<float>(i / 500) / 300);
        dots.threshold.push_back(0.5f);
        dots.critical.push_back(1);
    }
    return dots;
}

// A strip of the dots, with several bands of pixels.
constexpr PageSize kPage{.width_mm = 10, .height_mm = 100, .mm_per_page_unit = 100};

// As they come: another order would have to be found first.
DrawingToSave many_to_save(const Dots& dots, const fs::path& path, DrawingFormat format) {
    return {.file = {.path = path, .format = format, .saving = {.order = DotOrder::recursion}},
            .dots = stream_of(dots, 100),
            .page = kPage};
}
DrawingToSave many_to_save(const Dots& dots, const fs::path& path) {
    return many_to_save(dots, path, drawing_format(path));
}

}  // namespace

TEST_CASE("no number leaves for a machine that is none, or lies far from the page") {
    const TemporaryFolder folder;
    const fs::path file = folder / "drawing";
    put_text(file, "the old drawing");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    // Page units are 100 mm; dots that reach over from beside a small part of a page are not far.
    const auto saved = [&](DrawingFormat format, float x, float y, float radius, bool as_stroke) {
        Dots dots;
        dots.x = {0.05f, x};
        dots.y = {0.5f, y};
        dots.radius = {0.01f, radius};
        dots.threshold = {0.5f, 0.5f};
        dots.critical = {1, 1};
        DrawingToSave drawing = many_to_save(dots, file, format);
        Strokes strokes{.points = {{1, 1}, {100.0 * x, 100.0 * y}}, .ends = {2}};
        if (as_stroke) drawing.strokes = stream_of(strokes, 0.3);
        try {
            return save_drawing(drawing);
        } catch (const std::runtime_error& error) {
            CHECK(std::string(error.what()).find("far from its page") != std::string::npos);
            CHECK(text_of(file) == "the old drawing");
            return false;
        }
    };
    for (const DrawingFormatName& format : kDrawingFormats) {
        if (has_pixels(format.format)) continue;
        for (const bool as_stroke : {false, true}) {
            if (as_stroke && is_table(format.format)) continue;
            CAPTURE(std::string(format.word));
            CAPTURE(as_stroke);
            for (const float wrong : {nan, INFINITY, -INFINITY, 9e12f, -9e12f, 4.0f}) {
                CHECK_FALSE(saved(format.format, wrong, 0.5f, 0.01f, as_stroke));
                CHECK_FALSE(saved(format.format, 0.05f, wrong, 0.01f, as_stroke));
                if (!as_stroke) CHECK_FALSE(saved(format.format, 0.05f, 0.5f, wrong + 1, false));
            }
            CHECK(saved(format.format, -0.3f, 1.3f, 0.3f, as_stroke));
            put_text(file, "the old drawing");
        }
    }
}

TEST_CASE("whatever becomes of a file while it is written, every format says so in a sentence") {
    // A writer's stream fails at once, in the middle, at the end and as it is closed.
    class Failing : public std::streambuf {
     public:
        explicit Failing(std::size_t room) : room_(room) {}
        std::size_t written = 0;

     private:
        std::streamsize xsputn(const char*, std::streamsize size) override {
            if ((written += static_cast<std::size_t>(size)) > room_) throw std::runtime_error("no room");
            return size;
        }
        int_type overflow(int_type c) override {
            xsputn(nullptr, 1);
            return traits_type::not_eof(c);
        }
        std::size_t room_;
    };
    Dots dots;
    for (int i = 0; i < 400; ++i) {
        dots.x.push_back(static_cast<float>(i % 20) / 200);
        dots.y.push_back(static_cast<float>(i) / 400);
        dots.threshold.push_back(0.5f);
        dots.critical.push_back(1);
    }
    DotPieces two;
    two.pieces = {dots, dots};
    two.pieces[1].pen = 1;
    const Strokes lines{.points = {{1, 1}, {9, 50}, {2, 90}}, .ends = {3}};
    for (const DrawingFormatName& format : kDrawingFormats) {
        for (const bool several_pens : {false, true}) {
            for (const bool as_strokes : {false, true}) {
                if (as_strokes && is_table(format.format)) continue;
                CAPTURE(std::string(format.word));
                CAPTURE(several_pens);
                CAPTURE(as_strokes);
                DrawingToSave drawing = many_to_save(dots, {}, format.format);
                drawing.dots = stream_of(two, 100);
                drawing.dot_radius_mm = 0.3;
                drawing.file.saving.dpi = 100;
                if (several_pens) drawing.pens = parse_pens("A:#000:0.3,B:#f00:0.5").own;
                if (!several_pens) drawing.dots = stream_of(dots, 100);
                if (as_strokes) drawing.strokes = stream_of(lines, 0.3);
                drawing.file.settings.pen_width_mm = 0.3;
                const auto bytes_with = [&](std::size_t room) {
                    Failing buffer(room);
                    std::ostream out(&buffer);
                    out.exceptions(std::ios::badbit | std::ios::failbit);
                    write_drawing(out, drawing, "A drawing");
                    return buffer.written;
                };
                const TemporaryFolder folder;
                const auto sentence = [&](const fs::path& file) -> std::string {
                    drawing.file.path = file;
                    try {
                        save_ordered(drawing);
                    } catch (const std::runtime_error& error) {
                        return error.what();
                    }
                    return "";
                };
                REQUIRE(sentence(folder / "old") == "");
                const std::size_t whole = fs::file_size(folder / "old");
                REQUIRE(whole > 100);
                const bool goes_back = format.format == DrawingFormat::tiff;
                const std::size_t streamed =
                    goes_back ? 0 : bytes_with(std::numeric_limits<std::size_t>::max());
                for (const double share : {0.0, 0.25, 0.5, 0.99, 1.0}) {
                    const auto short_of = [&](std::size_t all) {
                        return share < 1 ? static_cast<std::size_t>(share * static_cast<double>(all))
                                         : all - 1;
                    };
                    if (!goes_back)
                        CHECK_THROWS_WITH_AS(bytes_with(short_of(streamed)), "no room", std::runtime_error);
                    put_text(folder / "old", "the old drawing");
                    rlimit before{};
                    getrlimit(RLIMIT_FSIZE, &before);
                    rlimit small = before;
                    small.rlim_cur = short_of(whole);
                    setrlimit(RLIMIT_FSIZE, &small);
                    const std::string limited = sentence(folder / "old");
                    setrlimit(RLIMIT_FSIZE, &before);
                    CHECK(limited.find("old: cannot be written: the file grew beyond") != limited.npos);
                    CHECK(text_of(folder / "old") == "the old drawing");
                }
                fs::create_symlink("/dev/full", folder / "full");
                const std::string full = sentence(folder / "full");
                if (!goes_back) CHECK(full.find("cannot be written: the disk is full") != full.npos);
                CHECK(full != "");
                CHECK(folder.entries() == 2);
            }
        }
    }
}

TEST_CASE("progress rises from nothing to all, in every format") {
    TemporaryFolder folder;
    const Dots dots = many_dots();
    for (const char* name :
         {"a.svg", "a.csv", "a.png", "a.pdf", "a.tif", "a.gcode", "a.hpgl", "a.dxf", "a.json"}) {
        CAPTURE(name);
        std::vector<double> shares;
        const Watch watch{.stop = {}, .progress = [&](double share) { shares.push_back(share); }};
        CHECK(save_drawing(many_to_save(dots, folder / name), watch));
        REQUIRE(shares.size() > 3);
        CHECK(shares.front() == 0);
        CHECK(shares.back() == 1);
        for (std::size_t i = 1; i < shares.size(); ++i) CHECK(shares[i] >= shares[i - 1]);
    }
}

TEST_CASE("a saving that is stopped half way leaves the old file whole and nothing else") {
    TemporaryFolder folder;
    const Dots dots = many_dots();
    for (const char* name :
         {"a.svg", "a.csv", "a.png", "a.pdf", "a.tif", "a.gcode", "a.hpgl", "a.dxf", "a.json"}) {
        CAPTURE(name);
        std::ofstream(folder / name) << "old";
        std::stop_source source;
        const auto stop_half_way = [&](double share) {
            if (share > 0.4) source.request_stop();
        };
        CHECK_FALSE(save_drawing(many_to_save(dots, folder / name),
                                 {.stop = source.get_token(), .progress = stop_half_way}));
        CHECK(text_of(folder / name) == "old");
        fs::remove(folder / name);
        CHECK(fs::is_empty(folder / "."));
    }
}

TEST_CASE("a PDF most of whose dots lie beyond its page is stopped wherever it has come to") {
    TemporaryFolder folder;
    Dots dots;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(0, 1);
    for (int i = 0; i < 60'000; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(static_cast<float>(i) / 60'000);  // whole paths of theirs are left out
    }
    DrawingToSave drawing = many_to_save(dots, folder / "a.pdf");
    drawing.page = {.width_mm = 100, .height_mm = 20, .mm_per_page_unit = 100};
    for (const double at : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        CAPTURE(at);
        std::stop_source source;
        const auto stop_there = [&](double share) {
            if (share > at) source.request_stop();
        };
        CHECK_FALSE(save_drawing(drawing, {.stop = source.get_token(), .progress = stop_there}));
        CHECK(fs::is_empty(folder / "."));
    }
}

TEST_CASE(
    "up to a million dots are saved for plotters in an order of short moves, unless another is asked for") {
    const Dots dots = many_dots();
    CHECK(usual_order(DrawingFormat::svg, 1'000'000) == DotOrder::shortest);
    CHECK(usual_order(DrawingFormat::svg, kMostRoutedDots + 1) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::svg, kMostSortedDots + 1) == DotOrder::recursion);
    CHECK(usual_order(DrawingFormat::gcode, kMostRoutedDots + 1) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::csv, 10) == DotOrder::recursion);
    TemporaryFolder folder;
    Dots few = dots;
    few.resize(3'000, false);
    const auto saved = [&](std::optional<DotOrder> order) {
        CHECK(save_drawing({.file = {.path = folder / "a.svg", .saving = {.order = order}},
                            .dots = stream_of(few, 100),
                            .page = kPage}));
        return text_of(folder / "a.svg");
    };
    CHECK(saved({}) == saved(DotOrder::shortest));
    CHECK(saved({}) != saved(DotOrder::recursion));
    // The first dot along a Hilbert curve is the one in the corner, the last the one across.
    const Dots sorted = sorted_dots(stream_of(dots, 100), DotOrder::space);
    CHECK(sorted.size() == dots.size());
    CHECK(sorted.x[0] == 0);
    CHECK(sorted.y[0] == 0);
    CHECK(sorted.x[dots.size() - 1] > 0.99f);
    CHECK(sorted.y[dots.size() - 1] < 0.01f);
}

}  // namespace dapple
