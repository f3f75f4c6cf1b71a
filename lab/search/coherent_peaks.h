#pragma once
// The frequencies at which copies of a tile add up, whatever their orientations.
//
// At a frequency k of the lattice that fits the tile, every copy of a tile has the same phase, so that a
// large picture has the amplitude sum over tiles of F_g(k): if all eight orientations are equally frequent,
// N times their mean per point. By the symmetry that mean is real, about the tile's centre
//
//      C(k) = sum over points of ( cos kx x cos ky y + cos ky x cos kx y ) / 2,
//
// one number for the up to eight frequencies (+-kx, +-ky), (+-ky, +-kx). Its power C(k)^2 / N grows with the
// number of tiles and is what remains of the tile's periodicity in a spectrum; S(k) / 8 by chance.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace dapple {

/// A penalty on the coherent powers of points that move: weight * sum over k of max(0, 16 C(k)^2 / N -
/// limit)^2 over all 0 < |k| <= 2 sqrt(N). 16 C^2 / N is the bin's height in a spectrum of 16 tiles in which
/// white noise is 1. Kept up to date only for the frequencies near or above the limit at the last call of
/// reset().
class CoherentPeaks {
 public:
    CoherentPeaks(std::size_t points, double weight, double limit);

    bool empty() const { return weight_ == 0; }
    /// Positions are in spacings, 1 / sqrt(N) of the tile's side, from the tile's centre.
    void reset(std::span<const glm::dvec2> positions);
    /// The penalty at the last reset() or take().
    double penalty() const { return penalty_; }
    /// The highest 16 C^2 / N, at the last reset().
    double highest() const { return highest_; }

    /// The change of the penalty if points move from their places to others, in spacings.
    struct Move {
        glm::dvec2 from, to;
    };
    double try_moves(std::span<const Move> moves);
    /// Makes the moves of the last try_moves().
    void take();

 private:
    struct Frequency {
        int x, y;  // 0 <= x <= y
    };
    void fill_cosines(glm::dvec2 p);
    double wave(Frequency k) const;
    double penalty_of(double sum) const;

    double weight_, limit_, side_;
    double per_point_;  // 16 / N
    int highest_frequency_;
    std::vector<Frequency> frequencies_, watched_;
    std::vector<double> sums_, tried_;  // C of the watched ones
    std::vector<float> cos_x_, cos_y_;
    double penalty_ = 0, tried_penalty_ = 0, highest_ = 0;
};

}  // namespace dapple
