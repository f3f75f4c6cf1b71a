#pragma once
// Samples in an order in which the first few stand for all as well as so few can.

#include <cstdint>
#include <span>
#include <vector>

#include "core/lights/light_samples.h"

namespace dapple {

/// The numbers of the samples, the most important first. Each of the first n stands for a group of samples
/// about itself; the next one parts the group whose light is spread out most. The first n become a set of
/// their own by giving the weight of every other sample to the nearest of them, and, if they may move, by
/// going to the middle of what they got.
std::vector<std::uint32_t> priority_order(std::span<const LightSample> samples);

}  // namespace dapple
