#pragma once
// The spectrum section and what keeps it up to date: measures the dots on screen while it is open.

#include <cstdint>
#include <functional>
#include <optional>

#include "app/viewer/background.h"
#include "app/viewer/camera.h"
#include "app/viewer/gl_objects.h"
#include "app/viewer/view_analysis.h"

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

    /// Draws the section.
    void draw();

    /// To be called each frame after draw(). `request` is asked for the dots on screen when they are to be
    /// measured: the section is open, they are others than before, and the last measuring is over.
    void update(const ViewKey& key, const std::function<ViewAnalysisRequest()>& request);

 private:
    Background<ViewAnalysis> analyst_;
    GlTexture picture_;
    std::optional<ViewAnalysis> analysis_;
    std::optional<ViewKey> measured_;
    bool open_ = false;
};

}  // namespace dapple
