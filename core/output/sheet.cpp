#include "core/output/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/text/length.h"
#include "core/text/numbers.h"

namespace dapple {

namespace {

constexpr int kMostSheets = 1000;  // along a side

constexpr double kLongestMarkMm = 5;

constexpr double kRoundingMm = 0.1;  // of a page size that someone has read and typed

constexpr float kPageStart = PageSpan{}.first, kPageEnd = PageSpan{}.end;

// Lengths in page units, counted from the picture's corner, which lies a margin from the page's.
PageSpan span_of(int index, int count, double length, double overlap, double margin) {
    // The same sum for a sheet's end as for the next one's begin where nothing overlaps.
    const auto begin = [&](int i) { return (length - overlap) * i / count; };
    return {index == 1 ? kPageStart : static_cast<float>(begin(index - 1) - margin),
            index == count ? kPageEnd : static_cast<float>(begin(index) + overlap - margin),
            begin(index - 1) - margin};
}

// A side alone is not cut, and so has no strip to share.
glm::dvec2 overlap_of(const Sheet& sheet) {
    return {sheet.columns > 1 ? sheet.overlap_mm : 0, sheet.rows > 1 ? sheet.overlap_mm : 0};
}

void check_overlap(const PageSize& page, const Sheet& sheet) {
    const glm::dvec2 overlap = overlap_of(sheet);
    const double across = page.width_mm / (sheet.columns + 1), down = page.height_mm / (sheet.rows + 1);
    if (overlap.x < across && overlap.y < down) return;
    throw std::runtime_error(
        fmt::format("an overlap of {:g} mm is too wide for {} x {} sheets of a page of {:.4g} x {:.4g} mm; "
                    "choose less than {:.3g} mm",
                    sheet.overlap_mm, sheet.columns, sheet.rows, page.width_mm, page.height_mm,
                    std::min(sheet.columns > 1 ? across : down, sheet.rows > 1 ? down : across)));
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

Sheet parse_sheets(std::string_view text) {
    const auto numbers = numbers_of<int, 2>(text, "x");
    if (!numbers) {
        throw std::runtime_error(
            fmt::format("'{}' are no sheets; write COLUMNSxROWS, for example 3x4", text));
    }
    const auto [columns, rows] = *numbers;
    if (columns < 1 || rows < 1 || columns > kMostSheetsAtOnce || rows > kMostSheetsAtOnce) {
        throw std::runtime_error(
            fmt::format("'{}': there are from 1 to {} sheets a side", text, kMostSheetsAtOnce));
    }
    return {.columns = columns, .rows = rows};
}

std::string grid_text(const Sheet& sheet) {
    return fmt::format("{}x{}", sheet.columns, sheet.rows);
}

bool is_several(const Sheet& sheet) {
    return sheet.columns > 1 || sheet.rows > 1;
}

std::vector<Sheet> all_sheets(const Sheet& sheet) {
    std::vector<Sheet> all;
    for (int row = 1; row <= sheet.rows; ++row)
        for (int column = 1; column <= sheet.columns; ++column)
            all.push_back({column, row, sheet.columns, sheet.rows, sheet.overlap_mm});
    return all;
}

std::string name_of(const Sheet& sheet) {
    std::string letters;
    for (int left = sheet.column; left > 0; left = (left - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
    return letters + std::to_string(sheet.row);
}

// Four lengths, between them , , and x; the last one's unit is that of all which have none.
static std::optional<std::array<double, 4>> lengths_of_region(std::string_view text) {
    const std::string_view unit = text.substr(text.find_last_of("0123456789.") + 1);
    std::array<double, 4> lengths{};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t end = i < 3 ? text.find(",,x"[i]) : text.size();
        if (end == text.npos || end == 0) return std::nullopt;
        std::string part(text.substr(0, end));
        if (i < 3 && std::string_view("0123456789.").find(part.back()) != std::string_view::npos)
            part += unit;
        const std::optional<double> length = millimetres_of(part);
        if (!length) return std::nullopt;
        lengths[i] = *length;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lengths;
}

Rectangle<double> parse_region(std::string_view text) {
    const auto lengths = lengths_of_region(text);
    if (!lengths) {
        throw std::runtime_error(
            fmt::format("'{}' is not a region; write X,Y,WIDTHxHEIGHT, for example 20,15,100x80 in "
                        "millimetres or 1,1,4x3in",
                        text));
    }
    const auto [x, y, width, height] = *lengths;
    for (const double length : {x, y, x + width, y + height}) {
        if (std::isinf(length))
            throw std::runtime_error(
                fmt::format("'{}': a region lies on the page, and none is so large", text));
    }
    // Written so that what is not a number is refused too.
    if (!(x >= 0) || !(y >= 0)) {
        throw std::runtime_error(
            fmt::format("'{}': a region's corner is counted from the page's, from 0 up", text));
    }
    if (!(width > 0) || !(height > 0)) {
        throw std::runtime_error(fmt::format("'{}': a region needs a width and a height over 0", text));
    }
    return {{x, y}, {x + width, y + height}};
}

// The fewest decimals that come to the same end.
static std::string length_between(double from, double to) {
    for (int decimals = 0; decimals < 20; ++decimals) {
        const std::string text = fmt::format("{:.{}f}", to - from, decimals);
        if (from + *number_of<double>(text) == to) return text;
    }
    return fmt::format("{}", to - from);
}

std::string text_of_region(const Rectangle<double>& region) {
    const auto [low, high] = region;
    return fmt::format("{},{},{}x{}", low.x, low.y, length_between(low.x, high.x),
                       length_between(low.y, high.y));
}

Excerpt sheet_of(const PageSize& page, const Sheet& sheet, glm::dvec2 picture_corner_mm) {
    check_overlap(page, sheet);
    const double unit = page.mm_per_page_unit;
    const glm::dvec2 margin = picture_corner_mm / unit, overlap = overlap_of(sheet);
    const glm::dvec2 size = sheet_step(page, sheet) + overlap;
    return {{span_of(sheet.column, sheet.columns, page.width_mm / unit, overlap.x / unit, margin.x),
             span_of(sheet.row, sheet.rows, page.height_mm / unit, overlap.y / unit, margin.y)},
            {size.x, size.y, unit}};
}

glm::dvec2 sheet_step(const PageSize& page, const Sheet& sheet) {
    const glm::dvec2 overlap = overlap_of(sheet);
    return {(page.width_mm - overlap.x) / sheet.columns, (page.height_mm - overlap.y) / sheet.rows};
}

std::vector<CutMark> cut_marks(const PageSize& page, const Sheet& sheet) {
    if (sheet.overlap_mm == 0) return {};
    const glm::dvec2 size = sheet_step(page, sheet) + overlap_of(sheet);
    const double cut = sheet.overlap_mm / 2, length = std::min(cut, kLongestMarkMm);
    std::vector<CutMark> marks;
    const auto across = [&](double x) {
        marks.push_back({{x, 0}, {x, length}});
        marks.push_back({{x, size.y - length}, {x, size.y}});
    };
    const auto down = [&](double y) {
        marks.push_back({{0, y}, {length, y}});
        marks.push_back({{size.x - length, y}, {size.x, y}});
    };
    if (sheet.column > 1) across(cut);
    if (sheet.column < sheet.columns) across(size.x - cut);
    if (sheet.row > 1) down(cut);
    if (sheet.row < sheet.rows) down(size.y - cut);
    return marks;
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
