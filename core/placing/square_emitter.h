#pragma once
// From a square of the recursion to its dots.

#include <cstddef>

#include "core/placing/dots.h"
#include "core/placing/kernel.h"
#include "core/placing/traversal.h"

namespace dapple {

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
    SquareEmitter(const SquareEmitter&) = delete;
    SquareEmitter& operator=(const SquareEmitter&) = delete;

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

}  // namespace dapple
