#pragma once
// Picture to dots, step by step, doing again only the steps whose settings changed.
//
//     picture, tone ──► density ──┐
//     tile, ranking ──► tile ─────┴──► dots, outlines

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/drawing_settings.h"
#include "app/files/picture.h"
#include "app/viewer/density_choice.h"
#include "app/viewer/dot_colours.h"
#include "core/image/density.h"
#include "core/stipple.h"

namespace dapple {

/// What the canvas shows of the page, placed at a scale that goes with the zoom.
struct CloseView {
    PageWindow window;
    double scale = 0;

    bool operator==(const CloseView&) const = default;
};

/// Those of the settings that dots depend on.
struct PlaceOrder {
    Tone tone;
    std::string tile;
    std::optional<RankingOrder> ranking;
    StippleRequest stipple;               // Figure 8 with a count: about so many different dots
    bool outlines = false;                // the tiles too
    std::optional<CloseView> close = {};  // instead of the whole page; the exact placer only
    DensityChoice density = {};
    DotColourChoice colours = {};
    std::uint64_t most_dots = kMostDots;  // a count or a scale that asks for more is lowered

    bool operator==(const PlaceOrder&) const = default;
};
PlaceOrder order_of(const DrawingSettings& settings, const DensityChoice& density = {});

struct PlacedDrawing {
    Stippling stippling;
    std::vector<PlacedTile> outlines;
    std::vector<glm::u8vec4> colours;  // one a dot; empty: all in ink
    glm::dvec2 page_size{1, 1};        // page units
    PageWindow window;                 // dots and outlines are relative to its corner
    double tone_ms = 0;                // density and its pyramid, 0 if they were still there
};

class Workbench {
 public:
    /// Shows another picture from now on.
    void set_picture(Grid<float> light);
    bool has_picture() const { return !light_.empty(); }

    /// Places into `drawing`, using its memory again. False if stopped. Throws std::runtime_error as
    /// stipple(), density_of() and tile_named() do. Needs a picture.
    bool place(const PlaceOrder& order, PlacedDrawing& drawing, std::stop_token stop = {});

    /// What the dots of that order are placed on.
    const Density& density(const Tone& tone, const DensityChoice& choice = {});
    RankedTile& tile(const std::string& name, std::optional<RankingOrder> ranking);

 private:
    struct TileKey {
        std::string name;
        std::optional<RankingOrder> ranking;
        bool operator==(const TileKey&) const = default;
    };

    Grid<float> light_;
    std::optional<Tone> tone_;
    DensityChoice choice_;  // of use with a tone
    std::optional<Density> density_;
    std::optional<TileKey> tile_key_;
    std::optional<RankedTile> tile_;
};

}  // namespace dapple
