#include "tests/bench/relaxed_dots.h"

namespace dapple {

double processor_ms_since(std::clock_t start) {
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

RelaxedDots relaxed_dots(Pipeline& pipeline, std::size_t count, int steps) {
    DrawingSettings request;
    request.automatic_tone = false;
    request.tone = {};
    request.placing = {.count = count, .threads = 0};
    request.relax = steps;
    request.page.margins = Margins{};  // so that the page ends with the picture
    const DrawingPlan plan = pipeline.plan(request);
    Stippling drawn;
    const std::clock_t start = std::clock();
    pipeline.draw(plan, drawn);
    const double ms = processor_ms_since(start);
    RelaxedDots result{
        .density = plan.density, .scale = drawn.scale, .radius = plan.radius(drawn.scale), .ms = ms};
    result.dots.reserve(drawn.dots.size());
    for_each_position(drawn.dots, [&](float x, float y) { result.dots.emplace_back(x, y); });
    return result;
}

}  // namespace dapple
