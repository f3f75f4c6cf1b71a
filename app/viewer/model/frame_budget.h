#pragma once
// How long a frame may draw, learnt from how long frames take.

namespace dapple {

/// What else there is in a frame (the page's pixels, the panels, what the system does to show it) depends on
/// the computer and on what else that does meanwhile. Drawing gets what is left of a frame that is answered
/// as quickly as one notices; a little in any case, or it would never come to its end.
class FrameBudget {
 public:
    /// Of a frame, so that the longest stay well below a tenth of a second.
    static constexpr double kFrameSeconds = 0.06;
    static constexpr double kLeastSeconds = 0.012;

    /// Of which a frame has at most `most`, in seconds.
    double seconds(double most) const;

    /// A frame took so long, of which drawing that goes by the budget took `drawing` (seconds).
    void learn(double frame, double drawing);

 private:
    double other_ = 0.03;  // that the rest of a frame takes
};

}  // namespace dapple
