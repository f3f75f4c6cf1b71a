#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

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
            const Excerpt sheet = sheet_of(mural, {column, row, 3, 4});
            cut_to(sheet.part, dots);
            CHECK(sheet.size.width_mm == 300);
            CHECK(sheet.size.height_mm == 150);
            CHECK(sheet.size.mm_per_page_unit == 900);
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

TEST_CASE("a region's text is read as the same region, in as few digits as do") {
    for (const char* text : {"120,80,50x40.5", "0,0,0.01x100000", "1.1,2.2,3.3x4.4", "60.07,0.1,0.3x1e-7"}) {
        CAPTURE(text);
        const Rectangle<double> region = parse_region(text);
        CHECK(parse_region(text_of_region(region)) == region);
    }
    CHECK(text_of_region(parse_region("1.1,2.2,3.3x4.4")) == "1.1,2.2,3.3x4.4");
    CHECK(text_of_region(parse_region("1,1,4x3in")) == "25.4,25.4,101.6x76.2");
}

TEST_CASE(
    "regions with common edges share the dots out, and those at the page's edges take what lies on them") {
    // Positions in millimetres on a page of 90 x 60; edges are no binary fractions.
    Dots all;
    for (const double y : {0.0, 20.1, 20.1000001, 41.0, 60.0}) {
        for (const double x : {0.0, 29.9999999, 30.3, 30.3000001, 59.0, 90.0}) {
            all.x.push_back(static_cast<float>(x / 90));
            all.y.push_back(static_cast<float>(y / 90));
            all.threshold.push_back(static_cast<float>(all.x.size()));
        }
    }
    const PageSize page{90, 60, 90};
    std::vector<int> seen(all.size() + 1);
    for (const char* text :
         {"0,0,30.3x20.1", "30.3,0,59.7x20.1", "0,20.1,30.3x39.9", "30.3,20.1,59.7x39.9"}) {
        const Rectangle<double> region = parse_region(text);
        const Excerpt excerpt = region_of(page, region);
        CHECK(excerpt.size.width_mm == doctest::Approx(region.size().x));
        CHECK(excerpt.size.height_mm == doctest::Approx(region.size().y));
        Dots dots = all;
        cut_to(excerpt.part, dots);
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const auto id = static_cast<std::size_t>(dots.threshold[i]);
            ++seen[id];
            CHECK(std::abs(dots.x[i] * 90.0 + region.low.x - all.x[id - 1] * 90.0) < 1e-4);
            CHECK(std::abs(dots.y[i] * 90.0 + region.low.y - all.y[id - 1] * 90.0) < 1e-4);
        }
    }
    CHECK(std::count(seen.begin() + 1, seen.end(), 1) == static_cast<long>(all.size()));
}

TEST_CASE("a region is read as lengths, and has to be one and on the page") {
    CHECK(parse_region("120,80,50x40.5") == Rectangle<double>{{120, 80}, {170, 120.5}});
    CHECK(parse_region("0,0.5,1x2") == Rectangle<double>{{0, 0.5}, {1, 2.5}});
    CHECK(parse_region("1,2,3x4in") == Rectangle<double>{{25.4, 50.8}, {4 * 25.4, 6 * 25.4}});
    CHECK(parse_region("1cm,2,3cmx4mm") == Rectangle<double>{{10, 2}, {40, 6}});
    for (const char* wrong : {"", "1,2", "1,2,3", "1,2,3x", "1,2,3x4ft", "1,2,x4", ",2,3x4", "1,2,3ftx4",
                              "-1,2,3x4", "1,-2,3x4", "1,2,0x4", "1,2,3x0", "1,2,-3x4", "nan,2,3x4",
                              "1,2,infx4", "1,2,3x4x5", "a,2,3x4", " 1,2,3x4", "1,2/3x4"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(parse_region(wrong), std::runtime_error);
    }
    const PageSize page{200, 133.0 + 1.0 / 3, 200};
    CHECK(region_of(page, {{0, 0}, {200, page.height_mm}}).part == PagePart{});
    // Someone has read 133.33 as the page's height, someone else 133.34.
    CHECK(region_of(page, {{0, 0}, {200, 133.34}}).size.height_mm == page.height_mm);
    CHECK_THROWS_AS(region_of(page, {{150, 0}, {201, 10}}), std::runtime_error);
    CHECK_THROWS_AS(region_of(page, {{0, 100}, {10, 134}}), std::runtime_error);
    CHECK_THROWS_AS(region_of(page, {{200, 0}, {200.01, 10}}), std::runtime_error);
}

TEST_CASE("the window around a part holds its dots, and no more than a hair beyond it") {
    const PageSize page{900, 600, 900};
    const auto in_units = [](std::int64_t n) { return static_cast<double>(n) * 0x1p-62; };
    for (int column = 1; column <= 3; ++column) {
        const PagePart part = sheet_of(page, {column, 2, 3, 4}).part;
        const PageWindow window = window_around(part);
        const double left = in_units(window.x), top = in_units(window.y);
        CHECK(left < (column - 1) / 3.0);
        CHECK(left > (column - 1) / 3.0 - 1e-5);
        CHECK(left + window.width > column / 3.0);
        CHECK(left + window.width < column / 3.0 + 1e-5);
        CHECK(top < 150.0 / 900);
        CHECK(top > 150.0 / 900 - 1e-5);
        CHECK(top + window.height > 300.0 / 900);
        CHECK(top + window.height < 300.0 / 900 + 1e-5);
    }
    const PageWindow all = window_around({});
    CHECK(all.x < 0);
    CHECK(in_units(all.x) + all.width > 1);
}

TEST_CASE("a margin surrounds the picture, and sheets of the page with it share its edges") {
    const PageSize page{200, 140, 180};
    // The picture's corner is 10 mm from the page's.
    const Excerpt whole = sheet_of(page, {}, {10, 10});
    CHECK(whole.part.across.offset * 180 == doctest::Approx(-10));
    CHECK(whole.part.down.offset * 180 == doctest::Approx(-10));
    const Excerpt left = sheet_of(page, {1, 1, 3, 2}, {10, 10}),
                  middle = sheet_of(page, {2, 1, 3, 2}, {10, 10}),
                  below = sheet_of(page, {2, 2, 3, 2}, {10, 10});
    CHECK(left.part.across.end == middle.part.across.first);
    CHECK(middle.part.down.end == below.part.down.first);
    CHECK(middle.part.across.first * 180 == doctest::Approx(200 / 3.0 - 10));
    CHECK(below.part.down.offset * 180 == doctest::Approx(60));
    const Excerpt region = region_of(page, {{200 / 3.0, 0}, {400 / 3.0, 70}}, {10, 10});
    CHECK(region.part.across.first == middle.part.across.first);
    CHECK(region.part.across.end == middle.part.across.end);
    CHECK(region.part.down == middle.part.down);
}
