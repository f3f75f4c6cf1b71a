#pragma once
// How much discs around dots cover, for dots of any method.

#include <functional>
#include <vector>

#include "lab/related/wanted.h"

namespace dapple {

/// A curve of coverage: at loads 0, kCoveredLoadStep, ... up to kCoveredLoads - 1 of them, which cover black
/// for dots of every kind, white noise too.
inline constexpr double kCoveredLoadStep = 0.05;
inline constexpr std::size_t kCoveredLoads = 160;

/// The share of the unit square, whose edges meet, within a disc around each dot, the discs' area together
/// being each of those loads. From 10,000 places spread evenly. At least one dot.
std::vector<float> coverage_by_load(const PlainDots& dots);

/// The mean of that over kCoverageSets constant greys by a method, from `fewest` dots up to just below
/// `factor` times as many, each with another seed. None if stopped.
std::vector<float> mean_coverage_by_load(const std::function<PlainDots(const DotsWanted&)>& method,
                                         std::size_t fewest, double factor, const std::stop_token& stop = {});
inline constexpr int kCoverageSets = 8;

}  // namespace dapple
