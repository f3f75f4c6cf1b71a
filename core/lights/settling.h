#pragma once
// Lights that settle on the sphere: each stands for the texels that it is nearest to by angle, moves to the
// middle of their power, and so on for some steps (Lloyd 1982).
//
// Where lights have gathered more densely than there are texels, as on a sun, some are nearest to none. These
// go where power is spread out most, so that in the end each has some.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/image/environment.h"
#include "core/image/grid.h"
#include "core/lights/light_samples.h"
#include "core/watch.h"

namespace dapple {

/// What some texels come to.
struct TexelSum {
    glm::dvec3 flux{};       // linear RGB
    double solid_angle = 0;  // steradians
    double power = 0;
    glm::dvec3 moment{};  // the sum of power * direction, directions as in OpenEXR

    TexelSum& operator+=(const TexelSum& other);
};

/// A map's texels in squares of more and more of them, for the lights that are nearest to each. Both have to
/// live on. `power` is what lights are drawn to, a value of 0 or more a texel; texels with a negative one are
/// left out of everything.
class TexelTree {
 public:
    TexelTree(const EnvironmentMap& map, const Grid<float>& power, int threads);

    /// The sum of the texels that are nearest to each light, in double precision: of unit vectors, at least
    /// one. Ties go to the first. Nothing if stopped; `watch` is told of shares from 0 to 1.
    std::optional<std::vector<TexelSum>> nearest_to(std::span<const glm::dvec3> lights,
                                                    const Watch& watch) const;

    /// The number of the light that is nearest to each texel.
    Grid<std::uint32_t> nearest_of(std::span<const glm::dvec3> lights) const;

    enum class Most {
        power,
        spread,  // power times the square of the distance to the light
    };
    /// For each of some of the lights, of the texels that are nearest to it, the one with the most of that.
    std::vector<glm::ivec2> texels_with(Most most, std::span<const glm::dvec3> lights,
                                        std::span<const std::size_t> which) const;

    glm::dvec3 direction(int column, int row) const;

    /// Of a texel; zero if it is left out. And of it and the eight around it.
    TexelSum texel(int column, int row) const;
    TexelSum around(glm::ivec2 texel) const;

 private:
    struct Square {
        int level, column, row;
    };
    struct Task {
        Square square;
        std::vector<std::uint32_t> lights;  // that may be nearest to a texel of it
    };
    template <class Texel>
    void for_each_texel(const Square& square, const Texel& texel) const;
    template <class Result, class Whole, class Texel>
    bool for_each_light(std::span<const glm::dvec3> lights, const Watch& watch, const Whole& whole,
                        const Texel& texel, std::vector<Result>& results) const;
    // Calls whole(square, light) for the largest squares all of whose texels are nearest to one light, and
    // of smaller ones texel(column, row, light).
    template <class Whole, class Texel>
    class Descent;

    std::vector<Task> tasks(std::span<const glm::dvec3> lights) const;

    const EnvironmentMap& map_;
    const Grid<float>& power_;
    std::size_t threads_;
    std::vector<double> around_cosine_, around_sine_, down_cosine_, down_sine_, solid_angle_;
    std::vector<Grid<TexelSum>> levels_;  // of squares of 4 texels a side, 8, ...
};

/// Moves lights for so many steps, and returns what each then stands for; all have power if there are as many
/// texels with some. Nothing if stopped.
std::optional<std::vector<TexelSum>> settle(const TexelTree& tree, std::vector<glm::dvec3>& lights, int steps,
                                            const Watch& watch = {});

}  // namespace dapple
