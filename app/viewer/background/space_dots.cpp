#include "app/viewer/background/space_dots.h"

#include "app/viewer/background/dot_colours.h"
#include "core/volume/settle_volume.h"
#include "core/volume/volume.h"

namespace dapple {
namespace {

constexpr int kSteps = 20, kVoxels = 64;  // along a side
constexpr glm::vec3 kInk(0.08f, 0.13f, 0.28f), kOwnInk(0.05f), kEdgeInk(0.1f);

Volume volume_of(SpaceVolume volume) {
    switch (volume) {
        case SpaceVolume::cube:
            return cube_volume(kVoxels);
        case SpaceVolume::ball:
            return ball_volume(kVoxels);
        case SpaceVolume::gyroid:
            return gyroid_volume(kVoxels);
    }
    return {};
}

// Paler below.
glm::vec3 colour_of_eighth(const glm::dvec3& place) {
    constexpr double kHalf = kVoxels / 2.0;
    const int eighth = (place.x < kHalf ? 0 : 1) + (place.y < kHalf ? 0 : 2) + (place.z < kHalf ? 4 : 0);
    return orientation_colour({static_cast<std::uint8_t>(eighth)});
}

// As rows of balls that touch: so they hide others, and are hidden.
void add_edges(std::vector<Ball>& balls) {
    constexpr int kALine = 256;
    for (int axis = 0; axis < 3; ++axis)
        for (int line = 0; line < 9; ++line) {
            const int across = line % 3, up = line / 3;
            const double radius = across == 1 || up == 1 ? 0.16 : 0.3;
            for (int i = 0; i <= kALine; ++i) {
                glm::dvec3 place;
                place[axis] = double{kVoxels} * i / kALine;
                place[(axis + 1) % 3] = across * kVoxels / 2.0;
                place[(axis + 2) % 3] = up * kVoxels / 2.0;
                balls.push_back({place, radius, kEdgeInk});
            }
        }
}

}  // namespace

SpaceDots dots_in_space(const SpaceChoice& choice, const std::function<bool(const SpaceDots&)>& tell) {
    static const CyclicTile<2, 3> tile = volume_tile();  // takes longer than its dots
    const Volume volume = volume_of(choice.volume);
    SpaceDots dots{.choice = choice,
                   .places = place_in_volume(tile, volume, static_cast<std::size_t>(choice.dots)),
                   .all_steps = choice.settled ? kSteps : 0};
    // The order of the subdivision begins with them, in the tile's.
    for (const glm::dvec3& point : tile.points)
        if (dots.of_tile < dots.places.size() && dots.places[dots.of_tile] == point * double{kVoxels})
            ++dots.of_tile;
    if (tell && !tell(dots)) return dots;
    settle(dots.places, volume, dots.all_steps, [&](int step) {
        dots.steps = step;
        return !tell || tell(dots);
    });
    return dots;
}

Background<SpaceDots>::Work space_work(const SpaceChoice& choice) {
    return [choice](const Background<SpaceDots>::Task& task) -> std::optional<SpaceDots> {
        dots_in_space(choice, [&task](const SpaceDots& dots) {
            task.publish(dots);
            return !task.stop().stop_requested();
        });
        return std::nullopt;
    };
}

Box space_box() {
    return {glm::dvec3(0), glm::dvec3(kVoxels)};
}

std::vector<Ball> balls_of(const SpaceDots& dots, bool boundaries) {
    constexpr double kLarger = 1.3, kLeast = 0.8;
    const double radius = ball_radius(space_box(), dots.places.size());
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < dots.places.size(); ++i) {
        const glm::dvec3& place = dots.places[i];
        if (!boundaries)
            balls.push_back({place, radius, kInk});
        else if (i < dots.of_tile)
            balls.push_back({place, std::max(kLarger * radius, kLeast), kOwnInk});
        else
            balls.push_back({place, radius, colour_of_eighth(place)});
    }
    if (boundaries) add_edges(balls);
    return balls;
}

}  // namespace dapple
