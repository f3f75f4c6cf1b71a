#include "core/image/framing.h"

namespace dapple {
namespace {

template <class T>
Grid<T> framed_pixels(const Grid<T>& picture, const Framing& framing) {
    const auto [low, high] = framing.pixels;
    const glm::ivec2 size = framing.size();
    Grid<T> result(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        T* const row = result.row(y);
        for (int x = 0; x < size.x; ++x) {
            switch (framing.quarter_turns) {
                case 1:  // what was at the lower left comes to the upper left
                    row[x] = picture.at(low.x + y, high.y - 1 - x);
                    break;
                case 2:
                    row[x] = picture.at(high.x - 1 - x, high.y - 1 - y);
                    break;
                case 3:
                    row[x] = picture.at(high.x - 1 - y, low.y + x);
                    break;
                default:
                    row[x] = picture.at(low.x + x, low.y + y);
            }
        }
    }
    return result;
}

}  // namespace

glm::dvec2 opened_pixel(const Framing& framing, glm::dvec2 framed) {
    const glm::dvec2 low(framing.pixels.low), high(framing.pixels.high);
    switch (framing.quarter_turns) {
        case 1:
            return {low.x + framed.y, high.y - framed.x};
        case 2:
            return high - framed;
        case 3:
            return {high.x - framed.y, low.y + framed.x};
        default:
            return low + framed;
    }
}

Grid<float> framed(const Grid<float>& picture, const Framing& framing) {
    return framed_pixels(picture, framing);
}

Grid<glm::u16vec3> framed(const Grid<glm::u16vec3>& picture, const Framing& framing) {
    return framed_pixels(picture, framing);
}

}  // namespace dapple
