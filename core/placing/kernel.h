#pragma once
// The inner loop: which points of one square exist, and where.
//
// One body (kernel_body.h) is compiled for several vector widths; the processor decides at run time. The
// operations and their order are the same, so the dots are equal to the bit.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/placing/dots.h"
#include "core/placing/placing_table.h"

namespace dapple {

/// A square of the page, ready for its points to be tested. Points are given about its centre in half sides,
/// -1..1.
struct KernelSquare {
    const PointBlock* points = nullptr;  // by ascending rank, up to a rank of infinity
    const float* block_ends = nullptr;   // each block's last rank
    bool swap = false;                   // x and y
    std::size_t first = 0;               // the first point to be tested; those before it are dots already

    float centre_x = 0, centre_y = 0;  // in the window
    float half_x = 0, half_y = 0;      // half sides; the signs mirror the points
    float sign_x = 1, sign_y = 1;      // those signs

    // Where the window or the picture ends in the square: points from low to below high take part, in half
    // sides from the centre in the page's frame.
    bool at_edge = false;
    float low_x = 0, low_y = 0, high_x = 0, high_y = 0;

    float ranks_per_density = 0;  // a point exists where density * this > rank
    float certain_below = 0;      // ranks below this exist all over the square
    float none_from = 0;          // ranks from this on exist nowhere in it
    float threshold_per_rank = 0;
    float tail_per_density = 0;  // below ranks_per_density: dots that need more are the tail

    // Where the density at a point comes from.
    enum class Source {
        block,    // at most 4 x 4 pixels, copied to `block`
        picture,  // the picture, all pixels that are read lying in it
        clamped,  // the picture, its outermost pixels going on outside
    };
    Source source = Source::block;
    // A point's position among the middles of pixels, see Density::middle() = pixel_centre + pixel_half *
    // point; the picture's first pixel is at 1, so that none is negative. In double precision: a point then
    // has the same density with whatever square it comes.
    double pixel_centre_x = 0, pixel_centre_y = 0, pixel_half_x = 0, pixel_half_y = 0;
    float mixed = 1;                      // 0: the pixel at or before the position alone counts
    float block[16];                      // rows of four; not set at first, as that takes a while
    int first_column = 0, first_row = 0;  // of the block; counted likewise
    const float* picture = nullptr;
    int width = 0, height = 0;
};

/// Where dots go; room for all the square's points plus kKernelPadding. threshold and critical are null
/// together, tail too may be.
struct KernelOutput {
    float* x = nullptr;
    float* y = nullptr;
    float* threshold = nullptr;
    float* critical = nullptr;
    TailDot* tail = nullptr;
    std::size_t first_index = 0;  // of x[0], for dots of the tail
    bool beyond_caches = false;   // the columns: their lines are asked for before they are written
};

/// How many dots of a square there are, and of the tail, those before its first point among them.
struct PlacedCount {
    std::size_t dots = 0, tail = 0;
};

/// The points of a square, from the first one on, that exist wherever in it they lie.
struct CertainPoints {
    std::size_t count = 0;
    bool all = false;  // no other can exist; else some that are certain may not be counted
};

inline constexpr std::size_t kKernelPadding = kBlockPoints;

struct Kernels {
    const char* name = nullptr;  // "plain", "avx2", "avx512"

    /// Writes certain points of a square without edges, in the order of their ranks. Its first point and what
    /// belongs to its source may be unset; only output.x and y are written.
    CertainPoints (*place_certain)(const KernelSquare& square, const KernelOutput& output);

    /// Writes the square's dots from its first point on, in the same order, behind those that are there.
    PlacedCount (*place)(const KernelSquare& square, const KernelOutput& output);
};

extern const Kernels kPlainKernels;  // for any processor

/// Those that were compiled and that this processor runs: the plain ones, then ever wider.
std::vector<const Kernels*> runnable_kernels();

/// The widest of them, or those of choose_kernels().
const Kernels& chosen_kernels();

/// What placers that are made from now on use, by its name: for tests, and to tell whose fault something is,
/// as the dots are the same. Throws std::runtime_error if none of runnable_kernels() has that name.
void choose_kernels(std::string_view name);

}  // namespace dapple
