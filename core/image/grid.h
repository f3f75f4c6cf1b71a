#pragma once
// A rectangle of values, row after row, the top row first.

#include <cassert>
#include <cstddef>
#include <vector>

namespace dapple {

template <class T>
struct Grid {
    int width = 0, height = 0;
    std::vector<T> values;  // width * height

    Grid() = default;
    Grid(int w, int h, T fill = {}) : width(w), height(h), values(static_cast<std::size_t>(w) * h, fill) {}

    bool empty() const { return values.empty(); }
    T& at(int x, int y) { return values[index(x, y)]; }
    const T& at(int x, int y) const { return values[index(x, y)]; }
    T* row(int y) { return values.data() + index(0, y); }
    const T* row(int y) const { return values.data() + index(0, y); }

 private:
    std::size_t index(int x, int y) const {
        assert(x >= 0 && y >= 0 && x < width && y < height);
        return static_cast<std::size_t>(y) * width + x;
    }
};

}  // namespace dapple
