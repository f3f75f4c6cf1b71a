// Saving a drawing while someone watches it.

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/save_drawing.h"
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

}  // namespace

TEST_CASE("progress rises from nothing to all, in every format") {
    TemporaryFolder folder;
    const Dots dots = many_dots();
    for (const char* name :
         {"a.svg", "a.csv", "a.png", "a.pdf", "a.tif", "a.gcode", "a.hpgl", "a.dxf", "a.json"}) {
        CAPTURE(name);
        std::vector<double> shares;
        const SavingWatch watch{.stop = {}, .progress = [&](double share) { shares.push_back(share); }};
        CHECK(save_drawing(folder / name, {}, {.dots = stream_of(dots, 100), .page = kPage}, watch));
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
        CHECK_FALSE(save_drawing(folder / name, {}, {.dots = stream_of(dots, 100), .page = kPage},
                                 {.stop = source.get_token(), .progress = stop_half_way}));
        CHECK(text_of(folder / name) == "old");
        fs::remove(folder / name);
        CHECK(fs::is_empty(folder / "."));
    }
}

TEST_CASE("a few dots are saved for plotters in an order of short moves, unless another is asked for") {
    const Dots dots = many_dots();
    CHECK(usual_order(DrawingFormat::svg, kMostRoutedDots) == DotOrder::shortest);
    CHECK(usual_order(DrawingFormat::svg, dots.size()) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::svg, kMostSortedDots + 1) == DotOrder::recursion);
    CHECK(usual_order(DrawingFormat::gcode, dots.size()) == DotOrder::space);
    CHECK(usual_order(DrawingFormat::csv, 10) == DotOrder::recursion);
    TemporaryFolder folder;
    const auto saved = [&](std::optional<DotOrder> order) {
        CHECK(save_drawing(folder / "a.svg", {},
                           {.dots = stream_of(dots, 100), .page = kPage, .order = order}));
        return text_of(folder / "a.svg");
    };
    CHECK(saved({}) == saved(DotOrder::space));
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
