#include "io/reports/light_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/reports/html.h"
#include "io/reports/plot.h"

namespace dapple {

namespace {

constexpr std::array<glm::vec3, 7> kColours{{{0.55f, 0.55f, 0.55f},
                                             {0.85f, 0.6f, 0.1f},
                                             {0.75f, 0.2f, 0.2f},
                                             {0.6f, 0.3f, 0.7f},
                                             {0.2f, 0.55f, 0.3f},
                                             {0.3f, 0.6f, 0.85f},
                                             {0.1f, 0.25f, 0.6f}}};

// Ways to look at the errors, each a table of its own.
struct Measure {
    std::string_view name;
    std::vector<RelativeError> SamplerErrors::*of_surface;
    double RelativeError::*over_normals;

    double of(const SamplerErrors& sampler, std::size_t count_index) const {
        return (sampler.*of_surface)[count_index].*over_normals;
    }
};
constexpr std::array<Measure, 4> kMeasures{
    {{"irradiance: mean error", &SamplerErrors::irradiance, &RelativeError::mean},
     {"irradiance: largest error", &SamplerErrors::irradiance, &RelativeError::largest},
     {"a glossy surface, cosine^50: mean error", &SamplerErrors::glossy, &RelativeError::mean},
     {"a glossy surface, cosine^50: largest error", &SamplerErrors::glossy, &RelativeError::largest}}};
static_assert(kGlossy == 50);

// How many times as large the least error of the others is.
double ratio_to_best(const LightComparison& comparison, const Measure& measure, std::size_t count_index) {
    double ours = 0, best = std::numeric_limits<double>::max();
    for (const SamplerErrors& sampler : comparison.samplers) {
        const double error = measure.of(sampler, count_index);
        if (sampler.sampler == LightSampler::settled)
            ours = error;
        else if (sampler.sampler != LightSampler::unbiased)
            best = std::min(best, error);
    }
    return ours > 0 ? best / ours : 0;
}

// The first row has the names.
std::vector<std::vector<std::string>> table_of(const LightComparison& comparison, const Measure& measure) {
    std::vector<std::vector<std::string>> rows{{"samples"}};
    for (const SamplerErrors& sampler : comparison.samplers)
        rows.front().emplace_back(name_of(sampler.sampler));
    rows.front().emplace_back("best other / dapple");
    for (std::size_t i = 0; i < comparison.request.counts.size(); ++i) {
        auto& row = rows.emplace_back(1, fmt::format("{}", comparison.request.counts[i]));
        for (const SamplerErrors& sampler : comparison.samplers)
            row.push_back(fmt::format("{:.3g} %", 100 * measure.of(sampler, i)));
        row.push_back(fmt::format("{:.1f}", ratio_to_best(comparison, measure, i)));
    }
    return rows;
}

std::vector<std::string> slopes_of(const LightComparison& comparison) {
    std::vector<std::string> row{"slope"};
    for (const SamplerErrors& sampler : comparison.samplers)
        row.push_back(fmt::format("{:.2f}", sampler.slope));
    row.emplace_back("");
    return row;
}

}  // namespace

void write_comparison_csv(std::ostream& out, const LightComparison& comparison) {
    out << "sampler,samples,relative_error,largest_error,glossy_error,largest_glossy_error,slope\n";
    for (const SamplerErrors& sampler : comparison.samplers) {
        for (std::size_t i = 0; i < comparison.request.counts.size(); ++i) {
            out << fmt::format("\"{}\",{}", name_of(sampler.sampler), comparison.request.counts[i]);
            for (const Measure& measure : kMeasures) out << fmt::format(",{}", measure.of(sampler, i));
            out << fmt::format(",{}\n", sampler.slope);
        }
    }
}

std::string comparison_plot(const LightComparison& comparison) {
    Plot plot;
    plot.title = "Error of irradiance against the number of samples";
    plot.x = {.label = "samples", .scale = AxisScale::logarithmic};
    plot.y = {.label = "mean relative error of irradiance", .scale = AxisScale::logarithmic};
    plot.width = 820;
    plot.height = 420;
    for (std::size_t s = 0; s < comparison.samplers.size(); ++s) {
        const SamplerErrors& sampler = comparison.samplers[s];
        PlotCurve curve;
        curve.name = std::string(name_of(sampler.sampler));
        curve.colour = kColours[s % kColours.size()];
        for (std::size_t i = 0; i < comparison.request.counts.size(); ++i)
            curve.points.push_back(
                {static_cast<double>(comparison.request.counts[i]), sampler.irradiance[i].mean});
        plot.curves.push_back(std::move(curve));
    }
    return svg_plot(plot);
}

std::string comparison_page(const LightComparison& comparison, std::string_view map_name) {
    HtmlPage page(fmt::format("Light samples of {}", map_name));
    const ComparisonRequest& request = comparison.request;
    page.paragraph(fmt::format(
        "What {} surfaces that face every way get of n samples, against the sum over all texels of the map: "
        "relative errors of luminance, the mean and the largest over these surfaces, averaged over {} seeds.",
        request.normals, request.runs));
    const std::array plots{comparison_plot(comparison)};
    page.drawings(plots,
                  "Lower is better. Random samples gain a half decade for every decade of samples; "
                  "samples that share the map evenly among themselves gain a whole one or more.");
    for (const Measure& measure : kMeasures) {
        page.heading(measure.name);
        const auto table = table_of(comparison, measure);
        std::vector<HtmlPage::Row> rows;
        for (std::size_t i = 1; i < table.size(); ++i) rows.push_back({.cells = table[i]});
        if (&measure == kMeasures.data()) rows.push_back({.cells = slopes_of(comparison)});
        page.table(table.front(), rows);
    }
    return page.text();
}

std::string comparison_table(const LightComparison& comparison) {
    std::string text;
    const auto add = [&text](const std::vector<std::string>& row) {
        text += fmt::format("{:>8}", row.front());
        for (std::size_t i = 1; i < row.size(); ++i) text += fmt::format("{:>22}", row[i]);
        text += '\n';
    };
    for (const Measure& measure : kMeasures) {
        text += fmt::format("{}\n", measure.name);
        for (const auto& row : table_of(comparison, measure)) add(row);
        if (&measure == kMeasures.data()) add(slopes_of(comparison));
    }
    return text;
}

}  // namespace dapple
