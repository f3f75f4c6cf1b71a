#include "lab/compare/columns.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "core/text/shown_text.h"

namespace dapple {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string three_digits(double value) {
    return fmt::format("{:.3f}", value);
}
std::string two_digits(double value) {
    return fmt::format("{:.2f}", value);
}
std::string percent(double value) {
    return fmt::format("{:.1f} %", 100 * value);
}
std::string fine_percent(double value) {
    return fmt::format("{:.2f} %", 100 * value);
}
std::string whole(double value) {
    return grouped(std::uint64_t(value + 0.5));
}
std::string scientific(double value) {
    return fmt::format("{:.1e}", value);
}

constexpr MarkColumn<GreyMarks> kGreyColumns[] = {
    {"dots", "dots", Better::neither, [](const GreyMarks& m) { return double(m.count); }, whole},
    {"seconds", "time", Better::low, [](const GreyMarks& m) { return m.seconds; }, measured_time},
    {"nearest_min", "nearest: minimum", Better::high, [](const GreyMarks& m) { return m.nearest.minimum; },
     three_digits},
    {"nearest_p1", "nearest: 1st percentile", Better::high, [](const GreyMarks& m) { return m.nearest.p1; },
     three_digits},
    {"nearest_mean", "nearest: mean", Better::high, [](const GreyMarks& m) { return m.nearest.mean; },
     three_digits},
    {"power_below_03", "power below 0.3", Better::low, [](const GreyMarks& m) { return m.power_03; },
     three_digits},
    {"power_below_05", "power below 0.5", Better::low, [](const GreyMarks& m) { return m.power_05; },
     three_digits},
};

constexpr MarkColumn<GreyMarks> kMoreGreyColumns[] = {
    {"highest_bin", "highest bin", Better::low, [](const GreyMarks& m) { return m.peaks.highest_bin; },
     whole},
    {"top_share", "top 0.1 %", Better::low, [](const GreyMarks& m) { return m.peaks.top_share; }, percent},
    {"effective_nyquist", "effective Nyquist", Better::high,
     [](const GreyMarks& m) { return m.effective_nyquist; }, three_digits},
    {"star_discrepancy", "star discrepancy", Better::low,
     [](const GreyMarks& m) { return m.star.value_or(kNone); }, scientific},
    {"l2_star", "L2 star discrepancy", Better::low, [](const GreyMarks& m) { return m.l2_star; }, scientific},
    {"seam", "seam", Better::low, [](const GreyMarks& m) { return m.seam.value_or(kNone); }, two_digits},
};

constexpr MarkColumn<DrawingMarks> kDrawingColumns[] = {
    {"dots", "dots", Better::neither, [](const DrawingMarks& m) { return double(m.count); }, whole},
    {"seconds", "time", Better::low, [](const DrawingMarks& m) { return m.seconds; }, measured_time},
    {"ssim", "SSIM", Better::high, [](const DrawingMarks& m) { return m.marks.ssim; }, three_digits},
    {"gradients", "gradients", Better::high, [](const DrawingMarks& m) { return m.marks.gradients; },
     three_digits},
    {"tone_error", "tone error", Better::low, [](const DrawingMarks& m) { return m.marks.tone_error; },
     fine_percent},
    {"nearest_p1", "nearest: 1st percentile", Better::high,
     [](const DrawingMarks& m) { return m.distances.p1; }, three_digits},
    {"nearest_mean", "nearest: mean", Better::high, [](const DrawingMarks& m) { return m.distances.mean; },
     three_digits},
    {"cvt_energy", "CVT energy", Better::low, [](const DrawingMarks& m) { return m.cells.energy; },
     three_digits},
    {"capacity_deviation", "capacity deviation", Better::low,
     [](const DrawingMarks& m) { return m.cells.capacity; }, three_digits},
    {"centroid_displacement", "centroid displacement", Better::low,
     [](const DrawingMarks& m) { return m.cells.displacement; }, three_digits},
};

// `marks_of` a method: none if it was not measured.
template <class Marks, class MarksOf>
std::vector<Place> places(std::span<const MarkColumn<Marks>> columns,
                          std::span<const MeasuredMethod> measured, const MarksOf& marks_of) {
    std::vector<Place> places;
    for (const MarkColumn<Marks>& column : columns) {
        if (column.better == Better::neither) continue;
        const MeasuredMethod *first = nullptr, *ours = nullptr;
        double first_value = kNone, our_value = kNone;
        for (const MeasuredMethod& one : measured) {
            const std::optional<Marks>& marks = marks_of(one);
            const double value = marks ? column.value(*marks) : kNone;
            if (value != value) continue;
            const auto better_than = [&](double other) {
                return other != other || (column.better == Better::low ? value < other : value > other);
            };
            if (better_than(first_value)) {
                first = &one;
                first_value = value;
            }
            if (one.method.ours && better_than(our_value)) {
                ours = &one;
                our_value = value;
            }
        }
        if (!ours) continue;
        Place place{.what = column.head,
                    .first_title = first->method.title,
                    .first_value = column.written(first_value),
                    .dapple_title = ours->method.title,
                    .dapple_value = column.written(our_value)};
        place.dapple_first = first_value == our_value;
        places.push_back(place);
    }
    return places;
}

}  // namespace

std::span<const MarkColumn<GreyMarks>> grey_columns() {
    return kGreyColumns;
}

std::span<const MarkColumn<GreyMarks>> more_grey_columns() {
    return kMoreGreyColumns;
}

std::span<const MarkColumn<DrawingMarks>> drawing_columns() {
    return kDrawingColumns;
}

std::string measured_time(double seconds) {
    if (seconds < 0.001) return fmt::format("{:.0f} µs", 1e6 * seconds);
    if (seconds < 0.1) return fmt::format("{:.1f} ms", 1000 * seconds);
    if (seconds < 1) return fmt::format("{:.0f} ms", 1000 * seconds);
    if (seconds < 100) return fmt::format("{:.1f} s", seconds);
    return fmt::format("{:.1f} min", seconds / 60);
}

std::vector<Place> grey_places(std::span<const MeasuredMethod> measured) {
    const auto marks_of = [](const MeasuredMethod& one) -> const std::optional<GreyMarks>& {
        return one.grey.front();
    };
    std::vector<Place> all = places(grey_columns(), measured, marks_of);
    const std::vector<Place> more = places(more_grey_columns(), measured, marks_of);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::vector<Place> drawing_places(std::span<const MeasuredMethod> measured, std::size_t picture) {
    return places(drawing_columns(), measured,
                  [&](const MeasuredMethod& one) -> const std::optional<DrawingMarks>& {
                      return one.drawings[picture];
                  });
}

}  // namespace dapple
