#pragma once
// The section "Spectrum": what is measured of the dots on screen.

#include <imgui.h>

#include "app/viewer/model/view_analysis.h"

namespace dapple {

struct SpectrumInfo {
    const ViewAnalysis* analysis = nullptr;  // none yet: being measured
    ImTextureID picture{};                   // of its spectrum
};

/// Section "Spectrum", folded at first: the spectrum of the dots on screen as a
/// picture and as a curve, how much they repeat and how far apart they are, each with a sentence that says
/// what it means. True while it is open, for only then is there anything to measure.
bool draw_spectrum_panel(const SpectrumInfo& info);

}  // namespace dapple
