#include "app/viewer/model/variations.h"

#include <algorithm>
#include <cmath>

#include "core/settings/setting.h"

namespace dapple {
namespace {

constexpr float kToneStep = 0.15f;

DrawingSettings with_tone(DrawingSettings drawing, const Tone& drawn, float Tone::*part, float by) {
    if (drawing.automatic_tone) drawing.tone = drawn;
    drawing.automatic_tone = false;
    drawing.tone.*part = std::clamp(drawing.tone.*part + by, -1.0f, 1.0f);
    return drawing;
}

double within(double value, const Setting& setting) {
    return std::clamp(value, setting.range.least, setting.range.most);
}

// Dots sized by tone are as many as their sizes ask for.
DrawingSettings with_dots(DrawingSettings drawing, const DrawnInfo& drawn, double times) {
    if (drawing.dot_size.sizing == DotSizing::by_tone) {
        const double larger = 1 / std::sqrt(times);
        drawing.dot_size.smallest_mm = within(drawing.dot_size.smallest_mm * larger, setting::smallest);
        drawing.dot_size.largest_mm = within(drawing.dot_size.largest_mm * larger, setting::largest);
    } else if (drawing.placing.count) {
        const double count = std::round(static_cast<double>(*drawing.placing.count) * times);
        const double most = static_cast<double>(drawn.most_dots);
        drawing.placing.count = static_cast<std::uint64_t>(std::clamp(count, 1.0, std::max(most, 1.0)));
    } else {
        drawing.placing.scale *= times;
    }
    return drawing;
}

DrawingSettings sized_otherwise(DrawingSettings drawing, const DrawnInfo& drawn) {
    const bool by_tone = drawing.dot_size.sizing == DotSizing::by_tone;
    drawing.dot_size =
        dot_size_from(by_tone ? DotSizing::automatic : DotSizing::by_tone, drawn.dot_radius_mm);
    return drawing;
}

DrawingSettings inked_otherwise(DrawingSettings drawing) {
    drawing.pens.set = drawing.pens.set == PenSet::one ? PenSet::cmyk : PenSet::one;
    return drawing;
}

DrawingSettings drawn_otherwise(DrawingSettings drawing) {
    drawing.style = drawing.style == DrawingStyle::dots ? DrawingStyle::line : DrawingStyle::dots;
    return drawing;
}

}  // namespace

std::array<Variation, 9> variations_of(const DrawingSettings& now, const DrawnInfo& drawn) {
    const bool by_tone = now.dot_size.sizing == DotSizing::by_tone;
    return {Variation{"lighter", with_tone(now, drawn.tone, &Tone::brightness, kToneStep)},
            {"more contrast", with_tone(now, drawn.tone, &Tone::contrast, kToneStep)},
            {"darker", with_tone(now, drawn.tone, &Tone::brightness, -kToneStep)},
            {"fewer dots", with_dots(now, drawn, 0.5)},
            {"as it is", now},
            {"more dots", with_dots(now, drawn, 2)},
            {by_tone ? "one size" : "sized by tone", sized_otherwise(now, drawn)},
            {now.pens.set == PenSet::one ? "in colour" : "one ink", inked_otherwise(now)},
            {now.style == DrawingStyle::dots ? "one line" : "dots", drawn_otherwise(now)}};
}

}  // namespace dapple
