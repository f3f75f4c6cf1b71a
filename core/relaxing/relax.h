#pragma once
// Relaxation: dots that have been placed move into better places.
//
// The first steps are Lloyd's, which make dots even (lloyd_steps.h); the others go down an energy
// until they are also as many as there should be, over every few of them (energy_steps.h). As placed they are
// even already: three steps show more of a picture than a hundred of Lloyd's from random dots.
//
// What moves is seen no more as a part of the endless subdivision: the first n dots of a relaxed drawing are
// not the drawing with n dots.

#include <cstddef>
#include <memory>
#include <stop_token>

#include "core/image/density.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/relaxing/blurred_density.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/energy_steps.h"

namespace dapple {

inline constexpr int kMostRelaxingSteps = 100;

/// So many steps come first. They carry ink far, which the energy's short kernels cannot.
inline constexpr int kFirstLloydSteps = 4;

/// See RelaxingRequest::even_from.
inline constexpr float kNeverEven = 2;

struct RelaxingRequest {
    double scale = 0;                    // that the dots were placed at, over 0
    int threads = 1;                     // the dots are the same for any number; 0: all cores
    int lloyd_steps = kFirstLloydSteps;  // after so many come those down the energy
    // From this density of the tone on the later steps are Lloyd's too: where dots overlap to solid black,
    // paper shows between them unless they are even. No density is as large where none overlap.
    float even_from = kNeverEven;
    float kernel = kPictureKernel;  // see energy_steps.h
    // A dot goes to where there is less by a chance of that share of what it comes from (Metropolis et al.
    // 1953), so that as many come back as go: of the details that kernels do not see each keeps its dots.
    // Else it stays where there would be less than a quarter, so that thin lines stay lines.
    bool keeps_density = false;
    float ink = 1;        // see ink_for() of energy_steps.h
    DotAreas areas = {};  // of the dots; the later steps weigh them by these
    // See blurred_for_kernels(). Without, it is made once it is needed.
    std::shared_ptr<const BlurredDensity> blurred = {};
    // The first steps give each dot room for the disc that its own radius says, which many dots of another
    // size beside it would not leave it.
    bool by_radius = false;
    double stirring = 1;  // how much dots are stirred, 0..1; see stir.h
};

/// How far around a part of a page dots have an influence on where those on it are after so many steps, in
/// page units: relaxed with all dots within it, those on the part come out as on the whole page, to the bit.
double relaxing_rim(double scale, int steps);

/// The height of the rows that relaxed dots come in, in page units: a power of two, about the distance
/// between dots on black.
double relaxing_row(double scale);

/// Dots on their way from where they are given. They keep their other columns.
class Relaxation {
 public:
    /// Dots in page units from the page's corner, of a density that fills the page and does not wrap round.
    /// The density has to live on.
    Relaxation(DotPieces dots, const Density& density, const RelaxingRequest& request);

    /// One step. False if stopped; the dots are then as before.
    bool step(const std::stop_token& stop = {});

    /// The dots as they lie now, row after row of the page and in each from the left to the right. Where a
    /// row ends depends on the scale alone, so that the dots on a part of a page come in the order of the
    /// whole.
    DotPieces dots() const;

    /// The dots as they lie now, in the order in which they were taken.
    Dots dots_as_taken() const;

 private:
    const Density& density_;
    RelaxingRequest request_;
    int depth_;  // rows are 2^-depth page units high
    DotPieces placed_;
    DotRows rows_;
    DotRows::Positions next_x_, next_y_;
    int taken_ = 0;
};

/// Stirs dots as placed (stir.h), then several steps. False if stopped; the dots are then as before.
bool relax(DotPieces& dots, const Density& density, int steps, const RelaxingRequest& request,
           const std::stop_token& stop = {});

}  // namespace dapple
