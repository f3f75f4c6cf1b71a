#include "app/viewer/background/dot_blocks.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "core/placing/placer.h"
#include "core/routing/short_way.h"

namespace dapple {

namespace {

constexpr std::uint64_t kMostLines = 20'000'000;

Dots in_order(Dots dots, DrawingStyle style, DotOrder order, LineWay way, const std::stop_token& stop) {
    const bool by_way = order == DotOrder::space || order == DotOrder::shortest;
    if (by_way) sort_dots(dots, DotOrder::space);
    const bool shortest = order == DotOrder::shortest && style == DrawingStyle::line;
    if (shortest && way == LineWay::final) shorten_way(dots, {.stop = stop, .progress = {}});
    return dots;
}

// The dots of each pen.
std::vector<Dots> by_pen(const DotPieces& dots) {
    std::vector<Dots> all;
    for (const Dots& piece : dots.pieces) {
        if (all.empty() || all.back().pen != piece.pen) all.emplace_back().pen = piece.pen;
        append(all.back(), piece);
    }
    return all;
}

// Each block has up to kDotsPerBlock lines that follow each other.
void put_into_blocks(ShownStrokes& strokes) {
    for (std::size_t first = 0; first < strokes.lines.size(); first += kDotsPerBlock) {
        DotBlock block{.first = first,
                       .index = first,
                       .count = std::min(kDotsPerBlock, strokes.lines.size() - first),
                       .low = glm::vec2(strokes.lines[first]),
                       .high = glm::vec2(strokes.lines[first])};
        for (std::size_t i = first; i < first + block.count; ++i) {
            const glm::vec2 a(strokes.lines[i].x, strokes.lines[i].y),
                b(strokes.lines[i].z, strokes.lines[i].w);
            block.low = glm::min(block.low, glm::min(a, b));
            block.high = glm::max(block.high, glm::max(a, b));
        }
        strokes.blocks.push_back(block);
    }
}

constexpr int kDeepest = 62;  // a page coordinate's binary digits
constexpr int kMostLevels = 64;

glm::u8vec4 opaque(glm::vec3 colour) {
    return {glm::u8vec3(glm::round(glm::clamp(colour, 0.0f, 1.0f) * 255.0f)), 255};
}

double rank_share(const TileRank& at, std::size_t tile_size) {
    const auto n = static_cast<double>(tile_size);
    const double share = at.level == 0 ? at.rank / n : (at.rank - n) / (3 * n);
    return std::clamp(share, 0.0, 1.0);
}

// A million dots in some milliseconds.
template <class Colour>
void colour_each(std::span<glm::u8vec4> colours, const DotPieces& dots, const Colour& colour) {
    std::size_t first = 0;
    for (const Dots& piece : dots.pieces) {
        const auto of_piece = colours.subspan(first, piece.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, piece.size(), 1 << 14),
                          [&](const tbb::blocked_range<std::size_t>& part) {
                              for (std::size_t i = part.begin(); i < part.end(); ++i)
                                  colour(of_piece[i], piece, i);
                          });
        first += piece.size();
    }
}

struct Placed {
    Orientation orientation;
    std::size_t kind = 0;
};

/// Finds the orientation and kind of the tile of a level that a point lies in, by walking down to it. Points
/// are in 2^-62 page units from a root tile's corner; all root tiles are alike.
class TileWalk {
 public:
    TileWalk(const Rule& rule, const NextKinds& next_kind) : next_kind_(next_kind) {
        for (const Orientation tile : all_orientations())
            for (int q = 0; q < 4; ++q)
                next_[tile.index][apply_to_quadrant(tile, q)] = {compose(tile, rule.child[q]),
                                                                 static_cast<std::size_t>(q)};
    }

    Placed at(std::int64_t x, std::int64_t y, int level) const {
        Placed tile;
        for (int depth = 1; depth <= std::min(level, kDeepest); ++depth) {
            const int quadrant = static_cast<int>((x >> (kDeepest - depth)) & 1) +
                                 2 * static_cast<int>((y >> (kDeepest - depth)) & 1);
            const auto& [orientation, own_quadrant] = next_[tile.orientation.index][quadrant];
            tile = {orientation, next_kind_[tile.kind][own_quadrant]};
        }
        return tile;
    }

 private:
    // By the tile's orientation and a quadrant of the page: the child's orientation, and which of its
    // parent's quadrants it is.
    std::array<std::array<std::pair<Orientation, std::size_t>, 4>, 8> next_;
    const NextKinds& next_kind_;
};

}  // namespace

ShownStrokes on_screen(const StrokeStream& strokes, std::span<const Pen> pens, double mm_per_page_unit) {
    ShownStrokes shown;
    const double unit = 1 / mm_per_page_unit;
    shown.width = strokes.widest() * unit;
    if (strokes.points > kMostLines) return shown;
    shown.lines.reserve(strokes.points);
    strokes.for_each_stroke([&](std::span<const glm::dvec2> points, int pen) {
        const auto add = [&](glm::dvec2 a, glm::dvec2 b) {
            shown.lines.emplace_back(glm::vec2(a * unit), glm::vec2(b * unit));
            if (pens.empty()) return;
            shown.widths.push_back(static_cast<float>(strokes.width_of(pen) * unit));
            shown.pens.push_back(static_cast<std::uint8_t>(pen));
        };
        if (points.size() == 1) add(points[0], points[0]);
        for (std::size_t i = 1; i < points.size(); ++i) add(points[i - 1], points[i]);
    });
    put_into_blocks(shown);
    return shown;
}

ShownStrokes shown_inking(const Inking& inking, std::span<const Pen> pens, glm::dvec2 corner) {
    constexpr double kPen = 1.0 / 500;  // page units, of what fills blacks
    ShownStrokes shown = on_screen(
        stream_of(strokes_of({.lines = {}, .areas = inking.areas, .white = {}}, kPen, 1), kPen), {}, 1);
    shown.widths.assign(shown.lines.size(), static_cast<float>(kPen));
    for (const InkLine& simple : inking.lines) {
        const InkLine line = flattened(simple);
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            shown.lines.emplace_back(glm::vec2(line.points[i - 1]), glm::vec2(line.points[i]));
            shown.widths.push_back((line.widths[i - 1] + line.widths[i]) / 2);
        }
    }
    const glm::vec2 from(corner);
    for (glm::vec4& line : shown.lines) line -= glm::vec4(from, from);
    if (!pens.empty()) shown.pens.assign(shown.lines.size(), static_cast<std::uint8_t>(darkest_of(pens)));
    return shown;
}

ShownStrokes shown_strokes(const DotPieces& dots, const DrawingSettings& settings,
                           std::optional<DotOrder> order, std::span<const Pen> pens, const PageSize& page,
                           double dot_radius, LineWay way, const std::stop_token& stop) {
    const double unit = page.mm_per_page_unit, width = settings.pen_width_mm;
    const DrawingStyle style = settings.style;
    const std::vector<double> widths = stroke_widths(settings.pens, width, pens, pen_use(settings));
    if (style == DrawingStyle::dots)
        return on_screen(marks_of(stream_of(dots), page, settings.mark, dot_radius * unit, width, widths),
                         pens, unit);
    Strokes lines;
    for (Dots& own : by_pen(dots)) {
        const Dots ordered = in_order(std::move(own), style, order.value_or(DotOrder::shortest), way, stop);
        append(lines,
               style == DrawingStyle::line ? line_through(ordered, page) : lines_to_nearest(ordered, page));
    }
    StrokeStream stream = stream_of(lines, width);
    stream.widths_mm = widths;
    return on_screen(stream, pens, unit);
}

bool needs_thresholds(const DotColourChoice& choice) {
    return choice.colouring != DotColouring::ink || choice.deepest_level < kDeepestStep;
}

std::vector<glm::u8vec4> without_deeper_levels(std::vector<glm::u8vec4> colours, const DotPieces& dots,
                                               std::size_t tile_size, int deepest, glm::vec3 ink) {
    if (deepest >= kDeepestStep) return colours;
    if (colours.empty()) colours.assign(dots.size(), opaque(ink));
    colour_each(colours, dots, [&](glm::u8vec4& colour, const Dots& piece, std::size_t i) {
        if (tile_rank_of(piece.threshold[i], tile_size).level > deepest) colour.a = 0;
    });
    return colours;
}

std::vector<glm::u8vec4> chosen_colours(const DotPieces& dots, const DotOrigins& origins,
                                        const DotColourChoice& choice) {
    return without_deeper_levels(dot_colours(dots, origins, choice.colouring), dots, origins.tile_size,
                                 choice.deepest_level, choice.ink);
}

glm::vec3 rank_colour(double share) {
    constexpr std::array kRamp{glm::vec3(0.09f, 0.17f, 0.40f), glm::vec3(0.13f, 0.52f, 0.58f),
                               glm::vec3(0.85f, 0.68f, 0.36f)};
    const auto t = static_cast<float>(2 * std::clamp(share, 0.0, 1.0));
    const int low = t < 1 ? 0 : 1;
    return glm::mix(kRamp[low], kRamp[low + 1], t - static_cast<float>(low));
}

glm::vec3 orientation_colour(Orientation orientation) {
    constexpr std::array kHues{glm::vec3(0.10f, 0.28f, 0.60f), glm::vec3(0.70f, 0.15f, 0.18f),
                               glm::vec3(0.08f, 0.45f, 0.25f), glm::vec3(0.45f, 0.20f, 0.55f)};
    const glm::vec3 hue = kHues[orientation.index & 3];
    return orientation.index < 4 ? hue : glm::mix(hue, glm::vec3(1), 0.45f);
}

glm::vec3 kind_colour(std::size_t kind) {
    constexpr float kTurn = 0.618034f;  // of the circle of hues
    const float turns = kTurn * static_cast<float>(kind), hue = 6 * (turns - std::floor(turns));
    const auto channel = [&](float at) {
        const float away = std::abs(std::fmod(hue - at + 9, 6.0f) - 3);
        return 0.12f + 0.6f * std::clamp(2 - away, 0.0f, 1.0f);
    };
    return {channel(0), channel(2), channel(4)};
}

std::vector<glm::u8vec4> dot_colours(const DotPieces& dots, const DotOrigins& origins,
                                     DotColouring colouring) {
    std::vector<glm::u8vec4> colours;
    if (colouring == DotColouring::ink) return colours;
    colours.resize(dots.size());
    const TileWalk walk(origins.rule, origins.next_kind);
    const std::size_t kinds = origins.next_kind.size();
    std::array<glm::u8vec4, kMostLevels> of_level;
    for (int level = 0; level < kMostLevels; ++level) of_level[level] = opaque(level_colour(level));
    std::array<glm::u8vec4, 8> of_orientation;
    for (const Orientation g : all_orientations()) of_orientation[g.index] = opaque(orientation_colour(g));
    std::vector<glm::u8vec4> of_kind;
    for (std::size_t kind = 0; kind < kinds; ++kind) of_kind.push_back(opaque(kind_colour(kind)));
    const auto in_units = [](double length) {
        return static_cast<std::int64_t>(std::ldexp(length, kDeepest));
    };
    const std::int64_t left = origins.window.x - in_units(origins.tile_corner.x);
    const std::int64_t top = origins.window.y - in_units(origins.tile_corner.y);
    colour_each(colours, dots, [&](glm::u8vec4& colour, const Dots& piece, std::size_t i) {
        const TileRank at = tile_rank_of(piece.threshold[i], origins.tile_size);
        if (colouring == DotColouring::level) {
            colour = of_level[std::min(at.level, kMostLevels - 1)];
        } else if (colouring == DotColouring::rank) {
            colour = opaque(rank_colour(rank_share(at, origins.tile_size)));
        } else {
            const Placed tile = walk.at(left + in_units(piece.x[i]), top + in_units(piece.y[i]), at.level);
            colour = kinds > 1 ? of_kind[tile.kind] : of_orientation[tile.orientation.index];
        }
    });
    return colours;
}

std::vector<DotBlock> dot_blocks(const DotPieces& dots) {
    std::vector<DotBlock> blocks;
    blocks.reserve(dots.size() / kDotsPerBlock + dots.pieces.size());
    std::size_t index = 0;
    for (std::size_t piece = 0; piece < dots.pieces.size(); ++piece) {
        const Dots& columns = dots.pieces[piece];
        const bool has_radii = columns.radius.size() == columns.size();
        for (std::size_t first = 0; first < columns.size(); first += kDotsPerBlock) {
            const std::size_t count = std::min(kDotsPerBlock, columns.size() - first);
            const auto part = [&](const FloatBuffer& column) {
                return std::span(column).subspan(first, count);
            };
            const auto [left, right] = std::ranges::minmax(part(columns.x));
            const auto [top, bottom] = std::ranges::minmax(part(columns.y));
            DotBlock block{.piece = piece,
                           .first = first,
                           .index = index,
                           .count = count,
                           .low = {left, top},
                           .high = {right, bottom}};
            if (has_radii) {
                const auto radii = part(columns.radius);
                block.radii = std::accumulate(radii.begin(), radii.end(), 0.0);
                block.largest_radius = std::ranges::max(radii);
            }
            blocks.push_back(block);
            index += count;
        }
    }
    return blocks;
}

}  // namespace dapple
