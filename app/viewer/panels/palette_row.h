#pragma once
// The row "Palette" of the section "Pens": takes the pens of one, keeps the present ones as one, removes one.

#include <filesystem>
#include <utility>
#include <vector>

#include "app/viewer/model/banner.h"
#include "app/viewer/panels/kept_row.h"
#include "core/pens/pen.h"
#include "io/settings/palettes.h"

namespace dapple {

class PaletteRow {
 public:
    /// Without a folder there are the built-in palettes only, and none is saved.
    explicit PaletteRow(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// `now` are the pens that draw, none if they are not known; the banner says what went wrong with a file,
    /// or that one was saved. True if pens were taken: they are one's own then.
    bool draw(PenChoice& pens, const Palette& now, Banner& banner);

 private:
    void read(Banner& banner);

    std::filesystem::path folder_;
    std::vector<NamedPalette> palettes_;  // all that can be chosen; empty: not read yet
    KeptRow row_;
};

}  // namespace dapple
