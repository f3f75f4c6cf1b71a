#include "core/output/sheet.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>

namespace dapple {

namespace {

constexpr int kMostSheets = 1000;  // along a side

// Where sheet `index` of `count` begins and ends along a side; the outermost take what lies on the edge.
struct Span {
    float first, end;
    double offset;
};

Span span_of(int index, int count, double length) {
    const auto edge = [&](int i) { return static_cast<float>(length * i / count); };
    return {index == 1 ? -1.0f : edge(index - 1),
            index == count ? std::numeric_limits<float>::max() : edge(index), length * (index - 1) / count};
}

}  // namespace

Sheet parse_sheet(std::string_view text) {
    std::array<int, 4> numbers{};
    constexpr std::string_view ends = ",/x";
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [rest, error] = std::from_chars(at, end, numbers[i]);
        const bool ended = i < ends.size() ? rest != end && *rest == ends[i] : rest == end;
        if (error != std::errc{} || !ended) {
            throw std::runtime_error(
                fmt::format("'{}' is not a sheet; write COLUMN,ROW/COLUMNSxROWS, for example 2,1/3x4", text));
        }
        at = rest + 1;
    }
    const auto [column, row, columns, rows] = numbers;
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

void cut_to_sheet(const Sheet& sheet, Dots& dots, PageSize& page, std::span<PlacedTile> tiles) {
    if (sheet == Sheet{}) return;
    const Span across = span_of(sheet.column, sheet.columns, page.width_mm / page.mm_per_page_unit);
    const Span down = span_of(sheet.row, sheet.rows, page.height_mm / page.mm_per_page_unit);
    std::size_t to = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const float x = dots.x[i], y = dots.y[i];
        if (x < across.first || x >= across.end || y < down.first || y >= down.end) continue;
        dots.x[to] = static_cast<float>(x - across.offset);
        dots.y[to] = static_cast<float>(y - down.offset);
        dots.threshold[to] = dots.threshold[i];
        if (!dots.critical.empty()) dots.critical[to] = dots.critical[i];
        ++to;
    }
    for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold}) column->resize(to);
    if (!dots.critical.empty()) dots.critical.resize(to);
    for (PlacedTile& tile : tiles) {
        tile.x -= across.offset;
        tile.y -= down.offset;
    }
    page.width_mm /= sheet.columns;
    page.height_mm /= sheet.rows;
}

}  // namespace dapple
