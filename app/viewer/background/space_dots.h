#pragma once
// Dots in space, placed and settled in the background as `dapple volume` does it.

#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "app/viewer/background/background.h"
#include "core/volume/turning_view.h"

namespace dapple {

enum class SpaceVolume { cube, ball, gyroid };

/// Which dots.
struct SpaceChoice {
    SpaceVolume volume = SpaceVolume::gyroid;
    int dots = 10'000;
    bool settled = true;  // or as placed

    bool operator==(const SpaceChoice&) const = default;
};
inline constexpr int kFewestSpaceDots = 100, kMostSpaceDots = 100'000;

/// The same, and how they are looked at: see TurnedView.
struct SpaceSettings {
    SpaceChoice choice{};
    bool turning = true;  // by itself
    double turn = 0.07, down = 0.35;
};

struct SpaceDots {
    SpaceChoice choice{};
    std::vector<glm::dvec3> places;  // in voxels
    std::size_t of_tile = 0;         // of them, the first: points of the tile itself, not of its parts
    int steps = 0, all_steps = 0;    // that they have settled
};

/// Tells of them as placed and after each step, and ends there if that returns false.
SpaceDots dots_in_space(const SpaceChoice& choice, const std::function<bool(const SpaceDots&)>& tell = {});
Background<SpaceDots>::Work space_work(const SpaceChoice& choice);

/// All around them: the cube that the tile fills.
Box space_box();

/// As they are to be seen. With boundaries: each eighth of the cube in a colour of its own, the tile's own
/// points dark and large, and the edges of the cube and its eighths.
std::vector<Ball> balls_of(const SpaceDots& dots, bool boundaries);

}  // namespace dapple
