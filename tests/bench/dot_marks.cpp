#include "tests/bench/dot_marks.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/analysis/autocorrelation.h"
#include "core/analysis/periodogram.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"
#include "lab/analysis/seams.h"

namespace dapple {

DotMarks dot_marks(const std::vector<glm::dvec2>& points, double load) {
    const Domain torus{};
    const std::vector<glm::dvec2> inside = points_inside(points, torus);
    const Periodogram spectrum = periodogram(inside, torus);
    const Peaks peaks = spectral_peaks(spectrum);
    return {peaks.highest_bin,
            peaks.top_share,
            low_frequency_power(spectrum, 0.3),
            low_frequency_power(spectrum, 0.5),
            nearest_summary(inside, torus),
            seams(points, load).worst(),
            low_frequency_power(spectrum, 0.1, 0.03),
            low_frequency_power(spectrum, 0.3, 0.1)};
}

std::vector<glm::dvec2> stirred_on_torus(const std::vector<glm::dvec2>& points, double scale) {
    const auto apart = static_cast<float>(1 / std::sqrt(kDotsPerScale * scale));
    std::vector<glm::dvec2> result;
    for (const glm::dvec2 p : points)
        result.push_back(glm::fract(p + glm::dvec2(stirring_at(glm::vec2(p), apart))));
    return result;
}

std::vector<glm::dvec2> relaxed_on_torus(const std::vector<glm::dvec2>& points, double scale, int steps,
                                         float kernel) {
    if (steps == 0) return points;
    const double rim = relaxing_rim(scale, steps), side = 1 + 2 * rim;
    Dots dots;
    const auto add = [&](glm::dvec2 p) {
        dots.x.push_back(static_cast<float>((p.x + rim) / side));
        dots.y.push_back(static_cast<float>((p.y + rim) / side));
    };
    for (const glm::dvec2 p : points) add(p);
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            if (i == 0 && j == 0) continue;
            for (const glm::dvec2 p : points) {
                const glm::dvec2 copy = p + glm::dvec2(i, j);
                if (glm::all(glm::greaterThan(copy, glm::dvec2(-rim))) &&
                    glm::all(glm::lessThan(copy, glm::dvec2(1 + rim))))
                    add(copy);
            }
        }
    }
    const Density grey(Grid<float>(1, 1, 1.0f));
    DotPieces pieces;
    pieces.pieces.push_back(std::move(dots));
    const RelaxingRequest relaxing{
        .scale = scale * side * side, .threads = 0, .keeps_density = kernel == kSampleKernel};
    Relaxation relaxation(std::move(pieces), grey, relaxing);
    for (const RelaxingStep& how : relaxing_steps(steps, relaxing))
        if (how.kind != RelaxingStep::Kind::warp) relaxation.step(how);  // these see edges
    const Dots moved = relaxation.dots_as_taken();
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < points.size(); ++i)
        result.push_back(glm::fract(glm::dvec2(moved.x[i], moved.y[i]) * side - rim));
    return result;
}

double coincidence(const std::vector<glm::dvec2>& points, double tile_side) {
    const Domain torus{};
    return periodicity(points_inside(points, torus), torus, {tile_side, tile_side}).value;
}

}  // namespace dapple
