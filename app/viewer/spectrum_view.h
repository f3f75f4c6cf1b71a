#pragma once
// The spectrum section and what keeps it up to date: measures the dots on screen while it is open.

#include <cstdint>
#include <functional>
#include <optional>

#include "app/viewer/analyst.h"
#include "app/viewer/camera.h"
#include "app/viewer/density_choice.h"
#include "app/viewer/gl_objects.h"

namespace dapple {

/// Tells one view of dots from another.
struct ViewKey {
    std::uint64_t placing = 0;  // a number that changes with the dots
    Camera camera;
    bool operator==(const ViewKey&) const = default;
};

class SpectrumView {
 public:
    explicit SpectrumView(std::function<void()> wake) : analyst_(std::move(wake)) {}

    /// Draws the section, which edits what the dots are placed on.
    void draw(DensityChoice& density);

    /// To be called each frame after draw(). `request` is asked for the dots on screen when they are to be
    /// measured: the section is open, they are others than before, and the analyst is free.
    void update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request);

 private:
    Analyst analyst_;
    GlTexture picture_;
    std::optional<ViewAnalysis> analysis_;
    std::optional<ViewKey> measured_;
    bool open_ = false;
};

}  // namespace dapple
