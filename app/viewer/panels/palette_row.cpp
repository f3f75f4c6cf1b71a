#include "app/viewer/panels/palette_row.h"

#include <cstddef>
#include <exception>
#include <string>

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
    KeptThings things{
        .label = "Palette",
        .tip =
            "Pens of one's own by a name: common ones, and those that you save here. The command takes "
            "them as --pens NAME.",
        .what = "palette",
        .present = "as set below",
        .keep = "Save these pens as...",
        .may_keep = !folder_.empty() && !now.empty(),
        .take =
            [&](int which) {
                pens.set = PenSet::own;
                pens.own = palettes_[static_cast<std::size_t>(which)].pens;
                taken = true;
            },
        .save = [&](const std::string& name) { save_palette(name, now, folder_); },
        .remove = [&](const std::string& name) { remove_palette(name, folder_); },
        .changed = [&] { read(banner); },
    };
    // As a file has them, whose colours are of 8 bits.
    const std::string present = pens.set == PenSet::own ? text_of(pens) : "";
    for (const NamedPalette& palette : palettes_) {
        if (text_of(PenChoice{.set = PenSet::own, .own = palette.pens}) == present)
            things.chosen = static_cast<int>(things.all.size());
        things.all.push_back({palette.name, palette.about.empty()});
    }
    row_.draw(things, banner);
    return taken;
}

}  // namespace dapple
