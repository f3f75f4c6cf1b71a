#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/image/environment.h"
#include "core/lights/lit_objects.h"
#include "core/text/shown_text.h"
#include "io/files/environment_file.h"
#include "lab/analysis/report_page.h"
#include "lab/reproduce/figure8_dots.h"
#include "lab/reproduce/figures.h"

namespace dapple {
namespace {

struct PaperMap {
    const char* name;
    std::size_t samples;
};
constexpr std::array<PaperMap, 4> kPaperMaps{
    {{"Grace Cathedral", 8'234}, {"St. Peter's", 12'636}, {"Uffizi", 10'606}, {"Galileo's Tomb", 34'299}}};

struct NamedMap {
    std::string name;
    EnvironmentMap map;
};

void add_sampled(HtmlPage& page, const NamedMap& named, const PaperMap& paper) {
    const Figure8Drawing drawing = figure8_drawing(light_density(named.map), paper.samples);
    const Dots& dots = drawing.placed.dots;
    std::vector<glm::dvec2> places;
    // The map is the upper half of the root square.
    for (std::size_t i = 0; i < dots.size(); ++i) places.push_back({dots.x[i], 2 * double(dots.y[i])});
    // As much white on all four maps.
    const double radius = 2 * std::sqrt(34'299 / static_cast<double>(paper.samples));
    page.pictures(std::array{HtmlPage::Picture{
        .bytes = png_of(light_picture(named.map, places, natural_exposure(named.map), radius)),
        .alt = "an environment map with its samples",
        .caption = fmt::format("{}, printed: {} samples; {}, ours: {}", paper.name, grouped(paper.samples),
                               named.name, in_words(drawing))}});
}

}  // namespace

void add_light_figures(HtmlPage& page, const std::vector<std::filesystem::path>& maps) {
    page.heading("Figure 7: environment maps with samples");
    std::vector<NamedMap> named;
    if (maps.empty()) named.push_back({"a sky made by this program", sky_map()});
    for (const std::filesystem::path& map : maps)
        named.push_back({map.filename().string(), read_environment(map).map});
    // Every map, and every number of samples; each in a row of its own, wide enough for its dots to be seen.
    for (std::size_t i = 0; i < std::max(named.size(), kPaperMaps.size()); ++i)
        add_sampled(page, named[i % named.size()], kPaperMaps[i % kPaperMaps.size()]);
    page.paragraph(
        "Many samples where much light comes from, few elsewhere. The paper's samples took it approximately "
        "30 ms in 2006. Ours are as many, by Figure 8 with the paper's ranks, on maps of our choice. Density "
        "is luminance times the sine of the angle from straight up: the sine is our choice too, as the paper "
        "does not say what it weighs a map's rows with.");
}

}  // namespace dapple
