#pragma once
// What a placer keeps from one placing to the next, and the placing that its calls share.

#include <optional>
#include <vector>

#include "core/placing/pieces.h"
#include "core/placing/placer.h"

namespace dapple {

struct PlacerMemory {
    Pieces pieces;
    std::vector<PieceMemory> piece_memories;
    EmitterMemory emitter;  // of a placing that needs no pieces; its late dots are those of the last placing

    // Of an exact count.
    std::vector<float> criticals;
    std::vector<TieKey> ties;
    std::vector<std::size_t> dropped;
};

/// As many threads as are asked for, 0 being all cores.
std::size_t threads_for(int wanted);

/// Places all that the traversal reaches into `dots`, and its late dots into memory.emitter.late. False if
/// stopped.
bool place_columns(const Traversal& traversal, PlacerMemory& memory, Dots& dots, const std::stop_token& stop);

/// Hands the same over in pieces, each with its late dots. False if stopped or ended by the taker.
bool hand_over_pieces(const Traversal& traversal, PlacerMemory& memory, PieceTaker& taker,
                      const std::stop_token& stop);

}  // namespace dapple
