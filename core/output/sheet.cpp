#include "core/output/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/text/numbers.h"

namespace dapple {

namespace {

constexpr int kMostSheets = 1000;  // along a side

constexpr double kRoundingMm = 0.1;  // of a page size that someone has read and typed

constexpr float kPageStart = PageSpan{}.first, kPageEnd = PageSpan{}.end;

// Lengths in page units, counted from the picture's corner, which lies a margin from the page's.
PageSpan span_of(int index, int count, double length, double margin) {
    const auto edge = [&](int i) { return static_cast<float>(length * i / count - margin); };
    return {index == 1 ? kPageStart : edge(index - 1), index == count ? kPageEnd : edge(index),
            length * (index - 1) / count - margin};
}

// From and to in millimetres.
PageSpan span_between(double from, double to, double page_mm, double mm_per_page_unit, double margin) {
    const auto edge = [&](double mm) { return static_cast<float>(mm / mm_per_page_unit - margin); };
    return {from > 0 ? edge(from) : kPageStart, to < page_mm ? edge(to) : kPageEnd,
            from / mm_per_page_unit - margin};
}

}  // namespace

Sheet parse_sheet(std::string_view text) {
    const auto numbers = numbers_of<int, 4>(text, ",/x");
    if (!numbers) {
        throw std::runtime_error(
            fmt::format("'{}' is not a sheet; write COLUMN,ROW/COLUMNSxROWS, for example 2,1/3x4", text));
    }
    const auto [column, row, columns, rows] = *numbers;
    if (columns < 1 || rows < 1 || columns > kMostSheets || rows > kMostSheets) {
        throw std::runtime_error(
            fmt::format("'{}': a mural has from 1 to {} sheets a side", text, kMostSheets));
    }
    if (column < 1 || row < 1 || column > columns || row > rows) {
        throw std::runtime_error(
            fmt::format("'{}': sheets are counted from 1,1 to {},{}", text, columns, rows));
    }
    return {column, row, columns, rows};
}

Rectangle<double> parse_region(std::string_view text) {
    const auto numbers = numbers_of<double, 4>(text, ",,x");
    if (!numbers) {
        throw std::runtime_error(fmt::format(
            "'{}' is not a region; write X,Y,WIDTHxHEIGHT in millimetres, for example 20,15,100x80", text));
    }
    const auto [x, y, width, height] = *numbers;
    // Written so that what is not a number is refused too.
    if (!(x >= 0) || !(y >= 0) || !std::isfinite(x + y)) {
        throw std::runtime_error(
            fmt::format("'{}': a region's corner is counted from the page's, from 0 up", text));
    }
    if (!(width > 0) || !(height > 0) || !std::isfinite(width + height)) {
        throw std::runtime_error(fmt::format("'{}': a region needs a width and a height over 0", text));
    }
    return {{x, y}, {x + width, y + height}};
}

Excerpt sheet_of(const PageSize& page, const Sheet& sheet, glm::dvec2 picture_corner_mm) {
    const glm::dvec2 margin = picture_corner_mm / page.mm_per_page_unit;
    return {{span_of(sheet.column, sheet.columns, page.width_mm / page.mm_per_page_unit, margin.x),
             span_of(sheet.row, sheet.rows, page.height_mm / page.mm_per_page_unit, margin.y)},
            {page.width_mm / sheet.columns, page.height_mm / sheet.rows, page.mm_per_page_unit}};
}

std::vector<CutMark> registration_marks(const PageSize& page) {
    const double size = std::min(6.0, std::min(page.width_mm, page.height_mm) / 20), half = size / 2;
    std::vector<CutMark> marks;
    for (const double x : {size, page.width_mm - size}) {
        for (const double y : {size, page.height_mm - size}) {
            marks.push_back({{x - half, y}, {x + half, y}});
            marks.push_back({{x, y - half}, {x, y + half}});
        }
    }
    return marks;
}

Excerpt region_of(const PageSize& page, const Rectangle<double>& region, glm::dvec2 picture_corner_mm) {
    const glm::dvec2 margin = picture_corner_mm / page.mm_per_page_unit;
    const auto [low, high] = region;
    const bool begins_on_page = low.x < page.width_mm && low.y < page.height_mm;
    if (!begins_on_page || high.x > page.width_mm + kRoundingMm || high.y > page.height_mm + kRoundingMm) {
        throw std::runtime_error(
            fmt::format("the region reaches to {:.10g} x {:.10g} mm, and the page is {:.10g} x {:.10g} mm",
                        high.x, high.y, page.width_mm, page.height_mm));
    }
    return {{span_between(low.x, high.x, page.width_mm, page.mm_per_page_unit, margin.x),
             span_between(low.y, high.y, page.height_mm, page.mm_per_page_unit, margin.y)},
            {std::min(high.x, page.width_mm) - low.x, std::min(high.y, page.height_mm) - low.y,
             page.mm_per_page_unit}};
}

}  // namespace dapple
