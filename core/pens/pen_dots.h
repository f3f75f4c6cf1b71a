#pragma once
// The dots of all pens as one drawing: no two of any pens lie closer than a drawing with one pen has them,
// and each pen's own are even too.
//
//      dots as placed and relaxed ──► shared out along a Hilbert curve ──► pens exchanged between near dots
//                                                       ▲                            │
//                                                       └── dots moved for both ◄────┘   (a few times)
//
// Where pens have dots of several sizes, these are moved further once it is settled which dot is whose.
//
// Layers made one by one would collide wherever two pens draw; screens at angles make moire.

#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/image/density.h"
#include "core/pens/separation.h"
#include "core/placing/dots.h"

namespace dapple {

// Which pen draws which dot, so that each pen's own dots are about as even as all of them.

/// A number for each dot: the place of its pen in the palette.
using PenLabels = std::vector<std::uint8_t>;

/// Dots, what each pen's share of the dots is where each of them lies (in all 1), and how much paper a dot
/// has for itself there, in page units squared.
struct DotsToShare {
    const Dots& dots;
    std::span<const Shares> shares;
    std::span<const float> area;
    std::size_t pens = 1;
};

/// Gives each dot the pen that lags most behind its share on the way through the dots in their order; so
/// every stretch of the way has each pen's share but for a dot. The order should be DotOrder::space.
PenLabels shared_out(const DotsToShare& dots);

/// Dots that lie near each other exchange their pens wherever that lowers the energy of each pen's dots, a
/// sum over pairs of the same pen of exp(-u / 2) + 3 exp(-2 u), u the squared distance over that at which the
/// pen's dots would lie there, times 0.62 squared. Numbers of dots stay. On any number of threads the same.
class LabelExchange {
 public:
    /// Which dots are near each other is found here: later they may move by less than the distance between
    /// them. What `dots` refers to has to live on. Threads 0: all cores.
    LabelExchange(const DotsToShare& dots, int threads);

    /// So many times through all dots, as they are now, as far as there is something to gain.
    void exchange(PenLabels& labels, int sweeps);

 private:
    void sum_up(const PenLabels& labels, std::size_t dot);
    void exchange_once(PenLabels& labels, bool shifted);
    float distance2(std::size_t a, std::size_t b) const;
    float between(std::size_t a, std::size_t b, float distance2, std::size_t pen) const;
    bool improve(PenLabels& labels, std::size_t dot, std::size_t first, std::size_t last);
    void relabel(PenLabels& labels, std::size_t dot, std::size_t pen, std::size_t first, std::size_t last);

    DotsToShare dots_;
    std::size_t threads_;
    std::size_t near_ = 1;
    std::vector<std::uint32_t> others_;  // near_ of each dot, the nearest first
    std::vector<float> per_sigma2_;      // of each dot, pen after pen: 1 over the square of where u is 1
    std::vector<float> energy_;          // of each dot, pen after pen
    std::vector<float> kernel_;          // of u, at equal steps
};

/// The densities by which a page's dots are shared out: each pen's, and their sum, which is that of all dots.
struct PenDensities {
    std::shared_ptr<const Density> all;
    std::vector<std::shared_ptr<const Density>> each;  // of each pen, as the palette

    /// The shares of the dots at a place, 1 together; alike for all where there are to be none.
    Shares shares_at(glm::dvec2 place) const;
};

struct PenDotsRequest {
    double scale = 0;    // that the dots were placed at
    bool move = true;    // else the dots stay where they are
    bool rough = false;  // just shared out, soon, for a look before the end
    /// The area of a dot of each pen, in any unit; empty: all are as large. Larger ones then push smaller
    /// ones away until all of them cover as much paper as dots of one size would.
    std::vector<double> areas = {};
    int threads = 1;  // the result is the same for any number; 0: all cores
};

/// A piece for each pen, in the order of the palette; Dots::pen says which. Dots keep their other columns,
/// but for radii where there are areas. No pieces if stopped.
DotPieces pen_dots(const DotPieces& dots, const PenDensities& densities, const PenDotsRequest& request,
                   const std::stop_token& stop = {});

}  // namespace dapple
