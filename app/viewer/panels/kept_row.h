#pragma once
// A row of what is kept by name, as presets and palettes are: chooses one, keeps the present one under a name
// that is typed below the row, removes one of the person's own.

#include <functional>
#include <string>
#include <vector>

#include "app/viewer/model/banner.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

struct KeptThing {
    std::string name;
    bool own = false;  // the person's, which can be removed
};

/// What a row is about.
struct KeptThings {
    const char* label = "";  // "Preset"
    const char* tip = "";
    const char* what = "";     // "preset"
    const char* present = "";  // the entry of what none of them is: "as set below"
    const char* keep = "";     // the entry that keeps it: "Save these settings as..."
    std::vector<KeptThing> all = {};
    int chosen = -1;        // which of them is as the present one; -1: none
    bool may_keep = false;  // there is a place to keep them in
    std::function<void(int which)> take = {};
    /// What they throw is told in the banner.
    std::function<void(const std::string&name)> save = {}, remove = {};
    std::function<void()> changed = {};                     // told after either
    float lines_wide = 0;                                   // as in ListLook
    std::function<bool(int which, bool marked)> draw = {};  // one of them; none: by their names
};

class KeptRow {
 public:
    /// The banner says what went wrong, or that one was saved.
    void draw(const KeptThings& things, Banner& banner);

 private:
    void draw_naming(const KeptThings& things, Banner& banner);

    bool naming_ = false;        // the present one is about to be kept,
    std::string typed_;          // under this name
    bool ask_for_keys_ = false;  // its field is to have the keyboard
};

}  // namespace dapple
