#pragma once
// A placing cut into pieces that several threads work on and hand over in the order of the recursion.

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/placing/square_emitter.h"
#include "core/placing/traversal.h"

namespace dapple {

/// A square's own dots, or all below it too.
struct PieceSquare {
    Visit visit;
    bool with_descendants = false;
};

/// The whole placing, in order: piece i is the squares from ends[i - 1] to before ends[i].
struct Pieces {
    std::vector<PieceSquare> squares;
    std::vector<std::size_t> ends;
};

/// Cuts into pieces of at most about `dots` dots each. Uses the memory of `pieces` again.
void divide_into_pieces(const Traversal& traversal, double dots, Pieces& pieces);

/// All that the traversal reaches, onto the emitter. False if stopped.
bool place_all(const Traversal& traversal, SquareEmitter& emitter, const std::stop_token& stop);

/// Where a piece is placed, kept for others after it: small enough for a core's own cache.
struct PieceMemory {
    Dots dots;
    EmitterMemory emitter;
    std::size_t start = 0;  // of the piece within the whole, for who takes it

    enum class State {
        free,
        is_placed,  // or is handed over
        waits,      // for its turn
    };
    State state = State::free;
    std::size_t piece = 0;
};

/// Who takes the pieces. Taking in turn may throw.
class PieceTaker {
 public:
    virtual ~PieceTaker() = default;
    /// Called in the order of the pieces, one at a time. False ends the placing.
    virtual bool take_in_turn(PieceMemory& piece) = 0;
    /// Called after that, beside other pieces'.
    virtual void take_beside(const PieceMemory&) {}
};

/// Places every piece. False if stopped or ended by the taker.
bool place_pieces(const Traversal& traversal, const Pieces& pieces, std::size_t threads,
                  std::vector<PieceMemory>& memories, PieceTaker& taker, const std::stop_token& stop);

}  // namespace dapple
