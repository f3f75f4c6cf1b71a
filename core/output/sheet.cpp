#include "core/output/sheet.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "core/text/number_words.h"
#include "core/text/text_lines.h"

namespace dapple {

namespace {

// All in millimetres.
constexpr double kPaperWidth = 210, kPaperHeight = 297, kBorder = 15;
constexpr double kPictureTop = 35, kPictureHeight = 165;
constexpr double kTextSize = 4, kLineHeight = 6;

void write_box(std::ostream& out, glm::dvec2 corner, glm::dvec2 size, std::string_view style) {
    fmt::print(out,
               R"(<rect x="{:.3f}" y="{:.3f}" width="{:.3f}" height="{:.3f}" {}/>)"
               "\n",
               corner.x, corner.y, size.x, size.y, style);
}

void write_text(std::ostream& out, glm::dvec2 at, double size, std::string_view style,
                std::string_view text) {
    fmt::print(out,
               R"(<text x="{:.3f}" y="{:.3f}" font-size="{:.3f}" {}>{}</text>)"
               "\n",
               at.x, at.y, size, style, xml_text(text));
}

// The steps, in lines that fit the paper.
std::vector<std::string> steps_for(const AssemblyPlan& plan) {
    const Sheet& sheets = plan.sheets;
    const double overlap = sheets.overlap_mm;
    std::vector<std::string> lines{"1. Print or plot each file at 100 %, never fitted to the paper."};
    if (overlap > 0) {
        if (sheets.columns > 1)
            lines.push_back(
                fmt::format("2. From column B on, cut {:g} mm off each sheet's left side, along the marks.",
                            overlap / 2));
        if (sheets.rows > 1)
            lines.push_back(fmt::format("{} From row 2 on, cut {:g} mm off each sheet's upper side.",
                                        sheets.columns > 1 ? "   " : "2.", overlap / 2));
        lines.push_back(
            "3. Join each row: lay the cut side of a sheet on the marks of the one to its left, so");
        lines.push_back(
            "   that the drawing meets in the strip that both have, and glue it onto that strip.");
        lines.push_back("4. Join the rows in the same way, from the top down.");
    } else {
        lines.push_back(
            "2. Cut away bare paper around the drawing. The sheets share no strip: lay them edge to");
        lines.push_back(
            "   edge, each row from the left and the rows from the top, and tape them from behind.");
    }
    return lines;
}

}  // namespace

void write_assembly_plan(std::ostream& out, const AssemblyPlan& plan) {
    const PageSize& page = plan.page;
    const Sheet& sheets = plan.sheets;
    const glm::dvec2 whole(page.width_mm, page.height_mm), step = sheet_step(page, sheets);
    const PageSize one = sheet_of(page, sheets).size;
    const glm::dvec2 size(one.width_mm, one.height_mm);
    const double scale = std::min((kPaperWidth - 2 * kBorder) / whole.x, kPictureHeight / whole.y);
    const glm::dvec2 corner((kPaperWidth - whole.x * scale) / 2, kPictureTop);

    fmt::print(out,
               R"(<?xml version="1.0" encoding="UTF-8"?>)"
               "\n"
               R"(<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="{0:g}mm" height="{1:g}mm" )"
               R"(viewBox="0 0 {0:g} {1:g}" font-family="sans-serif">)"
               "\n",
               kPaperWidth, kPaperHeight);
    write_box(out, {0, 0}, {kPaperWidth, kPaperHeight}, R"(fill="#ffffff")");
    write_text(out, {kBorder, 18}, 6, R"(font-weight="bold")", "How the sheets of " + plan.name + " join");
    const bool several = sheets.columns * sheets.rows > 1;
    write_text(out, {kBorder, 26}, kTextSize, "",
               fmt::format("{:.5g} x {:.5g} mm on {} sheet{} of {:.5g} x {:.5g} mm", whole.x, whole.y,
                           sheets.columns * sheets.rows, several ? "s" : "", size.x, size.y));

    write_box(out, corner, whole * scale, R"(fill="#f7f7f7" stroke="#000000" stroke-width="0.4")");
    const double overlap = sheets.overlap_mm * scale;
    for (int column = 1; column < sheets.columns; ++column)
        write_box(out, corner + glm::dvec2(step.x * column * scale, 0), {overlap, whole.y * scale},
                  R"(fill="#c8c8c8")");
    for (int row = 1; row < sheets.rows; ++row)
        write_box(out, corner + glm::dvec2(0, step.y * row * scale), {whole.x * scale, overlap},
                  R"(fill="#c8c8c8")");
    constexpr std::string_view kCut = R"(stroke="#000000" stroke-width="0.3" stroke-dasharray="2 1.2")";
    const auto write_cut = [&](glm::dvec2 from, glm::dvec2 to) {
        fmt::print(out,
                   R"(<path d="M{:.3f} {:.3f}L{:.3f} {:.3f}" {}/>)"
                   "\n",
                   from.x, from.y, to.x, to.y, kCut);
    };
    for (int column = 1; column < sheets.columns; ++column) {
        const double x = corner.x + step.x * column * scale + overlap / 2;
        write_cut({x, corner.y}, {x, corner.y + whole.y * scale});
    }
    for (int row = 1; row < sheets.rows; ++row) {
        const double y = corner.y + step.y * row * scale + overlap / 2;
        write_cut({corner.x, y}, {corner.x + whole.x * scale, y});
    }
    const double letters = std::min({0.4 * step.y * scale, 0.25 * step.x * scale, 12.0});
    for (int row = 1; row <= sheets.rows; ++row) {
        for (int column = 1; column <= sheets.columns; ++column) {
            const glm::dvec2 middle = glm::dvec2(step.x * (column - 1), step.y * (row - 1)) + size / 2.0;
            write_text(out, corner + middle * scale + glm::dvec2(0, 0.35 * letters), letters,
                       R"(text-anchor="middle")", name_of(Sheet{column, row, sheets.columns, sheets.rows}));
        }
    }

    std::vector<std::string> lines{
        fmt::format("A1 is the file {0}-A1{1}; letters are columns from the left, numbers rows from the top.",
                    plan.name, plan.ending)};
    if (sheets.overlap_mm > 0)
        lines.push_back(
            fmt::format("Grey: the {:g} mm that neighbours share. Dashed: where to cut.", sheets.overlap_mm));
    if (several)
        lines.push_back(fmt::format(
            "The next sheet begins {:.5g} mm further right, or {:.5g} mm further down.", step.x, step.y));
    for (std::string& line : steps_for(plan)) lines.push_back(std::move(line));
    double y = kPictureTop + kPictureHeight + 14;
    for (const std::string& line : lines) {
        write_text(out, {kBorder, y}, kTextSize, R"(xml:space="preserve")", line);
        y += kLineHeight;
    }
    out << "</svg>\n";
}

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
    throw failure(
        "an overlap of {:g} mm is too wide for {} x {} sheets of a page of {:.4g} x {:.4g} mm; choose less "
        "than {:.3g} mm",
        sheet.overlap_mm, sheet.columns, sheet.rows, page.width_mm, page.height_mm,
        std::min(sheet.columns > 1 ? across : down, sheet.rows > 1 ? down : across));
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
        throw failure("'{}' is not a sheet; write COLUMN,ROW/COLUMNSxROWS, for example 2,1/3x4", text);
    }
    const auto [column, row, columns, rows] = *numbers;
    if (columns < 1 || rows < 1 || columns > kMostSheets || rows > kMostSheets)
        throw failure("'{}': a mural has from 1 to {} sheets a side", text, kMostSheets);
    if (column < 1 || row < 1 || column > columns || row > rows)
        throw failure("'{}': sheets are counted from 1,1 to {},{}", text, columns, rows);
    return {column, row, columns, rows};
}

Sheet parse_sheets(std::string_view text) {
    const auto numbers = numbers_of<int, 2>(text, "x");
    if (!numbers) {
        throw failure("'{}' is not a number of sheets; write COLUMNSxROWS, for example 3x4", text);
    }
    const auto [columns, rows] = *numbers;
    if (columns < 1 || rows < 1 || columns > kMostSheetsAtOnce || rows > kMostSheetsAtOnce)
        throw failure("'{}': there are from 1 to {} sheets a side", text, kMostSheetsAtOnce);
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
        throw failure(
            "'{}' is not a region; write X,Y,WIDTHxHEIGHT, for example 20,15,100x80 in millimetres or "
            "1,1,4x3in",
            text);
    }
    const auto [x, y, width, height] = *lengths;
    for (const double length : {x, y, x + width, y + height})
        if (std::isinf(length)) throw failure("'{}': no page is large enough for this region", text);
    // Written so that what is not a number is refused too.
    if (!(x >= 0) || !(y >= 0))
        throw failure("'{}': a region's corner is counted from the page's, from 0 up", text);
    if (!(width > 0) || !(height > 0))
        throw failure("'{}': a region needs a width and a height over 0", text);
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
    if (!begins_on_page || high.x > page.width_mm + kRoundingMm || high.y > page.height_mm + kRoundingMm)
        throw failure("the region reaches to {:.10g} x {:.10g} mm, and the page is {:.10g} x {:.10g} mm",
                      high.x, high.y, page.width_mm, page.height_mm);
    return {{span_between(low.x, high.x, page.width_mm, page.mm_per_page_unit, margin.x),
             span_between(low.y, high.y, page.height_mm, page.mm_per_page_unit, margin.y)},
            {std::min(high.x, page.width_mm) - low.x, std::min(high.y, page.height_mm) - low.y,
             page.mm_per_page_unit}};
}

}  // namespace dapple
