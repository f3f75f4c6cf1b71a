#pragma once
// What dapple-lab analyse looks at: points from a table, the dots of a picture, or those of a constant grey.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/domain.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"
#include "io/files/picture.h"
#include "lab/analysis/tone_fidelity.h"
#include "lab/related/methods.h"

namespace dapple {

/// How the dots came about, if this program placed them.
struct PlacedBy {
    std::string tile;
    std::optional<RankingMethod> ranking{};  // none: the tile's own
    PlacerKind placer{};
    double scale = 0;
    std::uint64_t emitted = 0;     // duplicates included
    std::uint64_t duplicates = 0;  // at a place that has a dot already; not among the points
    double mean_density = 0;       // over the picture
};

/// A drawing's tone at one viewing distance.
struct ToneFromAfar {
    double sigma_spacings = 0;  // the eye's blur, in mean dot spacings
    double distance_mm = 0;     // how far away that is, for a page of the width asked for
    ToneFidelity fidelity;
};

struct Subject {
    std::string name;                    // of a file, or what was placed
    Domain domain{};                     // a table's in its own unit, a picture's in its longer side
    std::vector<glm::dvec2> points{};    // distinct if placed by us
    std::optional<glm::dvec2> period{};  // of the tile that the points repeat, in the domain's unit
    std::optional<PlacedBy> placed{};
    std::vector<ToneFromAfar> tone{};  // a picture's, nearest first
};

/// What a table's points fill. Without width and height the page that the table names (page_of_table()), or
/// else their own box: see in_their_own_box().
struct TableDomain {
    std::optional<double> width{}, height{};  // in the table's unit, both or neither
    Topology topology = Topology::window;
    std::optional<double> period{};  // to look for a repetition, in the table's unit
};

/// Throws std::runtime_error if the file cannot be read, as parse_point_table() does, and if a point lies
/// outside a window.
Subject points_of_table(const std::filesystem::path& file, const TableDomain& domain);

/// The dots of a drawing that dapple render wrote, .json or .svg, in millimetres; the page is its own. Throws
/// std::runtime_error if the file cannot be read or is no such drawing.
Subject points_of_drawing(const std::filesystem::path& file, Topology topology);

/// Dots on a constant grey that fills the unit square, as placed unless steps of relaxation are asked for.
/// The period is that of the finest complete level of tiles: 2^-l for 4^l N dots or more. Figure 8 given a
/// count places about so many. Throws std::runtime_error as tile_named() and stipple() do.
Subject dots_of_grey(double density, const DrawingSettings& settings, Topology topology);

/// Dots of a constant grey by a method that this program is compared with, about as many as asked for, on the
/// unit square. No period is looked for.
Subject dots_of_method(const RelatedMethod& method, std::size_t count, std::uint64_t seed, Topology topology);

/// The dots of a picture, or of the sample, and their tone at four viewing distances, where the eye's blur is
/// 1/2, 1, 2 and 4 mean spacings. Drawn in the picture's own size for this. Throws std::runtime_error as
/// read_picture(), tile_named() and stipple() do, and if there is nothing to draw.
Subject dots_of_picture(const std::optional<std::filesystem::path>& image, const DrawingSettings& settings,
                        Topology topology, PictureLimit limit);

}  // namespace dapple
