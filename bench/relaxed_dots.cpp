#include "bench/relaxed_dots.h"

namespace dapple {

RelaxedDots relaxed_dots(Pipeline& pipeline, std::size_t count, int steps) {
    DrawingRequest request;
    request.automatic_tone = false;
    request.placing = {.count = count, .threads = 0};
    request.relax = steps;
    const DrawingPlan plan = pipeline.plan(request);
    Stippling drawn;
    pipeline.draw(plan, drawn);
    RelaxedDots result{.density = plan.density,
                       .scale = drawn.scale,
                       .radius = plan.radius(drawn.scale),
                       .ms = drawn.place_ms + drawn.relax_ms};
    result.dots.reserve(drawn.dots.size());
    for_each_position(drawn.dots, [&](float x, float y) { result.dots.emplace_back(x, y); });
    return result;
}

}  // namespace dapple
