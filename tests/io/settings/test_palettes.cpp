// Palettes: pens that are kept by name.

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/viewer/panels/settings_panels.h"
#include "io/settings/palettes.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace fs = std::filesystem;

TEST_CASE("the palettes that come with the program are pens with widths, and each is another") {
    std::set<std::string> names, texts;
    for (const NamedPalette& palette : built_in_palettes()) {
        CAPTURE(palette.name);
        const std::string text = text_of(own_pens(palette.pens));
        CHECK(parse_pens(text).own == palette.pens);
        CHECK_FALSE(palette.about.empty());
        CHECK_FALSE(names_pen_set(palette.name));
        CHECK(palette.pens.size() >= 4);
        for (const Pen& pen : palette.pens) CHECK(pen.width_mm > 0);
        names.insert(palette.name);
        texts.insert(text);
    }
    CHECK(names.size() == built_in_palettes().size());
    CHECK(texts.size() == built_in_palettes().size());
    CHECK(texts.size() >= 3);
}

TEST_CASE("a palette of one's own comes back as it was, and can be removed") {
    const TemporaryFolder folder;
    const fs::path palettes = folder / "palettes";
    const Palette mine = parse_pens("Sky:#3aa0d8:0.3+0.05:0.6,Ochre:#c08a2e").own;
    save_palette("My pens (2)", mine, palettes);
    CHECK(text_of(palettes / "My pens (2).json") ==
          "[{\"name\":\"Sky\",\"colour\":\"#3aa0d8\",\"width_mm\":0.3,\"gap_mm\":0.6,\"gain_mm\":0.05},\n"
          " {\"name\":\"Ochre\",\"colour\":\"#c08a2e\"}]\n");
    CHECK(own_palettes(palettes) == std::vector<std::string>{"My pens (2)"});
    CHECK(palette_named("My pens (2)", palettes).pens == mine);
    // What a window's rows may hold, although no pen is so fine or gains without a width.
    save_palette("fine", {{.name = "A", .width_mm = 1e-5}, {.name = "B", .gap_mm = 1, .gain_mm = 1}},
                 palettes);
    CHECK(palette_named("fine", palettes).pens[0].width_mm == kFinestPenMm);
    CHECK(palette_named("fine", palettes).pens[1] == Pen{.name = "B"});
    remove_palette("fine", palettes);
    remove_palette("My pens (2)", palettes);
    CHECK(own_palettes(palettes).empty());
    CHECK_THROWS_WITH_AS(palette_named("mine", palettes),
                         "there is no file or palette \"mine\"; palettes are ballpoints, technical-pens, "
                         "fineliners, felt-tips, "
                         "earth-tones",
                         std::runtime_error);
    for (const char* name :
         {"", "a/b", "../up", ".hidden", "a\nb", "a,b", "a:b", "#abc", "cmyk", "auto", "one", "ballpoints"})
        CHECK_THROWS_AS(save_palette(name, mine, palettes), std::runtime_error);
    CHECK_THROWS_AS(save_palette("none", {}, palettes), std::runtime_error);
    CHECK(own_palettes(palettes).empty());
    CHECK_THROWS_WITH_AS(save_palette("mine", mine, ""),
                         "there is no home folder for palettes; set HOME to one", std::runtime_error);
}

TEST_CASE("the palette row takes one's pens, keeps the present ones under a name, and removes them again") {
    const TemporaryFolder folder;
    put_text(folder / "broken.json", "[{\"name\": \"A\"}]");
    put_text(folder / "lines.json", "Sky:#3aa0d8:0.3\nInk:#111111\n");
    PaletteRow row(folder.path());
    DrawingSettings settings;
    settings.pens.set = PenSet::cmyk;
    Banner banner;
    HeadlessUi ui([&] { draw_pen_panel(settings, LengthUnit::mm, {}, {&row, &banner}); });
    const auto choose = [&](const char* name) {
        ui.click("Palette");
        ui.frame();
        ui.click(name);
        ui.frame();
    };
    CHECK(banner.kind == BannerKind::error);
    CHECK(banner.message.find("broken.json: pen 1: colour: is missing") != std::string::npos);
    choose("ballpoints");
    CHECK(settings.pens.set == PenSet::own);
    CHECK(settings.pens.own == palette_named("ballpoints", "").pens);
    choose("lines");  // the broken one is in no other's way
    CHECK(settings.pens.own == parse_pens("Sky:#3aa0d8:0.3,Ink:#111111").own);
    settings.pens.own[0].width_mm = 0.7;
    ui.frame();
    choose("Save these pens as...");
    ui.click("Palette name");
    ui.type("mine");
    ui.click("Save palette");
    CHECK(banner.message.find("broken.json") != std::string::npos);  // still
    CHECK(own_palettes(folder.path()) == std::vector<std::string>{"broken", "lines", "mine"});
    CHECK(read_pens(folder / "mine.json").own == settings.pens.own);
    settings.pens = {.set = PenSet::greys};
    ui.frame();
    choose("mine");
    CHECK(settings.pens.own[0].width_mm == 0.7);
    choose("Remove mine");
    CHECK_FALSE(fs::exists(folder / "mine.json"));
    CHECK(settings.pens.own[0].width_mm == 0.7);  // what draws stays
    fs::remove(folder / "broken.json");
    settings.pens = {.set = PenSet::automatic, .automatic = 6};
    ui.frame();
    choose("fineliners");  // automatic ones are chosen from it
    CHECK(text_of(settings.pens).starts_with("auto:6:Black:#1d1d1b:0.4,"));
    choose("ballpoints");  // which are four
    CHECK(settings.pens.automatic == 3);
    CHECK(settings.pens.own.size() == 4);
    choose("common pens");
    CHECK(text_of(settings.pens) == "auto:3");
    settings.pens = {.set = PenSet::cmyk, .width_mm = 0.25};
    ui.frame();
    choose("Save these pens as...");
    ui.click("Palette name");
    ui.type("inks");
    ui.click("Save palette");
    CHECK(banner.message == "Saved the palette inks");
    CHECK(palette_named("inks", folder.path()).pens == palette_of(settings.pens));
}

}  // namespace dapple
