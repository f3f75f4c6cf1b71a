#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/output/sheet.h"

using namespace dapple;

TEST_CASE("a mural's sheets have each dot once, where it was") {
    std::mt19937 random(3);
    Dots all;
    const PageSize mural{900, 600, 900};
    for (int i = 0; i < 6000; ++i) {
        // Many of them on the very edges between sheets.
        all.x.push_back(i % 3 ? static_cast<float>(random()) * 0x1p-32f
                              : static_cast<float>(random() % 4) / 3);
        all.y.push_back(static_cast<float>(random()) * 0x1p-32f * 2 / 3);
        all.threshold.push_back(static_cast<float>(i));
    }
    std::vector<int> seen(all.size());
    for (int row = 1; row <= 4; ++row) {
        for (int column = 1; column <= 3; ++column) {
            Dots dots = all;
            PageSize page = mural;
            cut_to_sheet({column, row, 3, 4}, dots, page, {});
            CHECK(page.width_mm == 300);
            CHECK(page.height_mm == 150);
            for (std::size_t i = 0; i < dots.size(); ++i) {
                const auto id = static_cast<std::size_t>(dots.threshold[i]);
                ++seen[id];
                CHECK(std::abs(dots.x[i] * 900.0 + (column - 1) * 300.0 - all.x[id] * 900.0) < 1e-3);
                CHECK(std::abs(dots.y[i] * 900.0 + (row - 1) * 150.0 - all.y[id] * 900.0) < 1e-3);
                CHECK(dots.x[i] * 900 > -1e-3);
                CHECK(dots.y[i] * 900 < 150 + 1e-3);
            }
        }
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<long>(all.size()));
}

TEST_CASE("sheets are read as column, row, columns and rows") {
    CHECK(parse_sheet("2,1/3x4") == Sheet{2, 1, 3, 4});
    CHECK(parse_sheet("1,1/1x1") == Sheet{});
    for (const char* wrong : {"", "2,1", "2,1/3", "4,1/3x4", "0,1/3x4", "2,5/3x4", "1,1/0x1", "2,1/3x4x",
                              "a,1/3x4", "1,1/2000x1"}) {
        CHECK_THROWS(parse_sheet(wrong));
    }
}
