#pragma once
// What the keys and the buttons do.

#include "app/viewer/canvas.h"
#include "app/viewer/panels/file_dialog.h"
#include "app/viewer/session.h"
#include "app/viewer/shortcuts.h"
#include "app/viewer/window.h"

namespace dapple {

/// Of the window, what comes and goes.
struct Shown {
    bool panels = true;
    bool help = false;
    FileDialog dialog;
};

/// All that an action may touch.
struct Stage {
    Session& session;
    Canvas& canvas;
    Window& window;
    Shown& shown;
};

void act(Action action, const Stage& stage);

}  // namespace dapple
