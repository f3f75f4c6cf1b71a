#include "app/commands/render_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace dapple {
namespace {

// What throws for a reason that an option gives, with that option's name.
template <class Make>
auto with_option(const char* option, const Make& make) {
    try {
        return make();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", option, error.what()));
    }
}

// The page, or the part of it that is drawn.
Excerpt excerpt_of(const PageLayout& layout, const RenderOptions& options) {
    const glm::dvec2 corner = layout.picture.low;
    if (!options.region)
        return with_option("--overlap", [&] { return sheet_of(layout.page, options.sheet, corner); });
    const glm::dvec2 size = options.region->size();
    if (std::min(size.x, size.y) < kShortestSideMm) {
        throw std::runtime_error(fmt::format("--region: {:g} x {:g} mm is too small; give {:g} mm or more",
                                             size.x, size.y, kShortestSideMm));
    }
    return with_option("--region", [&] { return region_of(layout.page, *options.region, corner); });
}

}  // namespace

bool draws_whole_page(const RenderOptions& options) {
    return !options.region && options.sheet == Sheet{};
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

DrawnPage drawn_page(const PageLayout& layout, const RenderOptions& options) {
    return {layout, sheet_of(layout.page, {}, layout.picture.low), excerpt_of(layout, options)};
}

bool draws_lines(const DrawingSettings& settings, DrawingFormat format) {
    return settings.style != DrawingStyle::dots && !is_table(format);
}

const Excerpt& placed_on(const DrawnPage& page, const DrawingSettings& settings, DrawingFormat format) {
    return draws_lines(settings, format) ? page.whole : page.part;
}

PagePart reached(const DrawnPage& page, const DrawingSettings& settings, DrawingFormat format,
                 double radius) {
    const PagePart& part = placed_on(page, settings, format).part;
    return has_colours(format) && page.part.part != PagePart{} && !draws_lines(settings, format)
               ? widened(part, radius)
               : part;
}

Rectangle<double> seen_from(const Excerpt& excerpt, const PageLayout& layout,
                            const Rectangle<double>& on_page) {
    const glm::dvec2 offset(excerpt.part.across.offset, excerpt.part.down.offset);
    const glm::dvec2 corner = layout.picture.low + offset * layout.page.mm_per_page_unit;
    return {on_page.low - corner, on_page.high - corner};
}

}  // namespace dapple
