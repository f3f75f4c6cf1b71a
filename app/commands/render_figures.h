#pragma once
// What can be told of a drawing that `dapple render` saves: measured, timed, and found worth knowing
// before it is plotted.

#include "app/commands/render_page.h"
#include "app/commands/render_report.h"
#include "app/files/save_drawing.h"
#include "core/drawing/pipeline.h"

namespace dapple {

struct SavedDrawing {
    glm::ivec2 picture;  // pixels
    const DotsForFile& from;
    const DrawnPage& page;
    const DrawingToSave& drawing;
    const DotStream& dots;
    const DotPieces* by_pen = nullptr;  // the same in memory, as they are drawn; none if they are too many
};

/// All but the order, the way before it was shortened, and the times of the work.
Rendered figures_of(const SavedDrawing& saved, const RenderOptions& options);

}  // namespace dapple
