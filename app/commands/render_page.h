#pragma once
// Where `dapple render` draws: the page, the picture on it, and the part of it that is wanted.

#include <fmt/format.h>

#include <glm/vec2.hpp>
#include <stdexcept>

#include "app/commands/render.h"
#include "core/drawing/drawing_file.h"
#include "core/drawing/page_setup.h"

namespace dapple {

/// What make() makes; an error that it throws gets that option's name before it.
template <class Make>
auto with_option(const char* option, const Make& make) {
    try {
        return make();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", option, error.what()));
    }
}

/// Whether neither a sheet nor a region was asked for.
bool draws_whole_page(const RenderOptions& options);

/// The layout for a picture of so many pixels, before it is known how large the dots are if that follows from
/// their number. Throws std::runtime_error, "--option: why", for a page that cannot be.
PageLayout layout_for(glm::ivec2 picture, const RenderOptions& options);

/// The page and the part of it that is wanted. Throws as layout_for() does, for a part that does not lie on
/// the page.
DrawnPage page_for(const PageLayout& layout, const RenderOptions& options);

}  // namespace dapple
