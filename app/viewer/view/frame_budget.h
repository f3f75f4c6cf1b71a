#pragma once
// How long a frame may draw and what it can draw in that time, learnt from how long frames take.

#include <cstddef>

namespace dapple {

/// What else a frame takes (the page's pixels, the panels, what the system does to show it) depends on the
/// computer and on what else that does meanwhile. Drawing gets the rest of a frame that seems to answer at
/// once; a little in any case, or it would never come to its end.
class FrameBudget {
 public:
    /// How long a frame may take, so that the longest stay well below a tenth of a second.
    static constexpr double kFrameSeconds = 0.06;
    static constexpr double kLeastSeconds = 0.012;

    /// The seconds that a frame may draw for: at most `most`, but never less than kLeastSeconds.
    double seconds(double most) const;

    /// A frame took so long, of which drawing that goes by the budget took `drawing` (seconds).
    void learn(double frame, double drawing);

 private:
    double other_ = 0.03;  // that the rest of a frame takes
};

/// How long dots take to be drawn: so much for each of them, and so much for each sample that they cover, by
/// how fast the computer is. A part of them, each so much larger that it is as dark, saves time for the dots
/// alone.
class DotCost {
 public:
    /// A part of a drawing has at least half of its dots, and never fewer than the first of these: larger
    /// ones would be blobs. Of more than the second of them none is missed by the eye, whatever the screen.
    static constexpr std::size_t kFewestDots = 20'000, kEnoughDots = 500'000;

    /// Beside one processor that runs OpenGL, before anything was measured.
    explicit DotCost(double slowness = 1) : slowness_(slowness) {}

    /// In seconds; the radius in samples.
    double seconds(double dots, double radius) const;

    /// So many dots took `seconds`.
    void learn(double dots, double radius, double seconds);

    /// One dot in how many is drawn, times sqrt(that) as large, to be ready within about `seconds`; 1: all
    /// are, as they are few or a part would take about as long. `before` is what it was in the frame before,
    /// of the same gesture: a picture that gets coarse and fine in turns is worse than a coarse one.
    std::size_t every(std::size_t dots, double radius, double seconds, std::size_t before = 1) const;

 private:
    double slowness_;
};

}  // namespace dapple
