#include "core/relaxing/relax.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/placing/pieces.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/energy_steps.h"
#include "core/relaxing/lloyd_steps.h"
#include "core/relaxing/stir.h"

namespace dapple {

namespace {

// Densities over which the one kind of step passes into the other.
constexpr float kEvenWithin = 0.1f;

// Strides of both kinds that do about as much.
constexpr float kLloydToEnergy = 3;

// A warp carries no dot farther than so many distances to the next: sparse ones do not cross white gaps.
constexpr float kMostWarped = 0.5f;
constexpr float kLeastWarped = 1e-6f;  // of the density, below which dots are no farther apart

constexpr std::size_t kDotsAtOnce = 2048;  // on a thread, about

// Steps of dots, row after row, and where they end.
class Mover {
 public:
    Mover(const DotRows& rows, const Density& density, const RelaxingRequest& request)
        : rows_(rows), density_(density), page_(density, request.scale), request_(request) {}

    // By a step: after so many.
    void by(const RelaxingStep& how, int taken) {
        how_ = how;
        taken_ = taken;
        lloyd_.emplace(rows_, density_, page_);
        if (how.kind == RelaxingStep::Kind::energy)
            energy_.emplace(rows_, *request_.blurred, page_, how.kernel, request_.areas, request_.ink);
    }

    void move_row(std::int64_t row, DotRows::Positions& to_x, DotRows::Positions& to_y) {
        lloyd_->begin_row(row);
        if (energy_) energy_->begin_row(row);
        for (std::size_t i = rows_.begin(row); i < rows_.end(row); ++i) {
            const float tone = tone_at(rows_.x[i], rows_.y[i]);
            move_dot(i, tone, step_of(i, tone), request_.keeps_density, to_x[i], to_y[i]);
        }
    }

    void warp_row(std::int64_t row, const Displacement& displacement, DotRows::Positions& to_x,
                  DotRows::Positions& to_y) {
        for (std::size_t i = rows_.begin(row); i < rows_.end(row); ++i) {
            const float x = rows_.x[i], y = rows_.y[i];
            const glm::dvec2 place = page_.place(x, y);
            const auto density = static_cast<float>(density_.at(place));
            glm::vec2 way = displacement.at(x, y);
            const float apart = page_.spacing / std::sqrt(std::max(density, kLeastWarped));
            const float most = std::min(kMostWarped * apart, kFarthestWarped), length = glm::length(way);
            if (length > most) way *= most / length;
            move_dot(i, request_.areas.of_tone(density, place), {way.x, way.y}, false, to_x[i], to_y[i]);
        }
    }

 private:
    void move_dot(std::size_t dot, float tone, DotStep step, bool by_chance, float& to_x, float& to_y) const {
        to_x = rows_.x[dot];
        to_y = rows_.y[dot];
        const float chance = by_chance ? chance_at(to_x, to_y, taken_) : 0;
        for (int i = 0; i < kShorterTries; ++i) {
            const float x = std::clamp(to_x + step.x, 0.0f, last_x_);
            const float y = std::clamp(to_y + step.y, 0.0f, last_y_);
            const float there = tone_at(x, y);
            if (by_chance ? keeps_density(tone, there, chance) : there > kLeastShare * tone) {
                to_x = x;
                to_y = y;
                return;
            }
            step.x *= 0.5f;
            step.y *= 0.5f;
        }
    }

    DotStep step_of(std::size_t dot, float tone) {
        if (!energy_) return lloyd_->step(dot, how_.stride);
        const float even = std::clamp((tone - request_.even_from) / kEvenWithin, 0.0f, 1.0f);
        if (even == 0) return energy_->step(dot, how_.stride);
        const DotStep a = lloyd_->step(dot, kLloydToEnergy * how_.stride);
        if (even == 1) return a;
        const DotStep b = energy_->step(dot, how_.stride);
        return {even * a.x + (1 - even) * b.x, even * a.y + (1 - even) * b.y};
    }

    float tone_at(float x, float y) const {
        const glm::dvec2 place = page_.place(x, y);
        return request_.areas.of_tone(static_cast<float>(density_.at(place)), place);
    }

    const DotRows& rows_;
    const Density& density_;
    const PageRows page_;
    const RelaxingRequest& request_;
    // The last places on it: on its right and lower edges there is no density any more.
    const float last_x_ = std::nextafter(page_.width, 0.0f), last_y_ = std::nextafter(page_.height, 0.0f);
    std::optional<LloydSteps> lloyd_;
    std::optional<EnergySteps> energy_;
    RelaxingStep how_;
    int taken_ = 0;
};

FloatBuffer in_one_column(const DotPieces& dots, FloatBuffer Dots::*column) {
    FloatBuffer values;
    for (const Dots& piece : dots.pieces)
        values.insert(values.end(), (piece.*column).begin(), (piece.*column).end());
    return values;
}

}  // namespace

// The first ones carry ink far, along thin lines too, where kernels would not reach from dot to dot. Then
// strides are short and long by turns, which evens dots out in fewer steps than any one stride: long ones
// overshoot what is rough, and short ones mend it (Altschuler & Parrilo 2023). The last one's wider kernel is
// for what is a few dots wide; where steps are few they make dots even and nothing else.
std::vector<RelaxingStep> relaxing_steps(int steps, const RelaxingRequest& request) {
    using Kind = RelaxingStep::Kind;
    constexpr RelaxingStep kFirst{Kind::lloyd, 3}, kLast{Kind::energy, 0.6f, kPictureKernel};
    constexpr RelaxingStep kShort{Kind::energy, 0.4f, kEvenKernel}, kLong{Kind::energy, 1.2f, kEvenKernel};
    constexpr RelaxingStep kOfSamples{Kind::energy, 0.5f, kSampleKernel}, kWarp{Kind::warp};
    constexpr int kLloydOfSamples = 4, kStepsToOneOfLloyd = 6, kFew = 3;
    const bool few = steps <= kFew;
    std::vector<RelaxingStep> all;
    if (steps == 0) return all;
    for (int i = 0; i < steps; ++i) {
        if (request.keeps_density)
            all.push_back(i < kLloydOfSamples ? RelaxingStep{} : kOfSamples);
        else if (i == steps - 1)
            all.push_back(few ? kShort : kLast);
        else if (few || i <= steps / kStepsToOneOfLloyd)
            all.push_back(i == 0 ? kFirst : RelaxingStep{});
        else
            all.push_back(i % 2 == 1 ? kShort : kLong);
    }
    // Samples keep their share of each side of an edge, which a smooth displacement carries them over.
    if (request.carried || request.keeps_density) return all;
    all.insert(all.end() - 1, kWarp);
    all.insert(all.end(), 2, kWarp);
    return all;
}

double relaxing_rim(double scale, int steps) {
    // A step looks as far as dots cut cells, and the dots it finds came from a step's length further away;
    // the first from where they were stirred and carried.
    constexpr double kRows = double{LloydSteps::kCellReach} + LloydSteps::kFarthestRow + 1;
    static_assert(kRows >= EnergySteps::kFarthestRow + 1 + EnergySteps::kLongestStep);
    const double row = relaxing_row(scale);
    return (steps * kRows + double{kFarthestWarped}) * row + farthest_stirred(scale);
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
    if (request.carried) warp(*request.carried);
}

template <class Take>
void Relaxation::on_stretches(const std::stop_token& stop, const Take& take) const {
    std::vector<std::int64_t> ends;
    std::size_t begun = 0;
    for (std::int64_t row = 0; row < rows_.rows(); ++row) {
        if (rows_.end(row) - begun < kDotsAtOnce && row + 1 < rows_.rows()) continue;
        ends.push_back(row + 1);
        begun = rows_.end(row);
    }
    for_each_on_threads(ends.size(), threads_for(request_.threads), [&](std::size_t i) {
        if (!stop.stop_requested()) take(i == 0 ? 0 : ends[i - 1], ends[i]);
    });
}

void Relaxation::find_areas(const std::stop_token& stop) {
    rows_.areas.resize(rows_.size());
    on_stretches(stop, [&](std::int64_t first, std::int64_t end) {
        const PageRows page(density_, request_.scale);
        for (std::size_t i = rows_.begin(first); i < rows_.begin(end); ++i) {
            const glm::dvec2 place = page.place(rows_.x[i], rows_.y[i]);
            rows_.areas[i] = request_.areas.at(static_cast<float>(density_.at(place)), place);
        }
    });
}

void Relaxation::find_radii() {
    const FloatBuffer radius = in_one_column(placed_, &Dots::radius);
    rows_.radii2.resize(rows_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto in_rows = static_cast<float>(std::ldexp(radius[rows_.numbers[i]], depth_));
        rows_.radii2[i] = in_rows * in_rows;
    }
    rows_.most_radius2 = rows_.radii2.empty() ? 0 : std::ranges::max(rows_.radii2);
}

bool Relaxation::step(const RelaxingStep& how, const std::stop_token& stop) {
    using Kind = RelaxingStep::Kind;
    if (how.kind != Kind::lloyd && request_.areas.differ()) find_areas(stop);
    if (how.kind == Kind::warp) {
        if (stop.stop_requested()) return false;
        warp_by_all();
        return true;
    }
    if (how.kind == Kind::energy && !request_.blurred)
        request_.blurred = std::make_shared<const BlurredDensity>(
            blurred_for_kernels(density_, request_.scale, how.kernel, request_.areas));
    if (request_.by_radius) find_radii();
    next_x_.resize(rows_.size());
    next_y_.resize(rows_.size());
    on_stretches(stop, [&](std::int64_t first, std::int64_t end) {
        Mover mover(rows_, density_, request_);
        mover.by(how, taken_);
        for (std::int64_t row = first; row < end; ++row) mover.move_row(row, next_x_, next_y_);
    });
    if (stop.stop_requested()) return false;
    ++taken_;
    rows_.move(next_x_, next_y_, request_.threads);
    return true;
}

void Relaxation::warp_by_all() {
    if (!warp_)
        warp_ = std::make_shared<const Warp>(density_, WarpRequest{.scale = request_.scale,
                                                                   .dots = static_cast<double>(rows_.size()),
                                                                   .areas = request_.areas,
                                                                   .ink = request_.light,
                                                                   .cut_off = request_.cut_off});
    warp(warp_->displacement(rows_));
}

DotPieces Relaxation::dots_warped() {
    const DotRows before = rows_;
    step({RelaxingStep::Kind::warp});
    DotPieces result = dots();
    rows_ = before;
    return result;
}

void Relaxation::warp(const Displacement& displacement) {
    next_x_.resize(rows_.size());
    next_y_.resize(rows_.size());
    on_stretches({}, [&](std::int64_t first, std::int64_t end) {
        Mover mover(rows_, density_, request_);
        for (std::int64_t row = first; row < end; ++row) mover.warp_row(row, displacement, next_x_, next_y_);
    });
    rows_.move(next_x_, next_y_, request_.threads);
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
    for (const RelaxingStep& how : relaxing_steps(steps, request))
        if (!relaxation.step(how, stop)) return false;
    dots = relaxation.dots();
    return true;
}

}  // namespace dapple
