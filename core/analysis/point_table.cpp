#include "core/analysis/point_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <stdexcept>

#include "core/text/numbers.h"

namespace dapple {
namespace {

constexpr std::string_view kBlank = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// Commas, semicolons and tabs end a field even if it is empty; without any of them blanks do.
void split(std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    const bool separated = line.find_first_of(",;\t") != line.npos;
    const std::string_view separators = separated ? ",;\t" : " ";
    for (;;) {
        const std::size_t end = line.find_first_of(separators);
        const std::string_view field = trimmed(line.substr(0, end));
        if (separated || !field.empty()) fields.push_back(field);
        if (end == line.npos) return;
        line.remove_prefix(end + 1);
    }
}

std::optional<double> number(std::string_view field) {
    if (field.starts_with('+')) field.remove_prefix(1);
    return number_of<double>(field);
}

struct Columns {
    std::size_t x = 0, y = 1;
};

std::optional<Columns> named_columns(const std::vector<std::string_view>& fields) {
    const auto find = [&](std::string_view wanted, std::string_view or_else) -> std::optional<std::size_t> {
        for (const std::string_view name : {wanted, or_else}) {
            const auto found = std::ranges::find(fields, name);
            if (found != fields.end()) return static_cast<std::size_t>(found - fields.begin());
        }
        return std::nullopt;
    };
    const auto x = find("x_mm", "x"), y = find("y_mm", "y");
    if (!x || !y) return std::nullopt;
    return Columns{*x, *y};
}

// A field as it may stand in a sentence.
std::string quoted(std::string_view field) {
    return fmt::format("\"{}{}\"", field.substr(0, 40), field.size() > 40 ? "..." : "");
}

}  // namespace

std::vector<glm::dvec2> parse_point_table(std::string_view text, const std::string& name) {
    std::vector<glm::dvec2> points;
    std::vector<std::string_view> fields;
    std::optional<Columns> columns;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    for (std::size_t line_number = 1; !text.empty(); ++line_number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.starts_with('#')) continue;
        split(line, fields);

        const auto fail = [&](const std::string& what) {
            throw std::runtime_error(fmt::format("{}, line {}: {}", name, line_number, what));
        };
        if (!columns && !number(fields.front())) {
            columns = named_columns(fields);
            if (!columns)
                fail(fmt::format("{} is neither a number nor a header with x_mm and y_mm, or x and y",
                                 quoted(fields.front())));
            continue;
        }
        if (!columns) columns.emplace();
        const auto coordinate = [&](std::size_t column, const char* axis) {
            if (column >= fields.size()) fail(fmt::format("there is no {}; a point needs two numbers", axis));
            const std::optional<double> value = number(fields[column]);
            if (!value) fail(fmt::format("{} is not a number", quoted(fields[column])));
            if (!std::isfinite(*value)) fail(fmt::format("{} is {}, not a place", axis, fields[column]));
            return *value;
        };
        const double x = coordinate(columns->x, "x");
        points.push_back({x, coordinate(columns->y, "y")});
    }
    if (points.empty()) throw std::runtime_error(name + ": there are no points in it");
    return points;
}

std::optional<glm::dvec2> page_of_table(std::string_view text) {
    std::vector<std::string_view> names, fields;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.starts_with('#')) continue;
        split(line, names.empty() ? names : fields);
        if (!fields.empty()) break;
    }
    const auto side = [&](std::string_view name) -> std::optional<double> {
        const auto column = std::size_t(std::ranges::find(names, name) - names.begin());
        if (column >= std::min(names.size(), fields.size())) return {};
        const std::optional<double> length = number(fields[column]);
        return length && *length > 0 && std::isfinite(*length) ? length : std::nullopt;
    };
    const auto width = side("page_width_mm"), height = side("page_height_mm");
    if (!width || !height) return {};
    return glm::dvec2(*width, *height);
}

PlacedPoints in_their_own_box(std::vector<glm::dvec2> points, Topology topology, const std::string& name) {
    if (points.empty()) throw std::runtime_error(name + ": there are no points in it");
    glm::dvec2 low = points.front(), high = low;
    for (const glm::dvec2 p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec2 size = high - low;
    if (!(size.x > 0 || size.y > 0)) {
        throw std::runtime_error(
            name + ": all points are at one place; say with --width and --height what they fill");
    }
    // (n - 1) e^2 - (w + h) e - w h = 0
    const double a = double(points.size()) - 1, b = size.x + size.y;
    const double spacing = (b + std::sqrt(b * b + 4 * a * size.x * size.y)) / (2 * a);
    for (glm::dvec2& p : points) p = p - low + 0.5 * spacing;
    return {{size.x + spacing, size.y + spacing, topology}, std::move(points)};
}

}  // namespace dapple
