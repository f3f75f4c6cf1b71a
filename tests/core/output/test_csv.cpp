#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/output/drawing_format.h"

using namespace dapple;

namespace {

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    return fields;
}

template <class T>
T number(const std::string& text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    CHECK(error == std::errc{});
    CHECK(end == text.data() + text.size());
    return value;
}

}  // namespace

TEST_CASE("a table of dots reads back to the very same dots") {
    constexpr std::size_t n = 16;
    const PageSize page{.width_mm = 123.4, .height_mm = 77.7, .mm_per_page_unit = 123.4};
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    std::uniform_int_distribution<int> level(0, 9);
    Dots dots;
    for (int i = 0; i < 2000; ++i) {
        dots.x.push_back(unit(random));
        dots.y.push_back(unit(random) * unit(random));
        // A threshold as dots.h defines it.
        const int l = level(random);
        const auto rank = static_cast<float>(l == 0 ? random() % n : n + random() % (3 * n));
        const float threshold = (rank + 0.5f) / 16 * (l == 0 ? 1.0f : std::ldexp(1.0f, 2 * (l - 1)));
        dots.threshold.push_back(threshold);
        dots.critical.push_back(threshold / (unit(random) + 1e-3f));
    }

    std::stringstream table;
    write_csv(table, {.size = page, .dots = stream_of(dots), .dot_radius_mm = 0.1 + 0.2, .tile_size = n});
    std::string line;
    REQUIRE(std::getline(table, line));
    CHECK(line == "x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm");
    for (std::size_t i = 0; i < dots.size(); ++i) {
        REQUIRE(std::getline(table, line));
        const std::vector<std::string> fields = fields_of(line);
        REQUIRE(fields.size() == 8);
        CHECK(static_cast<float>(number<double>(fields[0]) / page.mm_per_page_unit) == dots.x[i]);
        CHECK(static_cast<float>(number<double>(fields[1]) / page.mm_per_page_unit) == dots.y[i]);
        CHECK(number<double>(fields[2]) == 0.1 + 0.2);
        const int l = number<int>(fields[3]), rank = number<int>(fields[4]);
        const float unscaled = (static_cast<float>(rank) + 0.5f) / 16;
        CHECK(unscaled * (l == 0 ? 1.0f : std::ldexp(1.0f, 2 * (l - 1))) == dots.threshold[i]);
        CHECK(number<float>(fields[5]) == dots.critical[i]);
        CHECK(number<double>(fields[6]) == page.width_mm);
        CHECK(number<double>(fields[7]) == page.height_mm);
    }
    CHECK(!std::getline(table, line));
}

TEST_CASE("a table of no dots is its header") {
    std::ostringstream table;
    write_csv(table, {.size = {.width_mm = 1, .height_mm = 1, .mm_per_page_unit = 1}});
    CHECK(table.str() == "x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm\n");
}
