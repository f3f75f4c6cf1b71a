#include "lab/related/bent_square.h"

#include <algorithm>
#include <stdexcept>

namespace dapple {
namespace {

struct Step {
    std::size_t index;
    double share;  // of the way through it, 0..1
};

// Which of the `count` steps of a cumulative sum from 0 on a value lies in; never one without height.
Step step_at(const double* sums, std::size_t count, double value) {
    const auto above = std::size_t(std::upper_bound(sums + 1, sums + count, value) - sums);
    std::size_t index = above - 1;
    while (index > 0 && sums[index + 1] == sums[index]) --index;
    const double height = sums[index + 1] - sums[index];
    return {index, height > 0 ? std::clamp((value - sums[index]) / height, 0.0, 1.0) : 0.5};
}

}  // namespace

BentSquare::BentSquare(const Density* density) {
    if (!density) return;
    width_ = density->width();
    height_ = density->height();
    longer_ = density->longer_side();
    rows_.assign(1, 0.0);
    columns_.reserve(std::size_t(width_ + 1) * std::size_t(height_));
    for (int y = 0; y < height_; ++y) {
        double sum = 0;
        columns_.push_back(0);
        for (int x = 0; x < width_; ++x) columns_.push_back(sum += double(density->values().at(x, y)));
        rows_.push_back(rows_.back() + sum);
    }
    if (!(rows_.back() > 0)) throw std::runtime_error("the picture is white: there is nothing to draw");
}

glm::dvec2 BentSquare::operator()(glm::dvec2 even) const {
    if (rows_.empty()) return even;
    const Step row = step_at(rows_.data(), std::size_t(height_), even.y * rows_.back());
    const double* const sums = columns_.data() + row.index * std::size_t(width_ + 1);
    const Step column = step_at(sums, std::size_t(width_), even.x * sums[width_]);
    return glm::dvec2(double(column.index) + column.share, double(row.index) + row.share) / double(longer_);
}

}  // namespace dapple
