#pragma once
// A placing cut into pieces that several threads work on: kept side by side, or handed over in the order of
// the recursion.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/placing/dots.h"
#include "core/placing/kernel.h"
#include "core/placing/placer.h"
#include "core/placing/traversal.h"

namespace dapple {

// From a square of the recursion to its dots.

/// Working memory that is kept from one emitter to the next.
struct EmitterMemory {
    TailDots tail;  // see SquareEmitter
};

/// Appends squares' dots to columns that it overwrites; they get their length when it is destroyed.
class SquareEmitter {
 public:
    /// Dots that do not exist yet at the traversal's tail scale are listed in memory.tail too, in their
    /// order. `beyond_caches`: the drawing will be larger than the caches.
    SquareEmitter(const Traversal& traversal, Dots& dots, EmitterMemory& memory, bool beyond_caches = false);
    ~SquareEmitter();
    SquareEmitter& operator=(SquareEmitter&&) = delete;

    /// The dots that the square itself brings; where the recursion ends, all there are in it.
    void emit(const Visit& visit, bool ends);

 private:
    void set_edges(const Visit& visit, KernelSquare& square) const;
    bool may_be_decided(const KernelSquare& square, const CellPoints& points) const;
    bool set_density(const Visit& visit, KernelSquare& square) const;
    PlacedCount emit_across_seam(const KernelSquare& square, const KernelOutput& output) const;
    KernelOutput room_for(std::size_t count);

    const Traversal& traversal_;
    Dots& dots_;
    EmitterMemory& memory_;
    const bool beyond_caches_;
    const Kernels& kernels_;
    std::size_t count_ = 0, capacity_ = 0;
    std::size_t tail_ = 0;
};

/// A square's own dots, or all below it too.
struct PieceSquare {
    Visit visit;
    bool with_descendants = false;
};

/// The whole placing, in order: piece i is the squares from ends[i - 1] to before ends[i].
struct Pieces {
    std::vector<PieceSquare> squares;
    std::vector<std::size_t> ends;
    std::vector<double> most;  // dots in each, as far as the density's maxima tell
};

/// Cuts into pieces of at most about `dots` dots each. Uses the memory of `pieces` again.
void divide_into_pieces(const Traversal& traversal, double dots, Pieces& pieces);

/// A piece's dots onto the emitter. False if stopped.
bool place_piece(const Traversal& traversal, const Pieces& pieces, std::size_t piece, SquareEmitter& emitter,
                 const std::stop_token& stop);

/// Does the same work on so many threads at once.
template <class Work>
void on_threads(std::size_t threads, const Work& work) {
    if (threads == 1) return work();
    tbb::parallel_for(std::size_t{0}, threads, [&](std::size_t) { work(); });
}

/// Calls body(i) for each i below `count`, on so many threads.
template <class Body>
void for_each_on_threads(std::size_t count, std::size_t threads, const Body& body) {
    std::atomic<std::size_t> next = 0;
    on_threads(std::min(count, threads), [&] {
        for (std::size_t i; (i = next++) < count;) body(i);
    });
}

/// Where a piece is placed that is handed over, kept for others after it: small enough for a core's own
/// cache.
struct PieceMemory {
    Dots dots;
    EmitterMemory emitter;

    enum class State {
        free,
        is_placed,  // at the moment
        waits,      // for its turn, or is handed over
    };
    State state = State::free;
    std::size_t piece = 0;
};

/// Who takes the pieces.
class PieceTaker {
 public:
    virtual ~PieceTaker() = default;
    /// Called in the order of the pieces, one at a time, by whichever thread; the others go on placing
    /// meanwhile, as far ahead as there are memories. False ends the placing. May throw.
    virtual bool take(PieceMemory& piece) = 0;
};

/// Places every piece and hands it over. False if stopped or ended by the taker. Four memories a thread: how
/// far placing may be ahead of the taker.
bool hand_over_pieces(const Traversal& traversal, const Pieces& pieces, std::size_t threads,
                      std::vector<PieceMemory>& memories, PieceTaker& taker, const std::stop_token& stop);

// What a placer keeps from one placing to the next, and the placing that its calls share.

struct PlacerMemory {
    std::atomic<float>* share = nullptr;  // see Placer::report_share()
    Pieces pieces;
    std::vector<PieceMemory> piece_memories;
    std::vector<EmitterMemory> emitters;  // of pieces that are kept: piece i's tail is emitters[i].tail

    // For an exact count.
    std::vector<float> criticals;
    std::vector<TieKey> ties;
};

/// As many threads as are asked for, 0 being all cores.
std::size_t threads_for(int wanted);

/// Places all that the traversal reaches into `dots`, and each piece's tail into memory.emitters. False
/// if stopped.
bool keep_dots(const Traversal& traversal, PlacerMemory& memory, DotPieces& dots,
               const std::stop_token& stop);

/// Hands the same over piece by piece, each with its tail. False if stopped or ended by the taker.
bool hand_over_dots(const Traversal& traversal, PlacerMemory& memory, PieceTaker& taker,
                    const std::stop_token& stop);

}  // namespace dapple
