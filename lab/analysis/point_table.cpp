#include "lab/analysis/point_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/text/number_words.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr std::string_view kBlank = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// The field at the line's begin, what parts it from the rest being removed with it. In quotes there may be
// anything; of two in a row, which mean one, both are left.
std::string_view take_field(std::string_view& line, char separator) {
    line.remove_prefix(
        std::min(line.find_first_not_of(kBlank.substr(0, separator == '\t' ? 1 : 3)), line.size()));
    std::string_view field;
    std::size_t after = 0;
    if (line.starts_with('"')) {
        std::size_t close = line.find('"', 1);
        while (close != line.npos && line.substr(close + 1).starts_with('"'))
            close = line.find('"', close + 2);
        if (close != line.npos) {
            field = line.substr(1, close - 1);
            after = close + 1;
        }
    }
    const std::size_t end = std::min(line.find(separator, after), line.size());
    // What follows a quote belongs to no field; the whole is then no number.
    if (after == 0 || !trimmed(line.substr(after, end - after)).empty()) field = trimmed(line.substr(0, end));
    line.remove_prefix(end);
    return field;
}

// Fields may be empty, but between blanks.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    for (;;) {
        fields.push_back(take_field(line, separator));
        if (separator == ' ') line = trimmed(line);
        if (line.empty()) return;
        if (separator != ' ') line.remove_prefix(1);
    }
}

// With a point or a comma before its decimals. A comma is left in a field only if it does not part fields.
std::optional<double> number(std::string_view field) {
    if (field.starts_with('+')) field.remove_prefix(1);
    const std::size_t comma = field.find(',');
    if (comma == field.npos) return number_of<double>(field);
    const auto is_digit = [&](std::size_t i) {
        return i < field.size() && field[i] >= '0' && field[i] <= '9';
    };
    if (comma == 0 || !is_digit(comma - 1) || !is_digit(comma + 1) || field.find('.') != field.npos)
        return {};
    std::string with_point(field);
    with_point[comma] = '.';
    return number_of<double>(with_point);
}

// The line without what is in quotes.
std::string unquoted(std::string_view line) {
    std::string rest;
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (!quoted) rest += c;
    }
    return rest;
}

// What parts the fields of such a line. Where there are commas and blanks, either may: in "1, 2" and "1,a b"
// it is the comma, in "1,5 2,5", which without its blanks has no two numbers, it is not.
char separator_of(std::string_view line) {
    const std::string rest = unquoted(line);
    for (const char c : {'\t', ';'})
        if (rest.find(c) != rest.npos) return c;
    if (rest.find(',') == rest.npos) return ' ';
    std::vector<std::string_view> fields;
    split(line, ' ', fields);
    const bool decimal = fields.size() > 1 && std::ranges::all_of(fields, [](std::string_view field) {
                             return number(field).has_value();
                         });
    return decimal ? ' ' : ',';
}

// The lines of a text that are neither blank nor comments: perhaps one of names, and rows.
class Table {
 public:
    explicit Table(std::string_view text) : rest_(without_byte_order_mark(text)) {
        if (!next_line()) return;
        split(line_, separator_of(line_), names_);
        if (number(names_.front())) {
            names_.clear();
            waits_ = true;
        }
    }

    // The columns' names; empty: the table does not say.
    const std::vector<std::string_view>& names() const { return names_; }
    std::size_t line_number() const { return number_; }

    bool next_row() {
        if (!std::exchange(waits_, false) && !next_line()) return false;
        if (!separator_) separator_ = separator_of(line_);
        split(line_, *separator_, fields_);
        if (fields_.size() > 1 && fields_.size() == names_.size() + 1 && fields_.back().empty())
            fields_.pop_back();  // a separator at the end of each row
        if (!names_first_) names_first_ = !names_.empty() && fields_.size() == names_.size() + 1;
        return true;
    }
    const std::vector<std::string_view>& row() const { return fields_; }
    // Where rows have one field more than there are names, their first is the row's own, as R writes it.
    std::size_t before_first() const { return names_first_.value_or(false) ? 1 : 0; }

 private:
    bool next_line() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_ = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            if (!line_.empty() && !line_.starts_with('#')) return true;
        }
        return false;
    }

    std::string_view rest_, line_;
    std::size_t number_ = 0;
    bool waits_ = false;  // the line is a row that was not asked for yet
    std::vector<std::string_view> names_, fields_;
    std::optional<char> separator_;    // of the rows: the first one's
    std::optional<bool> names_first_;  // of the rows: the first one's
};

bool is_called(std::string_view field, std::string_view name) {
    const auto same = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); };
    return std::ranges::equal(field, name, same);
}

std::optional<std::size_t> column_called(std::span<const std::string_view> fields, std::string_view name) {
    const auto found =
        std::ranges::find_if(fields, [&](std::string_view field) { return is_called(field, name); });
    if (found == fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found - fields.begin());
}

// A field as it may stand in a sentence.
std::string quoted(std::string_view field) {
    return fmt::format("\"{}{}\"", field.substr(0, 40), field.size() > 40 ? "..." : "");
}

}  // namespace

std::vector<glm::dvec2> parse_point_table(std::string_view text, const std::string& name) {
    std::vector<glm::dvec2> points;
    Table table(text);
    const auto fail = [&](const std::string& what) {
        throw std::runtime_error(fmt::format("{}, line {}: {}", name, table.line_number(), what));
    };
    std::size_t x_column = 0, y_column = 1;
    if (const auto& names = table.names(); !names.empty()) {
        const auto find = [&](const char* wanted, const char* or_else) {
            const auto column = column_called(names, wanted);
            return column ? column : column_called(names, or_else);
        };
        const auto x = find("x_mm", "x"), y = find("y_mm", "y");
        if (!x || !y)
            fail(fmt::format("{} is neither a number nor a header with x_mm and y_mm, or x and y",
                             quoted(names.front())));
        x_column = *x;
        y_column = *y;
    }
    char decimal_mark = 0;  // none has come yet
    const auto coordinate = [&](std::size_t column, const char* axis) {
        const std::vector<std::string_view>& fields = table.row();
        if (column >= fields.size()) fail(fmt::format("there is no {}; a point needs two numbers", axis));
        const std::string_view field = fields[column];
        const std::optional<double> value = number(field);
        if (!value) fail(fmt::format("{} is not a number", quoted(field)));
        if (!std::isfinite(*value)) fail(fmt::format("{} is {}, not a place", axis, field));
        if (const std::size_t mark = field.find_first_of(".,"); mark != field.npos) {
            if (decimal_mark != 0 && decimal_mark != field[mark])
                fail(fmt::format(
                    "{} has a decimal {}, while numbers before it have a decimal {}; write all with the same",
                    quoted(field), field[mark] == ',' ? "comma" : "point",
                    decimal_mark == ',' ? "comma" : "point"));
            decimal_mark = field[mark];
        }
        return *value;
    };
    while (table.next_row()) {
        const std::size_t named = table.names().size() + table.before_first(), fields = table.row().size();
        if (!table.names().empty() && fields > named)
            fail(
                fmt::format("there are {} fields, and the header names {}; if decimals have commas, part the "
                            "fields with semicolons",
                            fields, table.names().size()));
        const double x = coordinate(table.before_first() + x_column, "x");
        points.push_back({x, coordinate(table.before_first() + y_column, "y")});
    }
    if (points.empty()) throw std::runtime_error(name + ": there are no points in it");
    return points;
}

std::optional<glm::dvec2> page_of_table(std::string_view text) {
    Table table(text);
    if (!table.next_row()) return {};
    const auto side = [&](std::string_view name) -> std::optional<double> {
        const auto column = column_called(table.names(), name);
        if (!column || table.before_first() + *column >= table.row().size()) return {};
        const std::optional<double> length = number(table.row()[table.before_first() + *column]);
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
            name + ": all points are at one place; give the width and height of the area that they fill");
    }
    // (n - 1) e^2 - (w + h) e - w h = 0
    const double a = double(points.size()) - 1, b = size.x + size.y;
    const double spacing = (b + std::sqrt(b * b + 4 * a * size.x * size.y)) / (2 * a);
    for (glm::dvec2& p : points) p = p - low + 0.5 * spacing;
    return {{size.x + spacing, size.y + spacing, topology}, std::move(points)};
}

}  // namespace dapple
