#pragma once
// The column of panels beside the canvas, from the picture's name down to the tile.

#include <functional>
#include <glm/vec2.hpp>

#include "app/viewer/panels/tile_panel.h"
#include "app/viewer/session.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/spectrum_view.h"

namespace dapple {

class SidePanel {
 public:
    /// Draws it into a rectangle. The panels edit the session's settings; the buttons call `act`.
    void draw(Session& session, SpectrumView& spectrum, const std::function<void(Action)>& act,
              glm::vec2 corner, glm::vec2 size);

 private:
    TilePanelState tile_;
    int tiles_seen_ = 0;
};

}  // namespace dapple
