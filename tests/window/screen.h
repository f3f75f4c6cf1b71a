#pragma once
// What is to be seen on a display.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <glm/gtc/type_precision.hpp>
#include <string>

#include "core/image/grid.h"
#include "core/image/rectangle.h"
#include "tests/window/running_viewer.h"

namespace dapple {

/// The pixels of the display in use. Taken as a plain PNM, in a fraction of the time of a PNG.
inline Grid<glm::u8vec3> screen() {
    const TemporaryFolder folder;
    const fs::path file = folder / "screen.ppm";
    run({"import", "-window", "root", "-depth", "8", "ppm:" + file.string()});
    const std::string text = text_of(file);
    int width = 0, height = 0, begin = 0;
    REQUIRE(std::sscanf(text.c_str(), "P6 %d %d 255%n", &width, &height, &begin) == 2);
    Grid<glm::u8vec3> pixels(width, height);
    static_assert(sizeof(glm::u8vec3) == 3);
    const std::size_t from = static_cast<std::size_t>(begin) + 1, bytes = 3 * pixels.values.size();
    REQUIRE(text.size() == from + bytes);
    std::memcpy(pixels.values.data(), text.data() + from, bytes);
    return pixels;
}

/// The box has to lie within.
inline Grid<glm::u8vec3> cut_out(const Grid<glm::u8vec3>& pixels, const Rectangle<int>& box) {
    const glm::ivec2 size = box.size();
    REQUIRE(contains({{0, 0}, {pixels.width, pixels.height}}, box));
    Grid<glm::u8vec3> part(size.x, size.y);
    for (int y = 0; y < size.y; ++y) std::copy_n(pixels.row(box.low.y + y) + box.low.x, size.x, part.row(y));
    return part;
}

}  // namespace dapple
