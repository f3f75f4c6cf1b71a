#pragma once
// A rectangle along the axes, in pixels, millimetres, page units or fractions: whoever has one says which.

#include <glm/vec2.hpp>

namespace dapple {

template <class T>
struct Rectangle {
    glm::vec<2, T> low{}, high{};  // low.x < high.x and low.y < high.y, or it is empty

    glm::vec<2, T> size() const { return high - low; }
    bool operator==(const Rectangle&) const = default;
};

/// Whether they have an area in common.
template <class T>
bool overlap(const Rectangle<T>& a, const Rectangle<T>& b) {
    return a.low.x < b.high.x && a.low.y < b.high.y && b.low.x < a.high.x && b.low.y < a.high.y;
}

/// Whether no part of `inner` lies outside.
template <class T>
bool contains(const Rectangle<T>& outer, const Rectangle<T>& inner) {
    return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
           inner.high.y <= outer.high.y;
}

}  // namespace dapple
