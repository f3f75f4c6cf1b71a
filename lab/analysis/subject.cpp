#include "lab/analysis/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>
#include <utility>

#include "core/drawing/pipeline.h"
#include "core/image/auto_tone.h"
#include "core/output/raster.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"
#include "io/files/picture.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "lab/analysis/drawing_points.h"
#include "lab/analysis/point_table.h"

namespace dapple {
namespace {

// Written by any program, and read from a pipe too.
constexpr TextKind kTable{.what = "table", .may_wait = true}, kDrawing{.what = "drawing", .may_wait = true};
constexpr std::array kBlursInSpacings{0.5, 1.0, 2.0, 4.0};

struct Placed {
    DrawingPlan plan;
    Stippling stippling;
};

Placed place(Pipeline& pipeline, const DrawingSettings& settings) {
    pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
    Placed placed{.plan = pipeline.plan(settings), .stippling = {}};
    if (placed.plan.lowered) {
        throw std::runtime_error(
            fmt::format("--scale: {:g} would make more than {} dots", settings.placing.scale, kMostDots));
    }
    pipeline.draw(placed.plan, placed.stippling);
    return placed;
}

PlacedBy described(const Stippling& stippling, const DrawingSettings& settings) {
    return {.tile = tile_in_use(settings),
            .ranking = settings.ranking,
            .placer = settings.placer,
            .scale = stippling.scale,
            .emitted = stippling.dots.size(),
            .duplicates = stippling.duplicates};
}

// Two dots at one place differ by a float's last bits: their positions were worked out along two paths.
constexpr double kSamePlace = 0x1p-22;

// The distinct dots. Rounded to float, one can lie a hair beyond the far edge.
std::vector<glm::dvec2> points_of(const Stippling& stippling, const Domain& domain) {
    std::vector<glm::dvec2> points;
    points.reserve(stippling.dots.size());
    const glm::dvec2 corner{domain.width, domain.height};
    for_each_position(stippling.dots,
                      [&](float x, float y) { points.push_back(glm::min(glm::dvec2(x, y), corner)); });
    if (stippling.duplicates > 0) drop_duplicates(points, kSamePlace);
    return points;
}

std::vector<ToneFromAfar> tone_from_afar(const Placed& placed, const Grid<float>& light,
                                         const DrawingSettings& settings) {
    const Stippling& stippling = placed.stippling;
    const PageSize& page = placed.plan.page;
    const double mm_per_px = page.width_mm / light.width;
    Grid<float> drawing =
        coverage_of({.size = page,
                     .dots = stream_of(stippling.dots),
                     .dot_radius_mm = placed.plan.radius(stippling.scale) * page.mm_per_page_unit},
                    {.dpi = kMmPerInch / mm_per_px, .threads = settings.placing.threads});
    // Light ink on dark paper is the light itself.
    if (!settings.tone.invert)
        for (float& value : drawing.values) value = 1 - value;
    const double dots = double(stippling.dots.size() - stippling.duplicates);
    const double spacing_px = std::sqrt(double(light.values.size()) / dots);
    std::vector<ToneFromAfar> result;
    for (const double sigma : kBlursInSpacings)
        result.push_back({.sigma_spacings = sigma,
                          .distance_mm = viewing_distance(sigma * spacing_px * mm_per_px),
                          .fidelity = tone_fidelity(drawing, light, sigma * spacing_px)});
    return result;
}

}  // namespace

Subject points_of_table(const std::filesystem::path& file, const TableDomain& domain) {
    const std::string name = file.string(), text = text_of_file(file, kTable);
    Subject subject{.name = name, .domain = {}, .points = parse_point_table(text, name)};
    std::optional<glm::dvec2> size = page_of_table(text);
    if (domain.width && domain.height) size = glm::dvec2(*domain.width, *domain.height);
    if (size) {
        subject.domain = {size->x, size->y, domain.topology};
        subject.points = points_inside(subject.points, subject.domain, name);
    } else {
        PlacedPoints placed = in_their_own_box(std::move(subject.points), domain.topology, name);
        subject.domain = placed.domain;
        subject.points = std::move(placed.points);
    }
    if (domain.period) subject.period = glm::dvec2(*domain.period);
    return subject;
}

Subject points_of_drawing(const std::filesystem::path& file, Topology topology) {
    const std::string name = file.string(), text = text_of_file(file, kDrawing);
    PlacedPoints placed = ending_of(file) == ".json" ? points_of_json(text, name) : points_of_svg(text, name);
    placed.domain.topology = topology;
    // On a torus the far edge is the near one.
    return {
        .name = name, .domain = placed.domain, .points = points_inside(placed.points, placed.domain, name)};
}

Subject dots_of_grey(double value, const DrawingSettings& wanted, Topology topology) {
    DrawingSettings settings = wanted;
    if (!settings.relax) settings.relax = 0;  // what is asked for is the tile
    Pipeline pipeline;
    pipeline.set_plain(Density(Grid<float>(1, 1, static_cast<float>(value))));
    const Placed placed = place(pipeline, settings);
    Subject subject{.name = fmt::format("a constant grey of density {:g}", value),
                    .domain = {1, 1, topology}};
    subject.points = points_of(placed.stippling, subject.domain);
    subject.placed = described(placed.stippling, settings);
    subject.placed->mean_density = placed.plan.density->mean();
    const double tiles = double(subject.points.size()) / double(pipeline.tile().tile().size());
    const int level = tiles >= 1 ? static_cast<int>(std::log2(tiles) / 2 + 1e-9) : 0;
    subject.period = glm::dvec2(std::exp2(-level));
    return subject;
}

Subject dots_of_method(const RelatedMethod& method, std::size_t count, std::uint64_t seed,
                       Topology topology) {
    Subject subject{.name = fmt::format("{}, {} dots asked for", method.title, grouped(count)),
                    .domain = {1, 1, topology}};
    subject.points = points_inside(method.dots({.count = count, .seed = seed}), subject.domain);
    return subject;
}

Subject dots_of_picture(const std::optional<std::filesystem::path>& image, const DrawingSettings& settings,
                        Topology topology, PictureLimit limit) {
    Subject subject{.name = image ? image->string() : "the sample", .domain = {}};
    Pipeline pipeline;
    set_picture(pipeline, image ? read_picture(*image, limit) : sample_picture());
    const Placed placed = place(pipeline, settings);
    const Density& density = *placed.plan.density;
    if (density.mean() == 0) {
        throw std::runtime_error(subject.name + ": nothing to draw, all of it is as light as the paper");
    }
    subject.domain = {double(density.width()) / density.longer_side(),
                      double(density.height()) / density.longer_side(), topology};
    subject.points = points_of(placed.stippling, subject.domain);
    subject.placed = described(placed.stippling, settings);
    subject.placed->mean_density = density.mean() / subject.domain.area();
    if (!subject.points.empty())
        subject.tone = tone_from_afar(placed, exposed(pipeline.light(), placed.plan.tone.exposure), settings);
    return subject;
}

}  // namespace dapple
