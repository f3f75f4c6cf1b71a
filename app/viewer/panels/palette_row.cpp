#include "app/viewer/panels/settings_panels.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>

#include "core/pens/separation.h"

namespace dapple {

void PaletteRow::read(Banner& banner) {
    palettes_ = built_in_palettes();
    for (const std::string& name : own_palettes(folder_)) {
        try {
            palettes_.push_back(palette_named(name, folder_));
        } catch (const std::exception& error) {
            banner = {BannerKind::error, error.what()};
        }
    }
}

bool PaletteRow::draw(PenChoice& pens, const Palette& now, Banner& banner) {
    if (palettes_.empty()) read(banner);
    bool taken = false;
    const bool automatic = pens.set == PenSet::automatic;
    KeptThings things{
        .label = "Palette",
        .tip =
            "Named sets of pens: common ones and those you save here. Automatic pens are chosen from them. "
            "Commands take them as --pens NAME.",
        .what = "palette",
        .present = automatic ? "custom pens" : "Custom",
        .keep = "Save these pens as...",
        .may_keep = !folder_.empty() && !now.empty(),
        .take =
            [&](int which) {
                taken = true;
                if (automatic && which == 0) return pens.own.clear();
                pens.own = palettes_[static_cast<std::size_t>(which - automatic)].pens;
                const int others = static_cast<int>(pens.own.size()) - 1;
                if (!automatic || others == 0) pens.set = PenSet::own;
                if (pens.set == PenSet::automatic) pens.automatic = std::min(pens.automatic, others);
            },
        .save = [&](const std::string& name) { save_palette(name, now, folder_); },
        .remove = [&](const std::string& name) { remove_palette(name, folder_); },
        .changed = [&] { read(banner); },
    };
    // As a file has them, whose colours are of 8 bits.
    const bool own = pens.set == PenSet::own || chooses_from_own(pens);
    const std::string present = own ? text_of(PenChoice{.set = PenSet::own, .own = pens.own}) : "";
    if (automatic) {
        if (!own) things.chosen = 0;
        things.all.push_back({"common pens"});
    }
    for (const NamedPalette& palette : palettes_) {
        if (text_of(PenChoice{.set = PenSet::own, .own = palette.pens}) == present)
            things.chosen = static_cast<int>(things.all.size());
        things.all.push_back({palette.name, palette.about.empty()});
    }
    row_.draw(things, banner);
    return taken;
}

}  // namespace dapple
