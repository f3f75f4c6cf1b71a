#include "core/placing/traversal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dapple {

namespace {

constexpr double kUnitsPerPage = 0x1p62;
constexpr int kUnitBits = 62;
// Far more than single precision errs: what is not in the tail by so much has a lower critical scale, rounded
// or not.
constexpr double kSurelyBefore = 1 - 1e-5;

// A window may reach over the page's ends; integers may not.
std::int64_t window_end(std::int64_t start, double length) {
    const double end = static_cast<double>(start) + length * kUnitsPerPage;
    if (end >= 2 * kUnitsPerPage) return std::numeric_limits<std::int64_t>::max();
    return start + static_cast<std::int64_t>(std::llround(length * kUnitsPerPage));
}

}  // namespace

Traversal::Traversal(const PlacingTable& table, const Density& density, const PlacingRequest& request,
                     std::optional<double> tail_scale)
    : table_(table), density_(density), request_(request) {
    if (!(request.scale >= 0) || !std::isfinite(request.scale)) {
        throw std::runtime_error("the scale must be a number from 0 up");
    }
    if (tail_scale) tail_share_ = request.scale > 0 ? kSurelyBefore * *tail_scale / request.scale : 0;
    const PageWindow& w = request.window;
    window_ = {{w.x, w.y}, {window_end(w.x, w.width), window_end(w.y, w.height)}};
    if (request.origin == PlacingOrigin::window) {
        origin_ = {w.x, w.y};
    }
    const glm::dvec2 corner = density.tile_corner();
    tile_corner_ = glm::i64vec2(corner * kUnitsPerPage);

    // Powers of two from one depth to the next: exact.
    const double longer_side = density.longer_side();
    depths_[0] = {0.5,
                  longer_side,
                  -corner.x,
                  -corner.y,
                  density.width() / longer_side - corner.x,
                  density.height() / longer_side - corner.y,
                  std::ldexp(kDotsPerScale * request.scale, 2 * table.cell_depth),
                  static_cast<float>(std::ldexp(1 / kDotsPerScale, -2 * table.cell_depth))};
    for (int depth = 1; depth <= kMaxDepth; ++depth) {
        const DepthScale& above = depths_[depth - 1];
        depths_[depth] = {above.half / 2,
                          above.side_pixels / 2,
                          above.first_column * 2,
                          above.first_row * 2,
                          above.columns_end * 2,
                          above.rows_end * 2,
                          above.ranks_per_density / 4,
                          above.threshold_per_rank * 4};
    }
}

bool Traversal::start(int number, Visit& root) const {
    root = {};
    root.square = {0, (number & 1) - 1, (number >> 1) - 1};
    root.density.bounds = density_.bounds(root.square);
    root.in_window = contains(window_, area_of(root.square));
    return request_.scale > 0 && root.density.bounds.max > 0 && overlap(window_, area_of(root.square));
}

bool Traversal::has_whole_page() const {
    constexpr std::int64_t kPage = std::int64_t{1} << kUnitBits;
    return contains(window_, {{0, 0}, {kPage, kPage}});
}

bool Traversal::ends_at(const Visit& visit) const {
    const int depth = visit.square.depth;
    if (depth < table_.cell_depth) return false;
    const Cell& cell = table_.cells[visit.cell];
    const float end = depth == table_.cell_depth ? 4 * cell.first_next_rank : cell.subtree_end;
    return depths_[depth].ranks_per_density * visit.density.bounds.max <= end || depth >= kMaxDepth;
}

const CellPoints& Traversal::points_of(const Visit& visit, bool ends) const {
    const Cell& cell = table_.cells[visit.cell];
    if (level(visit) == 0) return cell.all;
    return ends ? cell.subtree : cell.newborn;
}

bool Traversal::descend(const Visit& parent, int page_quadrant, Visit& child) const {
    const int depth = parent.square.depth + 1;
    child.square = {depth, 2 * parent.square.x + (page_quadrant & 1),
                    2 * parent.square.y + (page_quadrant >> 1)};
    if (depth < density_.small_depth()) {
        child.density.is_patch = false;
        child.density.bounds = density_.bounds(child.square);
    } else if (parent.density.is_patch) {
        child.density.is_patch = true;
        child.density.patch = parent.density.patch.quadrant(page_quadrant);
        child.density.bounds = child.density.patch.bounds();
    } else {
        child.density = density_.look(child.square);
    }
    const double reached = depths_[depth].ranks_per_density * child.density.bounds.max;
    if (depth <= table_.cell_depth) {
        // Cells of the root tile have the tile's own points as well, born from the first on.
        if (!(reached > 0)) return false;
        child.cell = static_cast<std::uint16_t>(parent.cell * 4 + page_quadrant);
        child.orientation = {};
    } else {
        const Cell& cell = table_.cells[parent.cell];
        const int q = apply_to_quadrant(inverse(parent.orientation), page_quadrant);
        if (!(reached > cell.next_rank[q])) return false;
        child.cell = cell.next_cell[q];
        child.orientation = compose(parent.orientation, cell.next_turn[q]);
    }

    child.in_window = parent.in_window;
    if (!parent.in_window) {
        if (!overlap(window_, area_of(child.square))) return false;
        child.in_window = contains(window_, area_of(child.square));
    }
    return true;
}

Rectangle<std::int64_t> Traversal::area_of(const QuadSquare& s) const {
    const int shift = kUnitBits - s.depth;
    return {{(s.x << shift) + tile_corner_.x, (s.y << shift) + tile_corner_.y},
            {((s.x + 1) << shift) + tile_corner_.x, ((s.y + 1) << shift) + tile_corner_.y}};
}

glm::dvec2 Traversal::corner_in_window(const QuadSquare& square) const {
    return glm::dvec2(area_of(square).low - origin_) * (1 / kUnitsPerPage);
}

}  // namespace dapple
