#include "lab/compare/tables.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "core/text/shown_text.h"
#include "lab/compare/columns.h"

namespace dapple {
namespace {

template <class Marks>
std::vector<std::string> head_of(std::span<const MarkColumn<Marks>> columns) {
    std::vector<std::string> head{"method"};
    for (const MarkColumn<Marks>& column : columns) head.emplace_back(column.head);
    return head;
}

template <class Marks>
std::vector<std::string> row_of(const std::string& title, std::span<const MarkColumn<Marks>> columns,
                                const std::optional<Marks>& marks) {
    std::vector<std::string> row{title};
    for (const MarkColumn<Marks>& column : columns) row.push_back(marks ? cell(column, *marks) : "-");
    return row;
}

// Each column by itself. A dash where one of them was not measured.
std::vector<std::string> worst_row(std::span<const MarkColumn<GreyMarks>> columns,
                                   const MeasuredMethod& one) {
    std::vector<std::string> row{one.method.title + ", worst of the others"};
    for (const MarkColumn<GreyMarks>& column : columns) {
        std::string written;
        double worst = 0;
        for (std::size_t i = 1; i < one.grey.size(); ++i) {
            const double value = one.grey[i] ? column.value(*one.grey[i]) : std::nan("");
            if (column.better == Better::neither || std::isnan(value)) {
                written = "-";
                break;
            }
            if (i == 1 || (column.better == Better::low ? value > worst : value < worst)) worst = value;
            written = column.written(worst);
        }
        row.push_back(written);
    }
    return row;
}

CompareTable grey_table(const char* title, std::span<const MarkColumn<GreyMarks>> columns,
                        std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    CompareTable table{title, head_of(columns), {}};
    table.head.insert(table.head.begin() + 1, "asked for");
    for (const MeasuredMethod& one : measured) {
        if (one.method.pictures_only) continue;
        for (std::size_t i = 0; i < one.grey.size(); ++i) {
            table.rows.push_back(row_of(one.method.title, columns, one.grey[i]));
            table.rows.back().insert(table.rows.back().begin() + 1, grouped(request.dots[i]));
        }
        if (one.grey.size() > 2) {
            table.rows.push_back(worst_row(columns, one));
            table.rows.back().insert(table.rows.back().begin() + 1, "");
        }
    }
    return table;
}

CompareTable growth_table(std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    CompareTable table{"How time grows", {"method"}, {}};
    for (const std::size_t count : request.growth) table.head.push_back(grouped(count) + " dots");
    table.head.insert(table.head.end(), {"more dots add to fewer", "source", "limits"});
    for (const MeasuredMethod& one : measured) {
        std::vector<std::string> row{one.method.title};
        for (const Growth& growth : one.growth)
            row.push_back(growth.seconds ? measured_time(*growth.seconds) : "-");
        if (one.method.pictures_only) row.resize(1 + request.growth.size(), "-");
        row.insert(row.end(), {one.method.nested ? "yes" : "no", one.method.source, one.method.limits});
        table.rows.push_back(row);
    }
    return table;
}

PlacesTable table_of(const std::string& where, const std::vector<Place>& places) {
    PlacesTable table{.title = "Who is first: " + where, .rows = {}, .sentence = {}};
    std::size_t behind = 0;
    for (const Place& place : places) {
        table.rows.push_back({{std::string(place.what), place.first_title, place.first_value,
                               place.dapple_title, place.dapple_value},
                              place.dapple_first});
        if (!place.dapple_first) ++behind;
    }
    table.sentence = behind == 0
                         ? "Dapple is first in every column."
                         : fmt::format("Dapple is not first in {} of {} columns.", behind, places.size());
    return table;
}

// What was not measured may have been first.
std::string left_out(std::span<const MeasuredMethod> measured,
                     const std::function<bool(const MeasuredMethod&)>& was_measured) {
    std::string names;
    for (const MeasuredMethod& one : measured)
        if (!was_measured(one)) names += (names.empty() ? "" : ", ") + one.method.title;
    return names.empty() ? "" : " Not measured, and so not in this: " + names + ".";
}

}  // namespace

std::vector<CompareTable> compare_tables(std::span<const MeasuredMethod> measured,
                                         const CompareRequest& request) {
    std::vector<CompareTable> tables;
    if (!request.dots.empty()) {
        tables.push_back(grey_table("Constant grey: distances and tone", grey_columns(), measured, request));
        tables.push_back(grey_table("Constant grey: repetition, waves, discrepancy, seams",
                                    more_grey_columns(), measured, request));
    }
    for (std::size_t i = 0; i < request.pictures.size(); ++i) {
        CompareTable table{
            fmt::format("{}, {} dots", printable(request.pictures[i].name), grouped(request.picture_dots)),
            head_of(drawing_columns()),
            {}};
        for (const MeasuredMethod& one : measured)
            table.rows.push_back(row_of(one.method.title, drawing_columns(), one.drawings[i]));
        tables.push_back(table);
    }
    if (!request.growth.empty()) tables.push_back(growth_table(measured, request));
    return tables;
}

std::vector<PlacesTable> places_tables(std::span<const MeasuredMethod> measured,
                                       const CompareRequest& request) {
    std::vector<PlacesTable> tables;
    const auto add = [&](const std::string& where, const std::vector<Place>& places,
                         const std::function<bool(const MeasuredMethod&)>& was_measured) {
        if (places.empty()) return;
        tables.push_back(table_of(where, places));
        tables.back().sentence += left_out(measured, was_measured);
    };
    if (!request.dots.empty())
        add(fmt::format("constant grey, {} dots", grouped(request.dots[0])), grey_places(measured),
            [](const MeasuredMethod& one) { return one.method.pictures_only || one.grey.front(); });
    for (std::size_t i = 0; i < request.pictures.size(); ++i)
        add(printable(request.pictures[i].name), drawing_places(measured, i),
            [i](const MeasuredMethod& one) { return one.drawings[i].has_value(); });
    return tables;
}

}  // namespace dapple
