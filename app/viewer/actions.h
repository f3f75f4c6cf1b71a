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
    bool asks_for_tile = false;  // of use while the dialog is open and does not save
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
