#include "app/viewer/background/preview_dots.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <numbers>
#include <optional>

namespace dapple {
namespace {

// Dots with a critical scale up to this are about one in so many, everywhere on the page. None if they do not
// say when they appear.
std::optional<float> limit_of(const DotPieces& dots, double every) {
    constexpr std::size_t kLookedAt = 1 << 15;
    const std::size_t step = 1 + dots.size() / kLookedAt;
    std::vector<float> sample;
    std::uint32_t random = 1;
    std::size_t stretch = 0;  // of so many dots, in the piece: one of them is looked at
    for (const Dots& piece : dots.pieces) {
        if (piece.critical.size() != piece.size()) return std::nullopt;
        for (; stretch < piece.size(); stretch += step) {
            // Any of them: ranks come in an order that has its own periods.
            random = random * 1664525 + 1013904223;
            const std::size_t place = stretch + (random >> 8) % step;
            if (place < piece.size()) sample.push_back(piece.critical[place]);
        }
        stretch -= piece.size();
    }
    if (sample.empty()) return std::nullopt;
    const auto at = std::min(static_cast<std::size_t>(double(sample.size()) / every), sample.size() - 1);
    std::nth_element(sample.begin(), sample.begin() + std::ptrdiff_t(at), sample.end());
    return sample[at];
}

// By how much larger, or smaller, the area of a part's dots has to be than that of all in their place, as
// they overlap otherwise.
class Growth {
 public:
    Growth(const DotsInFull& all, double every) {
        for (std::size_t i = 0; i < kLoads; ++i) {
            const double load = kStep * double(i + 1);
            InkedDots dots = all.ink, part{.relaxing_steps = 0};
            if (dots.level) {
                *dots.level += std::log2(std::max(load / all.full_load, 1e-9)) / 2;
                part.level = *dots.level - std::log2(every) / 2;
            }
            const float wanted = covered(dots, load);
            double low = kLeast, high = kMost;
            while (high - low > 1e-3) {
                const double middle = (low + high) / 2;
                (covered(part, load * middle) < wanted ? low : high) = middle;
            }
            // A part of relaxed dots lies about as placed ones do, which cover a little more: measured.
            const double lost = all.ink.relaxing_steps > 0 ? 0.3 / every * std::min(load, 1.0) : 0;
            by_load_[i] = static_cast<float>(high * (1 + lost));
        }
    }

    float operator()(double load) const {
        if (!(load > kStep)) return by_load_[0];
        return by_load_[static_cast<std::size_t>(std::min(load / kStep, double{kLoads})) - 1];
    }

 private:
    static constexpr double kStep = 0.02, kLeast = 0.7, kMost = 1.5;
    static constexpr std::size_t kLoads = 100;
    std::array<float, kLoads> by_load_{};  // kStep, 2 kStep, ...
};

// What each pen's dots would cover if none overlapped, in cells of the view.
class Loads {
 public:
    // Each of the dots stands for so many of its size.
    Loads(const DotPieces& dots, double every, const Rectangle<double>& view) : low_(view.low) {
        constexpr double kDotsInCell = 16, kMostCells = 4096;
        const glm::dvec2 size = glm::max(view.size(), 1e-30);
        const double side = std::sqrt(size.x * size.y * kDotsInCell / double(dots.size()));
        cells_ = glm::ivec2(glm::clamp(size / side, 1.0, kMostCells));
        per_unit_ = glm::dvec2(cells_) / size;
        int pens = 1;
        for (const Dots& piece : dots.pieces) pens = std::max(pens, piece.pen + 1);
        load_.assign(std::size_t(pens) * cells_.x * cells_.y, 0);
        const double area = std::numbers::pi * every * per_unit_.x * per_unit_.y;
        for (const Dots& piece : dots.pieces) {
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const glm::dvec2 place = (glm::dvec2(piece.x[i], piece.y[i]) - low_) * per_unit_;
                if (!(place.x >= 0 && place.y >= 0 && place.x < cells_.x && place.y < cells_.y)) continue;
                load_[index(place, piece.pen)] += area * piece.radius[i] * piece.radius[i];
            }
        }
    }

    // In the cell of that place, or the nearest one.
    double at(float x, float y, int pen) const {
        const glm::dvec2 place = (glm::dvec2(x, y) - low_) * per_unit_;
        return load_[index(glm::clamp(place, glm::dvec2(0), glm::dvec2(cells_ - 1)), pen)];
    }

 private:
    std::size_t index(glm::dvec2 place, int pen) const {
        return (std::size_t(pen) * cells_.y + std::size_t(place.y)) * cells_.x + std::size_t(place.x);
    }

    glm::dvec2 low_, per_unit_{1};
    glm::ivec2 cells_{1};
    std::vector<double> load_;
};

}  // namespace

PreviewDots preview_dots(const DotsInFull& all, double every) {
    const std::optional<float> limit = limit_of(all.dots, every);
    const auto step = std::max(static_cast<std::size_t>(every), std::size_t{1});
    PreviewDots part;
    part.dots.pieces.resize(all.in_view.size());
    part.blocks.resize(all.in_view.size());
    std::vector<std::vector<glm::u8vec4>> colours(all.colours.empty() ? 0 : all.in_view.size());
    tbb::parallel_for(std::size_t{0}, all.in_view.size(), [&](std::size_t b) {
        const DotBlock& block = all.blocks[all.in_view[b]];
        const Dots& from = all.dots.pieces[block.piece];
        Dots& to = part.dots.pieces[b];
        to.pen = from.pen;
        for (std::size_t k = 0; k < block.count; k += limit ? 1 : step) {
            const std::size_t i = block.first + k;
            if (limit && !(from.critical[i] <= *limit)) continue;
            to.x.push_back(from.x[i]);
            to.y.push_back(from.y[i]);
            if (!from.critical.empty()) to.critical.push_back(from.critical[i]);
            to.radius.push_back(from.radius.empty() ? static_cast<float>(all.radius) : from.radius[i]);
            if (!colours.empty()) colours[b].push_back(all.colours[block.index + k]);
        }
        part.blocks[b] = {.piece = b, .count = to.size(), .low = block.low, .high = block.high};
    });
    std::size_t looked_at = 0, taken = 0;
    Rectangle<double> box{glm::dvec2(std::numeric_limits<double>::max()),
                          glm::dvec2(std::numeric_limits<double>::lowest())};
    for (std::size_t b = 0; b < part.blocks.size(); ++b) {
        DotBlock& block = part.blocks[b];
        looked_at += all.blocks[all.in_view[b]].count;
        block.index = taken;
        taken += block.count;
        box = {glm::min(box.low, glm::dvec2(block.low)), glm::max(box.high, glm::dvec2(block.high))};
    }
    if (taken == 0) return part;
    for (const auto& some : colours) part.colours.insert(part.colours.end(), some.begin(), some.end());
    const double exactly = double(looked_at) / double(taken);
    const Loads loads(part.dots, exactly,
                      {glm::max(box.low, all.view.low), glm::min(box.high, all.view.high)});
    const Growth growth(all, exactly);
    tbb::parallel_for(std::size_t{0}, part.blocks.size(), [&](std::size_t b) {
        Dots& dots = part.dots.pieces[b];
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const double area = exactly * growth(loads.at(dots.x[i], dots.y[i], dots.pen));
            dots.radius[i] *= static_cast<float>(std::sqrt(area));
            part.blocks[b].largest_radius = std::max(part.blocks[b].largest_radius, dots.radius[i]);
            part.blocks[b].radii += dots.radius[i];
        }
    });
    return part;
}

}  // namespace dapple
