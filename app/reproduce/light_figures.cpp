#include <fmt/format.h>

#include <array>

#include "app/analysis/report_page.h"
#include "app/files/environment.h"
#include "app/files/tile_library.h"
#include "app/reproduce/figures.h"
#include "core/image/sky.h"
#include "core/lights/light_picture.h"

namespace dapple {
namespace {

constexpr std::array<std::uint64_t, 2> kSampleCounts{8'000, 34'000};

void add_map(HtmlPage& page, const EnvironmentMap& map, const std::string& name) {
    const Density density = light_density(map);
    RankedTile tile = tile_named("paper16", RankingMethod::energy);
    std::vector<HtmlPage::Picture> pictures;
    for (const std::uint64_t count : kSampleCounts) {
        Stippling placed;
        stipple(tile, density, PlacerKind::exact, {.count = count}, placed);
        std::vector<glm::dvec2> places;
        // The map is the upper half of the root square.
        for_each_position(placed.dots, [&](float x, float y) { places.push_back({x, 2 * double(y)}); });
        pictures.push_back({.bytes = png_of(light_picture(map, places, natural_exposure(map))),
                            .alt = "an environment map with its light samples",
                            .caption = fmt::format("{}: {} samples, placed in {:.1f} ms", name, places.size(),
                                                   placed.place_ms)});
    }
    page.pictures(
        pictures,
        "Many samples where much light comes from, few elsewhere: density is luminance times the sine of the "
        "angle from straight up. The paper places 8,000 to 34,000 samples in 30 ms on the machine of its "
        "day.");
}

}  // namespace

void add_light_figures(HtmlPage& page, const std::vector<std::filesystem::path>& maps) {
    page.heading("Figure 7: light samples from environment maps");
    if (maps.empty()) add_map(page, sky_map(), "A sky made by this program");
    for (const std::filesystem::path& map : maps)
        add_map(page, read_environment(map), map.filename().string());
}

}  // namespace dapple
