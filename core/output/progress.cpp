#include "core/output/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace dapple {
namespace {

// What reaches onto a small part of a page may be larger than that: a dot's shape, about its centre.
constexpr double kLeastReachMm = 250;

}  // namespace

DotsReport::DotsReport(std::uint64_t count, const PageSize& page, const WritingProgress& progress)
    : count_(static_cast<double>(count)), progress_(progress) {
    const double side = std::max(page.width_mm, page.height_mm), reach = std::max(side, kLeastReachMm);
    low_ = -reach;
    high_ = side + reach;
}

void DotsReport::refuse(double x_mm, double y_mm, double radius_mm) {
    throw std::runtime_error(
        fmt::format("a dot or a line would lie at {:g}, {:g} mm{}, far from its page, and is not written; "
                    "this is a fault of "
                    "the program: please report it with the settings",
                    x_mm, y_mm, radius_mm != 0 ? fmt::format(" with a radius of {:g} mm", radius_mm) : ""));
}

}  // namespace dapple
