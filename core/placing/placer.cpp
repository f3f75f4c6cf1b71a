#include "core/placing/placer.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/placing/kernel.h"
#include "core/placing/square_emitter.h"
#include "core/placing/traversal.h"

namespace dapple {

namespace {

// One piece of a placing, in the order of the recursion: a square's own dots, or all below it too.
struct Piece {
    Visit visit;
    bool with_descendants;
};

constexpr double kPiecesWanted = 64;  // enough that cores finish together, few enough to cost nothing

// The recursion down to squares that hold a small part of the work.
void divide_work(const Traversal& traversal, const Visit& visit, double share, std::vector<Piece>& pieces) {
    const double side = std::ldexp(1.0, -visit.square.depth);
    const bool divides = traversal.divides(visit);
    const bool whole = visit.density.bounds.max * side * side <= share || !divides;
    pieces.push_back({visit, whole});
    if (whole) return;
    Visit child;
    for (int q = 0; q < 4; ++q) {
        if (traversal.descend(visit, q, child)) divide_work(traversal, child, share, pieces);
    }
}

bool place_from(const Traversal& traversal, const Visit& visit, SquareEmitter& emitter,
                const std::stop_token& stop) {
    emitter.emit(visit);
    if (!traversal.divides(visit)) return true;
    if (stop.stop_requested()) return false;
    Visit child;
    for (int q = 0; q < 4; ++q) {
        if (traversal.descend(visit, q, child) && !place_from(traversal, child, emitter, stop)) return false;
    }
    return true;
}

void copy_to(const FloatBuffer& from, FloatBuffer& to, std::size_t at) {
    std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(at));
}

// Room for what is expected, so that columns need not grow, which takes twice the memory.
void reserve(Dots& dots, double expected, bool critical) {
    const auto room = static_cast<std::size_t>(std::min(expected * 1.01, 1e12)) + 4096;
    if (dots.x.capacity() >= room) return;
    dots = {};
    for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold}) column->reserve(room);
    if (critical) dots.critical.reserve(room);
}

constexpr std::size_t kKeptPartDots = std::size_t{1} << 22;  // parts larger than this give their memory back

}  // namespace

Placer::Placer(PlacingTable table) : table_(std::move(table)) {}

bool Placer::place(const Density& density, const PlacingRequest& request, Dots& dots, std::stop_token stop) {
    const Traversal traversal(table_, density, request);
    tbb::task_arena arena(request.threads > 0 ? request.threads : tbb::task_arena::automatic);
    if (arena.max_concurrency() == 1) {
        if (traversal.root().in_window) reserve(dots, 16 * request.scale * density.mean(), request.critical);
        SquareEmitter emitter(traversal, dots);
        return !traversal.starts() || place_from(traversal, traversal.root(), emitter, stop);
    }

    std::vector<Piece> pieces;
    if (traversal.starts()) divide_work(traversal, traversal.root(), density.mean() / kPiecesWanted, pieces);
    if (parts_.size() < pieces.size()) parts_.resize(pieces.size());
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
            SquareEmitter emitter(traversal, parts_[i]);
            if (pieces[i].with_descendants) {
                place_from(traversal, pieces[i].visit, emitter, stop);
            } else {
                emitter.emit(pieces[i].visit);
            }
        });
    });
    if (stop.stop_requested()) return false;

    std::vector<std::size_t> start(pieces.size() + 1, 0);
    for (std::size_t i = 0; i < pieces.size(); ++i) start[i + 1] = start[i] + parts_[i].size();
    reserve(dots, static_cast<double>(start.back()), request.critical);
    dots.x.resize(start.back());
    dots.y.resize(start.back());
    dots.threshold.resize(start.back());
    dots.critical.resize(request.critical ? start.back() : 0);
    const bool keep = start.back() <= kKeptPartDots;
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
            copy_to(parts_[i].x, dots.x, start[i]);
            copy_to(parts_[i].y, dots.y, start[i]);
            copy_to(parts_[i].threshold, dots.threshold, start[i]);
            if (request.critical) copy_to(parts_[i].critical, dots.critical, start[i]);
            if (!keep) parts_[i] = {};
        });
    });
    return true;
}

}  // namespace dapple
