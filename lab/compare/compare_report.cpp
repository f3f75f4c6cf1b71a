#include "lab/compare/compare_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text/shown_text.h"
#include "lab/compare/columns.h"
#include "lab/compare/tables.h"

namespace dapple {
namespace {

std::string in_markdown(const CompareTable& table) {
    std::string text = "\n### " + table.title + "\n";
    const auto line = [&](const std::vector<std::string>& cells) {
        for (const std::string& cell : cells) text += "| " + cell + ' ';
        text += "|\n";
    };
    line(table.head);
    text += '|';
    for (std::size_t i = 0; i < table.head.size(); ++i) text += "---|";
    text += '\n';
    for (const std::vector<std::string>& row : table.rows) line(row);
    return text;
}

template <class Marks>
nlohmann::ordered_json marks_json(std::span<const MarkColumn<Marks>> columns,
                                  const std::optional<Marks>& marks) {
    nlohmann::ordered_json json;
    for (const MarkColumn<Marks>& column : columns) {
        const double value = marks ? column.value(*marks) : std::nan("");
        json[std::string(column.key)] =
            std::isnan(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
    }
    return json;
}

nlohmann::ordered_json method_json(const MeasuredMethod& one, const CompareRequest& request) {
    const Contender& method = one.method;
    nlohmann::ordered_json json{{"name", method.name},
                                {"title", method.title},
                                {"source", method.source},
                                {"limits", method.limits},
                                {"nested", method.nested},
                                {"grey", nlohmann::ordered_json::array()},
                                {"pictures", nlohmann::ordered_json::array()},
                                {"growth", nlohmann::ordered_json::array()}};
    for (std::size_t i = 0; i < one.grey.size(); ++i) {
        nlohmann::ordered_json marks{{"wanted", request.dots[i]}};
        marks.update(marks_json(grey_columns(), one.grey[i]));
        marks.update(marks_json(more_grey_columns(), one.grey[i]));
        if (one.grey[i]) {
            nlohmann::ordered_json frequency, power;
            for (const Ring& ring : one.grey[i]->radial_power) {
                frequency.push_back(ring.frequency);
                power.push_back(ring.power);
            }
            marks["radial_frequency"] = frequency;
            marks["radial_power"] = power;
        }
        json["grey"].push_back(marks);
    }
    for (std::size_t i = 0; i < one.drawings.size(); ++i) {
        nlohmann::ordered_json marks{{"picture", request.pictures[i].name}, {"wanted", request.picture_dots}};
        marks.update(marks_json(drawing_columns(), one.drawings[i]));
        json["pictures"].push_back(marks);
    }
    for (const Growth& growth : one.growth)
        json["growth"].push_back({{"dots", growth.count},
                                  {"seconds", growth.seconds ? nlohmann::ordered_json(*growth.seconds)
                                                             : nlohmann::ordered_json()}});
    return json;
}

}  // namespace

std::string compare_text(std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    std::string text;
    for (const CompareTable& table : compare_tables(measured, request)) text += in_markdown(table);
    text += fmt::format("\nA dash: took longer than {:g} s, or does not apply to this method.\n",
                        request.seconds);
    for (const PlacesTable& places : places_tables(measured, request)) {
        CompareTable table{places.title, kPlacesHead, {}};
        for (const PlacesTable::Row& row : places.rows) table.rows.push_back(row.cells);
        text += in_markdown(table) + '\n' + places.sentence + '\n';
    }
    return text.substr(1);
}

std::string compare_json(std::span<const MeasuredMethod> measured, const CompareRequest& request) {
    nlohmann::ordered_json json{{"seconds_allowed", request.seconds},
                                {"seed", request.seed},
                                {"methods", nlohmann::ordered_json::array()}};
    for (const MeasuredMethod& one : measured) json["methods"].push_back(method_json(one, request));
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace dapple
