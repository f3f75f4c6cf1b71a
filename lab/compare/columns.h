#pragma once
// The columns of the tables, once for all: what each number is called, how it is written, and which end of
// it is the better one.

#include <span>
#include <string>
#include <string_view>

#include "lab/compare/measure.h"

namespace dapple {

enum class Better { low, high, neither };

template <class Marks>
struct MarkColumn {
    std::string_view key;   // in JSON
    std::string_view head;  // in tables
    Better better;
    /// NaN for what a method does not have.
    double (*value)(const Marks& marks);
    std::string (*written)(double value);
};

/// Two tables' worth: time, distances, tone; and repetition, waves, discrepancy, seams.
std::span<const MarkColumn<GreyMarks>> grey_columns();
std::span<const MarkColumn<GreyMarks>> more_grey_columns();
std::span<const MarkColumn<DrawingMarks>> drawing_columns();

/// "-" for NaN.
template <class Marks>
std::string cell(const MarkColumn<Marks>& column, const Marks& marks) {
    const double value = column.value(marks);
    return value == value ? column.written(value) : "-";
}

/// "25 µs", "4.1 ms", "3.2 s", "2.0 min".
std::string measured_time(double seconds);

/// One column's best value, and dapple's own best.
struct Place {
    std::string_view what;
    std::string first_title, first_value;
    std::string dapple_title, dapple_value;  // the better of dapple's rows
    bool dapple_first = false;               // equal values share a place
};

/// The places in each column with a better end, among the methods that were measured at the first of the
/// counts, or on that picture. None where dapple was not measured.
std::vector<Place> grey_places(std::span<const MeasuredMethod> measured);
std::vector<Place> drawing_places(std::span<const MeasuredMethod> measured, std::size_t picture);

}  // namespace dapple
