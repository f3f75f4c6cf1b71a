#include "core/drawing/relaxed_stream.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>

#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"

namespace dapple {

namespace {

// What all bands have in common.
class Bands {
 public:
    Bands(Placer& placer, const Density& density, const StreamRequest& request, int steps,
          const RelaxingRequest& relaxing, const std::stop_token& stop)
        : placer_(placer),
          density_(density),
          request_(request),
          steps_(steps),
          relaxing_(relaxing),
          stop_(stop) {
        request_.placing = placing_of(placer, density, request);
        relaxing_.scale = scale();
        relaxing_.threads = request_.placing.threads;
        relaxing_.stirring = stirring_of(placer.table(), scale());
        share_work(placer, density, request_.placing, steps, relaxing_);
    }

    double scale() const { return request_.placing.scale; }

    bool has_whole_page() const {
        const double longer = density_.longer_side();
        const auto has_all = [](const PageSpan& span, double length) {
            return span.first <= 0 && span.end > length;
        };
        return has_all(request_.part.across, density_.width() / longer) &&
               has_all(request_.part.down, density_.height() / longer);
    }

    // The bands' edges, whole rows of the relaxation: the order is then that of the page.
    std::vector<double> edges(std::uint64_t dots_at_once) const {
        const double longer = density_.longer_side();
        const double width = density_.width() / longer, height = density_.height() / longer;
        const auto on_page = [](const PageSpan& span, double length) {
            return std::pair(std::clamp(double{span.first}, 0.0, length),
                             std::clamp(double{span.end}, 0.0, length));
        };
        const auto [left, right] = on_page(request_.part.across, width);
        const auto [top, bottom] = on_page(request_.part.down, height);
        const double dots =
            expected_dots(density_, scale()) * (right - left) / width / height;  // a page unit
        const double row = relaxing_row(scale());
        const double rows =
            std::max(1.0, std::floor(static_cast<double>(dots_at_once) / std::max(dots * row, 1e-9)));
        std::vector<double> edges;
        for (double edge = std::floor(top / row) + rows; edge * row < bottom; edge += rows)
            edges.push_back(edge * row);
        return edges;
    }

    // The dots of the part between two edges; without one, up to the part's own. None if stopped.
    Dots band(std::optional<double> top, std::optional<double> bottom) {
        PagePart part = request_.part;
        if (top) part.down.first = std::max(part.down.first, static_cast<float>(*top));
        if (bottom) part.down.end = std::min(part.down.end, static_cast<float>(*bottom));
        const StreamRequest band{.placing = request_.placing, .part = part};
        DotPieces dots;
        Dots result;
        const PlacingRequest around = placing_of(placer_, density_, band, relaxing_rim(scale(), steps_));
        if (!placer_.place(density_, around, dots, stop_) || !relax(dots, density_, steps_, relaxing_, stop_))
            return result;
        for (Dots& piece : dots.pieces) {
            if (request_.finish) request_.finish(piece);
            cut_to(part, piece);
            append(result, piece);
        }
        return result;
    }

 private:
    Placer& placer_;
    const Density& density_;
    StreamRequest request_;
    int steps_;
    RelaxingRequest relaxing_;
    std::stop_token stop_;
};

}  // namespace

DotStream SettledDots::on(Placer& placer, const Density& density, const StreamRequest& request, int steps,
                          const RelaxingRequest& relaxing, const std::stop_token& stop) {
    const std::lock_guard lock(mutex_);
    if (!dots_) {
        auto all = std::make_shared<DotPieces>();
        const auto scale = placer.place(density, request.placing, *all, stop);
        if (!scale || !relax(*all, density, steps, relaxing, stop)) return {};
        if (request.finish)
            for (Dots& piece : all->pieces) request.finish(piece);
        scale_ = *scale;
        dots_ = std::move(all);
    }
    if (request.part == PagePart{}) return stream_of(dots_, scale_);
    DotPieces part = *dots_;
    for (Dots& piece : part.pieces) cut_to(request.part, piece);
    return stream_of(std::make_shared<const DotPieces>(std::move(part)), scale_);
}

std::shared_ptr<const Displacement> carried(Placer& placer, const Density& density,
                                            const PlacingRequest& placing, const RelaxingRequest& relaxing) {
    const Warp warp(
        density,
        {.scale = relaxing.scale, .dots = expected_dots(density, relaxing.scale), .areas = relaxing.areas});
    Warp::Count count(warp);
    PlacingRequest page = placing;
    page.window = {};
    const auto rows = static_cast<float>(1 / relaxing_row(relaxing.scale));
    placer.hand_over(density, page, [&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const glm::dvec2 place(piece.x[i], piece.y[i]);
            const float area =
                relaxing.areas.differ() ? relaxing.areas.at(static_cast<float>(density.at(place)), place) : 1;
            count.add(rows * piece.x[i], rows * piece.y[i], area);
        }
        return true;
    });
    return std::make_shared<const Displacement>(count.displacement());
}

void share_work(Placer& placer, const Density& density, const PlacingRequest& placing, int steps,
                RelaxingRequest& relaxing) {
    if (!relaxing.carried && !relaxing.keeps_density)
        relaxing.carried = carried(placer, density, placing, relaxing);
    for (const RelaxingStep& step : relaxing_steps(steps, relaxing)) {
        if (relaxing.blurred || step.kind != RelaxingStep::Kind::energy) continue;
        relaxing.blurred = std::make_shared<const BlurredDensity>(
            blurred_for_kernels(density, relaxing.scale, step.kernel, relaxing.areas));
    }
}

DotStream relaxed_stream(Placer& placer, const Density& density, const StreamRequest& request, int steps,
                         std::uint64_t dots_at_once, const std::stop_token& stop,
                         const RelaxingRequest& relaxing) {
    Bands bands(placer, density, request, steps, relaxing, stop);
    DotStream result;
    result.scale = bands.scale();
    const std::vector<double> edges = bands.edges(dots_at_once);
    if (edges.empty()) {
        const auto kept = std::make_shared<const Dots>(bands.band({}, {}));
        result.count = kept->size();
        result.for_each_piece = [kept](const TakePiece& take) {
            if (kept->size() > 0) take(*kept);
        };
        return result;
    }
    result.for_each_piece = [bands, edges, threads = request.placing.threads](const TakePiece& take) mutable {
        const auto policy = threads == 1 ? std::launch::deferred : std::launch::async;
        const auto begin = [&](std::size_t i) {
            return std::async(policy, [&bands, &edges, i] {
                return bands.band(i == 0 ? std::nullopt : std::optional(edges[i - 1]),
                                  i == edges.size() ? std::nullopt : std::optional(edges[i]));
            });
        };
        // While a band is taken, the next one is made, and no more than that.
        std::future<Dots> next = begin(0);
        for (std::size_t i = 0; i <= edges.size(); ++i) {
            const Dots band = next.get();
            if (i < edges.size()) next = begin(i + 1);
            if (band.size() > 0 && !take(band)) return;
        }
    };
    // No dot leaves the page or comes to it.
    if (bands.has_whole_page()) {
        result.count = stream(placer, density, {.placing = request.placing, .part = request.part}).count;
        return result;
    }
    result.for_each_piece([&](const Dots& band) {
        result.count += band.size();
        return true;
    });
    return result;
}

}  // namespace dapple
