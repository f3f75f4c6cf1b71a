#pragma once
// Relaxation: dots that have been placed move into better places.
//
// Steps go down an energy that makes dots even, and as many as there should be over every few of them
// (energy_steps.h); where dots overlap to solid black, and for several pens, they are Lloyd's
// (lloyd_steps.h). Warps see to it over more dots (warp.h). As placed they are even already: three steps show
// more of a picture than a hundred of Lloyd's from random dots.
//
// What moves is seen no more as a part of the endless subdivision: the first n dots of a relaxed drawing are
// not the drawing with n dots.

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/image/density.h"
#include "core/image/ink.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/relaxing/blurred_density.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/energy_steps.h"
#include "core/relaxing/warp.h"

namespace dapple {

inline constexpr int kMostRelaxingSteps = 100;

/// See RelaxingRequest::even_from.
inline constexpr float kNeverEven = 2;

/// How all dots move at once.
struct RelaxingStep {
    enum class Kind { lloyd, energy, warp };
    Kind kind = Kind::lloyd;
    float stride = 1.8f;            // see LloydSteps and EnergySteps; a warp has none
    float kernel = kPictureKernel;  // of the energy
};

struct RelaxingRequest {
    double scale = 0;  // that the dots were placed at, over 0
    int threads = 1;   // the dots are the same for any number; 0: all cores
    // From this density of the tone on all steps are Lloyd's: where dots overlap to solid black, paper shows
    // between them unless they are even. No density is as large where none overlap.
    float even_from = kNeverEven;
    // A dot goes to where there is less by a chance of that share of what it comes from (Metropolis et al.
    // 1953), so that as many come back as go: of the details that kernels do not see each keeps its dots.
    // Else it stays where there would be less than a quarter, so that thin lines stay lines.
    bool keeps_density = false;
    float ink = 1;        // see ink_for() of energy_steps.h
    DotAreas areas = {};  // of the dots; all but Lloyd's steps weigh them by these
    // See blurred_for_kernels(); for the narrowest of the steps' kernels. Without, it is made once it is
    // needed.
    std::shared_ptr<const BlurredDensity> blurred = {};
    // Lloyd's steps give each dot room for the disc that its own radius says, which many dots of another size
    // beside it would not leave it.
    bool by_radius = false;
    double stirring = 1;  // how much dots are stirred, 0..1; see stir.h
    // From density to light, by which dots are warped; none: they are counted. And see WarpRequest::cut_off.
    std::shared_ptr<const InkCurve> light = {};
    bool cut_off = false;
    // Carries dots along before the first step, in place of warps that see all dots after it: for those on a
    // part of a page, who are relaxed alone.
    std::shared_ptr<const Displacement> carried = {};
};

/// What so many steps are, 0..kMostRelaxingSteps, with the warps between and after them.
std::vector<RelaxingStep> relaxing_steps(int steps, const RelaxingRequest& request);

/// How far around a part of a page dots have an influence on where those on it are after so many steps, in
/// page units: relaxed with all dots within it and carried, those on the part come out as on the whole page,
/// to the bit.
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

    /// One step. False if stopped; the dots are then as before. A warp has to see all dots of the page.
    bool step(const RelaxingStep& how = {}, const std::stop_token& stop = {});

    /// The dots as they lie now, row after row of the page and in each from the left to the right. Where a
    /// row ends depends on the scale alone, so that the dots on a part of a page come in the order of the
    /// whole.
    DotPieces dots() const;

    /// The same as one warp more would leave them: what a drawing on its way is to be shown as.
    DotPieces dots_warped();

    /// The dots as they lie now, in the order in which they were taken.
    Dots dots_as_taken() const;

 private:
    // Calls take(first row, end) for stretches of rows, on all threads, until stopped.
    template <class Take>
    void on_stretches(const std::stop_token& stop, const Take& take) const;
    void find_areas(const std::stop_token& stop);
    void find_radii();
    void warp(const Displacement& displacement);
    void warp_by_all();

    const Density& density_;
    RelaxingRequest request_;
    int depth_;  // rows are 2^-depth page units high
    DotPieces placed_;
    DotRows rows_;
    DotRows::Positions next_x_, next_y_;
    std::shared_ptr<const Warp> warp_;
    int taken_ = 0;
};

/// Carries and stirs dots as placed (stir.h), then several steps. False if stopped; the dots are then as
/// before.
bool relax(DotPieces& dots, const Density& density, int steps, const RelaxingRequest& request,
           const std::stop_token& stop = {});

}  // namespace dapple
