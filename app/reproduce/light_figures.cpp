#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/analysis/report_page.h"
#include "app/files/environment.h"
#include "app/reproduce/figure8_dots.h"
#include "app/reproduce/figures.h"
#include "core/image/sky.h"
#include "core/lights/light_picture.h"

namespace dapple {
namespace {

// The samples of the paper's four maps.
constexpr std::array<std::size_t, 4> kPaperSamples{8'234, 12'636, 10'606, 34'299};

struct NamedMap {
    std::string name;
    EnvironmentMap map;
};

HtmlPage::Picture sampled(const NamedMap& named, std::size_t samples) {
    const Figure8Drawing drawing = figure8_drawing(light_density(named.map), samples);
    const Dots& dots = drawing.placed.dots;
    std::vector<glm::dvec2> places;
    // The map is the upper half of the root square.
    for (std::size_t i = 0; i < dots.size(); ++i) places.push_back({dots.x[i], 2 * double(dots.y[i])});
    return {.bytes = png_of(light_picture(named.map, places, natural_exposure(named.map))),
            .alt = "an environment map with its samples",
            .caption = fmt::format("{}: {}", named.name, in_words(drawing))};
}

}  // namespace

void add_light_figures(HtmlPage& page, const std::vector<std::filesystem::path>& maps) {
    page.heading("Figure 7: environment maps with samples");
    std::vector<NamedMap> named;
    if (maps.empty()) named.push_back({"A sky made by this program", sky_map()});
    for (const std::filesystem::path& map : maps)
        named.push_back({map.filename().string(), read_environment(map)});
    // Every map, and every number of samples.
    std::vector<HtmlPage::Picture> pictures;
    for (std::size_t i = 0; i < std::max(named.size(), kPaperSamples.size()); ++i)
        pictures.push_back(sampled(named[i % named.size()], kPaperSamples[i % kPaperSamples.size()]));
    page.pictures(
        pictures,
        "Many samples where much light comes from, few elsewhere: density is luminance times the "
        "sine of the angle from straight up. The paper's four maps have 8,234, 12,636, 10,606 and "
        "34,299 samples, and so have ours, by Figure 8 with the paper's ranks; the paper's own maps "
        "are not at hand, so which map has which number is our choice. The paper's samples took it "
        "30 ms in 2006.");
}

}  // namespace dapple
