// Presets: each is another, all are valid, and what is the picture's own stays.

#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <string>

#include "app/viewer/desktop/pasted_picture.h"
#include "app/viewer/model/session.h"
#include "app/viewer/panels/settings_panels.h"
#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"
#include "io/settings/presets.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace fs = std::filesystem;

TEST_CASE("the built-in presets differ from each other and from what is usual, and are valid settings") {
    std::set<std::string> texts, names;
    for (Preset preset : built_in_presets()) {
        CAPTURE(preset.name);
        const Describe all = [&](Fields& fields) {
            describe_drawing(fields, preset.settings.drawing, preset.settings.saving);
        };
        const std::string text = settings_text("", {"/p.dapple"}, all);
        const DrawingSettings before = preset.settings.drawing;
        read_settings(text, {"/p.dapple"}, all);
        CHECK(preset.settings.drawing == before);
        CHECK_FALSE(preset.about.empty());
        CHECK(with_preset(before, {}) != DrawingSettings{});
        texts.insert(text);
        names.insert(preset.name);
    }
    CHECK(texts.size() == built_in_presets().size());
    CHECK(names.size() == built_in_presets().size());
    CHECK(texts.size() >= 5);
}

TEST_CASE("a preset of one's own comes back as it was, and can be removed") {
    const TemporaryFolder folder;
    const fs::path presets = folder / "presets";
    SavedSettings mine;
    mine.drawing.placing.count = 777;
    mine.drawing.ink = parse_colour("#112233");
    mine.saving.dpi = 123;
    save_preset("My pen", mine, presets);
    CHECK(own_presets(presets) == std::vector<std::string>{"My pen"});
    const Preset read = preset_named("My pen", presets);
    CHECK(read.settings.drawing == mine.drawing);
    CHECK(read.settings.saving == mine.saving);
    remove_preset("My pen", presets);
    CHECK(own_presets(presets).empty());
    CHECK_THROWS_WITH_AS(preset_named("My pen", presets),
                         "there is no preset \"My pen\"; `dapple presets` lists them all",
                         std::runtime_error);
    for (const char* name : {"", "a/b", "../up", ".hidden", "a\nb", "night"})
        CHECK_THROWS_AS(save_preset(name, mine, presets), std::runtime_error);
    CHECK(own_presets(presets).empty());
}

TEST_CASE("a preset leaves the picture's crop, turns and exposure, and one undo brings all back") {
    Session session({}, [] {});
    session.settings.drawing.page.crop = Crop{{{10, 20}, {90, 80}}, Crop::Unit::percent};
    session.settings.drawing.page.quarter_turns = 1;
    session.settings.drawing.mask = Mask(Grid<std::uint8_t>(2, 2, 40));
    session.settings.drawing.automatic_exposure = false;
    session.settings.drawing.tone.exposure = 2;
    session.remember(false);
    const ViewerSettings before = session.settings;
    session.take_preset(preset_named("night", "").settings);
    session.remember(false);
    CHECK(session.settings.drawing.ink == kWhite);
    CHECK(session.settings.drawing.tone.invert);
    CHECK(session.settings.drawing.page.crop == before.drawing.page.crop);
    CHECK(session.settings.drawing.page.quarter_turns == 1);
    CHECK(session.settings.drawing.mask == before.drawing.mask);
    CHECK_FALSE(session.settings.drawing.mask.empty());
    CHECK(session.settings.drawing.tone.exposure == 2);
    session.undo();
    CHECK(session.settings == before);
}

TEST_CASE(
    "the preset row takes one's settings, keeps the present ones under a name, and removes them again") {
    const TemporaryFolder folder;
    PresetRow row(folder.path());
    SavedSettings now;
    Banner banner;
    HeadlessUi ui([&] {
        row.draw(
            now, [&](const SavedSettings& taken) { now = taken; },
            [](const DrawingSettings&) { return EntryPicture{}; }, banner);
    });
    const auto choose = [&](const char* name) {
        ui.click("Preset");
        ui.frame();
        ui.click(name);
        ui.frame();
    };
    choose("Night");
    CHECK(now.drawing == preset_named("night", "").settings.drawing);
    now.drawing.tone.contrast = 0.25f;
    choose("Save these settings as...");
    ui.click("Preset name");
    for (const char letter : std::string("mine"))
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letter));
    ui.frame();
    ui.click("Save preset");
    CHECK(banner.message == "Saved the preset mine");
    CHECK(own_presets(folder.path()) == std::vector<std::string>{"mine"});
    now = {};
    choose("mine");
    CHECK(now.drawing.tone.contrast == 0.25f);
    choose("Remove mine");
    CHECK(own_presets(folder.path()).empty());
    CHECK(now.drawing.tone.contrast == 0.25f);  // what is drawn stays
}

TEST_CASE("by keyboard alone unsaved settings are saved as a preset: no other takes their place on the way") {
    const TemporaryFolder folder;
    PresetRow row(folder.path());
    SavedSettings now;
    now.drawing.tone.contrast = 0.25f;
    const DrawingSettings before = now.drawing;
    Banner banner;
    HeadlessUi ui([&] {
        row.draw(
            now, [&](const SavedSettings& taken) { now = taken; },
            [](const DrawingSettings&) { return EntryPicture{}; }, banner);
    });
    ui.key(Key::tab);
    ui.key(Key::down);  // opens the list
    REQUIRE(ui.has("Save these settings as..."));
    for (int i = 0; i < 30; ++i) ui.key(Key::down);
    CHECK(now.drawing == before);
    ui.key(Key::enter);
    ui.frame();
    ui.frame();
    REQUIRE(ImGui::GetIO().WantTextInput);  // the name's field has the keys
    ui.type("mine");
    ui.key(Key::enter);
    CHECK(own_presets(folder.path()) == std::vector<std::string>{"mine"});
    CHECK(now.drawing == before);
    CHECK(preset_named("mine", folder.path()).settings.drawing.tone.contrast == 0.25f);
}

TEST_CASE("a pasted text names files as file managers and shells write them") {
    const TemporaryFolder folder;
    const fs::path plain = folder / "cat.jpg", odd = folder / "a b%\xc3\xa4.png";
    for (const fs::path& file : {plain, odd}) std::ofstream(file) << "x";
    const auto files = [&](const std::string& text) { return pasted_files(text, folder.path()); };
    const std::string at = folder.path().string();
    CHECK(files(plain.string()) == std::vector{plain});
    CHECK(files("  '" + plain.string() + "' \r\n") == std::vector{plain});
    CHECK(files("~/cat.jpg") == std::vector{plain});
    CHECK(files("file://" + at + "/a%20b%25%C3%a4.png") == std::vector{odd});
    CHECK(files("copy\nfile://localhost" + at + "/cat.jpg\nfile:" + at + "/a%20b%25%c3%a4.png") ==
          std::vector{plain, odd});
    for (const std::string& text :
         {std::string(), std::string("cat.jpg"), at, at + "/none.jpg", "file://elsewhere" + at + "/cat.jpg",
          std::string("%"), std::string("file://")})
        CHECK(files(text).empty());
}

}  // namespace dapple
