#include "lab/reports/light_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "lab/reports/html.h"
#include "lab/reports/plot.h"

namespace dapple {

namespace {

constexpr std::array<glm::vec3, 6> kColours{{{0.55f, 0.55f, 0.55f},
                                             {0.85f, 0.6f, 0.1f},
                                             {0.75f, 0.2f, 0.2f},
                                             {0.2f, 0.55f, 0.3f},
                                             {0.3f, 0.6f, 0.85f},
                                             {0.1f, 0.25f, 0.6f}}};

const SamplerErrors& of(const LightComparison& comparison, LightSampler sampler) {
    return *std::ranges::find(comparison.samplers, sampler, &SamplerErrors::sampler);
}

// How many times as large the least error of the others is.
double ratio_to_best(const LightComparison& comparison, std::size_t count_index) {
    const double ours = of(comparison, LightSampler::settled).errors[count_index];
    double best = std::numeric_limits<double>::max();
    for (const SamplerErrors& sampler : comparison.samplers)
        if (sampler.sampler != LightSampler::settled && sampler.sampler != LightSampler::unbiased)
            best = std::min(best, sampler.errors[count_index]);
    return ours > 0 ? best / ours : 0;
}

std::string per_cent(double error) {
    return fmt::format("{:.3g} %", 100 * error);
}

}  // namespace

void write_comparison_csv(std::ostream& out, const LightComparison& comparison) {
    out << "sampler,samples,relative_error,glossy_error,slope\n";
    for (const SamplerErrors& sampler : comparison.samplers) {
        for (std::size_t i = 0; i < sampler.errors.size(); ++i) {
            out << fmt::format("\"{}\",{},{},{},{}\n", name_of(sampler.sampler), comparison.request.counts[i],
                               sampler.errors[i], sampler.glossy_errors[i], sampler.slope);
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
        for (std::size_t i = 0; i < sampler.errors.size(); ++i)
            curve.points.push_back({static_cast<double>(comparison.request.counts[i]), sampler.errors[i]});
        plot.curves.push_back(std::move(curve));
    }
    return svg_plot(plot);
}

std::string comparison_page(const LightComparison& comparison, std::string_view map_name) {
    HtmlPage page(fmt::format("Light samples of {}", map_name));
    const ComparisonRequest& request = comparison.request;
    page.paragraph(
        fmt::format("Irradiance on {} surfaces that face every way, lit by n samples, against the sum over "
                    "all texels of the "
                    "map: mean relative error of luminance, over {} seeds.",
                    request.normals, request.runs));
    const std::array plots{comparison_plot(comparison)};
    page.drawings(plots,
                  "Lower is better. Random samples gain a half decade for every decade of samples; "
                  "samples that share the map evenly among themselves gain a whole one or more.");
    std::vector<std::string> head{"samples"};
    for (const SamplerErrors& sampler : comparison.samplers) head.emplace_back(name_of(sampler.sampler));
    head.emplace_back("best other / dapple");
    std::vector<HtmlPage::Row> rows;
    for (std::size_t i = 0; i < request.counts.size(); ++i) {
        HtmlPage::Row row{.cells = {fmt::format("{}", request.counts[i])}};
        for (const SamplerErrors& sampler : comparison.samplers)
            row.cells.push_back(per_cent(sampler.errors[i]));
        row.cells.push_back(fmt::format("{:.1f}", ratio_to_best(comparison, i)));
        rows.push_back(std::move(row));
    }
    HtmlPage::Row slopes{.cells = {"slope"}};
    for (const SamplerErrors& sampler : comparison.samplers)
        slopes.cells.push_back(fmt::format("{:.2f}", sampler.slope));
    slopes.cells.emplace_back("");
    rows.push_back(std::move(slopes));
    page.table(head, rows);
    page.paragraph(fmt::format(
        "The same of a glossy surface, which sees the light by the cosine to the power {}:", kGlossy));
    head.pop_back();
    rows.clear();
    for (std::size_t i = 0; i < request.counts.size(); ++i) {
        HtmlPage::Row row{.cells = {fmt::format("{}", request.counts[i])}};
        for (const SamplerErrors& sampler : comparison.samplers)
            row.cells.push_back(per_cent(sampler.glossy_errors[i]));
        rows.push_back(std::move(row));
    }
    page.table(head, rows);
    return page.text();
}

std::string comparison_table(const LightComparison& comparison) {
    std::string text = fmt::format("{:>8}", "samples");
    for (const SamplerErrors& sampler : comparison.samplers)
        text += fmt::format("{:>22}", name_of(sampler.sampler));
    text += fmt::format("{:>21}\n", "best other / dapple");
    for (std::size_t i = 0; i < comparison.request.counts.size(); ++i) {
        text += fmt::format("{:>8}", comparison.request.counts[i]);
        for (const SamplerErrors& sampler : comparison.samplers)
            text += fmt::format("{:>22}", per_cent(sampler.errors[i]));
        text += fmt::format("{:>21.1f}\n", ratio_to_best(comparison, i));
    }
    text += fmt::format("{:>8}", "slope");
    for (const SamplerErrors& sampler : comparison.samplers) text += fmt::format("{:>22.2f}", sampler.slope);
    text += fmt::format("\nof a glossy surface, cosine^{}:\n", kGlossy);
    for (std::size_t i = 0; i < comparison.request.counts.size(); ++i) {
        text += fmt::format("{:>8}", comparison.request.counts[i]);
        for (const SamplerErrors& sampler : comparison.samplers)
            text += fmt::format("{:>22}", per_cent(sampler.glossy_errors[i]));
        text += '\n';
    }
    return text;
}

}  // namespace dapple
