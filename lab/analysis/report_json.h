#pragma once
// The analysis of a point set as JSON, for programs.

#include <string>

#include "core/analysis/report.h"
#include "lab/analysis/subject.h"

namespace dapple {

/// The report as JSON. Its keys, each as the core/analysis header of the same subject defines it:
///
///   subject                 the file, or what was placed
///   tile, ranking, placer, scale, emitted, duplicates, mean_density
///                           only if this program placed the dots
///   dots                    distinct points, n
///   domain                  {width, height, topology: "torus" or "window"}
///   density                 n / area
///   largest_radius          r_max, in the domain's unit
///   relative_radius         half the smallest distance / r_max
///   nearest                 {min, p1, mean} of the distances to the nearest neighbour / (2 r_max)
///   local_density           {columns, rows, lowest, highest, deviation} over the mean density
///   highest_bin             greatest power at 0.5 < |k| < 2 sqrt(n); white noise has 1 on average
///   highest_bin_frequency   [i, j], in periods over the domain
///   top_share               part of that power which the strongest 0.1 % of the bins hold, 0..1
///   low_frequency_power     mean power below 0.5 sqrt(n): the same number as power_below_05
///   power_below_03, power_below_05
///   radial_frequency, radial_power, anisotropy     lists of equal length: f / sqrt(n), mean power of the
///                           ring, and its anisotropy in decibel
///   effective_nyquist       over sqrt(n) / 2
///   pair_correlation        {distance, g}: lists; the bins' middles in mean spacings
///   periodicity             highest autocorrelation at a multiple of the period, or null without one
///   periodicity_lag, period [a, b] periods and [x, y] in the domain's unit, or null
///   discrepancy             {star_lower, star_upper, l2_star}
///   tone_fidelity           only of a picture, one for each viewing distance: {blur_spacings, blur_px,
///                           viewing_distance_mm, mean_error, rms_error, psnr_db, ssim}
std::string report_json(const Subject& subject, const PointReport& report);

}  // namespace dapple
