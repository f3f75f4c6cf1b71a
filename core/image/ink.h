#pragma once
// How much paper dots cover: from their number and size to what is seen, and back.
//
//      load      number of dots * area of one / area of paper; more than what they cover, as dots overlap
//      coverage  the share of paper that is covered, 0..1
//      density   0..1, in proportion to the number of dots; load at density 1 is full_load()
//
// Even dots overlap late and then all at once, dots as placed earlier, and how early depends on where their
// number lies between two full levels of the tile. All of it is measured on dots that this program places and
// relaxes (bench/coverage_tables), with the default tile; the largest error is 0.01.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace dapple {

/// The dots whose coverage is asked for.
struct InkedDots {
    int relaxing_steps = 0;
    /// How many levels of the tile the dots at density 1 are: 0 for as many on the root square as the tile
    /// has points, 1 for four times as many; see level_of(). Only dots that were hardly relaxed depend on it.
    /// None: what is right on the mean over a level.
    std::optional<double> level = {};
    /// The smallest dots' area over the largest ones', 0..1: at density d a dot has smallest + (1 - smallest)
    /// * d of the largest area.
    double smallest_area = 1;
    /// The dots are joined by lines of one width, which cover paper in proportion to their length, and that
    /// is in proportion to the root of how many dots there are (Beardwood, Halton and Hammersley 1959). The
    /// coverage is then told as a share of what the lines cover at density 1.
    bool joined = false;
    /// The coverage that density 1 comes to, kLeastBlack..1; 1: kBlackCoverage. Dots are smaller for it,
    /// since less than full_load() is enough, and stand apart where the picture is dark.
    double black = 1;

    bool operator==(const InkedDots&) const = default;
};

/// The share of the paper that is covered where the density is 1.
inline constexpr float kBlackCoverage = 0.995f;

/// The load from which on dots are measured as they are relaxed where nearly all paper is covered: evenly.
inline constexpr double kSolidLoad = 1.2;

/// The lowest InkedDots::black.
inline constexpr double kLeastBlack = 0.5;

/// The black that automatic tone draws so many dots with, in hundredths: 0.9 up to 5,000, 0.95 at 20,000, 1
/// from 100,000 on. Covering the last twentieth of the paper takes a third of the dots that are in black;
/// where dots are few, they are missed elsewhere.
double usual_black(double dots);

/// log4(kDotsPerScale * scale / tile size).
double level_of(double scale, std::size_t tile_size);

/// Whether the coverage of dots relaxed so often depends on InkedDots::level.
bool depends_on_level(int relaxing_steps);

/// The share of paper that dots of one size cover at that load, `level` being that of their number there;
/// neither smallest_area, joined nor black have a say.
float covered(const InkedDots& dots, double load);

/// Coverage as measured at loads 0, load_step, 2 load_step, ..., of whatever dots.
struct MeasuredCoverage {
    double load_step = 0.05;
    std::span<const float> coverage;  // from 0 on, never falling; at least two
};

/// Between density and coverage, for one kind of dots.
class InkCurve {
 public:
    explicit InkCurve(const InkedDots& dots = {});
    /// The same for dots whose load at density 1 is `full_load`.
    InkCurve(const InkedDots& dots, double full_load);

    /// Density 1 is the first of the loads that covers kBlackCoverage, or the last.
    explicit InkCurve(const MeasuredCoverage& measured);

    /// Density 0..1; clamped.
    float coverage(float density) const;
    /// The inverse. What no dots cover, over coverage(1), has density 1.
    float density(float coverage) const;

    /// The density with which a tone is drawn that asks for that share of ink, 0..1: the inverse of
    /// coverage(). But where black is less than solid, the darker tones come nearer to each other, so that
    /// each stays darker than the next; light ones stay as they are.
    float density_for(float ink) const { return density(opened(ink)); }

    /// The coverage that a tone gets which asks for that share of ink.
    float opened(float ink) const;

    /// The load at density 1, of dots of the largest area.
    double full_load() const { return full_load_; }
    /// The load at a density, of dots of the size that they have there.
    float load(float density) const;

 private:
    static constexpr int kSteps = 512;
    std::array<float, kSteps + 1> coverage_;  // at equal steps of density, rising
    double full_load_, smallest_area_ = 1;
    float black_ = 1;
};

/// The radius of the largest dots, in page units, with which a drawing at that scale has the picture's tone.
double radius_for_tone(double scale, double full_load);

}  // namespace dapple
