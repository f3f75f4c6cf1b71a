#include "core/placing/placer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/placing/pieces.h"
#include "core/placing/traversal.h"

namespace dapple {

DotStream stream_of(const Dots& dots, double scale) {
    return {dots.size(), scale, 0, [&dots](const TakePiece& take) { take(dots); }};
}

DotStream stream_of(const DotPieces& dots, double scale) {
    return {dots.size(), scale, 0, [&dots](const TakePiece& take) {
                for (const Dots& piece : dots.pieces) {
                    if (piece.size() > 0 && !take(piece)) return;
                }
            }};
}

DotStream stream_of(std::shared_ptr<const DotPieces> dots, double scale) {
    DotStream stream = stream_of(*dots, scale);
    stream.for_each_piece = [dots = std::move(dots),
                             each = std::move(stream.for_each_piece)](const TakePiece& take) { each(take); };
    return stream;
}

namespace {

constexpr double kWhole = std::numeric_limits<double>::infinity();
constexpr double kWorthSharing = 1 << 14;      // dots; fewer are placed before another thread has woken up
constexpr double kLeastPieceDots = 2048;       // smaller ones are not worth claiming
constexpr double kPiecesPerThread = 12;        // so that threads finish together
constexpr double kMostHandedOver = 32768;      // 256 KiB: leaves most of a core's own cache to the density
constexpr double kMostKept = 1 << 20;          // else room for more dots than come
constexpr std::size_t kMostSquareDots = 1024;  // about
constexpr double kBeyondCaches = 2 << 20;      // dots: two columns of 8 MiB

// About so many dots are in the window.
double dots_in_window(const Traversal& traversal) {
    const PageWindow& window = traversal.request().window;
    return expected_dots(traversal.density(), traversal.request().scale) * std::min(window.width, 1.0) *
           std::min(window.height, 1.0);
}

double piece_dots(const Traversal& traversal, double most) {
    const auto threads = static_cast<double>(threads_for(traversal.request().threads));
    return std::clamp(dots_in_window(traversal) / (kPiecesPerThread * threads), kLeastPieceDots, most);
}

// Room for what is expected where there is far less: to grow step by step takes longer than placing.
void reserve(Dots& dots, double expected, bool thresholds) {
    const auto room = static_cast<std::size_t>(std::min(expected * 1.01, 1e12)) + kMostSquareDots;
    if (2 * dots.x.capacity() >= room && (!thresholds || 2 * dots.critical.capacity() >= room)) return;
    dots = {};
    dots.reserve(room, thresholds);
}

// Gives each piece to a function.
class Stream : public PieceTaker {
 public:
    explicit Stream(const TakePiece& take) : take_(take) {}
    bool take(PieceMemory& piece) override { return piece.dots.size() == 0 || take_(piece.dots); }

 private:
    const TakePiece& take_;
};

// A tile of a level is a square `cell_depth` above the cells that make it up; its own orientation and kind
// are found on the way.
void collect(const Traversal& traversal, const QuadSquare& square, Orientation orientation, std::size_t kind,
             std::vector<PlacedTile>& tiles) {
    const PlacingTable& table = traversal.table();
    if (!overlap(traversal.window(), traversal.area_of(square))) return;
    const double ranks = std::ldexp(kDotsPerScale * traversal.request().scale, -2 * square.depth);
    const double max = traversal.density().bounds(square).max;
    if (ranks * max <= (square.depth == 0 ? 0.0 : static_cast<double>(table.tile_size))) return;
    const glm::dvec2 corner = traversal.corner_in_window(square);
    tiles.push_back({square.depth, corner.x, corner.y, std::ldexp(1.0, -square.depth), orientation});
    if (table.next_kind.size() > 1) tiles.back().kind = kind;
    // Its children appear with the first of their newborn points.
    if (ranks * max <= static_cast<double>(table.tile_size) || square.depth >= kMaxDepth) return;
    for (int q = 0; q < 4; ++q) {
        const int placed = apply_to_quadrant(orientation, q);
        collect(traversal, {square.depth + 1, 2 * square.x + (placed & 1), 2 * square.y + (placed >> 1)},
                compose(orientation, table.rule.child[q]), table.next_kind[kind][q], tiles);
    }
}

}  // namespace

std::size_t threads_for(int wanted) {
    return static_cast<std::size_t>(wanted > 0 ? wanted : tbb::this_task_arena::max_concurrency());
}

bool keep_dots(const Traversal& traversal, PlacerMemory& memory, DotPieces& dots,
               const std::stop_token& stop) {
    const bool thresholds = traversal.request().thresholds, whole_page = traversal.has_whole_page();
    const std::size_t threads = threads_for(traversal.request().threads);
    const double expected = dots_in_window(traversal);
    const bool shared = threads > 1 && (!whole_page || expected >= kWorthSharing);
    divide_into_pieces(traversal, shared ? piece_dots(traversal, kMostKept) : kWhole, memory.pieces);

    const std::size_t count = memory.pieces.ends.size();
    // Pieces that are not needed stay for the next time.
    if (dots.pieces.size() < count) dots.pieces.resize(count);
    if (memory.emitters.size() < count) memory.emitters.resize(count);
    for (std::size_t i = count; i < dots.pieces.size(); ++i) dots.pieces[i].resize(0, thresholds);
    for (std::size_t i = count; i < memory.emitters.size(); ++i) memory.emitters[i].tail.clear();
    const double most = std::accumulate(memory.pieces.most.begin(), memory.pieces.most.end(), 0.0);
    std::atomic<std::size_t> done = 0;
    if (memory.share) *memory.share = 0;
    // Threads may come here in another order than they counted.
    const auto report = [&](std::size_t pieces) {
        if (!memory.share) return;
        const float now = static_cast<float>(pieces) / static_cast<float>(count);
        float reported = *memory.share;
        while (reported < now && !memory.share->compare_exchange_weak(reported, now)) continue;
    };
    for_each_on_threads(count, threads, [&](std::size_t i) {
        if (whole_page) reserve(dots.pieces[i], expected * memory.pieces.most[i] / most, thresholds);
        SquareEmitter emitter(traversal, dots.pieces[i], memory.emitters[i], expected >= kBeyondCaches);
        place_piece(traversal, memory.pieces, i, emitter, stop);
        report(++done);
    });
    return !stop.stop_requested();
}

bool hand_over_dots(const Traversal& traversal, PlacerMemory& memory, PieceTaker& taker,
                    const std::stop_token& stop) {
    divide_into_pieces(traversal, piece_dots(traversal, kMostHandedOver), memory.pieces);
    return hand_over_pieces(traversal, memory.pieces, threads_for(traversal.request().threads),
                            memory.piece_memories, taker, stop);
}

Placer::Placer(PlacingTable table) : Placer(std::make_shared<const PlacingTable>(std::move(table))) {}
Placer::Placer(std::shared_ptr<const PlacingTable> table)
    : table_(std::move(table)), memory_(std::make_unique<PlacerMemory>()) {}
Placer::Placer(Placer&&) noexcept = default;
Placer& Placer::operator=(Placer&&) noexcept = default;
Placer::~Placer() = default;

void Placer::report_share(std::atomic<float>* share) {
    memory_->share = share;
}

std::optional<double> Placer::place(const Density& density, const PlacingRequest& request, DotPieces& dots,
                                    std::stop_token stop) {
    if (request.count) return place_count(density, request, dots, stop);
    if (!keep_dots(Traversal(*table_, density, request), *memory_, dots, stop)) return std::nullopt;
    return request.scale;
}

bool Placer::hand_over(const Density& density, const PlacingRequest& request, const TakePiece& take,
                       std::stop_token stop) {
    if (request.count) return hand_over_count(density, request, take, stop);
    Stream stream(take);
    return hand_over_dots(Traversal(*table_, density, request), *memory_, stream, stop);
}

std::vector<PlacedTile> placed_tiles(const PlacingTable& table, const Density& density,
                                     const PlacingRequest& request) {
    const Traversal traversal(table, density, request);
    std::vector<PlacedTile> tiles;
    for (int root = 0; root < 4; ++root)
        collect(traversal, {0, (root & 1) - 1, (root >> 1) - 1}, {}, 0, tiles);
    return tiles;
}

}  // namespace dapple
