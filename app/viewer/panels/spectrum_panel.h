#pragma once
// The section "Spectrum": what is measured of the dots on screen.

#include <imgui.h>

#include <optional>
#include <string>

#include "app/viewer/view/view_analysis.h"

namespace dapple {

struct SpectrumInfo {
    const ViewAnalysis* analysis = nullptr;  // none yet: being measured
    ImTextureID picture{};                   // of its spectrum
};

/// What the orange spots in its picture mean, for dots of such a periodicity; none: too few tiles are in view
/// to tell. A lattice of them is a repeated pattern only where there is one: a tile that never repeats has
/// some spots as well, as each of its copies has the same points.
std::string spots_in_words(const std::optional<double>& periodicity);

/// Section "Spectrum", folded at first: the spectrum of the dots on screen as a
/// picture and as a curve, how much they repeat and how far apart they are, each with a sentence that says
/// what it means. True while it is open, for only then is there anything to measure.
bool draw_spectrum_panel(const SpectrumInfo& info);

}  // namespace dapple
