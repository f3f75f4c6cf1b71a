#include "core/relaxing/relax.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/placing/pieces.h"
#include "core/placing/placer_memory.h"
#include "core/relaxing/energy_steps.h"
#include "core/relaxing/lloyd_steps.h"
#include "core/relaxing/page_rows.h"
#include "core/relaxing/random_bits.h"
#include "core/relaxing/stir.h"

namespace dapple {

namespace {

// A dot stays where the ink is: it does not go where there is less than this share of the tone that it comes
// from.
constexpr float kLeastShare = 0.25f;
constexpr int kShorterTries = 3;

// Densities over which the one kind of step passes into the other.
constexpr float kEvenWithin = 0.1f;

constexpr std::size_t kDotsAtOnce = 2048;  // on a thread, about

// Moves dots, row after row.
class Mover {
 public:
    // Without a blurred density by Lloyd's steps alone. After so many steps.
    Mover(const DotRows& rows, const Density& density, const RelaxingRequest& request,
          const BlurredDensity* blurred, int taken)
        : rows_(rows),
          density_(density),
          page_(density, request.scale),
          lloyd_(rows, density, page_),
          areas_(request.areas),
          keeps_density_(request.keeps_density),
          taken_(taken) {
        if (blurred) energy_.emplace(rows, *blurred, page_, request.kernel, request.areas, request.ink);
        even_from_ = request.even_from;
    }

    void move_row(std::int64_t row, DotRows::Positions& to_x, DotRows::Positions& to_y) {
        lloyd_.begin_row(row);
        if (energy_) energy_->begin_row(row);
        for (std::size_t i = rows_.begin(row); i < rows_.end(row); ++i) move_dot(i, to_x[i], to_y[i]);
    }

 private:
    void move_dot(std::size_t dot, float& to_x, float& to_y) {
        to_x = rows_.x[dot];
        to_y = rows_.y[dot];
        const float tone = tone_at(to_x, to_y);
        DotStep step = step_of(dot, tone);
        const float chance = keeps_density_ ? chance_at(to_x, to_y, taken_) : 0;
        for (int i = 0; i < kShorterTries; ++i) {
            const float x = std::clamp(to_x + step.x, 0.0f, last_x_);
            const float y = std::clamp(to_y + step.y, 0.0f, last_y_);
            const float there = tone_at(x, y);
            if (keeps_density_ ? keeps_density(tone, there, chance) : there > kLeastShare * tone) {
                to_x = x;
                to_y = y;
                return;
            }
            step.x *= 0.5f;
            step.y *= 0.5f;
        }
    }

    DotStep step_of(std::size_t dot, float tone) {
        if (!energy_) return lloyd_.step(dot);
        const float even = std::clamp((tone - even_from_) / kEvenWithin, 0.0f, 1.0f);
        if (even == 0) return energy_->step(dot);
        const DotStep a = lloyd_.step(dot);
        if (even == 1) return a;
        const DotStep b = energy_->step(dot);
        return {even * a.x + (1 - even) * b.x, even * a.y + (1 - even) * b.y};
    }

    float tone_at(float x, float y) const {
        const glm::dvec2 place = page_.place(x, y);
        return areas_.of_tone(static_cast<float>(density_.at(place)), place);
    }

    const DotRows& rows_;
    const Density& density_;
    const PageRows page_;
    // The last places on it: on its right and lower edges there is no density any more.
    const float last_x_ = std::nextafter(page_.width, 0.0f), last_y_ = std::nextafter(page_.height, 0.0f);
    LloydSteps lloyd_;
    std::optional<EnergySteps> energy_;
    const DotAreas& areas_;
    float even_from_ = 0;
    bool keeps_density_;
    int taken_;
};

FloatBuffer in_one_column(const DotPieces& dots, FloatBuffer Dots::*column) {
    FloatBuffer values;
    for (const Dots& piece : dots.pieces)
        values.insert(values.end(), (piece.*column).begin(), (piece.*column).end());
    return values;
}

}  // namespace

double relaxing_rim(double scale, int steps) {
    // A step looks as far as dots cut cells, and the dots it finds came from a step's length further away;
    // the first from where they were stirred.
    constexpr double kRows = double{LloydSteps::kCellReach} + LloydSteps::kFarthestRow + 1;
    static_assert(kRows >= EnergySteps::kFarthestRow + 1 + EnergySteps::kLongestStep);
    const double step = std::ldexp(kRows, -PageRows::depth_for(scale));
    return steps * step + farthest_stirred(scale);
}

double relaxing_row(double scale) {
    return std::ldexp(1.0, -PageRows::depth_for(scale));
}

Relaxation::Relaxation(DotPieces dots, const Density& density, const RelaxingRequest& request)
    : density_(density),
      request_(request),
      depth_(PageRows::depth_for(request.scale)),
      placed_(std::move(dots)) {
    rows_.assign(placed_, depth_, request.threads);
}

bool Relaxation::step(const std::stop_token& stop) {
    next_x_.resize(rows_.size());
    next_y_.resize(rows_.size());
    const bool by_energy = taken_ >= request_.lloyd_steps;
    if (by_energy && !request_.blurred)
        request_.blurred = std::make_shared<const BlurredDensity>(
            blurred_for_kernels(density_, request_.scale, request_.kernel, request_.areas));
    // Stretches of rows, as many dots in each.
    std::vector<std::int64_t> ends;
    std::size_t begun = 0;
    for (std::int64_t row = 0; row < rows_.rows(); ++row) {
        if (rows_.end(row) - begun < kDotsAtOnce && row + 1 < rows_.rows()) continue;
        ends.push_back(row + 1);
        begun = rows_.end(row);
    }
    const auto on_stretches = [&](const auto& take) {
        for_each_on_threads(ends.size(), threads_for(request_.threads), [&](std::size_t i) {
            if (!stop.stop_requested()) take(i == 0 ? 0 : ends[i - 1], ends[i]);
        });
    };
    if (by_energy && request_.areas.differ()) {
        rows_.areas.resize(rows_.size());
        on_stretches([&](std::int64_t first, std::int64_t end) {
            const PageRows page(density_, request_.scale);
            for (std::size_t i = rows_.begin(first); i < rows_.begin(end); ++i) {
                const glm::dvec2 place = page.place(rows_.x[i], rows_.y[i]);
                rows_.areas[i] = request_.areas.at(static_cast<float>(density_.at(place)), place);
            }
        });
    }
    if (request_.by_radius) {
        const FloatBuffer radius = in_one_column(placed_, &Dots::radius);
        rows_.radii2.resize(rows_.size());
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const auto in_rows = static_cast<float>(std::ldexp(radius[rows_.numbers[i]], depth_));
            rows_.radii2[i] = in_rows * in_rows;
        }
        rows_.most_radius2 = rows_.radii2.empty() ? 0 : std::ranges::max(rows_.radii2);
    }
    on_stretches([&](std::int64_t first, std::int64_t end) {
        Mover mover(rows_, density_, request_, by_energy ? request_.blurred.get() : nullptr, taken_);
        for (std::int64_t row = first; row < end; ++row) mover.move_row(row, next_x_, next_y_);
    });
    if (stop.stop_requested()) return false;
    ++taken_;
    rows_.move(next_x_, next_y_, request_.threads);
    return true;
}

DotPieces Relaxation::dots() const {
    Dots all;
    all.x = rows_.x;
    all.y = rows_.y;
    const auto to_page = static_cast<float>(std::ldexp(1.0, -depth_));
    for (FloatBuffer* column : {&all.x, &all.y})
        for (float& position : *column) position *= to_page;
    for (FloatBuffer Dots::*column : {&Dots::threshold, &Dots::critical, &Dots::radius}) {
        const FloatBuffer values = in_one_column(placed_, column);
        if (values.empty()) continue;
        (all.*column).resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) (all.*column)[i] = values[rows_.numbers[i]];
    }
    return in_one_piece(std::move(all));
}

Dots Relaxation::dots_as_taken() const {
    Dots all;
    all.resize(rows_.size(), false);
    const auto to_page = static_cast<float>(std::ldexp(1.0, -depth_));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        all.x[rows_.numbers[i]] = rows_.x[i] * to_page;
        all.y[rows_.numbers[i]] = rows_.y[i] * to_page;
    }
    return all;
}

bool relax(DotPieces& dots, const Density& density, int steps, const RelaxingRequest& request,
           const std::stop_token& stop) {
    if (steps == 0 || dots.size() == 0) return !stop.stop_requested();
    DotPieces stirred = dots;
    stir(stirred, density, request);
    Relaxation relaxation(std::move(stirred), density, request);
    for (int i = 0; i < steps; ++i)
        if (!relaxation.step(stop)) return false;
    dots = relaxation.dots();
    return true;
}

}  // namespace dapple
