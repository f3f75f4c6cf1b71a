#pragma once
// Which share of the paper each pen covers, for a colour to be seen from afar.
//
// Dots lie side by side, so light adds up by area: the colour seen is the paper's, as far as it is bare, and
// each pen's as far as it covers, in linear light. (Neugebauer's equations of 1937 without overprints; what
// overlaps is made up for later, see core/drawing/pen_plan.h.) The shares are those whose colour errs least,
// none below 0 and all together at most 1; of the many that do so the smallest in the sum of squares, so that
// they change smoothly where the colour does. A share below 0.001 is none, and in a separation neither is one
// that is less than a fortieth of all: its few dots among those of others would be specks. Colours that no
// mixture reaches get paler rather than darker, lighter or of another hue: an error in luminance or hue
// weighs more than one in how strong the colour is.
//
// The picture's black to white is mapped onto the darkest to the lightest of the pens and the paper, so that
// every set of pens gives all the contrast it can.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/pens/pen.h"

namespace dapple {

/// A share of the paper for each pen, 0..1; beyond the last pen 0.
using Shares = std::array<float, kMostPens>;

/// Pens on a paper, side by side.
class PenMixer {
 public:
    /// 1..kMostPens pens; colours sRGB-encoded.
    PenMixer(std::span<const Pen> pens, glm::vec3 paper);

    /// What those shares look like; linear.
    glm::vec3 seen(const Shares& shares) const;
    /// The shares that come nearest to that linear colour, with those pens that then have so much of all
    /// shares or more.
    Shares solve(glm::vec3 aim, double least_part = 0) const;

    std::span<const glm::vec3> pens() const { return pens_; }  // linear, on the paper
    glm::vec3 paper() const { return paper_; }

 private:
    std::vector<glm::vec3> pens_;
    glm::vec3 paper_;
};

/// Three coloured pens together make grey too, so that of four pens the black one has a choice: `black` is 0
/// where it draws as little as possible, 1 where as much, kUsualBlack where the shares are as above; between
/// them along the line of shares that look exactly the same. (Grey component replacement.) Other sets have
/// no such line, or many.
class Separation {
 public:
    Separation(std::span<const Pen> pens, glm::vec3 paper, double black = kUsualBlack);

    /// The shares for a colour of the picture, linear, 0..1; clamped. Interpolated in tetrahedra between the
    /// solutions on a lattice of 33 colours along each axis.
    Shares shares(glm::vec3 colour) const;

    /// The same with the shares of each of the lattice's colours changed; from several threads at once.
    Separation changed(const std::function<Shares(const Shares&)>& change) const;

    /// What a colour of the picture is to look like on this paper; linear.
    glm::vec3 aim(glm::vec3 colour) const { return darkest_ + (lightest_ - darkest_) * colour; }
    const PenMixer& mixer() const { return mixer_; }

 private:
    PenMixer mixer_;
    glm::vec3 darkest_, lightest_;
    std::vector<Shares> lattice_;
};

/// Whether automatic pens are chosen from one's own, which have their own widths: if there are more of these
/// than are wanted. Otherwise they are chosen from common_pens(), all as wide as the choice says.
bool chooses_from_own(const PenChoice& choice);

/// As many of the candidates as asked for whose mixtures come nearest to the colours (linear, 0..1): each the
/// one that lowers the mean squared distance in OKLab (Ottosson 2020) most, beside those chosen before it,
/// and then once more beside all the others.
Palette best_pens(std::span<const glm::vec3> colours, std::span<const Pen> candidates, int count,
                  glm::vec3 paper);

/// OKLab of a linear colour.
glm::vec3 oklab_of(glm::vec3 linear);

}  // namespace dapple
