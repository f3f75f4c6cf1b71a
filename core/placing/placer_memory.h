#pragma once
// What a placer keeps from one placing to the next, and the placing that its calls share.

#include <atomic>
#include <optional>
#include <vector>

#include "core/placing/pieces.h"
#include "core/placing/placer.h"

namespace dapple {

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
