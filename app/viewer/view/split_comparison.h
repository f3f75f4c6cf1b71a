#pragma once
// The split view: to the right of a divider the same density with another tile, another placer or both.

#include <optional>
#include <string>

#include "core/drawing/settings.h"
#include "core/text/names.h"

namespace dapple {

enum class CompareBy {
    scale,
    count,  // of different dots; Figure 8 comes near it only
};
constexpr auto names_of(CompareBy) {
    return names("scale", "count");
}

struct Comparison {
    bool on = false;
    PlacerKind placer = PlacerKind::exact;  // these three of the right side
    std::string tile = "paper16";
    std::optional<RankingMethod> ranking;
    CompareBy by = CompareBy::scale;
    float divider = 0.5f;  // the left side's share of the canvas, 0..1

    bool operator==(const Comparison&) const = default;
};

/// Switched on or off. Where both sides would be alike the right one gets another tile: the paper's, which
/// repeats, or the default beside the paper's.
Comparison toggled(Comparison comparison, const DrawingSettings& left);

}  // namespace dapple
