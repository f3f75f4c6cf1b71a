#include "app/commands/render_page.h"

#include <fmt/format.h>

#include <stdexcept>

namespace dapple {

bool draws_whole_page(const RenderOptions& options) {
    return !options.saving.region && options.sheet == Sheet{};
}

PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options) {
    const PageSetup& setup = options.drawing.page;
    PageSetup uncut = setup;
    uncut.fit = PageFit::inside;
    const glm::ivec2 cropped = with_option("--crop", [&] {
                                   if (setup.crop) check_crop(*setup.crop, picture);
                                   return framing_of(uncut, picture);
                               }).size();
    static_cast<void>(with_option("--margin", [&] { return layout_of(setup, cropped); }));
    const glm::ivec2 size = framing_of(setup, picture).size();
    const PageLayout layout = with_option(
        "--dot-radius", [&] { return layout_of(setup, size, {.mm = reach_mm(options.drawing.dot_size)}); });
    const double width = layout.page.width_mm, height = layout.page.height_mm;
    const auto too_long = [&](const char* given, double side, const char* is, const char* becomes,
                              double other) {
        return std::runtime_error(fmt::format(
            "{}: {} x {} pixels would make a page {:g} mm {} and {:.4g} m {}, and {:g} m is the most; "
            "choose a {} of {:.2g} or less",
            name_of_image(options), size.x, size.y, side, is, other / 1000, becomes, kLongestSideMm / 1000,
            given, side * kLongestSideMm / other * 0.95));
    };
    if (setup.paper != Paper::as_picture) return layout;
    if (height > kLongestSideMm) throw too_long("--width", width, "wide", "high", height);
    if (width > kLongestSideMm) throw too_long("--height", height, "high", "wide", width);
    return layout;
}

DrawnPage page_for(const PageLayout& layout, const RenderOptions& options) {
    if (options.saving.region)
        return with_option("--region", [&] { return drawn_page(layout, options.saving); });
    return with_option("--overlap", [&] { return drawn_page(layout, options.sheet); });
}

}  // namespace dapple
