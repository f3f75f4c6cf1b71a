#pragma once
// LBG stippling: dots split where their cells hold too much and go where they hold too little, between steps
// of Lloyd's method.

#include "core/tile/random.h"
#include "lab/related/wanted.h"

namespace dapple {

/// O. Deussen, M. Spicker & Q. Zheng, "Weighted Linde-Buzo-Gray Stippling" (2017), with the numbers that
/// their published program starts with: at most kLbgSteps steps, hysteresis 0.6 + 0.01 a step. What splits
/// goes half the radius of a disc of its cell's area along the cell's long axis to either side.
///
/// What differs: it begins with one dot, and a dot's share is the picture's ink over the count, which meets
/// the count to some in a hundred; theirs is the area of a dot drawn at its size, so that the size decides
/// about the count. All dots are of one size: their adaptive point sizes, larger in the dark, are left out,
/// as the other methods compared have none.
PlainDots lbg(const DotsWanted& wanted);

inline constexpr int kLbgSteps = 50;

struct LbgStep {
    PlainDots dots;
    bool changed = false;  // some were split or taken away
};

/// One step for the wanted count: dots whose cells hold less than 1 - hysteresis / 2 of a share go, those
/// that hold more than 1 + hysteresis / 2 are split, the others move to the centroid.
LbgStep lbg_step(const PlainDots& dots, const DotsWanted& wanted, double hysteresis, Random& random);

}  // namespace dapple
